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

namespace {

std::size_t mesh_faces(const plane::Shape& shape) {
  if (const space::Solid* solid = space::solid_of(shape))
    return solid->form == space::Solid::Form::kMesh ? solid->mesh.faces.size() : 0;
  std::size_t sum = 0;
  for (const plane::ShapePtr& child : shape.children) sum += mesh_faces(*child);
  return sum;
}

/// The surfaces of a large mesh, or a union with one; null for other shapes.
std::shared_ptr<const std::vector<space::RaySolid>> large_surfaces(const plane::Shape& shape) {
  if (mesh_faces(shape) < space::kManyFaces) return nullptr;
  try {
    return std::make_shared<const std::vector<space::RaySolid>>(space::ray_solids(shape));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported && e.code() != ErrorCode::kGeometry) throw;
    return nullptr;  // convex parts may do, or say why not
  }
}

/// What balls are cut out of; null for other shapes.
std::shared_ptr<const space::CsgSolid> cut_of(const plane::Shape& shape) {
  try {
    auto cut = std::make_shared<const space::CsgSolid>(space::csg_solid(shape));
    if (distance::is_empty(*cut))
      throw Error(ErrorCode::kGeometry, "nothing with interior is left of the shape", shape.place);
    return cut;
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    return nullptr;
  }
}

}  // namespace

SpaceShape space_shape(const plane::Shape& shape) {
  SpaceShape out;
  try {
    out.boxes = space::box_complex(shape);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
  }
  if (out.boxes && out.boxes->empty()) {
    out.refused = "the shape is empty";
    return out;
  }
  if (out.boxes) {
    auto made = space::body_of(out.boxes->simplified());
    if (made) out.body = std::make_shared<const space::Body>(std::move(*made));
  }
  if (out.body) return out;
  out.surfaces = large_surfaces(shape);
  out.convex = out.surfaces && !seen_not_convex(*out.surfaces);
  const auto make = [kept = plane::Shape(shape)] { return std::make_shared<const space::Body>(space::body(kept)); };
  if (out.surfaces && !out.convex) {
    out.body = LazyBody::later(make);
    return out;
  }
  try {
    out.body = LazyBody(make());
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    out.refused = e.what();
    if (!out.boxes) out.cut = cut_of(shape);
    if (!out.boxes && !out.cut) throw;
  }
  return out;
}

}  // namespace findspace::formula
