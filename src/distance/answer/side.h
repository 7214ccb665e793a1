// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On which side of the truth an answer lies, whether a set of positions or a value. Keywords: inner and outer
// approximation.
#pragma once

#include <string_view>

namespace findspace::distance {

/// Of a set: all of it belongs (kInner), it holds all that belongs (kOuter), either in parts (kMixed). Of a best value:
/// a place of the set, or of its closure, takes it, and others may be better (kInner); it is not known to be taken, but
/// none is better than its bound (kOuter). Of a value at a position: it is near the true one, on either side (kMixed).
/// kNone: nothing is claimed.
enum class Side { kExact, kInner, kOuter, kMixed, kNone };

constexpr std::string_view name(Side side) {
  constexpr std::string_view kNames[] = {"exact", "inner", "outer", "mixed", "none"};
  return kNames[static_cast<int>(side)];
}

/// Of what takes both.
constexpr Side both(Side a, Side b) { return a == Side::kExact || a == b ? b : b == Side::kExact ? a : Side::kMixed; }

}  // namespace findspace::distance
