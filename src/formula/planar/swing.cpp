// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/swing.h"

#include <algorithm>
#include <cmath>

#include "formula/language/evaluate.h"
#include "formula/language/which.h"
#include "formula/planar/rotation_maps.h"
#include "plane/base/real_vector.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::formula {

using exact::Angle;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;
using plane::Section;
using plane::operator+;
using plane::operator-;
using plane::operator==;

namespace {

/// One leg's instants, appended to those before.
class Leg {
 public:
  Leg(Section& out, const Real& start, const Real& end) : out_(out), start_(start), end_(end) {}

  void rotation(RotationMap map, Real from, Real to) {
    if (to < from) {
      map = mirrored(map);
      from = -from;
      to = -to;
    }
    map = shifted(map, -from);
    const Real span = to - from;
    const Mark first = mark_at(map, Angle{});
    if (span.sign() == 0) {
      begin(first, first);
      return end(first);
    }
    const std::size_t n = map.at.size();
    const bool at_start = n > 0 && compare(map.at[0], Angle{}) == 0;
    begin(first, n == 0 ? map.everywhere : at_start ? map.after[0] : map.after[n - 1]);
    const exact::int128 laps = exact::floor(span / Real(360));
    const Angle last = Angle::of_degrees(span - Real(360) * Real(laps));
    for (exact::int128 lap = 0; lap <= laps; ++lap) {
      for (std::size_t k = lap == 0 && at_start ? 1 : 0; k < n; ++k) {
        if (lap == laps && compare(map.at[k], last) >= 0) break;
        stop((double(lap) * 360 + map.at[k].degrees()) / span.to_double(), map.here[k], map.after[k]);
      }
    }
    end(mark_at(map, last));
  }

 private:
  void begin(Mark at, Mark after) {
    if (out_.stops.empty()) out_.stops.push_back({start_, at, after});
    out_.stops.back().after = after;
    part_ = 0;
  }

  /// Parts of the leg that are printed alike stay in their order.
  void stop(double part, Mark at, Mark after) {
    part_ = std::min(std::max(part, std::nextafter(part_, 1.0)), std::nextafter(1.0, 0.0));
    out_.stops.push_back({start_ + Real::from_double(part_) * (end_ - start_), at, after});
  }

  void end(Mark at) { out_.stops.push_back({end_, at, 0}); }

