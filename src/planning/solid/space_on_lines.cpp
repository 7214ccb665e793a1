// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_on_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "findspace/error.h"
#include "space/rays/ray_intervals.h"

namespace findspace::planning {

using exact::Real;
using space::Point;
using space::RayGrid;
using space::RayInterval;
using space::RealVector;

namespace {

constexpr int kMostRounds = 100;
/// Lines that are looked at exactly, the most promising first, until one has a grid point in the set.
constexpr std::size_t kMostTried = 1000;

using Place = std::array<double, 3>;

struct Candidate {
  std::vector<double> key;
  Place at{};
};

/// The whole numbers of an interval of the set.
struct Whole {
  std::optional<std::int64_t> low, high;  // none: it goes on for ever
};

class LineSearch {
 public:
  LineSearch(const LinesAsked& lines, const SpaceGoals& goals) : lines_(lines), goals_(goals), steps_(goals.all) {
    for (const RealVector& tie : tie_forms()) steps_.push_back({tie, std::nullopt});
    for (std::size_t k = 0; k < 3; ++k) {
      if (!goals.fixed[k]) continue;
      const auto whole = goals.fixed[k]->integer();
      if (!whole || *whole > exact::kRayLimit || *whole < -exact::kRayLimit)
        throw Error(ErrorCode::kUnsupported, "a condition on a coordinate is off the grid, where lines do not tell");
      fixed_[k] = static_cast<std::int64_t>(*whole);
    }
  }

  SpaceBest run() {
    SpaceBest out;
    out.on_lines = true;
    std::optional<Point> at = first();
    if (!at && !unbounded_) return out;
    for (int round = 0; at && !unbounded_ && round < kMostRounds; ++round) {
      const Point before = *at;
      for (const int axis : {2, 1, 0}) {
        take_better(line(axis, *at), *at);
        for (const int plane : {1, 2}) take_better(lines_in_plane(axis, (axis + plane) % 3, *at), *at);
      }
      if (*at == before) break;
    }
    if (unbounded_) {
      out.attained = false;
      out.unbounded = true;
      out.on_lines = false;
      out.values.push_back(std::nullopt);
      return out;
    }
    out.at = space::real(*at);
    return out;
  }

 private:
  static std::int64_t& coordinate(Point& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

  /// Places for `count` lines between low and high.
  void spread(std::int64_t low, std::int64_t high, std::int64_t& at, std::int64_t& by, int& count) const {
    const std::int64_t width = std::max<std::int64_t>(high - low, 1);
    count = static_cast<int>(std::min<std::int64_t>(width, lines_.count));
    by = (width + count - 1) / count;
    at = low + by / 2;
  }

  /// Lines along z through grid points.
  RayGrid grid() const {
    RayGrid grid{2, 1, 0, 0, 1, 1, 1, 1};
    if (fixed_[0]) grid.u = *fixed_[0];
    if (fixed_[1]) grid.v = *fixed_[1];
    if (!fixed_[0]) spread(lines_.low.x, lines_.high.x, grid.u, grid.du, grid.nu);
    if (!fixed_[1]) spread(lines_.low.y, lines_.high.y, grid.v, grid.dv, grid.nv);
    return grid;
  }

  std::vector<double> key(const Place& p) const {
    std::vector<double> out;
    for (const SpaceGoal& goal : steps_) {
      double value = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = goal.point ? p[k] - (*goal.point)[k].to_double() : goal.form[k].to_double();
        value += goal.point ? c * c : c * p[k];
      }
      out.push_back(value);
    }
    return out;
  }

  /// The best place of an interval along z, but for rounding.
  Candidate candidate(const RayInterval& r) const {
    Place p = r.at;
    const SpaceGoal& goal = deciding(2);
    double c = goal.point                ? std::clamp((*goal.point)[2].to_double(), r.from, r.to)
               : goal.form[2].sign() > 0 ? r.from
                                         : r.to;
    if (fixed_[2]) c = static_cast<double>(*fixed_[2]);
    p[2] = std::isfinite(c) ? c : std::clamp(0.0, r.from, r.to);
    return {key(p), p};
  }

  /// The first goal that depends on the coordinate.
  const SpaceGoal& deciding(int axis) const {
    return *std::find_if(steps_.begin(), steps_.end(), [&](const SpaceGoal& g) {
      return g.point || g.form[static_cast<std::size_t>(axis)].sign() != 0;
    });
  }

