// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/boundary_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "distance/search/boundary_columns.h"
#include "distance/search/strict_work.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kRounds = 3;  // of tangents in a cell

/// Cells after which it is asked for a place of zero clearance, as most of what is left may be such.
constexpr int kAskAt = 3000;

struct BoundaryCell : TetrahedralCell {
  std::vector<int> out, in;  // the functions that are not satisfied in all of the cell
  std::vector<int> more;     // likewise, of LazyConstraints
  double key = 0;            // nothing in it is better
  int depth = 0;
  /// Of cells as good as each other the smallest comes first: where all of a boundary is as near, any place of it will
  /// do.
  bool operator<(const BoundaryCell& other) const {
    return key > other.key || (key == other.key && depth < other.depth);
  }
};

/// The objective is minimised: the distance, or minus the least of those that are to be great.
class BoundarySearch {
 public:
  BoundarySearch(const Constraints& constraints, const TouchingConstraint* distance,
                 std::span<const ConvexDistance> far, double size, const Incumbent& known,
                 double nearer = margin::kNearerAtAll)
      : constraints_(constraints), distance_(distance), far_(far), size_(size), nearer_(nearer), known_(known) {
    best_.value = exact::kInfinity;
    if (!constraints.more) return;
    nearer_ = constraints.more->nearer();
    last_cell_ = constraints.more->last_cell();
  }

  BoundaryPlace run(std::span<const Tetrahedron> domain, double floor, const Until* until = nullptr) {
    BoundaryCell all;
    all.out.resize(constraints_.reverse_convex.size());
    all.in.resize(constraints_.convex.size());
    std::iota(all.out.begin(), all.out.end(), 0);
    std::iota(all.in.begin(), all.in.end(), 0);
    domain_ = domain;
    until_ = until;
    const long least_left = until ? plane::cells_left() - until->cells : 0;
    const auto spent = [&] {
      return (constraints_.more && constraints_.more->spent()) || (until && plane::cells_left() <= least_left) ||
             strictly_spent();
    };
    if (constraints_.more || nearer_ > margin::kNearerAtAll) ask();
    for (const Tetrahedron& t : domain) add(t, all, floor, 0);
    double left = exact::kInfinity;
    long count = 0;
    bool ended = false;
    const auto settled = [&](const BoundaryCell& top) {
      if (ended || !(top.key < wanted())) return true;
      const bool enough = until && decided(*until, top.key);
      if (!enough && count++ == kAskAt) ask();
      best_.complete = enough || !spent();
      if (!enough && best_.complete) return false;
      left = std::min(left, top.key);
      return true;
    };
    const auto end =
        queue_.run(until ? kMostSearchCells : plane::allowed(kMostSearchCells), settled, [&](const BoundaryCell& top) {
          plane::count_cell();
          std::size_t a = 0, b = 1;
          const double edge = longest_edge(top.corner, a, b);
          ended = edge < last_cell_ * size_;
          if (!ended && edge >= margin::kSmallestCell * size_) return split(top, a, b);
          if (top.key < left) {
            left = top.key;
            best_.unresolved = centre(top.corner);
          }
          ask();
        });
    if (end == plane::SubdivisionEnd::kSpent) {
      best_.complete = false;
      left = std::min(left, queue_.best().key);
    }
    best_.bound = std::min({best_.value, wanted(), left});
    return best_;
  }

 private:
  /// Whether all between `lowest` and the best value known is on one side of the level, and nearly as far from it, or
  /// all is next to it.
  bool decided(const Until& until, double lowest) const {
    const double low = lowest - until.level, high = best_.value - until.level;
    const double near = low > 0 ? low : -high, far = low > 0 ? high : -low;
    if (near > 0) return until.share == 0 || near >= until.share * far;
    return until.blur > 0 && low >= -until.blur && high <= until.blur;
  }