  Section& out_;
  const Real &start_, &end_;
  double part_ = 0;
};

/// How the moving shape of a distance turns in place, as the other one sees it, at times that ascend; even between.
struct Swing {
  std::vector<Real> times, angles;
  SignMap wanted;  // without its prefix, and in rotation about `at`
  RealPoint at;
};

/// Over the time of the distance; nothing where that is not so.
std::optional<Swing> swing_of(const PreparedWorld& world, const SignMap& asked, const RealPoint& p) {
  Swing out{{}, {}, plain_level(asked), {}};
  Distance& d = out.wanted.distance;
  if (asked.minimum || !asked.more.empty() || is_directional(d)) return std::nullopt;
  const World& scene = world.world();
  const Roles r = world.roles(d);
  const Trajectory b = common_trajectory(scene.motion, r.names.first),
                   a = common_trajectory(scene.motion, r.names.second);
  const bool now = scene.instant && d.prefix == Extremum::kNone, rotation = d.mode == Mode::kRotation;
  out.times = now ? std::vector{*scene.instant} : common_times(scene.motion, b, a);
  for (const Real& time : out.times) {
    const RealPoint place = p + position_at(b, time), seen = place - position_at(a, time);
    const Real of_other = angle_at(a, time);
    out.angles.push_back(angle_at(b, time) - of_other);
    if (out.angles.size() == 1) out.at = seen;
    // Both may turn, about the same point.
    if (!(seen == out.at) || (of_other.sign() != 0 && !(seen == RealPoint{}))) return std::nullopt;
    if (rotation && !(place == centre_of(world, d))) return std::nullopt;
  }
  d.prefix = Extremum::kNone;
  if (rotation) d.vector = {out.at.x * world.step(), out.at.y * world.step()};
  return out;
}

std::shared_ptr<const PreparedWorld> without_motion(const PreparedWorld& world) {
  World still = world.world();
  still.motion = {};
  still.instant.reset();
  return std::make_shared<const PreparedWorld>(std::move(still));
}

/// The signs over all angles.
RotationMap signs_over_angles(const PreparedWorld& world, const Swing& swing) {
  return RotationMaps(*without_motion(world), RealPoint{}, swing.at).sign_map(swing.wanted);
}

/// The longest turn between two of its times.
Real longest_turn(const Swing& swing) {
  Real out;
  for (std::size_t k = 0; k + 1 < swing.angles.size(); ++k)
    out = std::max(out, abs(swing.angles[k + 1] - swing.angles[k]));
  return out;
}

/// The marks of the angles in time.
Section in_time(const RotationMap& map, const Swing& swing) {
  Section out;
  for (std::size_t k = 0; k + 1 < swing.times.size(); ++k)
    Leg(out, swing.times[k], swing.times[k + 1]).rotation(map, swing.angles[k], swing.angles[k + 1]);
  return out;
}

/// Those that occur.
std::vector<Mark> marks_of(const RotationMap& map, const Swing& swing) {
  std::vector<Mark> out;
  if (longest_turn(swing) >= Real(360)) {
    out = map.here;
    out.insert(out.end(), map.after.begin(), map.after.end());
    if (out.empty()) out.push_back(map.everywhere);
    return out;
  }
  const Section line = in_time(map, swing);
  for (const Section::Stop& s : line.stops) out.insert(out.end(), {s.at, s.after});
  out.pop_back();  // beyond the end
  return out;
}

}  // namespace

std::optional<Section> swing_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  constexpr int kMostLaps = 1000;  // of a leg: each has its stops
  if (world.world().instant || formula.sign_maps().empty()) return std::nullopt;
  std::vector<Swing> swings;
  for (const SignMap& wanted : formula.sign_maps()) {
    if (wanted.distance.prefix != Extremum::kNone) return std::nullopt;
    auto swing = swing_of(world, wanted, p);
    if (!swing) return std::nullopt;
    swings.push_back(*std::move(swing));
    if (swings.back().times != swings[0].times || swings.back().angles != swings[0].angles) return std::nullopt;
  }
  if (longest_turn(swings[0]) > Real(360 * kMostLaps)) return std::nullopt;
  std::vector<RotationMap> maps;
  for (const Swing& swing : swings) maps.push_back(signs_over_angles(world, swing));
  std::vector<const RotationMap*> operands;
  for (const RotationMap& m : maps) operands.push_back(&m);
  const RotationMap map =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
  return in_time(map, swings[0]);
}

std::optional<std::int8_t> swing_sign(const PreparedWorld& world, const SignMap& wanted, const RealPoint& p) {
  const std::optional<Swing> swing = swing_of(world, wanted, p);
  if (!swing) return std::nullopt;
  const RotationMap map = signs_over_angles(world, *swing);
  if (swing->times.size() == 1) return mark_at(map, Angle::of_degrees(swing->angles[0]));
  const std::vector<Mark> marks = marks_of(map, *swing);
  const auto [least, greatest] = std::minmax_element(marks.begin(), marks.end());
  return natural_extremum(wanted.distance) == Extremum::kInf ? *least : *greatest;
}

std::optional<AtRest> at_rest(const PreparedWorld& world, const Distance& wanted, const RealPoint& p) {
  const std::optional<Swing> swing = swing_of(world, {wanted, Real()}, p);
  if (!swing || wanted.mode != Mode::kPlain) return std::nullopt;
  const Real& first = swing->angles[0];
  const bool still = std::all_of(swing->angles.begin(), swing->angles.end(), [&](const Real& a) { return a == first; });
  if (!still || !(first / Real(360)).integer()) return std::nullopt;
  return AtRest{without_motion(world), swing->wanted.distance, swing->at};
}

}  // namespace findspace::formula
