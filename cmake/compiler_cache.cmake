# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# ccache where it is installed. -DCMAKE_CXX_COMPILER_LAUNCHER= at the first configuration leaves it out.
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
if(NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(CCACHE ccache)
  if(NOT CCACHE)
    return()
  endif()
  # Precompiled headers need these two allowances (ccache's manual, "Precompiled headers").
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()
# And the compilers a flag each: what ccache reads must name the precompiled header, and that must hold no time of day.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  else()
    add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()
