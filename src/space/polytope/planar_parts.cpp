// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/planar_parts.h"

#include <findspace/error.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "exact/solid/space_sign.h"
#include "plane/build/build.h"
#include "plane/query/topology.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

using exact::Real;
using plane::Index;
using Kind = plane::Shape::Kind;
using Found = std::optional<PlanarParts>;

[[noreturn]] void refuse(const plane::Shape& shape, const char* why) {
  throw Error(ErrorCode::kGeometry, std::string("a Phi-function needs a body, but the shape ") + why, shape.place);
}

/// One face of a region: rings of vertices, or a disc.
struct FacePart {
  std::vector<std::vector<exact::RealPoint>> rings;
  std::optional<Real> radius;  // of a disc, whose centre is rings[0][0]
};

std::vector<Index> boundary_of(const plane::Region& region, Index start) {
  std::vector<Index> walk{start};
  for (Index h = region.next(start); h != start; h = region.next(h)) walk.push_back(h);
  return walk;
}

/// The face as a disc, if one circle bounds it.
std::optional<FacePart> disc(const plane::Region& region, const plane::Face& face) {
  if (!face.inner.empty()) return std::nullopt;
  const std::vector<Index> walk = boundary_of(region, face.outer);
  const exact::SupportingCurve& circle = region.supporting_curve(walk[0] / 2);
  const bool round = circle.circle && std::all_of(walk.begin(), walk.end(), [&](Index h) {
                       return exact::same_supporting_curve(region.supporting_curve(h / 2), circle);
                     });
  if (!round) return std::nullopt;
  return FacePart{{{{circle.center_x(), circle.center_y()}}}, circle.w()};
}

std::optional<FacePart> polygon(const plane::Region& region, const plane::Face& face) {
  FacePart part;
  std::vector<Index> starts{face.outer};
  starts.insert(starts.end(), face.inner.begin(), face.inner.end());
  for (const Index start : starts) {
    auto& ring = part.rings.emplace_back();
    for (const Index h : boundary_of(region, start)) {
      if (region.is_arc(h / 2)) return std::nullopt;
      ring.push_back(region.geometry.exact(region.vertices[region.origin(h)].point));
    }
  }
  return part;
}

/// The least number that makes all coordinates whole, within the grid; 0 if there is none.
std::int64_t common_scale(const std::vector<FacePart>& faces) {
  exact::int128 scale = 1;
  Real largest(1);
  for (const FacePart& face : faces) {
    for (const auto& ring : face.rings) {
      for (const exact::RealPoint& p : ring) {
        for (const Real& c : {p.x, p.y}) {
          const auto fraction = c.fraction();
          if (!fraction || (*fraction)[1] > kCoordinateLimit) return 0;
          scale = scale / exact::gcd(scale, (*fraction)[1]) * (*fraction)[1];
          largest = std::max(largest, abs(c));
          if (scale > kCoordinateLimit || largest * Real(scale) > Real(kCoordinateLimit)) return 0;
        }
      }
    }
  }
  return static_cast<std::int64_t>(scale);
}

Point2 on_grid(const exact::RealPoint& p, std::int64_t scale) {
  return {static_cast<std::int64_t>(*(p.x * Real(scale)).integer()),
          static_cast<std::int64_t>(*(p.y * Real(scale)).integer())};
}

Found from_region(const plane::Region& region) {
  std::vector<FacePart> faces;
  for (const plane::Face& face : region.faces) {
    if (face.mark == 0) continue;
    std::optional<FacePart> part = disc(region, face);
    if (!part) part = polygon(region, face);
    if (!part) return std::nullopt;
    faces.push_back(std::move(*part));
  }
  PlanarParts result;
  result.scale = common_scale(faces);
  if (result.scale == 0) return std::nullopt;
  for (const FacePart& face : faces) {
    if (face.radius) {
      const Point2 center = on_grid(face.rings[0][0], result.scale);
      result.parts.push_back({ConvexPolygon::point(center), *face.radius * Real(result.scale)});
      continue;
    }
    std::vector<std::vector<Point2>> rings;
    for (const auto& ring : face.rings) {
      auto& points = rings.emplace_back();
      for (const exact::RealPoint& p : ring) points.push_back(on_grid(p, result.scale));
    }
    for (ConvexPolygon& part : convex_parts(rings)) result.parts.push_back({std::move(part), Real()});
  }
  return result;
}

/// Nothing also where the shape is not a body.
Found from_region(const plane::Shape& shape, double step) {
  const plane::Region region = plane::closure(plane::build(shape, step).region);
  if (plane::is_empty(region) || !plane::is_bounded(region) || !plane::is_regular(region)) return std::nullopt;
  return from_region(region);
}

Found parts_of(const plane::Shape& shape, double step);

std::optional<std::int64_t> common_multiple(std::int64_t a, std::int64_t b) {
  const exact::int128 multiple = exact::int128(a / std::gcd(a, b)) * b;
  if (multiple > kCoordinateLimit) return std::nullopt;
  return static_cast<std::int64_t>(multiple);
}

ConvexPolygon core_of(const std::vector<Point2>& points) {
  return points.size() == 1 ? ConvexPolygon::point(points[0]) : ConvexPolygon::hull(points);
}

/// The parts of all children on one grid.
Found joined(const plane::Shape& shape, double step) {
  PlanarParts sum;
  for (const plane::ShapePtr& child : shape.children) {
    const Found more = parts_of(*child, step);
    if (!more) return std::nullopt;
    const auto scale = common_multiple(sum.scale, more->scale);
    if (!scale) return std::nullopt;
    auto parts = at_scale(sum, *scale), others = at_scale(*more, *scale);
    if (!parts || !others) return std::nullopt;
    parts->insert(parts->end(), others->begin(), others->end());
    sum = {std::move(*parts), *scale};
  }
  return sum;
}

