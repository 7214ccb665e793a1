# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# ray_bench: ray maps of meshes. ray_rival_cgal: the same sums by CGAL's Nef polyhedra, where it is installed.
find_package(CGAL QUIET)
add_executable(ray_bench ray_bench.cpp ray_inputs.cpp)
target_link_libraries(ray_bench PRIVATE findspace_space)
if(TARGET CGAL::CGAL)
  add_executable(ray_rival_cgal ray_rival_cgal.cpp ray_inputs.cpp)
  target_link_libraries(ray_rival_cgal PRIVATE findspace_space CGAL::CGAL)
endif()
