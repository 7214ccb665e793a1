# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: findspace contributors
#
# findspace_common_headers(TARGET): the headers that most files include, compiled once for all layers of the
# library. Targets of another optimisation (apps, tests) compile their own.
set(FINDSPACE_COMMON_HEADERS
    <algorithm> <array> <bit> <cmath> <compare> <cstdint> <deque> <filesystem> <functional> <iterator> <limits> <map> <memory>
    <mutex> <numbers> <numeric> <optional> <queue> <set> <span> <string> <string_view> <tuple> <unordered_map> <utility> <variant>
    <vector> <fmt/format.h>)
function(findspace_common_headers target)
  if(TARGET findspace_exact AND NOT target STREQUAL findspace_exact)
    target_precompile_headers(${target} REUSE_FROM findspace_exact)
  else()
    target_precompile_headers(${target} PRIVATE ${FINDSPACE_COMMON_HEADERS})
  endif()
endfunction()