/// c + by * scale, or a number beyond the grid where that is.
std::int64_t shifted(std::int64_t c, std::int64_t by, std::int64_t scale) {
  const exact::int128 sum = c + exact::int128(by) * scale;
  return sum > kCoordinateLimit || sum < -kCoordinateLimit ? kCoordinateLimit + 1 : static_cast<std::int64_t>(sum);
}

/// Every part with its core moved or reflected; nothing where it leaves the grid.
template <class Change>
Found changed(Found parts, Change change) {
  if (!parts) return std::nullopt;
  for (PlanarPart& part : parts->parts) {
    std::vector<Point2> points;
    for (const Point2& p : part.core.vertices()) {
      const Point2 q = change(p, parts->scale);
      if (std::max({q.x, -q.x, q.y, -q.y}) > kCoordinateLimit) return std::nullopt;
      points.push_back(q);
    }
    part.core = core_of(points);
  }
  return parts;
}

Found offset_of(const plane::Shape& shape, double step) {
  if (shape.amount.sign() < 0) return from_region(shape, step);
  const plane::Shape& child = *shape.children[0];
  Found parts;
  if (child.kind == Kind::kPoints && shape.amount.sign() > 0) {
    parts.emplace();
    for (const plane::GridPoint& p : child.points) parts->parts.push_back({ConvexPolygon::point({p.x, p.y}), Real()});
  } else {
    parts = parts_of(child, step);
  }
  if (!parts) return from_region(shape, step);
  for (PlanarPart& part : parts->parts) part.radius += shape.amount * Real(parts->scale);
  return parts;
}

Found hull_of(const plane::Shape& shape, double step) {
  Found parts = joined(shape, step);
  if (!parts) return from_region(shape, step);
  std::vector<Point2> points;
  for (const PlanarPart& part : parts->parts) {
    if (part.radius != parts->parts[0].radius) return from_region(shape, step);
    points.insert(points.end(), part.core.vertices().begin(), part.core.vertices().end());
  }
  const bool flat = parts->parts.size() > 1 && std::all_of(parts->parts.begin(), parts->parts.end(),
                                                           [](const auto& p) { return p.core.is_point(); });
  if (flat) return from_region(shape, step);  // of discs in a row the core may be a segment
  parts->parts = {{core_of(points), parts->parts[0].radius}};
  return parts;
}

Found sum_of(const plane::Shape& shape, double step) {
  const Found a = parts_of(*shape.children[0], step), b = parts_of(*shape.children[1], step);
  if (!a || !b) return from_region(shape, step);
  const auto scale = common_multiple(a->scale, b->scale);
  if (!scale) return std::nullopt;
  PlanarParts sum;
  sum.scale = *scale;
  const auto ps = at_scale(*a, *scale), qs = at_scale(*b, *scale);
  if (!ps || !qs) return std::nullopt;
  for (const PlanarPart& p : *ps) {
    for (const PlanarPart& q : *qs) {
      std::vector<Point2> points;
      for (const Point2& v : p.core.vertices()) {
        for (const Point2& w : q.core.vertices()) points.push_back({v.x + w.x, v.y + w.y});
      }
      sum.parts.push_back({core_of(points), p.radius + q.radius});
    }
  }
  return sum;
}

Found parts_of(const plane::Shape& shape, double step) {
  switch (shape.kind) {
    case Kind::kDisc:
      if (shape.amount.sign() <= 0) return std::nullopt;
      return PlanarParts{{{ConvexPolygon::point({shape.points[0].x, shape.points[0].y}), shape.amount}}, 1};
    case Kind::kUnion:
      return joined(shape, step);
    case Kind::kClosure:
      return parts_of(*shape.children[0], step);
    case Kind::kTranslate:
      return changed(parts_of(*shape.children[0], step), [&](const Point2& p, std::int64_t scale) {
        return Point2{shifted(p.x, shape.points[0].x, scale), shifted(p.y, shape.points[0].y, scale)};
      });
    case Kind::kMirror:
      return changed(parts_of(*shape.children[0], step), [](const Point2& p, std::int64_t) {
        return Point2{-p.x, -p.y};
      });
    case Kind::kOffset:
      return offset_of(shape, step);
    case Kind::kHull:
      return hull_of(shape, step);
    case Kind::kMinkowskiSum:
      return sum_of(shape, step);
    default:
      return from_region(shape, step);
  }
}

}  // namespace

std::optional<PlanarParts> planar_parts(const plane::Shape& shape, double step) {
  if (Found parts = parts_of(shape, step); parts && !parts->parts.empty()) return parts;
  const plane::Region region = plane::closure(plane::build(shape, step).region);
  if (!plane::is_bounded(region)) refuse(shape, "is not bounded");
  if (plane::is_empty(region)) refuse(shape, "is empty");
  if (!plane::is_regular(region)) refuse(shape, "has parts without interior (curves or single points)");
  return from_region(region);
}

std::optional<std::vector<PlanarPart>> at_scale(const PlanarParts& parts, std::int64_t scale) {
  const std::int64_t factor = scale / parts.scale;
  if (factor == 1) return parts.parts;
  std::vector<PlanarPart> scaled;
  for (const PlanarPart& part : parts.parts) {
    std::vector<Point2> points;
    for (const Point2& v : part.core.vertices()) {
      if (std::max({v.x, -v.x, v.y, -v.y}) > kCoordinateLimit / factor) return std::nullopt;
      points.push_back({v.x * factor, v.y * factor});
    }
    scaled.push_back({core_of(points), part.radius * Real(factor)});
  }
  return scaled;
}

}  // namespace findspace::space
