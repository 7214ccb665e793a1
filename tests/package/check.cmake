# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# Installs BUILD into a folder of its own, then configures, builds and runs a project that finds it there; and configures
# one that has the sources as a folder.
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
