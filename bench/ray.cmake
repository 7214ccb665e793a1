# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# ray_bench: ray maps of meshes. ray_rival_cgal: the same sums by CGAL's Nef polyhedra; ray_nef: agreement with these on
# small pairs; ray_rival_openvdb: the same grown meshes by OpenVDB's level sets; each where its library is installed.
find_package(CGAL QUIET)
add_executable(ray_bench ray_bench.cpp ray_inputs.cpp)
target_include_directories(ray_bench PRIVATE ${CMAKE_SOURCE_DIR}/tests)
target_link_libraries(ray_bench PRIVATE findspace_space)
if(TARGET CGAL::CGAL)
  add_executable(ray_rival_cgal ray_rival_cgal.cpp ray_inputs.cpp)
  add_executable(ray_nef ray_nef.cpp ray_inputs.cpp)
  foreach(program ray_rival_cgal ray_nef)
    target_include_directories(${program} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    target_link_libraries(${program} PRIVATE findspace_space CGAL::CGAL)
  endforeach()
endif()

find_path(OPENVDB_INCLUDE openvdb/openvdb.h)
find_library(OPENVDB_LIBRARY openvdb)
find_package(TBB QUIET)
if(OPENVDB_INCLUDE AND OPENVDB_LIBRARY AND TARGET TBB::tbb)
  add_executable(ray_rival_openvdb ray_rival_openvdb.cpp ray_inputs.cpp)
  target_include_directories(ray_rival_openvdb SYSTEM PRIVATE ${OPENVDB_INCLUDE})
  target_link_libraries(ray_rival_openvdb PRIVATE findspace_space ${OPENVDB_LIBRARY} TBB::tbb)
else()
  message(STATUS "bench: without OpenVDB")
endif()
