// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotational_levels.h"

namespace findspace::distance {

using plane::Mark;

SignRange near_above(std::span<const Mark> m) { return {Mark(m[0] > 0 ? 1 : -1), m[1]}; }
SignRange near_below(std::span<const Mark> m) { return {m[0], Mark(m[1] < 0 ? -1 : 1)}; }

SignRange far(std::span<const Mark> m) {
  SignRange out{1, -1};
  const auto add = [&](int low, int high) {
    out.low = std::min(out.low, Mark(low));
    out.high = std::max(out.high, Mark(high));
  };
  for (Mark beyond = m[0]; beyond <= m[1]; ++beyond) {
    if (beyond < 0) add(1, 1);
    if (beyond == 0) add(0, 1);
    if (beyond <= 0) continue;
    for (Mark within = m[2]; within <= m[3]; ++within) add(within > 0 ? 1 : -1, within > 0 ? 1 : -1);
  }
  return out;
}

SignRange far_opposite(std::span<const Mark> m) {
  const SignRange r = far(m);
  return {r.low, m[0] <= 0 && m[1] <= 0 ? Mark(0) : r.high};
}

SignRange far_above_all(std::span<const Mark> m) { return {Mark(m[0] > 0 ? 1 : -1), Mark(m[1] > 0 ? 1 : -1)}; }

}  // namespace findspace::distance
