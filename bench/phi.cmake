# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# phi_bench: Phi-functions against CGAL, Qhull, FCL and libccd. Left out where one of them is not installed.
find_package(CGAL QUIET)
find_package(Eigen3 CONFIG QUIET)  # fcl names it; CGAL brings a FindEigen3 of its own that defines no target
find_package(fcl QUIET)
find_package(ccd QUIET)
find_library(FINDSPACE_QHULL qhull_r)
if(TARGET CGAL::CGAL AND fcl_FOUND AND FINDSPACE_QHULL)
  add_executable(phi_bench phi_bench.cpp phi_rival_cgal.cpp phi_rival_qhull.cpp phi_rival_fcl.cpp phi_rival_ccd.cpp)
  target_link_libraries(phi_bench PRIVATE findspace_io CGAL::CGAL fcl ccd ${FINDSPACE_QHULL})
else()
  message(STATUS "bench: without phi_bench")
endif()