  /// What is not less than this need not be looked for.
  double wanted() const {
    const double better = std::isfinite(best_.value) ? best_.value - nearer_ * size_ : best_.value;
    if (!until_ || !(until_->blur > 0)) return better;
    const double off = best_.value - until_->level;
    if (off > until_->blur) return std::min(better, until_->level + until_->blur);
    const double lower = until_->share > 0 ? off / until_->share : off;
    return std::min(better, until_->level + std::min(lower, -until_->blur));
  }

  double objective(const Vector& x) const {
    if (distance_) return (*distance_)(x).value;
    double least = exact::kInfinity;
    for (const ConvexDistance& f : far_) least = std::min(least, f(x));
    return -least;
  }

  /// By the functions that are not satisfied in all of the cell, or by all. In doubles: what this decides, and where an
  /// exact predicate follows, is said at margin::kAllowed.
  bool allowed(const Vector& x, const BoundaryCell* cell) const {
    const double tolerance = margin::kAllowed * size_;
    const auto out = [&](const ConvexDistance& f) { return f(x) >= tolerance; };
    const auto in = [&](const TouchingConstraint& f) { return f(x).value <= -tolerance; };
    if (!cell)
      return std::all_of(constraints_.reverse_convex.begin(), constraints_.reverse_convex.end(), out) &&
             std::all_of(constraints_.convex.begin(), constraints_.convex.end(), in) &&
             (!constraints_.more || constraints_.more->allows(x, {}));
    return std::all_of(cell->out.begin(), cell->out.end(),
                       [&](int i) { return out(constraints_.reverse_convex[static_cast<std::size_t>(i)]); }) &&
           std::all_of(cell->in.begin(), cell->in.end(),
                       [&](int i) { return in(constraints_.convex[static_cast<std::size_t>(i)]); }) &&
           std::all_of(cell->more.begin(), cell->more.end(),
                       [&](int i) { return constraints_.more->beyond(i, x) >= tolerance; }) &&
           (!constraints_.more || constraints_.more->allows(x, cell->more));
  }

  void offer(const Vector& x, const BoundaryCell& cell) {
    const double value = objective(x);
    if (value < best_.value && allowed(x, &cell)) take_about(x, value);
  }

  bool in_domain(const Vector& x) const {
    return std::any_of(domain_.begin(), domain_.end(), [&](const Tetrahedron& t) { return beyond_faces(t, x) <= 0; });
  }

  void take_about(const Vector& x, double value) {
    take(x, value);
    if (distance_) go_nearer(x);
  }

  void take(const Vector& x, double value) {
    best_.value = value;
    best_.place = x;
    best_.found = true;
    best_.known = false;
  }

  /// On the straight way from x to where the distance is from: as far as that is allowed. So complete faces of the
  /// boundary that are as near as each other are settled at once.
  void go_nearer(const Vector& x) {
    const Touching at = (*distance_)(x);
    double allowed_by = 0, by = at.value;
    for (int k = 0; k < 50 && by - allowed_by > nearer_ * size_; ++k) {
      const double middle = k == 0 ? by : (allowed_by + by) / 2;
      const Vector y = x - space::scaled(middle, at.slope);
      if (in_domain(y) && allowed(y, nullptr)) {
        allowed_by = middle;
        const double value = objective(y);
        if (value < best_.value) take(y, value);
      } else {
        by = middle;
      }
    }
  }

  void ask() {
    if (asked_ || !known_) return;
    asked_ = true;
    const auto value = known_();
    if (value && *value < best_.value) {
      best_.value = *value;
      best_.found = false;
      best_.known = true;
    }
  }

  /// Functions that cannot be 0 or beyond in the cell are left out; false where one allows nothing of the cell.
  bool keep_near(const Tetrahedron& corner, const std::vector<int>& out, const std::vector<int>& in, double edge,
                 BoundaryCell& cell, std::vector<Column>& columns) const {
    const Vector middle = centre(corner);
    for (const int i : out) {
      const ConvexDistance& f = constraints_.reverse_convex[static_cast<std::size_t>(i)];
      Column c{};
      for (std::size_t v = 0; v < 4; ++v) c[v] = f(corner[v]);
      if (most(c) < -margin::kDistanceNoise * size_) return false;
      if (least(c) > edge + margin::kDistanceNoise * size_) continue;
      cell.out.push_back(i);
      columns.push_back(c);
    }
    for (const int i : in) {
      const Touching at = constraints_.convex[static_cast<std::size_t>(i)](middle);
      if (at.value < -edge - margin::kDistanceNoise * size_) continue;
      const Column c = less(0, tangent(at, middle, corner));
      if (most(c) < -margin::kDistanceNoise * size_) return false;
      cell.in.push_back(i);
      columns.push_back(c);
    }
    return true;
  }

