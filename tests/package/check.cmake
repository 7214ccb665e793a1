# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# Installs BUILD into a folder of its own, then configures, builds and runs a project that finds it there; and configures
# one that has the sources as a folder; and builds the program by pkg-config alone.
set(place ${BUILD}/package)
file(REMOVE_RECURSE ${place})
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${place}/installed)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${place}/build -DCMAKE_PREFIX_PATH=${place}/installed
    -DSNIPPET=${BUILD}/tests/readme_snippet.cpp)
run(${CMAKE_COMMAND} --build ${place}/build)
run(${place}/build/uses_findspace)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${place}/folder -DSOURCE=${CMAKE_CURRENT_LIST_DIR}/../..
    -DSNIPPET=${BUILD}/tests/readme_snippet.cpp)
file(GLOB_RECURSE found ${place}/installed/*/findspace.pc)
cmake_path(GET found PARENT_PATH packages)
set(ENV{PKG_CONFIG_PATH} ${packages})
execute_process(COMMAND pkg-config --cflags --libs findspace OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(c++ ${BUILD}/tests/readme_snippet.cpp -o ${place}/by_pkg_config ${flags})
run(${place}/by_pkg_config)
