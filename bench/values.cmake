# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# values_bench: distances of two polygons at one position against GEOS and Boost.Geometry; and the formula of many atoms.
find_package(Boost QUIET)
if(TARGET PkgConfig::GEOS AND Boost_FOUND)
  add_executable(values_bench values_bench.cpp inputs.cpp values_rival_geos.cpp values_rival_boost.cpp)
  target_compile_definitions(values_bench PRIVATE FINDSPACE_SOURCE="${CMAKE_SOURCE_DIR}")
  target_link_libraries(values_bench PRIVATE findspace_formula nlohmann_json::nlohmann_json PkgConfig::GEOS Boost::headers)
else()
  message(STATUS "bench: without values_bench")
endif()
