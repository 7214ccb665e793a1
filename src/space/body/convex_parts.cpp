// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/convex_parts.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>

#include "plane/base/search_work.h"
#include "space/body/cell_parts.h"
#include "space/body/erosion.h"
#include "space/body/shape_topology.h"
#include "space/mesh/mesh.h"
#include "space/polytope/partition.h"
#include "space/polytope/polytope_sets.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using Kind = plane::Shape::Kind;

constexpr std::size_t kMostFaces = 100000;
constexpr long kMostLooks = 30'000'000;  // at pieces, of a partition

/// The parts of a surface that does not meet itself have exactly its volume; else it encloses some space twice, or not.
/// Where vertices were rounded the volume may change by the surface times the longest move, here taken twice.
std::optional<Refusal> fault_of_volume(const ConvexParts& parts, const Real& six_enclosed) {
  Real sum;
  double slack = 0;
  for (const Polytope& p : parts.parts) {
    sum += six_volumes(p);
    if (parts.rounded > 0) slack += 6 * 2 * parts.moved * surface_area(p);
  }
  const Real enclosed = six_enclosed * Real(parts.scale) * Real(parts.scale) * Real(parts.scale);
  if (abs(sum - enclosed) <= Real::from_double(slack)) return std::nullopt;
  return Refusal(Error(ErrorCode::kGeometry, "the mesh meets or crosses itself: its convex parts have " +
                                                 std::to_string(sum.to_double() / enclosed.to_double()) +
                                                 " times the volume that it encloses"));
}

