// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of space as surfaces of flat faces.

#include "findspace/error.h"
#include "formula/solid/solve_region.h"
#include "io/mesh/space_surface.h"

namespace findspace::io {
namespace {

Surface with_corners(std::span<const space::Point> points, const exact::Real& step) {
  using exact::Real;
  Surface out;
  for (const space::Point& p : points)
    out.vertices.push_back(
        {(Real(p.x) * step).to_double(), (Real(p.y) * step).to_double(), (Real(p.z) * step).to_double()});
  return out;
}

Surface polytope_surface(const space::Polytope& polytope, const exact::Real& step) {
  Surface out = with_corners(polytope.vertices(), step);
  for (int f = 0; f < polytope.facet_count(); ++f) out.faces.push_back(polytope.circuit(f));
  return out;
}

Surface triangle_surface(const space::Triangles& triangles, const exact::Real& step) {
  Surface out = with_corners(triangles.points, step);
  for (const auto& face : triangles.faces) out.faces.emplace_back(face.begin(), face.end());
  return out;
}

SolidSurface surface_of_boxes(const space::BoxComplex& boxes, const plane::Shape& shape, const exact::Real& step) {
  const space::SpaceSummary set = space::summarize(boxes, step);
  if (!set.bounded) throw Error(ErrorCode::kGeometry, "a mesh cannot hold an unbounded set", shape.place);
  SolidSurface out{box_surface(boxes, step)};
  if (out.surface.faces.empty())
    throw Error(ErrorCode::kGeometry, "a mesh cannot hold a set without volume", shape.place);
  if (set.dangling_area > 0 || set.dangling_length > 0 || !set.isolated.empty())
    out.lost = "a mesh cannot hold sheets, lines and points: lost";
  return out;
}

}  // namespace

Surface surface_of(const formula::ShapeBoundary& boundary, const exact::Real& step) {
  if (const auto* triangles = std::get_if<space::Triangles>(&boundary)) return triangle_surface(*triangles, step);
  if (const auto* boxes = std::get_if<space::BoxComplex>(&boundary)) return box_surface(*boxes, step);
  const space::Body& body = *std::get<formula::LazyBody::Pointer>(boundary);
  return polytope_surface(*body.parts[0].core, step / exact::Real(body.scale));
}

SolidSurface solid_surface(const plane::Shape& shape, const exact::Real& step) {
  const std::optional<formula::ShapeBoundary> found = formula::shape_boundary(shape);
  if (!found)
    throw Error(ErrorCode::kUnsupported,
                "this is not bounded by one surface of flat faces; describe -o writes its surface as found on lines",
                shape.place);
  if (const auto* boxes = std::get_if<space::BoxComplex>(&*found)) return surface_of_boxes(*boxes, shape, step);
  return {surface_of(*found, step)};
}

}  // namespace findspace::io
