// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A shape in the forms that it has: as boxes, as a body, large meshes as surfaces.
#include "distance/csg/csg_part.h"
#include "findspace/error.h"
#include "formula/solid/solve_space.h"
#include "space/convolution/ray_solids.h"
#include "space/shape/box_shape.h"
#include "space/surface/surface_set.h"

namespace findspace::formula {

using exact::Tried;

namespace {

std::size_t mesh_faces(const plane::Shape& shape) {
  if (const space::Solid* solid = space::solid_of(shape))
    return solid->form == space::Solid::Form::kMesh ? solid->mesh.faces.size() : 0;
  std::size_t sum = 0;
  for (const plane::ShapePtr& child : shape.children) sum += mesh_faces(*child);
  return sum;
}

/// The surfaces of a large mesh, or a union with one; null for other shapes. Where they are refused convex parts may
/// do.
std::shared_ptr<const std::vector<space::RaySolid>> large_surfaces(const plane::Shape& shape) {
  if (mesh_faces(shape) < space::kManyFaces) return nullptr;
  auto solids = space::try_ray_solids(shape);
  return solids ? std::make_shared<const std::vector<space::RaySolid>>(*std::move(solids)) : nullptr;
}

/// What balls are cut out of.
Tried<std::shared_ptr<const space::CsgSolid>> cut_of(const plane::Shape& shape) {
  auto made = space::try_csg_solid(shape);
  if (!made) return made.refusal();
  auto cut = std::make_shared<const space::CsgSolid>(*std::move(made));
  if (distance::is_empty(*cut))
    return exact::Refusal(Error(ErrorCode::kGeometry, "nothing with interior is left of the shape", shape.place));
  return cut;
}

/// Where a mesh crosses itself, its convex parts do not add up; its surface knows the place.
Tried<LazyBody::Pointer> shared_body(const plane::Shape& shape) {
  auto made = space::try_body(shape);
  if (made) return std::make_shared<const space::Body>(*std::move(made));
  if (made.refusal().fault()) {
    const auto surface = space::try_ray_solids(shape);
    if (!surface && surface.refusal().fault()) return surface.refusal();
  }
  return made.refusal();
}

}  // namespace

Tried<SpaceShape> try_space_shape(const plane::Shape& shape) {
  SpaceShape out;
  out.boxes = space::box_complex(shape);
  if (out.boxes && out.boxes->empty()) {
    out.refused = exact::Refusal("the shape is empty", shape.place).error.what();
    return out;
  }
  if (out.boxes) {
    auto made = space::body_of(out.boxes->simplified());
    if (made) out.body = std::make_shared<const space::Body>(std::move(*made));
  }
  if (out.body) return out;
  out.surfaces = large_surfaces(shape);
  out.convex = out.surfaces && !seen_not_convex(*out.surfaces);
  if (out.surfaces && !out.convex) {
    out.body = LazyBody::later([kept = plane::Shape(shape)] { return shared_body(kept); });
    return out;
  }
  auto made = shared_body(shape);
  if (made) {
    out.body = LazyBody(*made);
    return out;
  }
  if (made.refusal().fault()) return made.refusal();
  out.refused = made.refusal().error.what();
  if (out.boxes) return out;
  const auto cut = cut_of(shape);
  if (!cut) return cut.refusal();
  out.cut = *cut;
  return out;
}

SpaceShape space_shape(const plane::Shape& shape) { return try_space_shape(shape).or_throw(); }

}  // namespace findspace::formula