/// The box about the mesh: without it a surface that crosses itself could leave cells unbounded.
ConvexRegion bounding_box(const Mesh& mesh) {
  Point low = mesh.vertices[0], high = low;
  for (const Point& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {real(low), real(high)};
}

/// A prism over the convex parts of its polygon.
Tried<ConvexParts> prism_parts(const Solid& solid) {
  std::vector<std::vector<Point2>> rings;
  for (const plane::Contour& contour : solid.contours) {
    std::vector<Point2>& ring = rings.emplace_back();
    for (const plane::ContourEdge& edge : contour) {
      if (edge.arc) return Refusal("a prism with arcs has no convex polyhedral parts");
      ring.push_back({edge.start.x, edge.start.y});
    }
  }
  ConvexParts result;
  for (const ConvexPolygon& part : convex_parts(rings)) {
    std::vector<Point> points;
    for (const Point2& p : part.vertices())
      points.insert(points.end(), {{p.x, p.y, solid.low}, {p.x, p.y, solid.high}});
    result.parts.push_back(Polytope::hull(points));
  }
  return result;
}

ConvexParts one(Polytope p) {
  ConvexParts result;
  result.parts.push_back(std::move(p));
  return result;
}

Tried<ConvexParts> solid_parts(const Solid& solid) {
  switch (solid.form) {
    case Solid::Form::kPolytope:
      return one(Polytope::hull(solid.mesh.vertices));
    case Solid::Form::kPrism:
      return prism_parts(solid);
    case Solid::Form::kMesh:
      return try_convex_parts(solid.mesh);
    case Solid::Form::kBall:
      break;
  }
  return Refusal("a ball has no convex polyhedral parts");
}

bool fits(const ConvexParts& parts, const int128& scale) {
  const int128 most = kCoordinateLimit / (scale / parts.scale);
  const auto within = [&](const Point& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= most; };
  return std::all_of(parts.parts.begin(), parts.parts.end(),
                     [&](const Polytope& p) { return std::all_of(p.vertices().begin(), p.vertices().end(), within); });
}

/// On a coarser grid, with vertices rounded and counted; throws too_fine() where a part would be lost.
void put_on_grid(ConvexParts& parts, std::int64_t scale) {
  CellCorners corners;
  const Real step = Real::ratio(1, parts.scale);
  for (const Polytope& p : parts.parts) {
    std::vector<RealVector>& of = corners.emplace_back();
    for (const Point& v : p.vertices()) of.push_back(scaled(step, real(v)));
  }
  Tried<ConvexParts> made = rounded_corners(corners, scale);
  if (!made) throw too_fine();
  parts.parts = std::move(made->parts);
  parts.scale = scale;
  parts.rounded += made->rounded;
  parts.moved = std::max(parts.moved, made->moved);
  parts.around.clear();
}

/// One scale of both; where that leaves the range the finer one is put on the grid of the other.
std::int64_t put_together(ConvexParts& a, ConvexParts& b) {
  if (a.scale == b.scale) return a.scale;
  const int128 scale = int128(a.scale) / std::gcd(a.scale, b.scale) * b.scale;
  if (fits(a, scale) && fits(b, scale)) return static_cast<std::int64_t>(scale);
  const std::int64_t coarse = std::min(a.scale, b.scale);
  put_on_grid(a.scale > coarse ? a : b, coarse);
  return coarse;
}

void add(ConvexParts& sum, ConvexParts more) {
  const std::int64_t scale = put_together(sum, more);
  for (ConvexParts* each : {&sum, &more}) {
    if (each->scale == scale) continue;  // the sum of many is not copied for each
    each->parts = at_scale(*each, scale);
    enlarge(each->around, scale / each->scale);
    each->scale = scale;
  }
  append(sum.around, std::move(more.around), sum.parts.size());
  std::move(more.parts.begin(), more.parts.end(), std::back_inserter(sum.parts));
  sum.rounded += more.rounded;
  sum.moved = std::max(sum.moved, more.moved);
}

/// As convex_parts(), but of what is left of a shape there may be nothing.
Tried<ConvexParts> made(const plane::Shape& shape);

Tried<ConvexParts> all_children(const plane::Shape& shape) {
  ConvexParts sum;
  for (const plane::ShapePtr& child : shape.children) {
    Tried<ConvexParts> part = made(*child);
    if (!part) return part;
    add(sum, *std::move(part));
  }
  return sum;
}

ConvexParts hull_of(ConvexParts parts) {
  std::vector<Point> points;
  for (const Polytope& p : parts.parts) points.insert(points.end(), p.vertices().begin(), p.vertices().end());
  parts.parts = {Polytope::hull(points)};
  parts.around.clear();
  return parts;
}

double corners_of(const std::vector<Polytope>& parts) {
  const auto more = [](double sum, const Polytope& part) { return sum + double(part.vertices().size()); };
  return std::accumulate(parts.begin(), parts.end(), 0.0, more);
}

/// A sum of unions is the union of the sums of their parts.
Tried<ConvexParts> sum_of(const plane::Shape& sum) {
  Tried<ConvexParts> first = made(*sum.children[0]);
  if (!first) return first;
  Tried<ConvexParts> second = made(*sum.children[1]);
  if (!second) return second;
  ConvexParts &p = *first, &q = *second;
  require_few_corners(sum, corners_of(p.parts) * corners_of(q.parts), double(p.parts.size()) * double(q.parts.size()));
  ConvexParts result;
  result.scale = put_together(p, q);
  result.rounded = p.rounded + q.rounded;
  result.moved = std::max(p.moved, q.moved);
  const std::vector<Polytope> qs = at_scale(q, result.scale);
  for (const Polytope& x : at_scale(p, result.scale)) {
    for (const Polytope& y : qs) {
      std::vector<Point> points;
      for (const Point& v : x.vertices()) {
        for (const Point& w : y.vertices()) points.push_back(v + w);
      }
      result.parts.push_back(Polytope::hull(points));
    }
  }
  return result;
}

ConvexParts mirrored(ConvexParts parts) {
  for (Polytope& p : parts.parts) p = p.mirrored();
  for (auto& l : parts.lacking) l = std::make_shared<const ConvexParts>(mirrored(*l));
  enlarge(parts.around, -1);
  return parts;
}

/// `change` takes the parts and gives those of another set.
template <class Change>
Tried<ConvexParts> changed(Tried<ConvexParts> parts, const Change& change) {
  if (!parts) return parts;
  return change(*std::move(parts));
}

bool fits_moved(const ConvexParts& parts, const Point& t) {
  const auto within = [&](std::int64_t c, std::int64_t by) {
    const int128 sum = c + int128(by) * parts.scale;
    return sum <= kCoordinateLimit && sum >= -kCoordinateLimit;
  };
  return std::all_of(parts.parts.begin(), parts.parts.end(), [&](const Polytope& p) {
    return std::all_of(p.vertices().begin(), p.vertices().end(),
                       [&](const Point& v) { return within(v.x, t.x) && within(v.y, t.y) && within(v.z, t.z); });
  });
}

ConvexParts moved_by(ConvexParts parts, const Point& t) {
  if (!fits_moved(parts, t)) throw Error(ErrorCode::kOutOfRange, "a translation takes a vertex beyond 2^40 grid steps");
  std::erase_if(parts.lacking, [&](const auto& l) { return !fits_moved(*l, t); });
  for (auto& l : parts.lacking) l = std::make_shared<const ConvexParts>(moved_by(*l, t));
  const Point by{t.x * parts.scale, t.y * parts.scale, t.z * parts.scale};
  displace(parts.around, by);
  for (Polytope& p : parts.parts) {
    std::vector<Point> points;
    for (const Point& v : p.vertices()) points.push_back(v + by);
    p = Polytope::hull(points);
  }
  return parts;
}

Tried<ConvexParts> difference_of(const plane::Shape& shape) {
  const plane::Shape &a = *shape.children[0], &b = *shape.children[1];
  if (may_lack_walls(a)) return walls_are_lacking();
  Tried<ConvexParts> first = try_convex_parts(a);
  if (!first) return first;
  // Between rounded parts there are cracks, which b would widen: so the sets are moved that they are made of.
  if (first->rounded > 0) {
    if (const plane::ShapePtr inward = moved_inward(shape)) return made(*inward);
  }
  Tried<ConvexParts> second = try_convex_parts(b);
  if (!second) return second;
  std::vector<Body> lacking;
  for (const auto& set : first->lacking) lacking.push_back(body_of(*set));
  Tried<Body> left = eroded(body_of(*std::move(first)), body_of(*std::move(second)), lacking);
  if (!left) return left.refusal();
  Body& made = *left;
  ConvexParts result;
  for (BodyPart& part : made.parts) result.parts.push_back(*std::move(part.core));
  result.scale = made.scale;
  result.rounded = made.rounded;
  result.moved = made.moved;
  return result;
}

/// Keeps what is inside the other shape, or what is not. What both have in common may be thin where `beside` covers it,
/// or a set that one of them lacks.
Tried<ConvexParts> clip(const ConvexParts& kept, const plane::Shape& by, bool inside,
                        const ConvexParts* beside = nullptr);

/// Keeps what is in one of the children, or, after the first one, out of it.
Tried<ConvexParts> clip_each(const ConvexParts& kept, const plane::Shape& by, bool inside) {
  std::vector<plane::ShapePtr> others(by.children.begin() + 1, by.children.end());
  const auto outside = [&](const plane::Shape& c) { return !inside && c.kind == Kind::kComplement; };
  const auto of = [&](const plane::Shape& c, bool in, const ConvexParts* beside) {
    return outside(c) ? clip(kept, *c.children[0], true, beside) : clip(kept, c, in, beside);
  };
  Tried<ConvexParts> sum = of(*by.children[0], false, nullptr);
  if (!sum) return sum;
  const auto add_next = [&](const plane::Shape& c) -> std::optional<Refusal> {
    Tried<ConvexParts> next = of(c, inside, &*sum);
    if (!next) return next.refusal();
    add(*sum, *std::move(next));
    return std::nullopt;
  };
  if (auto why = in_any_order(std::move(others), add_next)) return *std::move(why);
  sum->lacking = kept.lacking;
  return sum;
}

/// What a set leaves that may lack boundary, by the sets that it is made of; nothing where it is not taken apart.
std::optional<Tried<ConvexParts>> clip_by_sets(const ConvexParts& kept, const plane::Shape& by) {
  switch (by.kind) {
    case Kind::kUnion: {  // walls between its sets stay
      Tried<ConvexParts> left = kept;
      for (std::size_t k = 0; left && k < by.children.size(); ++k) left = clip(*left, *by.children[k], false);
      return left;
    }
    case Kind::kIntersection:
      return clip_each(kept, by, false);
    case Kind::kDifference:  // a \ (b \ c) is a \ b and what a and c have in common
      return clip_each(kept, by, true);
    case Kind::kInterior:
      return is_open(*by.children[0]) ? clip_by_sets(kept, *by.children[0]) : std::nullopt;
    default:
      break;
  }
  const plane::ShapePtr inward = moved_inward(by);
  return inward ? clip_by_sets(kept, *inward) : std::nullopt;
}

Tried<ConvexParts> clip(const ConvexParts& kept, const plane::Shape& by, bool inside, const ConvexParts* beside) {
  const bool open = !inside && !is_closed(by);
  if (open) {
    if (auto left = clip_by_sets(kept, by)) return *std::move(left);
    if (may_lack_walls(by)) return walls_are_lacking();
  }
  Tried<ConvexParts> clipping = made(by);
  if (!clipping) {
    const bool thin = !inside && by.kind == Kind::kIntersection && !clipping.refusal().fault();
    return thin ? clip_each(kept, by, false) : clipping;  // of what is taken away a thin piece does not count
  }
  const auto taken = std::make_shared<const ConvexParts>(*std::move(clipping));
  const ConvexParts& other = *taken;
  const std::int64_t scale = joint_scale(joint_scale(kept.scale, other.scale), beside ? beside->scale : 1);
  const std::vector<Polytope> a = at_scale(kept, scale), b = at_scale(other, scale);
  std::vector<std::shared_ptr<const ConvexParts>> lacking = kept.lacking;
  if (inside) lacking.insert(lacking.end(), other.lacking.begin(), other.lacking.end());
  std::vector<Polytope> covers = beside ? at_scale(*beside, scale) : std::vector<Polytope>();
  for (const auto& l : lacking) {
    if ((!inside && !open) || scale % l->scale != 0 || !fits(*l, scale)) continue;
    const std::vector<Polytope> none = at_scale(*l, scale);
    covers.insert(covers.end(), none.begin(), none.end());
  }
  Tried<std::vector<ConvexRegion>> cells = inside ? intersection_cells(a, b, covers)
                                           : open ? outside_cells(a, b, covers)
                                                  : difference_cells(a, b);
  if (!cells) return open && !is_open(by) ? boundary_stays() : cells.refusal();
  Tried<ConvexParts> next = all_parts(cell_corners(*cells));
  if (!next) return next;
  next->scale *= scale;
  next->rounded += kept.rounded + other.rounded;
  next->moved = std::max({next->moved / static_cast<double>(scale), kept.moved, other.moved});
  if (!inside && !open) lacking.push_back(taken);
  next->lacking = std::move(lacking);
  return next;
}

/// a n b n .., or the closure of a without the others. Complements are taken away last.
Tried<ConvexParts> clipped(const plane::Shape& shape) {
  const bool common = shape.kind == Kind::kIntersection;
  const auto outside = [&](const plane::ShapePtr& c) { return common && c->kind == Kind::kComplement; };
  std::vector<plane::ShapePtr> children = shape.children;
  std::stable_partition(children.begin(), children.end(), [&](const auto& c) { return !outside(c); });
  if (outside(children[0])) return Refusal("an intersection of complements is not computed in 3D");
  Tried<ConvexParts> result = made(*children[0]);
  if (!result) return result;
  const auto clip_next = [&](const plane::Shape& c) -> std::optional<Refusal> {
    const bool away = common && c.kind == Kind::kComplement;
    Tried<ConvexParts> next = clip(*result, away ? *c.children[0] : c, common && !away);
    if (!next) return next.refusal();
    result = std::move(next);
    return std::nullopt;
  };
  if (auto why = in_any_order({children.begin() + 1, children.end()}, clip_next)) return *std::move(why);
  return result;
}

Tried<ConvexParts> node_parts(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) return solid_parts(*solid);
  switch (shape.kind) {
    case Kind::kUnion:
      return all_children(shape);
    case Kind::kIntersection:
    case Kind::kDifference:
      return clipped(shape);
    case Kind::kInterior:
      return made(*shape.children[0]);
    case Kind::kRegularize:
    case Kind::kClosure:
      return changed(made(*shape.children[0]), [](ConvexParts parts) {
        parts.lacking.clear();
        return parts;
      });
    case Kind::kHull:
      return changed(all_children(shape), hull_of);
    case Kind::kMinkowskiSum:
      return sum_of(shape);
    case Kind::kMinkowskiDifference:
      return difference_of(shape);
    case Kind::kMirror:
      return changed(made(*shape.children[0]), mirrored);
    case Kind::kTranslate:
      return changed(made(*shape.children[0]), [&](ConvexParts parts) {
        return moved_by(std::move(parts), {shape.points[0].x, shape.points[0].y, shape.lift});
      });
    default:
      break;
  }
  return Refusal("this kind of shape has no convex polyhedral parts; state it as a union of polytopes");
}

