// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_solids.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "space/convolution/mesh_crossing.h"
#include "space/mesh/mesh.h"
#include "space/polytope/convex_polygon.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

using exact::Refusal;
using exact::Tried;
using Kind = plane::Shape::Kind;

/// Walls over the rings, and the convex parts of the polygon as floor and lid; `clean` matches their sides.
Tried<Triangles> prism(const Solid& solid) {
  Mesh mesh;
  const auto vertex = [&](const Point2& p, std::int64_t z) {
    mesh.vertices.push_back({p.x, p.y, z});
    return static_cast<int>(mesh.vertices.size()) - 1;
  };
  std::vector<std::vector<Point2>> rings;
  for (const plane::Contour& contour : solid.contours) {
    std::vector<Point2>& ring = rings.emplace_back();
    for (const plane::ContourEdge& edge : contour) {
      if (edge.arc) return Refusal("a prism with arcs has no ray map");
      ring.push_back({edge.start.x, edge.start.y});
    }
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point2 &p = ring[k], &q = ring[(k + 1) % ring.size()];
      mesh.faces.push_back({vertex(p, solid.low), vertex(q, solid.low), vertex(q, solid.high), vertex(p, solid.high)});
    }
  }
  for (const ConvexPolygon& part : convex_parts(rings)) {
    std::vector<int> floor, lid;
    for (const Point2& p : part.vertices()) {
      lid.push_back(vertex(p, solid.high));
      floor.insert(floor.begin(), vertex(p, solid.low));
    }
    mesh.faces.push_back(lid);
    mesh.faces.push_back(floor);
  }
  clean(mesh, 1);
  return triangles(mesh);
}

Triangles surface_of(const Solid& solid) {
  Triangles out = triangles(solid.mesh);
  out.step = solid.step;
  return out;
}

/// One piece of Euler number 2 without an edge bent inward: convex, unless it goes round more than once.
bool bends_outward(const RayBody& body) {
  return body.pieces == 1 && body.euler() == 1 &&
         std::all_of(body.edges.begin(), body.edges.end(), [](const RayEdge& e) { return e.bend >= 0; });
}

/// The surface, if it does not cross itself. What is convex does not, nor what was made so: they need no look.
Tried<RaySolid> simple(const Solid& solid) {
  Triangles surface = surface_of(solid);
  Tried<RayBody> made = RayBody::of(surface);
  if (!made) return made.refusal();
  auto sheet = std::make_shared<const RaySheet>(*std::move(made));
  const bool simple = solid.simple || (bends_outward(sheet->body) && is_convex(solid.mesh));
  const SelfContact contact = simple ? SelfContact{} : self_contact(*sheet);
  if (!contact.crossing) return RaySolid{std::move(surface), {}, {}, std::move(sheet), contact.inner_walls};
  const RayBody& body = sheet->body;
  const auto text = [&](int f) {
    const std::array<Point, 3> corners{body.corner(f, 0), body.corner(f, 1), body.corner(f, 2)};
    return places_text(corners, surface.step);
  };
  return Refusal(Error(ErrorCode::kGeometry, "the mesh crosses itself, so what lies inside is not clear: triangle " +
                                                 text((*contact.crossing)[0]) + " and triangle " +
                                                 text((*contact.crossing)[1])));
}

Tried<RaySolid> primitive(const Solid& solid) {
  switch (solid.form) {
    case Solid::Form::kPolytope:
      return RaySolid{triangles(Polytope::hull(solid.mesh.vertices)), {}, {}};
    case Solid::Form::kMesh:
      return simple(solid);
    case Solid::Form::kPrism: {
      Tried<Triangles> surface = prism(solid);
      if (!surface) return surface.refusal();
      return RaySolid{*std::move(surface), {}, {}};
    }
    case Solid::Form::kBall:
      break;
  }
  return RaySolid{{}, solid.mesh.vertices[0], solid.radius};
}

/// A surface that crosses itself is a refusal too: convex parts may do.
Tried<std::vector<RaySolid>> of_solid(const Solid& solid, const std::string& place) {
  try {
    Tried<RaySolid> one = primitive(solid);
    if (!one) return one.refusal().at(place);
    return std::vector<RaySolid>{*std::move(one)};
  } catch (const Error& e) {
    throw Refusal(e).at(place).error;
  }
}

}  // namespace

Tried<std::vector<RaySolid>> try_ray_solids(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) return of_solid(*solid, shape.place);
  std::vector<RaySolid> all;
  for (const plane::ShapePtr& child : shape.children) {
    Tried<std::vector<RaySolid>> more = try_ray_solids(*child);
    if (!more) return more;
    std::move(more->begin(), more->end(), std::back_inserter(all));
  }
  switch (shape.kind) {
    case Kind::kUnion:
    case Kind::kClosure:
    case Kind::kRegularize:
      return all;
    case Kind::kTranslate:
      for (RaySolid& s : all) {
        s = moved(std::move(s), {shape.points[0].x, shape.points[0].y, shape.lift});
        for (const Point& p : s.surface.points)
          if (!in_ray_range(p)) return beyond_ray_range().at(shape.place);
      }
      return all;
    case Kind::kMirror:
      for (RaySolid& s : all) s = mirrored(std::move(s));
      return all;
    default:
      break;
  }
  return Refusal("this kind of shape has no ray map; state it as a mesh or a union of solids", shape.place);
}

RaySolid moved(RaySolid solid, const Point& by) {
  return {moved(std::move(solid.surface), by), solid.center + by, solid.radius, nullptr, solid.inner_walls};
}

RaySolid mirrored(RaySolid solid) {
  return {scaled(std::move(solid.surface), -1), -solid.center, solid.radius, nullptr, solid.inner_walls};
}

std::shared_ptr<const RaySheet> sheet_of(const RaySolid& solid) {
  return solid.sheet ? solid.sheet : std::make_shared<const RaySheet>(solid.surface);
}

std::vector<RaySolid> ray_solids(const plane::Shape& shape) { return try_ray_solids(shape).or_throw(); }

void extend_box(const Point& p, Point& low, Point& high, bool& any) {
  if (!any) low = high = p;
  any = true;
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

void extend_box(const std::vector<RaySolid>& solids, Point& low, Point& high, bool& any) {
  for (const RaySolid& s : solids) {
    for (const Point& p : s.surface.points) extend_box(p, low, high, any);
    if (!s.ball()) continue;
    const auto r = static_cast<std::int64_t>(exact::floor(s.radius)) + 1;
    extend_box(s.center - Point{r, r, r}, low, high, any);
    extend_box(s.center + Point{r, r, r}, low, high, any);
  }
}

bool is_convex(const RaySolid& solid) {
  if (solid.ball()) return false;
  return bends_outward(sheet_of(solid)->body);
}

}  // namespace findspace::space
