// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/solve_region.h"

#include <findspace/error.h>

#include <algorithm>

#include "formula/solid/faults.h"
#include "formula/solid/optimize_convex.h"
#include "space/polytope/solid.h"
#include "space/shape/box_shape.h"

namespace findspace::formula {

using distance::Way;
using exact::Tried;

namespace {

/// As boxes, and the best of them.
SpaceRegion region_of_boxes(const SpaceSolver& solver, const Formula& formula, const RegionQuery& query,
                            space::BoxComplex boxes) {
  SpaceRegion out;
  out.way = Way::kBoxes;
  out.boxes = std::move(boxes);
  if (query.objective) {
    auto best = optimize(out.boxes, solver.world().step, *query.objective, query.sense);
    out.boxes = std::move(best.at);
    out.extreme = best;
  } else if (const auto least = solver.minimum_of(formula)) {
    out.extreme = *least;
  }
  return out;
}

/// As one convex set, or the best positions of it where they are one.
SpaceRegion region_of_convex(SpaceSolver::ConvexMap map, const RegionQuery& query) {
  SpaceRegion out;
  if (query.objective) {
    auto best = optimize(map.set, map.step, *query.objective, query.sense);
    if (!best) return out;
    map.set = std::move(best->at);
    out.extreme = *best;
  } else if (query.flat && map.set.radius.sign() > 0) {
    return out;
  }
  out.way = Way::kConvex;
  out.convex = std::move(map);
  return out;
}

/// Whether its surface says that the shape is not convex; its convex parts may take long.
bool bent_inward(const plane::Shape& shape) {
  const auto solids = space::try_ray_solids(shape);
  if (!solids || solids->size() != 1 || solids->front().ball()) return false;
  const auto body = space::RayBody::of(solids->front().surface);
  return body &&
         std::any_of(body->edges.begin(), body->edges.end(), [](const space::RayEdge& e) { return e.bend < 0; });
}

bool known_convex(const SpaceShape& shape) {
  const bool waits = shape.surfaces && !shape.convex;  // not convex, then
  return !waits && shape.body && shape.body->convex();
}

/// Of a shape whose surface is closed and one.
Tried<space::Triangles> one_surface(const plane::Shape& shape) {
  const space::Solid* solid = space::solid_of(shape);
  const exact::Refusal none("the shape is not bounded by one surface");
  if (solid && solid->form == space::Solid::Form::kPolytope) return none;  // its facets stay whole
  auto solids = throwing_faults(space::try_ray_solids(shape));
  if (!solids) return solids.refusal();
  if (solids->size() != 1 || solids->front().ball()) return none;
  return std::move(solids->front().surface);
}

}  // namespace

SpaceRegion solve_region(const SpaceSolver& solver, const Formula& formula, const RegionQuery& query) {
  const bool by_distance = query.objective && query.objective->kind == Objective::Kind::kDistance;
  if (!by_distance) {
    if (auto boxes = solver.try_feasible(formula)) return region_of_boxes(solver, formula, query, *std::move(boxes));
  }
  auto convex = solver.feasible_convex(formula).or_throw();
  if (!convex || by_distance) return SpaceRegion();
  return region_of_convex(*std::move(convex), query);
}

ExactShape exact_shape(const plane::Shape& shape, bool flat) {
  ExactShape out;
  if (bent_inward(shape)) {
    out.shape.boxes = space::box_complex(shape);
    if (!out.shape.boxes) return out;
  } else if (auto made = throwing_faults(try_space_shape(shape))) {
    out.shape = *std::move(made);
  }
  if (out.shape.boxes)
    out.way = Way::kBoxes;
  else if (known_convex(out.shape) && !(flat && out.shape.body->round()))
    out.way = Way::kConvex;
  return out;
}

std::optional<ShapeBoundary> shape_boundary(const plane::Shape& shape) {
  std::optional<ShapeBoundary> out;
  if (auto surface = one_surface(shape)) {
    out.emplace(*std::move(surface));
  } else if (auto made = throwing_faults(try_space_shape(shape))) {
    if (made->boxes)
      out.emplace(*std::move(made->boxes));
    else if (known_convex(*made) && !made->body->round())
      out.emplace(made->body.pointer());
  }
  return out;
}

}  // namespace findspace::formula
