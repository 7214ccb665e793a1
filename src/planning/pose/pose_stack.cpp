// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/pose/pose_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "distance/planar/signed_distance.h"
#include "exact/margins/rounding.h"
#include "findspace/error.h"
#include "formula/planar/solve_region.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/walk/unite.h"
#include "planning/pose/pose_formula.h"

namespace findspace::planning {

using exact::Real;
using formula::Formula;
using formula::Solver;
using formula::World;
using plane::Mark;
using plane::Region;

namespace {

/// The greatest distance of the moving shapes from the pole, in grid steps, not too small.
double reach(const World& world, const plane::GridPoint& about) {
  double most = 0;
  for (const std::string& name : world.moving) {
    const Region& r = world.shapes.at(name);
    for (const plane::Vertex& v : r.vertices) {
      const exact::Point& p = r.geometry.points[v.point];
      most = std::max(most, std::hypot(p.x - double(about.x), p.y - double(about.y)) + p.error);
    }
    for (plane::Index e = 0; e < r.edges.size(); ++e) {
      if (!r.is_arc(e)) continue;
      const exact::SupportingCurve& k = r.supporting_curve(e);
      most = std::max(most, std::hypot(k.x().value - double(about.x), k.y().value - double(about.y)) + k.z().hi());
    }
  }
  return most * margin::kUpward + margin::kUpwardSteps;
}

bool has_arcs(const World& world) {
  return std::any_of(world.moving.begin(), world.moving.end(), [&](const std::string& name) {
    const Region& r = world.shapes.at(name);
    for (plane::Index e = 0; e < r.edges.size(); ++e) {
      if (r.is_arc(e)) return true;
    }
    return false;
  });
}

/// The shape grown by `by` steps, or eroded where that is negative.
Region offset(const Region& shape, const Real& by) {
  const std::array<plane::GridPoint, 1> origin{};
  const auto from_point = distance::SignedDistance::gamma1(plane::region_of_points(origin), shape);
  return plane::remark(from_point.sign_map(by), [](Mark m) { return Mark(m <= 0); });
}

/// The solvers of one angle.
class Stand {
 public:
  Stand(const World& world, const Formula& formula, const plane::GridPoint& about, const Real& degrees)
      : formula_(formula), world_(world) {
    slice.degrees = degrees;
    for (const std::string& name : world_.moving) {
      plane::SharedRegion& shape = world_.shapes.at(name);
      shape = plane::rotated(shape, about, degrees, world_.step.to_double(), slice.rounding);
    }
    formula::SolvedRegion found = formula::solve_region(Solver(world_), formula);
    slice.region = std::move(found.region);
    slice.outer = std::move(found.outer);
  }

  /// Where the formula certainly holds, or may hold, for shapes within `bound` steps.
  Region hedge(const Real& bound, Certainty certainty) const {
    const Hedged h = hedged(formula_, world_.moving, bound * world_.step, certainty);
    World w = world_;
    w.eroded = true;
    for (const Variant& v : h.variants) {
      const bool moves = std::find(world_.moving.begin(), world_.moving.end(), v.of) != world_.moving.end();
      w.shapes.emplace(v.name, offset(world_.shapes.at(v.of), v.by / world_.step));
      if (moves) w.moving.push_back(v.name);
    }
    return Solver(std::move(w)).feasible(h.formula);
  }

  PoseSlice slice;

 private:
  const Formula& formula_;
  World world_;
};

std::vector<Real> sorted_places(std::vector<Real> degrees) {
  for (Real& d : degrees) d -= Real(360) * Real(exact::floor(d / Real(360)));
  std::sort(degrees.begin(), degrees.end());
  degrees.erase(std::unique(degrees.begin(), degrees.end()), degrees.end());
  return degrees;
}

Region both(const Region& a, const Region& b, bool all) {
  const std::array<const Region*, 2> operands{&a, &b};
  return all ? plane::intersect(operands) : plane::unite(operands);
}

}  // namespace

PoseStack pose_stack(const World& world, const Formula& formula, const plane::GridPoint& about,
                     std::vector<Real> degrees) {
  degrees = sorted_places(std::move(degrees));
  const double radius = reach(world, about);
  const double roundings =
      has_arcs(world) ? 4 : 1;  // an arc keeps its radius: its middle moves a little more than its ends
  PoseStack out;
  std::vector<Stand> stands;
  for (const Real& d : degrees) stands.emplace_back(world, formula, about, d);
  const std::size_t n = stands.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Stand &p = stands[k], &q = stands[(k + 1) % n];
    const Real to = k + 1 < n ? q.slice.degrees : q.slice.degrees + Real(360), width = to - p.slice.degrees;
    if (n > 1 && width > Real(180)) continue;
    const double half = width.to_double() * std::numbers::pi / 360 * margin::kUpward;
    const double moved = roundings * std::max(p.slice.rounding.largest, q.slice.rounding.largest);
    const Real bound(std::int64_t(std::ceil(radius * half + moved)));
    out.sectors.push_back({p.slice.degrees, to, (bound * world.step).to_double(),
                           both(p.hedge(bound, Certainty::kCertain), q.hedge(bound, Certainty::kCertain), true),
                           both(p.hedge(bound, Certainty::kPossible), q.hedge(bound, Certainty::kPossible), false)});
  }
  for (Stand& s : stands) out.slices.push_back(std::move(s.slice));
  return out;
}

}  // namespace findspace::planning