  /// Likewise of LazyConstraints.
  bool keep_near_more(const Tetrahedron& corner, const std::vector<int>& known, double edge, BoundaryCell& cell,
                      std::vector<Column>& columns) {
    const auto take = [&](int i) {
      const Column c = constraints_.more->column(i, corner);
      if (most(c) < -margin::kDistanceNoise * size_) return false;
      if (least(c) > edge + margin::kDistanceNoise * size_) return true;
      cell.more.push_back(i);
      columns.push_back(c);
      return true;
    };
    const std::vector<int> made = constraints_.more->near(corner, edge, known);
    for (const Vector& x : constraints_.more->places(corner)) {
      if (const double value = objective(x); value < best_.value) take_about(x, value);
    }
    return std::all_of(made.begin(), made.end(), take);
  }

  /// What no place of the cell is better than, at the corners: linear, or concave.
  std::vector<Column> floors_of(const Tetrahedron& corner) const {
    if (distance_) {
      const Vector middle = centre(corner);
      return {tangent((*distance_)(middle), middle, corner)};
    }
    std::vector<Column> out(far_.size());
    for (std::size_t k = 0; k < far_.size(); ++k) {
      for (std::size_t v = 0; v < 4; ++v) out[k][v] = -far_[k](corner[v]);
    }
    return out;
  }

  void add(const Tetrahedron& corner, const BoundaryCell& of, double floor, int depth) {
    BoundaryCell cell;
    cell.corner = corner;
    cell.depth = depth;
    const std::vector<Column> objectives = floors_of(corner);
    cell.key = floor;
    for (const Column& c : objectives) cell.key = std::max(cell.key, least(c));
    if (!(cell.key < wanted())) return;
    std::size_t a = 0, b = 1;
    std::vector<Column> columns;
    const double edge = longest_edge(corner, a, b);
    if (!keep_near(corner, of.out, of.in, edge, cell, columns)) return;
    if (constraints_.more && !keep_near_more(corner, of.more, edge, cell, columns)) return;
    offer(centre(corner), cell);
    // First what is a little better than the best, so that this comes as near to the least as rounding lets it; the
    // cell is kept only where something clearly better may be.
    for (const double target : {best_.value, wanted()}) {
      std::vector<Column> all = columns;
      for (const Column& c : objectives) {
        if (std::isfinite(target)) all.push_back(less(target, c));
      }
      if (!try_best(all, target, corner, cell)) return;
    }
    if (cell.key < wanted()) queue_.push(std::move(cell));
  }

  /// Offers places at which the least of the columns is greatest, with tangents there; false where that is less than 0.
  bool try_best(std::vector<Column>& columns, double target, const Tetrahedron& corner, const BoundaryCell& cell) {
    if (columns.empty()) return true;
    for (int round = 0; round < (constraints_.more ? 1 : kRounds); ++round) {
      const HighestPlace high = highest_place(columns, corner);
      if (high.value < -margin::kDistanceNoise * size_ - margin::kLpNoise * high.spread) return false;
      offer(high.place, cell);
      if (!touch(high.place, target, corner, cell, columns)) break;
    }
    return true;
  }

  /// Adds the tangents at x of what x breaks; false where there is none.
  bool touch(const Vector& x, double target, const Tetrahedron& corner, const BoundaryCell& cell,
             std::vector<Column>& columns) const {
    const std::size_t before = columns.size();
    const double tolerance = margin::kDistanceNoise * size_;
    if (distance_ && std::isfinite(target)) {
      const Touching at = (*distance_)(x);
      if (at.value > target + tolerance) columns.push_back(less(target, tangent(at, x, corner)));
    }
    for (const int i : cell.in) {
      const Touching at = constraints_.convex[static_cast<std::size_t>(i)](x);
      if (at.value > tolerance) columns.push_back(less(0, tangent(at, x, corner)));
    }
    return columns.size() > before;
  }

