// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/instants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "exact/margins/formula.h"
#include "exact/margins/rounding.h"
#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_check.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/regions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/swing.h"
#include "plane/base/parallel.h"
#include "plane/base/subdivide.h"

namespace findspace::formula {

using distance::RotatingMotion;
using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Section;

namespace {

constexpr int kMostLooks = 1000;

/// A part of a leg, and the signs that may occur in it.
struct Piece {
  std::size_t leg;
  double from, to;
  Mark low = -1, high = 1;
  bool open() const { return low < high && to - from > margin::kNarrowestTime; }
  bool operator<(const Piece& other) const { return to - from < other.to - other.from; }
};

using Look = std::function<void(Piece&)>;

/// Halves the widest pieces whose signs are open.
std::vector<Piece> looked_through(std::size_t legs, int most, const Look& look) {
  plane::Subdivision<Piece> queue;
  std::vector<Piece> done;
  const auto add = [&](Piece piece) {
    look(piece);
    if (piece.open())
      queue.push(piece);
    else
      done.push_back(piece);
  };
  for (std::size_t leg = 0; leg < legs; ++leg) add({leg, 0, 1});
  queue.run((most + 1) / 2, [](const Piece&) { return false; },
            [&](const Piece& piece) {
              const double middle = piece.from + (piece.to - piece.from) / 2;
              add({piece.leg, piece.from, middle});
              add({piece.leg, middle, piece.to});
            });
  done.insert(done.end(), queue.left().begin(), queue.left().end());
  std::sort(done.begin(), done.end(),
            [](const Piece& a, const Piece& b) { return a.leg != b.leg ? a.leg < b.leg : a.from < b.from; });
  return done;
}

/// `least_only`: the value is a lower bound of the distance, which is not above 0 where the value is not. Of a
/// penetration the signs are those of the gap.
Look by_value(const RotatingMotion& f, const RealPoint& p, double level, bool least_only) {
  return [&f, &p, level, least_only](Piece& piece) {
    const auto v = f.look(p, piece.leg, Real::from_double(piece.from + (piece.to - piece.from) / 2));
    if (!v) return;
    const double off = f.rate(piece.leg) * (piece.to - piece.from) / 2 * margin::kUpward + v->off;
    const double at_least = f.rated_below_zero() ? level : std::max(level, 0.0), at_most = least_only ? 0 : level;
    if (v->rated - off > at_least) piece.low = 1;
    if (v->rated + off < at_most) piece.high = -1;
  };
}

/// From the signs of a gap minus -level those of the penetration, max(0, -gap), minus the level.
void turn_to_penetration(std::vector<Piece>& pieces, const Real& level) {
  const Mark floor = Mark(-level.sign());
  for (Piece& piece : pieces) {
    const Mark low = piece.low;
    piece.low = std::max(floor, Mark(-piece.high));
    piece.high = std::max(floor, Mark(-low));
  }
}

Look by_circles(const distance::RotationInTime& f, const Real& level) {
  return [&f, level](Piece& piece) {
    const distance::SignRange s =
        f.signs({piece.leg, Real::from_double(piece.from), Real::from_double(piece.to)}, level);
    piece.low = s.low;
    piece.high = s.high;
  };
}

/// The lower (upper) signs along the time.
Section line_of(const std::vector<Piece>& pieces, const std::vector<Real>& times, bool low) {
  const auto mark = [low](const Piece& p) { return low ? p.low : p.high; };
  const auto worse = [low](Mark a, Mark b) { return low ? std::min(a, b) : std::max(a, b); };
  Section out;
  out.before = mark(pieces[0]);
  Mark last = out.before;
  for (const Piece& p : pieces) {
    const Real at = times[p.leg] + Real::from_double(p.from) * (times[p.leg + 1] - times[p.leg]);
    out.stops.push_back({at, worse(last, mark(p)), mark(p)});
    last = mark(p);
  }
  out.stops.push_back({times.back(), last, last});
  return out;
}

/// The signs of one map.
Section signs_in_time(const PreparedWorld& world, const SignMap& asked, const RealPoint& p) {
  const SignMap wanted = plain_level(asked);
  const Motion& motion = world.motion();
  const bool whole_time = wanted.distance.prefix != Extremum::kNone;
  const Roles r = world.roles(wanted.distance);
  if (r.rotating) refuse(wanted.distance, "the instants of shapes that rotate are known between bounds only");
  if (whole_time) {
    const plane::SignMap map = sign_map(world, wanted);
    return Section::constant(motion.start, motion.end, mark_of(map, locate(map, p)));
  }
  const plane::SignMap map = wanted.minimum ? minimiser_map(least_at_rest(world, r))
                                            : function_at_rest(world, r)->sign_map(wanted.level / world.step());
  return plane::section_of_path(map, p, r.path.path, r.path.times);
}

/// The lower and the upper signs of a distance in rotation.
std::array<Section, 2> signs_in_rotation(const PreparedWorld& world, const SignMap& wanted, const Roles& r,
                                         const RealPoint& p, const std::vector<Real>& times) {
  const distance::RotationInTime f = rotation_in_time(world, r, p, false);
  const std::vector<Piece> pieces = looked_through(times.size() - 1, kMostLooks / 4, by_circles(f, wanted.level));
  return {line_of(pieces, times, true), line_of(pieces, times, false)};
}

/// The lower and the upper signs of a plain distance of shapes that rotate.
std::array<Section, 2> signs_of_turning(const PreparedWorld& world, const SignMap& wanted, const Roles& r,
                                        const RealPoint& p, const std::vector<Real>& times) {
  if (wanted.minimum || r.wanted.mode != Mode::kPlain)
    throw Error(ErrorCode::kUnsupported,
                written(r.wanted) + ": only distances in all directions are computed of shapes that rotate in time");
  Which which = r.which();
  const bool eta = which == Which::kEta1 || which == Which::kEta2;
  const bool first = which == Which::kEta1 || which == Which::kDelta1,
             second = which == Which::kEta2 || which == Which::kDelta2;
  // Containment up to level 0 is mu; above, mu is less, and where it is not above 0 nor are eta1 and delta1.
  if (first || second) which = eta ? Which::kMu : Which::kMuBack;
  const bool least_only = second || (first && wanted.level.sign() > 0);
  const RotatingMotion f(world.shape(r.names.first), world.shape(r.names.second), which,
                         rotation_poses(world, r, false), world.step().to_double());
  const bool penetration = which == Which::kPenetration;
  const double steps = (wanted.level / world.step()).to_double(), level = penetration ? -steps : steps;
  std::vector<Piece> pieces =
      looked_through(times.size() - 1, least_only ? kMostLooks / 4 : kMostLooks, by_value(f, p, level, least_only));
  if (second) {
    for (Piece& piece : pieces) piece.high = 1;
  }
  if (penetration) turn_to_penetration(pieces, wanted.level);
  return {line_of(pieces, times, true), line_of(pieces, times, false)};
}

std::array<Section, 2> sign_bounds_in_time(const PreparedWorld& world, const SignMap& wanted, const Roles& r,
                                           const RealPoint& p) {
  const std::vector<Real> times = common_times(world.motion(), common_trajectory(world.motion(), r.names.first),
                                               common_trajectory(world.motion(), r.names.second));
  return in_rotation(wanted) && !wanted.minimum ? signs_in_rotation(world, wanted, r, p, times)
                                                : signs_of_turning(world, wanted, r, p, times);
}

}  // namespace

std::vector<Section> signs_in_time(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  std::vector<Section> out(formula.sign_maps().size());
  plane::parallel_for(out.size(), [&](std::size_t k) { out[k] = signs_in_time(world, formula.sign_maps()[k], p); });
  return out;
}

Section instants_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  std::vector<Section> lines = signs_in_time(world, formula, p);
  // Also where there are no atoms.
  lines.push_back(Section::constant(world.motion().start, world.motion().end, 0));
  Section line = overlay_sections(lines, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
  line.before = line.stops.back().after = 0;  // there is no time outside the motion
  return line;
}

InstantBounds instant_bounds_at(const PreparedWorld& world, const Formula& formula, const RealPoint& p) {
  std::vector<Section> lines;
  for (const SignMap& map : formula.sign_maps()) {
    const SignMap m = plain_level(map);
    const Roles r = world.roles(m.distance);
    const bool between_bounds = r.rotating || in_rotation(m);
    const auto rest = r.rotating && !m.minimum ? at_rest(world, m.distance, p) : std::nullopt;
    if (between_bounds && !rest && m.distance.prefix == Extremum::kNone) {
      for (Section& s : sign_bounds_in_time(world, m, r, p)) lines.push_back(std::move(s));
      continue;
    }
    const Section line = between_bounds
                             ? Section::constant(world.motion().start, world.motion().end, sign_at(world, m, p))
                             : signs_in_time(world, m, p);
    lines.insert(lines.end(), 2, line);
  }
  const auto limited = [&](Mark wanted) {
    Section out =
        overlay_sections(lines, [&](std::span<const Mark> marks) { return Mark(certainty(formula, marks) >= wanted); });
    out.before = out.stops.back().after = 0;  // there is no time outside the motion
    return out;
  };
  return {limited(2), limited(1)};
}

}  // namespace findspace::formula
