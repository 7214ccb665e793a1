// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/planar/cell_search.h"

#include <algorithm>

#include "plane/query/topology.h"
#include "plane/walk/unite.h"
#include "planning/order/convex_cells.h"
#include "planning/order/linear_program.h"

namespace findspace::planning {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Region;

namespace {

constexpr std::size_t kAtOnce = 64;  // regions united together

/// A row over all coordinates: x of body 0, y of body 0, x of body 1, ...
struct Bound {
  std::vector<Real> row;
  Real value;
  bool strict = false;
};

/// The alternatives of one set.
using Choices = std::vector<std::vector<Bound>>;

bool same_point(const RealPoint& p, const RealPoint& q) { return p.x == q.x && p.y == q.y; }

/// The projection of a bounded polyhedron on one body, by its extreme points.
class Approximation {
 public:
  Approximation(LinearProgram& program, std::size_t variables, std::size_t body)
      : program_(program), variables_(variables), body_(body) {}

  std::vector<RealPoint> corners() {
    RealPoint low = farthest(-1, 0), high = farthest(1, 0);
    if (low.x == high.x) {
      low = farthest(0, -1);
      high = farthest(0, 1);
    }
    corners_.push_back(low);
    if (same_point(low, high)) return corners_;
    refine(low, high);
    corners_.push_back(high);
    refine(high, low);
    drop_straight();
    return corners_;
  }

 private:
  RealPoint farthest(const Real& a, const Real& b) {
    std::vector<Real> objective(variables_);
    objective[2 * body_] = a;
    objective[2 * body_ + 1] = b;
    const std::vector<Real> at = *program_.maximise(objective);
    return {at[2 * body_], at[2 * body_ + 1]};
  }

  /// Adds the corners to the right of the way from p to q.
  void refine(const RealPoint& p, const RealPoint& q) {
    const Real a = q.y - p.y, b = p.x - q.x;
    const RealPoint r = farthest(a, b);
    if (!(a * r.x + b * r.y > a * p.x + b * p.y)) return;
    refine(p, r);
    corners_.push_back(r);
    refine(r, q);
  }

  void drop_straight() {
    std::vector<RealPoint> kept;
    const std::size_t n = corners_.size();
    if (n < 3) return;
    for (std::size_t k = 0; k < n; ++k) {
      const RealPoint &p = corners_[(k + n - 1) % n], &q = corners_[k], &r = corners_[(k + 1) % n];
      if (((q.x - p.x) * (r.y - q.y) - (q.y - p.y) * (r.x - q.x)).sign() != 0) kept.push_back(q);
    }
    if (kept.size() > 2) corners_ = std::move(kept);
  }

  LinearProgram& program_;
  std::size_t variables_, body_;
  std::vector<RealPoint> corners_;
};

class Search {
 public:
  Search(const PairSystem& system, const Limit& limit) : limit_(limit), variables_(2 * system.own.size()) {
    closed_ = std::all_of(system.own.begin(), system.own.end(), plane::is_closed) &&
              std::all_of(system.between.begin(), system.between.end(),
                          [](const auto& b) { return plane::is_closed(b.second); });
    for (std::size_t i = 0; i < system.own.size(); ++i) add_choices(system.own[i], i, std::nullopt);
    // The sets of one body first; then pairs, so that the bodies met so far are joined completely before the next.
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const auto& [pair, region] : system.between) pairs.push_back(pair);
    std::sort(pairs.begin(), pairs.end(),
              [](const auto& p, const auto& q) { return std::pair(p.second, p.first) < std::pair(q.second, q.first); });
    for (const auto& p : pairs) add_choices(system.between.at(p), p.first, p.second);
    out_.positions.assign(system.own.size(), CellComplex::uniform(0));
    found_.resize(system.own.size());
  }

  Projections run() {
    extend(0);
    for (std::size_t i = 0; i < found_.size(); ++i) gather(i);
    if (stopped_) {
      out_.exact = false;
      out_.reason = "the time limit came before the search ended";
    }
    return std::move(out_);
  }

 private:
  void add_choices(const Region& region, std::size_t i, std::optional<std::size_t> j) {
    Choices all;
    for (const ConvexCell& cell : convex_cells(region, closed_)) {
      std::vector<Bound> bounds;
      for (const HalfPlane& h : cell) {
        Bound b{std::vector<Real>(variables_), h.c, h.strict};
        b.row[2 * i] = Real(h.a);
        b.row[2 * i + 1] = Real(h.b);
        if (j) {
          b.row[2 * *j] = Real(-h.a);
          b.row[2 * *j + 1] = Real(-h.b);
        }
        bounds.push_back(std::move(b));
      }
      all.push_back(std::move(bounds));
    }
    choices_.push_back(std::move(all));
  }

  void extend(std::size_t set) {
    if (stopped_ || limit_.over()) {
      stopped_ = true;
      return;
    }
    if (set > 0 && !possible()) return;
    if (set == choices_.size()) return keep();
    for (const auto& bounds : choices_[set]) {
      for (const Bound& b : bounds) chosen_.push_back(&b);
      extend(set + 1);
      chosen_.resize(chosen_.size() - bounds.size());
    }
  }

  /// Whether the chosen bounds have a common point, strict ones strictly: then there is a t > 0 that fits.
  bool possible() const {
    const bool strict = std::any_of(chosen_.begin(), chosen_.end(), [](const Bound* b) { return b->strict; });
    LinearProgram program(variables_ + (strict ? 1 : 0));
    for (const Bound* b : chosen_) {
      std::vector<Real> row = b->row;
      if (strict) row.push_back(Real(b->strict ? 1 : 0));
      program.add(std::move(row), b->value);
    }
    if (!strict) return program.feasible();
    std::vector<Real> only_t(variables_ + 1);
    only_t[variables_] = Real(1);
    program.add(only_t, Real(1));
    if (!program.feasible()) return false;
    const auto best = program.maximise(only_t);
    return best && (*best)[variables_].sign() > 0;
  }

  void keep() {
    LinearProgram program(variables_);
    for (const Bound* b : chosen_) program.add(b->row, b->value);
    program.feasible();
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const std::vector<RealPoint> corners = Approximation(program, variables_, i).corners();
      found_[i].push_back(convex_region(corners, closed_ || corners.size() == 1));
      if (found_[i].size() >= kAtOnce) gather(i);
    }
  }

  void gather(std::size_t i) {
    std::vector<const Region*> all{&out_.positions[i]};
    for (const Region& r : found_[i]) all.push_back(&r);
    out_.positions[i] = plane::unite(all);
    found_[i].clear();
  }

  const Limit& limit_;
  std::size_t variables_;
  bool closed_ = true, stopped_ = false;
  std::vector<Choices> choices_;
  std::vector<const Bound*> chosen_;
  std::vector<std::vector<Region>> found_;
  Projections out_;
};

}  // namespace

Projections search_cells(const PairSystem& system, const Limit& limit) { return Search(system, limit).run(); }

}  // namespace findspace::planning
