// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/swing.h"

#include <algorithm>
#include <cmath>

#include "formula/language/which.h"
#include "formula/planar/rotation_maps.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::formula {

using exact::Angle;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;
using plane::Section;

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

bool is_instant_of_plain(const SignMap& m) {
  return !m.minimum && m.distance.prefix == Extremum::kNone && plain_level(m).distance.mode == Mode::kPlain;
}

/// The rotation of the moving shapes, where that is all that moves and the maps are of instants.
std::optional<Trajectory> swinging(const World& world, const std::vector<SignMap>& maps) {
  if (!std::all_of(maps.begin(), maps.end(), is_instant_of_plain)) return std::nullopt;
  const auto of = [&](const std::string& name) { return world.motion.of.find(name); };
  const auto first = of(world.moving.at(0)), none = world.motion.of.end();
  if (first == none || world.motion.of.size() != world.moving.size()) return std::nullopt;
  for (const std::string& name : world.moving)
    if (of(name) == none || !(of(name)->second == first->second)) return std::nullopt;
  const std::vector<RealPoint>& path = first->second.path;
  const bool stays =
      std::all_of(path.begin(), path.end(), [&](const RealPoint& p) { return p.x == path[0].x && p.y == path[0].y; });
  return stays ? std::optional(first->second) : std::nullopt;
}

/// map(angles) over all angles of the shapes where they swing.
template <class Map>
RotationMap over_angles(const PreparedWorld& world, const Trajectory& way, const RealPoint& p, const Map& map) {
  World still = world.world();
  still.motion = {};
  const PreparedWorld prepared(std::move(still));
  return map(RotationMaps(prepared, RealPoint{}, {p.x + way.path[0].x, p.y + way.path[0].y}));
}

}  // namespace

std::optional<Section> swing_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  const std::optional<Trajectory> way = swinging(world.world(), formula.sign_maps());
  if (!way) return std::nullopt;
  const RotationMap map = over_angles(world, *way, p, [&](const RotationMaps& m) { return m.feasible(formula); });
  const std::vector<Real> times = common_times(world.motion(), *way, *way);
  Section out;
  for (std::size_t k = 0; k + 1 < times.size(); ++k)
    Leg(out, times[k], times[k + 1]).rotation(map, angle_at(*way, times[k]), angle_at(*way, times[k + 1]));
  return out;
}

std::optional<std::int8_t> swing_sign(const PreparedWorld& world, const SignMap& wanted, const RealPoint& p) {
  Distance instant = wanted.distance;
  const bool least = natural_extremum(instant) == Extremum::kInf;
  instant.prefix = Extremum::kNone;
  const auto occurs = [&](Relation relation) -> std::optional<bool> {
    const auto line = swing_at(world, Formula(compare(instant, relation, wanted.level)), p);
    if (!line) return std::nullopt;
    return std::any_of(line->stops.begin(), line->stops.end(),
                       [](const Section::Stop& s) { return s.at != 0 || s.after != 0; });
  };
  const auto beyond = occurs(least ? Relation::kLess : Relation::kGreater);
  if (!beyond) return std::nullopt;
  if (*beyond) return std::int8_t(least ? -1 : 1);
  if (*occurs(Relation::kEqual)) return std::int8_t(0);
  return std::int8_t(least ? 1 : -1);
}

std::optional<std::int8_t> swing_sign_now(const PreparedWorld& world, const SignMap& wanted, const RealPoint& p) {
  const std::optional<Trajectory> way = swinging(world.world(), {wanted});
  if (!way) return std::nullopt;
  const RotationMap map = over_angles(world, *way, p, [&](const RotationMaps& m) { return m.sign_map(wanted); });
  return mark_at(map, Angle::of_degrees(angle_at(*way, *world.world().instant)));
}

}  // namespace findspace::formula
