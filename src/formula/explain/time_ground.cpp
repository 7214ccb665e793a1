// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "distance/rotation/over_time.h"
#include "formula/explain/common_relaxation.h"
#include "formula/explain/ground.h"
#include "formula/planar/instants.h"
#include "formula/planar/position_functions.h"
#include "plane/query/locate_line.h"

namespace findspace::formula {
namespace {

using distance::OptimalValue;
using distance::PlanarAnswer;
using distance::Sense;
using exact::Real;
using exact::RealPoint;
using plane::LineInterval;
using plane::Mark;
using plane::PathPiece;
using plane::Section;
using plane::operator+;
using plane::operator-;
using plane::operator*;

bool is_empty(const Section& set) {
  return std::none_of(set.stops.begin(), set.stops.end(), [](const Section::Stop& s) { return s.at || s.after; });
}

Section closure(Section set) {
  Mark before = set.before;
  for (Section::Stop& s : set.stops) {
    s.at = std::max({s.at, before, s.after});
    before = s.after;
  }
  return set;
}

/// One of the set: the first that ends an interval and belongs to it, else the middle of an interval.
std::optional<RemainingPlace> instant_in(const Section& set) {
  const std::vector<LineInterval> all = intervals(set, Real(1));
  if (all.empty()) return std::nullopt;
  RemainingPlace out;
  for (const LineInterval& i : all)
    if (!out.time && (i.from_in || i.to_in)) out.time = (i.from_in ? i.from : i.to)->to_double();
  if (!out.time) out.time = ((*all[0].from + *all[0].to) / Real(2)).to_double();
  return out;
}

RealPoint between(const RealPoint& from, const RealPoint& to, const Real& part) {
  if (part == Real(1)) return to;
  return from + part * (to - from);
}

/// The way from p at the instants of a closed set, leg by leg.
std::vector<PathPiece> pieces_within(const Section& set, const Trajectory& way, const RealPoint& p) {
  std::vector<PathPiece> out;
  for (const LineInterval& i : intervals(set, Real(1)))
    for (std::size_t k = 0; k + 1 < way.times.size(); ++k) {
      const Real from = std::max(*i.from, way.times[k]), to = std::min(*i.to, way.times[k + 1]);
      if (from > to || (from == to && !(*i.from == *i.to))) continue;
      const Real lasts = way.times[k + 1] - way.times[k];
      const auto at = [&](const Real& time) {
        return p + between(way.path[k], way.path[k + 1], (time - way.times[k]) / lasts);
      };
      const bool moves = from < to;
      out.push_back({at(from), at(to), moves ? way.path[k + 1] - way.path[k] : RealPoint{}});
    }
  return out;
}

/// A distance at a position as a function of the time.
class InTime {
 public:
  InTime(const PreparedWorld& world, const Distance& distance, const RealPoint& p)
      : world_(world), distance_(distance), p_(p), roles_(world.roles(distance)) {
    if (!over_all_time()) at_rest_ = function_at_rest(world, roles_);
  }

  /// Its least or greatest value over a set that is not empty; nothing above all numbers.
  std::optional<PlanarAnswer> best(const Section& set, Sense sense) const {
    if (over_all_time()) return position_function(world_, distance_)->value(p_);
    if (const auto* smooth = dynamic_cast<const distance::TDistance*>(at_rest_.get()))
      return distance::best_on_pieces(*smooth, pieces_within(closure(set), roles_.path, p_), sense);
    return distance::bisected([&](const Real& level) { return extreme(signs(level), set, sense); });
  }
  /// Of its value minus a level.
  Section signs(const Real& level) const {
    const Motion& motion = world_.motion();
    if (over_all_time()) {
      const plane::SignMap map = position_function(world_, distance_)->sign_map(level);
      return Section::constant(motion.start, motion.end, mark_of(map, locate(map, p_)));
    }
    return plane::section_of_path(at_rest_->sign_map(level), p_, roles_.path.path, roles_.path.times);
  }