Tried<ConvexParts> made(const plane::Shape& shape) {
  try {
    Tried<ConvexParts> parts = node_parts(shape);
    return parts ? std::move(parts) : parts.refusal().at(shape.place);
  } catch (const Error& e) {
    if (shape.place.empty() || !e.place().empty()) throw;
    throw e.within(shape.place);
  }
}

}  // namespace

Tried<ConvexParts> try_convex_parts(const Mesh& mesh) {
  if (std::optional<Polytope> convex = convex_solid(mesh)) return one(*std::move(convex));
  if (mesh.faces.size() > kMostFaces) {
    return Refusal("a non-convex mesh of " + std::to_string(mesh.faces.size()) +
                   " faces is not cut into convex parts; state it as a union of polytopes");
  }
  std::vector<FacetPiece> facets;
  for (const auto& face : mesh.faces) {
    const Wide3 normal = exact::primitive(area_vector(mesh, face));
    FacetPiece piece{{normal, -exact::dot(normal, mesh.vertices[face[0]])}, {}};
    for (const int v : face) piece.corners.emplace_back(real(mesh.vertices[v]));
    facets.push_back(std::move(piece));
  }
  std::optional<Cells> cells = partition(std::move(facets), bounding_box(mesh), plane::allowed(kMostLooks));
  if (!cells)
    return plane::search_spent("a mesh of " + std::to_string(mesh.faces.size()) +
                               " faces that meets so many planes of others is not cut into convex parts");
  ConvexParts parts = parts_of_cells(cells->inside);
  if (const auto fault = fault_of_volume(parts, six_volumes(mesh))) return *fault;
  auto around = std::make_shared<const Surroundings>(Surroundings{mesh, std::move(cells->outside)});
  parts.around.push_back({std::move(around), 0, parts.parts.size(), parts.scale, {}});
  return parts;
}

Tried<ConvexParts> try_convex_parts(const plane::Shape& shape) {
  Tried<ConvexParts> parts = made(shape);
  if (parts && parts->parts.empty()) return Refusal("nothing with interior is left of the shape", shape.place);
  return parts;
}

ConvexParts convex_parts(const Mesh& mesh) { return try_convex_parts(mesh).or_throw(); }

ConvexParts convex_parts(const plane::Shape& shape) { return try_convex_parts(shape).or_throw(); }

std::vector<Polytope> at_scale(const ConvexParts& parts, std::int64_t scale) {
  const std::int64_t factor = scale / parts.scale;
  if (factor == 1) return parts.parts;
  std::vector<Polytope> scaled;
  for (const Polytope& p : parts.parts) {
    std::vector<Point> points;
    for (const Point& v : p.vertices()) {
      for (const std::int64_t c : {v.x, v.y, v.z}) {
        if (c > kCoordinateLimit / factor || c < -kCoordinateLimit / factor) {
          throw too_fine();
        }
      }
      points.push_back({v.x * factor, v.y * factor, v.z * factor});
    }
    scaled.push_back(Polytope::hull(points));
  }
  return scaled;
}

}  // namespace findspace::space
