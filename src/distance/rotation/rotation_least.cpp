// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotation_least.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/base/stop_check.h"

namespace findspace::distance {

using plane::closure;
using plane::intervals;
using plane::Mark;
using plane::overlay;
using plane::RotationInterval;
using plane::RotationMap;

namespace {

using exact::Angle;
using exact::Real;

constexpr Mark kOn = 1, kBelow = 2;

bool has(const RotationMap& map, Mark least) {
  const auto is = [least](Mark m) { return m >= least; };
  return map.at.empty()
             ? is(map.everywhere)
             : std::any_of(map.here.begin(), map.here.end(), is) || std::any_of(map.after.begin(), map.after.end(), is);
}

/// On the set: kBelow where f is below the level, kOn where it is on it.
RotationMap probe(const RotationMap& sign, const RotationMap& set) {
  const std::array<const RotationMap*, 2> both{&sign, &set};
  return overlay(both, [](std::span<const Mark> m) {
    return Mark(m[1] == 0 || m[0] > 0 ? 0 : m[0] == 0 ? kOn : kBelow);
  });
}

/// Angles beside the set that it lacks.
RotationMap missing_ends(const RotationMap& set) {
  const RotationMap closed = closure(set);
  const std::array<const RotationMap*, 2> both{&closed, &set};
  return overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != 0 && m[1] == 0); });
}

/// The middle of every interval.
RotationMap middles(const RotationMap& set) {
  RotationMap out = RotationMap::uniform(0);
  for (const RotationInterval& i : intervals(set)) {
    const bool single = !i.round && compare(i.from, i.to) == 0;
    const auto [from, to] = i.degrees();
    const double middle = std::fmod((from + to) / 2, 360);
    out.at.push_back(single ? i.from : Angle{exact::ExactAngle::near(middle, 52), Real()});
  }
  std::sort(out.at.begin(), out.at.end(), [](const Angle& p, const Angle& q) { return compare(p, q) < 0; });
  out.here.assign(out.at.size(), 1);
  out.after.assign(out.at.size(), 0);
  return out;
}

}  // namespace

const RotationMap& RotatedLevels::at(double steps) {
  const auto found = made_.find(steps);
  if (found != made_.end()) return found->second;
  if (plane::StopCheck* const check = plane::stop_check()) check->poll();
  return made_.emplace(steps, signs_(level(steps))).first->second;
}

RotationOptimum least_rotation(RotatedLevels& levels, const RotationMap& set, bool jumps) {
  const RotationMap closed = jumps ? set : closure(set);
  const auto reached = [&](double level) { return has(probe(levels.at(level), closed), kOn); };
  RotationOptimum out;
  out.at = RotationMap::uniform(0);
  if (!has(set, 1)) return out;
  double high = 1, low = -1;  // in steps
  bool is_bound = false;      // low
  for (; high < margin::kBeyondAll && !reached(high); high *= 2) {
    low = high;
    is_bound = true;
    if (!levels.is_spent(2 * high)) continue;
    out.set_enclosed({}, levels.level(low), Way::kAngles);
    return out;
  }
  if (high >= margin::kBeyondAll) return out;
  while (!is_bound && low > -margin::kBeyondAll && !levels.is_spent(low)) {
    is_bound = !reached(low);
    if (is_bound) break;
    high = low;
    low *= 2;
  }
  if (low <= -margin::kBeyondAll) {
    out.at = plane::remark(probe(levels.at(high), set), [](Mark m) { return Mark(m == kBelow); });
    out.set_lowest(Way::kAngles);
    return out;
  }
  while (is_bound && high - low > std::max(1.0, std::abs(high)) * margin::kRotatedBracket) {
    const double middle = low + (high - low) / 2;
    if (levels.is_spent(middle)) break;
    (reached(middle) ? high : low) = middle;
  }
  const double whole = std::round(high);
  const RotationMap map = probe(levels.at(whole), closed);
  if (std::abs(high - whole) < 1 && !has(map, kBelow) && has(map, kOn))
    out.set_exact(levels.level(whole), Way::kAngles);
  else
    out.set_enclosed(levels.level(high), is_bound ? std::optional(levels.level(low)) : std::nullopt, Way::kAngles);
  const RotationMap at = out.proven() ? map : middles(probe(levels.at(high), closed));
  const std::array<const RotationMap*, 2> both{&at, &set};
  const RotationMap inside = overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != 0 && m[1] != 0); });
  const bool reached_inside = has(inside, 1);
  out.attained = reached_inside && (out.proven() || !has(probe(levels.at(high), missing_ends(set)), kOn));
  out.at = reached_inside ? inside : at;
  return out;
}

}  // namespace findspace::distance
