// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "findspace/error.h"

namespace findspace::formula {

using exact::Real;
using exact::RealPoint;

namespace {

bool same_points(const std::vector<RealPoint>& a, const std::vector<RealPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const RealPoint& p, const RealPoint& q) { return p.x == q.x && p.y == q.y; });
}

Trajectory standing_still() { return {{Real()}, {RealPoint{}}, {Real()}}; }

}  // namespace

Trajectory common_trajectory(const Motion& motion, const std::vector<std::string>& names) {
  auto of = [&](const std::string& name) {
    const auto found = motion.of.find(name);
    return found == motion.of.end() ? standing_still() : found->second;
  };
  const Trajectory first = of(names.at(0));
  for (const std::string& name : names) {
    if (of(name) == first) continue;
    throw Error(
        ErrorCode::kUnsupported,
        fmt::format("'{}' and '{}' move differently, so their union changes its form in time; take them one by one",
                    names[0], name));
  }
  return first;
}

bool operator==(const Trajectory& a, const Trajectory& b) {
  return a.times == b.times && a.angles == b.angles && same_points(a.path, b.path);
}

namespace {

/// The way point at or before a time, and the part of the leg after it.
std::pair<std::size_t, Real> leg_at(const Trajectory& t, const Real& time) {
  const auto next = std::upper_bound(t.times.begin(), t.times.end(), time);
  if (next == t.times.begin()) return {0, Real()};
  const std::size_t k = std::size_t(next - t.times.begin()) - 1;
  if (next == t.times.end()) return {k, Real()};
  return {k, (time - t.times[k]) / (t.times[k + 1] - t.times[k])};
}

}  // namespace

RealPoint position_at(const Trajectory& t, const Real& time) {
  const auto [k, part] = leg_at(t, time);
  const RealPoint &p = t.path[k], &q = t.path[std::min(k + 1, t.path.size() - 1)];
  return {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)};
}

Real angle_at(const Trajectory& t, const Real& time) {
  const auto [k, part] = leg_at(t, time);
  return t.angles[k] + part * (t.angles[std::min(k + 1, t.angles.size() - 1)] - t.angles[k]);
}

bool rotations(const Trajectory& t) {
  return std::any_of(t.angles.begin(), t.angles.end(), [](const Real& a) { return a.sign() != 0; });
}

std::vector<Real> common_times(const Motion& motion, const Trajectory& a, const Trajectory& b) {
  std::vector<Real> times{motion.start, motion.end};
  for (const Trajectory* t : {&a, &b})
    std::copy_if(t->times.begin(), t->times.end(), std::back_inserter(times),
                 [&](const Real& time) { return motion.start < time && time < motion.end; });
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

Trajectory relative_path(const Motion& motion, const std::vector<std::string>& moving,
                         const std::vector<std::string>& fixed) {
  const Trajectory b = common_trajectory(motion, moving), a = common_trajectory(motion, fixed);
  Trajectory out;
  out.times = common_times(motion, b, a);
  for (const Real& time : out.times) {
    const RealPoint p = position_at(b, time), q = position_at(a, time);
    out.path.push_back({p.x - q.x, p.y - q.y});
    out.angles.push_back(Real());
  }
  return out;
}

}  // namespace findspace::formula