  std::optional<Point> first() {
    std::vector<Candidate> all;
    const RayGrid lines = grid();
    const space::RaySourcePointer source = lines_.source(lines);
    space::each_row(*source, [&](int j, space::RayRow&& row) {
      space::each_interval(lines, j, row, [&](const RayInterval& r) {
        const auto z = fixed_[2] ? static_cast<double>(*fixed_[2]) : r.from;
        if (z >= r.from && z <= r.to) all.push_back(candidate(r));
      });
    });
    const std::size_t tried = std::min(all.size(), kMostTried);
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(tried), all.end(),
                      [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
    for (std::size_t k = 0; k < tried; ++k) {
      const Point through{std::llround(all[k].at[0]), std::llround(all[k].at[1]), 0};
      if (const auto found = best_over(line(2, through))) return found;
      if (unbounded_) return std::nullopt;
    }
    return std::nullopt;
  }

  /// The line along the axis through p.
  static RayGrid line(int axis, const Point& p) {
    Point at = p;
    return {axis, 1, coordinate(at, (axis + 1) % 3), coordinate(at, (axis + 2) % 3), 1, 1, 1, 1};
  }

  /// Lines along the axis within the plane through p that is normal to another one.
  RayGrid lines_in_plane(int axis, int normal, const Point& p) const {
    RayGrid grid = line(axis, p);
    const int across = 3 - axis - normal;
    Point low = lines_.low, high = lines_.high;
    if (fixed_[static_cast<std::size_t>(across)]) return grid;
    const bool first = across == (axis + 1) % 3;
    spread(coordinate(low, across), coordinate(high, across), first ? grid.u : grid.v, first ? grid.du : grid.dv,
           first ? grid.nu : grid.nv);
    return grid;
  }

  void take_better(const RayGrid& grid, Point& at) {
    if (unbounded_ || fixed_[static_cast<std::size_t>(grid.axis)]) return;
    const auto found = best_over(grid);
    if (found && compare_goals(*found, at) < 0) at = *found;
  }

  /// The best grid point of the set on the lines; nothing where there is none, or no bound.
  std::optional<Point> best_over(const RayGrid& grid) {
    const space::RaySourcePointer source = lines_.source(grid);  // its rows' places refer to it
    std::optional<Point> best;
    for (int j = 0; j < grid.nv; ++j) {
      const space::RayRow row = source->row(j);
      for (int i = 0; i < grid.nu; ++i) {
        Point p;
        coordinate(p, (grid.axis + 1) % 3) = grid.u_at(i);
        coordinate(p, (grid.axis + 2) % 3) = grid.v_at(j);
        for (const Whole& part : parts_of(row, i)) {
          const auto found = best_of(part, grid.axis, p);
          if (unbounded_) return std::nullopt;
          if (found && (!best || compare_goals(*found, *best) < 0)) best = found;
        }
      }
    }
    return best;
  }

  /// The grid points of the set on line i of a row, as intervals.
  static std::vector<Whole> parts_of(const space::RayRow& row, int i) {
    std::vector<Whole> out;
    bool in = row.before[static_cast<std::size_t>(i)] <= 0;
    Whole now;
    const auto close = [&](const std::optional<std::int64_t>& high) {
      now.high = high;
      if (!now.low || !now.high || *now.low <= *now.high) out.push_back(now);
    };
    for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
      const space::RayEvent& event = row.events[static_cast<std::size_t>(e)];
      const Real place = event.at.to_real();
      const auto down = static_cast<std::int64_t>(exact::floor(place));
      const bool whole = place.integer().has_value(), here = event.here <= 0, after = event.after <= 0;
      if (in) close(whole && !here ? down - 1 : down);
      if (!in && here && !after && whole) {
        now.low = down;
        close(down);
      }
      if (after) now.low = whole && here && !in ? down : down + 1;
      in = after;
    }
    if (in) close(std::nullopt);
    return out;
  }

  /// The best of them on the line along the axis through p.
  std::optional<Point> best_of(const Whole& part, int axis, const Point& p) {
    const SpaceGoal& goal = deciding(axis);
    const auto k = static_cast<std::size_t>(axis);
    std::int64_t c = 0;
    if (fixed_[k]) {
      c = *fixed_[k];
      if ((part.low && c < *part.low) || (part.high && *part.high < c)) return std::nullopt;
    } else if (goal.point) {
      c = static_cast<std::int64_t>(exact::floor((*goal.point)[k] + Real::ratio(1, 2)));
      if (part.low) c = std::max(c, *part.low);
      if (part.high) c = std::min(c, *part.high);
    } else {
      const auto& end = goal.form[k].sign() > 0 ? part.low : part.high;
      unbounded_ = unbounded_ || (!end && goals_.all.size() > goal_number(goal));
      if (unbounded_) return std::nullopt;
      c = end ? *end : part.low.value_or(part.high.value_or(0));
    }
    Point q = p;
    coordinate(q, axis) = c;
    return q;
  }

  std::size_t goal_number(const SpaceGoal& goal) const { return static_cast<std::size_t>(&goal - steps_.data()); }

  int compare_goals(const Point& p, const Point& q) const {
    const RealVector a = space::real(p), b = space::real(q);
    for (const SpaceGoal& goal : steps_) {
      const auto value = [&](const RealVector& x) {
        if (!goal.point) return space::dot(goal.form, x);
        const RealVector off = space::minus(x, *goal.point);
        return space::dot(off, off);
      };
      if (const int order = compare(value(a), value(b)); order != 0) return order;
    }
    return 0;
  }

  const LinesAsked& lines_;
  const SpaceGoals& goals_;
  std::vector<SpaceGoal> steps_;  // the goals, then the rule for ties
  std::array<std::optional<std::int64_t>, 3> fixed_;
  bool unbounded_ = false;
};

}  // namespace

SpaceBest best_on_lines(const LinesAsked& lines, const SpaceGoals& goals) { return LineSearch(lines, goals).run(); }

}  // namespace findspace::planning