  void split(const BoundaryCell& cell, std::size_t a, std::size_t b) {
    for (const Tetrahedron& half : halves(cell.corner, a, b)) add(half, cell, cell.key, cell.depth + 1);
  }

  const Constraints& constraints_;
  std::span<const Tetrahedron> domain_;
  const TouchingConstraint* distance_;
  std::span<const ConvexDistance> far_;
  double size_, nearer_, last_cell_ = 0;
  const Incumbent& known_;
  BoundaryPlace best_;
  const Until* until_ = nullptr;
  bool asked_ = false;
  plane::Subdivision<BoundaryCell> queue_{"tetrahedra of the nearest or farthest allowed place"};
};

}  // namespace

BoundaryPlace nearest_allowed(std::span<const Tetrahedron> domain, const Constraints& constraints,
                              const TouchingConstraint& distance, double size, double floor, const Incumbent& known,
                              const Until* until) {
  return BoundarySearch(constraints, &distance, {}, size, known).run(domain, floor, until);
}

BoundaryPlace farthest_allowed(std::span<const Tetrahedron> domain, const Constraints& constraints,
                               std::span<const ConvexDistance> distances, double size, const Incumbent& known,
                               const FarEnd& end) {
  BoundaryPlace out =
      BoundarySearch(constraints, nullptr, distances, size, known, end.nearer).run(domain, -end.ceiling);
  out.value = -out.value;
  out.bound = -out.bound;
  return out;
}

namespace {

constexpr int kMostSlackCells = 20000;
constexpr int kSlackRounds = 4;  // of tangents in a cell
constexpr double kNear = 0.75;   // of the bound: a value that more tangents do not help

/// Over a cell the slack is at most the chords of what is to be kept out of, and the tangents of what is to be kept in.
class SlackTarget : public MaxMinTarget {
 public:
  explicit SlackTarget(const Constraints& constraints) : constraints_(constraints) {}

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& /*best*/) const override {
    ++looks_;
    for (const ConvexDistance& f : constraints_.reverse_convex) {
      Column& c = cell.distances.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) c[v] = f(cell.corner[v]);
    }
    touch(middle, cell);
    for (const Column& c : cell.distances) cell.bound = std::min(cell.bound, most(c));
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    double least = exact::kInfinity;
    for (const ConvexDistance& f : constraints_.reverse_convex) least = std::min(least, f(x));
    for (const TouchingConstraint& g : constraints_.convex) least = std::min(least, -g(x).value);
    best.offer(x, least);
    if (!(least > kNear * cell.bound && least > 0)) touch(x, cell);
  }

  double distance(int set, const Vector& x) const override {
    return constraints_.reverse_convex[static_cast<std::size_t>(set)](x);
  }
  double shortest_share() const override { return 1; }
  int rounds() const override { return kSlackRounds; }
  int looks() const { return looks_; }

 private:
  void touch(const Vector& x, MaxMinCell& cell) const {
    for (const TouchingConstraint& g : constraints_.convex)
      cell.distances.push_back(less(0, tangent(g(x), x, cell.corner)));
  }

  const Constraints& constraints_;
  mutable int looks_ = 0;
};

}  // namespace

Slack most_slack(std::span<const Tetrahedron> domain, const Constraints& constraints, const SlackEnd& end) {
  const SlackTarget target(constraints);
  const SolidMaxMin found =
      tetrahedral_max_min({{domain.begin(), domain.end()}}, target,
                          MaxMinBest(-exact::kInfinity, end.enough, 1 - end.share, end.blur), kMostSlackCells);
  const int cells = (target.looks() - static_cast<int>(domain.size())) / 2;  // each is looked at by halves
  return {found.value, found.bound, found.place, cells};
}

}  // namespace findspace::distance