 private:
  /// With inf or sup: one value.
  bool over_all_time() const { return distance_.prefix != Extremum::kNone; }
  static Mark extreme(const Section& signs, const Section& set, Sense sense) {
    const std::array<Section, 2> both{signs, set};
    Mark best = sense == Sense::kMinimum ? 2 : -2;
    overlay_sections(both, [&](std::span<const Mark> m) {
      if (m[1] != 0) best = sense == Sense::kMinimum ? std::min(best, m[0]) : std::max(best, m[0]);
      return m[1];
    });
    return best;
  }

  const PreparedWorld& world_;
  const Distance& distance_;
  const RealPoint& p_;
  Roles roles_;
  distance::PositionFunctionPointer at_rest_;
};

class TimeGround : public KnownCells {
 public:
  TimeGround(const PreparedWorld& world, RealPoint p, const Demands& demands)
      : KnownCells(demands), world_(world), p_(std::move(p)), signs_(signs_in_time(world, demands.formula(), p_)) {
    Section time = Section::constant(world.motion().start, world.motion().end, 1);
    time.before = time.stops.back().after = 0;
    signs_.push_back(std::move(time));
    std::set<MetDemands> distinct;
    instants([&](std::span<const Mark> signs) {
      distinct.insert(met_at(demands, signs));
      return true;
    });
    know(distinct);
  }

  LevelChange best(std::size_t k, int sign, Sense sense) override {
    const Section set = instants([&](std::span<const Mark> signs) { return holds_without(demands(), signs, k, sign); });
    OptimalValue best;
    best.sense = sense;
    if (is_empty(set)) return changed(demands(), k, best, false);
    const InTime f(world_, demands().formula().atoms()[k].distance, p_);
    const std::optional<PlanarAnswer> found = f.best(set, sense);
    if (!found || found->minus_infinity) {
      best.unbounded = best.maximum() == !found;
      return changed(demands(), k, best, false);
    }
    const distance::Enclosure ends = found->bounds();
    const std::optional<Real>& reached = best.maximum() ? ends.lower : ends.upper;
    if (found->proven)
      best.set_exact(found->value, found->way);
    else
      best.set_enclosed(reached, best.maximum() ? ends.upper : ends.lower, found->way);
    const Section there = as_good(f.signs(*reached), set, sense);
    best.scale(world_.step());
    LevelChange out = changed(demands(), k, best, found->proven && !is_empty(there));
    const auto place = instant_in(is_empty(there) ? as_good(f.signs(*reached), closure(set), sense) : there);
    if (out.kind == LevelChange::Kind::kTo && place) out.place = *place;
    return out;
  }
  CommonRelaxation together(const std::optional<Real>& enough) override {
    const FindPlace find = [this](const Formula& near) { return instant_in(instants_at(world_, near, p_)); };
    return common_relaxation(find, world_.step(), demands(), enough);
  }

 private:
  /// {instant : rule(signs then)}
  template <class Rule>
  Section instants(const Rule& rule) const {
    return overlay_sections(signs_, [&](std::span<const Mark> signs) {
      return Mark(signs.back() != 0 && rule(signs.first(signs.size() - 1)) ? 1 : 0);
    });
  }
  /// Where the sign says that a value is as good as the best.
  static Section as_good(const Section& signs, const Section& set, Sense sense) {
    const std::array<Section, 2> both{signs, set};
    return overlay_sections(both, [&](std::span<const Mark> m) {
      return Mark(m[1] != 0 && (sense == Sense::kMinimum ? m[0] <= 0 : m[0] >= 0) ? 1 : 0);
    });
  }

  const PreparedWorld& world_;
  RealPoint p_;
  std::vector<Section> signs_;  // and last where there is time
};

}  // namespace

std::unique_ptr<Ground> time_ground(const PreparedWorld& world, const RealPoint& p, const Demands& demands) {
  return std::make_unique<TimeGround>(world, p, demands);
}

}  // namespace findspace::formula
