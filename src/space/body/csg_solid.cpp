// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/csg_solid.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "space/body/body_boxes.h"
#include "space/body/cell_parts.h"
#include "space/body/csg_thin.h"
#include "space/body/erosion.h"
#include "space/body/open_union.h"
#include "space/body/union_frontier.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {

using exact::Real;
using exact::Refusal;
using exact::Tried;

namespace {

constexpr std::size_t kMostParts = 10000;

Body one(const BodyPart& part, std::int64_t scale = 1) {
  Body out;
  out.scale = scale;
  out.parts.push_back(part);
  return out;
}

/// A solid without sets, with all else.
CsgSolid bare(const CsgSolid& of) {
  CsgSolid out;
  out.scale = of.scale;
  out.walls = of.walls;
  out.rounded = of.rounded;
  out.moved = of.moved;
  return out;
}

/// What is told of both.
void add_notes(CsgSolid& to, const CsgSolid& of) {
  to.walls = to.walls || of.walls;
  to.rounded += of.rounded;
  to.moved = std::max(to.moved, of.moved);
}

/// `change` takes a body and returns it in other coordinates.
template <class Change>
CsgSolid changed(const CsgSolid& body, std::int64_t scale, Change&& change) {
  CsgSolid out = bare(body);
  out.scale = scale;
  const auto set = [&](const BodyPart& part) { return change(one(part, body.scale)).parts[0]; };
  for (const CsgPart& part : body.parts) {
    CsgPart& made = out.parts.emplace_back();
    for (const BodyPart& p : part.within) made.within.push_back(set(p));
    for (const BodyPart& p : part.without) made.without.push_back(set(p));
  }
  for (const Body& tolerance : body.containers) out.containers.push_back(change(tolerance));
  for (const Body& obstacle : body.obstacles) out.obstacles.push_back(change(obstacle));
  return out;
}

Refusal too_many() { return Refusal("shapes cut by round ones into more than 10,000 parts are not computed"); }

/// False where there are too many already.
bool keep(CsgPart part, FlatParts flats, std::vector<CsgPart>& out) {
  const Bounds3 box = bounds(part);
  if (flats == FlatParts::kDropped ? !bulky(box) : !holds_places(box)) return true;
  std::erase_if(part.without, [&](const BodyPart& o) { return !open_meet(bounds(o), box); });
  if (out.size() == kMostParts) return false;
  out.push_back(std::move(part));
  return true;
}

std::pair<CsgSolid, CsgSolid> together(const CsgSolid& a, const CsgSolid& b) {
  const std::int64_t scale = joint_scale(a.scale, b.scale);
  return {at_scale(a, scale), at_scale(b, scale)};
}

/// x less y: where x leaves one of the sets that y lies within, or is in one that y lies without.
Tried<std::vector<CsgPart>> less(const std::vector<CsgPart>& all, const CsgPart& y, FlatParts flats) {
  std::vector<CsgPart> out;
  for (const CsgPart& x : all) {
    for (const BodyPart& p : y.within) {
      CsgPart part = x;
      part.without.push_back(p);
      if (!keep(std::move(part), flats, out)) return too_many();
    }
    for (const BodyPart& p : y.without) {
      CsgPart part = x;
      part.within.push_back(p);
      if (!keep(std::move(part), flats, out)) return too_many();
    }
  }
  return out;
}

Tried<std::vector<CsgPart>> less(std::vector<CsgPart> all, const std::vector<CsgPart>& others, FlatParts flats) {
  Tried<std::vector<CsgPart>> left = std::move(all);
  for (const CsgPart& y : others) {
    left = less(*left, y, flats);
    if (!left) break;
  }
  return left;
}

Refusal thin_in_common() { return thin_part("an intersection"); }

/// Whether the interior of the set holds the box.
bool covers(const BodyPart& set, const Bounds3& box) {
  for (int i = 0; i < 8; ++i) {
    RealVector at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = (i >> k & 1) != 0 ? box.high[k] : box.low[k];
    if (side(set, at) >= 0) return false;
  }
  return true;
}

}  // namespace

CsgSolid uncut(Body body) {
  CsgSolid out;
  out.scale = body.scale;
  out.rounded = body.rounded;
  out.moved = body.moved;
  for (const BodyPart& part : body.parts) out.parts.push_back({{part}, {}});
  out.containers.push_back(std::move(body));
  return out;
}

CsgSolid united(const CsgSolid& first, const CsgSolid& second) {
  auto [a, b] = together(first, second);
  a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
  a.containers.clear();
  a.obstacles.clear();
  add_notes(a, b);
  return std::move(a);
}

// The second form is kept where both have it.
Tried<CsgSolid> common(const CsgSolid& first, const CsgSolid& second, FlatParts flats) {
  const auto [a, b] = together(first, second);
  CsgSolid out = bare(a);
  add_notes(out, b);
  for (const CsgPart& x : a.parts) {
    for (const CsgPart& y : b.parts) {
      CsgPart part = x;
      part.within.insert(part.within.end(), y.within.begin(), y.within.end());
      part.without.insert(part.without.end(), y.without.begin(), y.without.end());
      if (!keep(std::move(part), flats, out.parts)) return too_many();
    }
  }
  if (flats == FlatParts::kRefused && !drop_thin(out.parts)) return thin_in_common();
  if (a.containers.empty() || b.containers.empty()) return out;
  for (const CsgSolid* from : {&a, &b}) {
    out.containers.insert(out.containers.end(), from->containers.begin(), from->containers.end());
    out.obstacles.insert(out.obstacles.end(), from->obstacles.begin(), from->obstacles.end());
  }
  return out;
}

Tried<CsgSolid> less(const CsgSolid& first, const CsgSolid& second, FlatParts flats) {
  auto [a, b] = together(first, second);
  if (auto left = less(std::move(a.parts), b.parts, flats))
    a.parts = *std::move(left);
  else
    return left.refusal();
  if (flats == FlatParts::kRefused && !drop_thin(a.parts)) return thin_in_common();
  add_notes(a, b);
  const bool whole = b.containers.size() == 1 && b.obstacles.empty();
  if (whole && !a.containers.empty())
    a.obstacles.push_back(std::move(b.containers[0]));
  else {
    a.containers.clear();
    a.obstacles.clear();
  }
  return std::move(a);
}

namespace {

bool touch(const BodyPart& a, const BodyPart& b) { return holds_places(bounds(CsgPart{{a, b}, {}})); }

/// Whether a face of the polytope and the other set may lie on each other.
bool is_flush(const BodyPart& polytope, const BodyPart& other) {
  const auto on = [&](const Plane& plane) {
    if (!flat_sided(other)) return support(other, real(plane.normal)) == Real(-plane.offset);
    const auto corners = other.vertices();
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Point& v) { return exact::dot(plane.normal, v) + plane.offset == 0; });
  };
  return std::any_of(polytope.core->planes().begin(), polytope.core->planes().end(), on) && touch(polytope, other);
}

/// The normals of the flat faces.
std::vector<RealVector> face_normals(const BodyPart& set) {
  std::vector<RealVector> out;
  if (set.core) {
    for (const Plane& plane : set.core->planes()) out.push_back(real(plane.normal));
  } else if (set.flat.size() > 2) {
    out.push_back(cross(real(set.flat[1] - set.flat[0]), real(set.flat[2] - set.flat[0])));
    out.push_back(negated(out[0]));
  }
  return out;
}

/// Whether a face of the polytope and the other set, with the same outward normal, may lie on each other.
bool is_flush_within(const BodyPart& polytope, const BodyPart& other) {
  const auto on = [&](const Plane& plane) { return support(other, real(plane.normal)) == Real(-plane.offset); };
  return std::any_of(polytope.core->planes().begin(), polytope.core->planes().end(), on) && touch(polytope, other);
}

/// The same where the other set has a flat face there.
bool has_face_within(const BodyPart& polytope, const BodyPart& other) {
  const std::vector<RealVector> normals = face_normals(other);
  const auto on = [&](const Plane& plane) {
    const RealVector out = real(plane.normal);
    const auto along = [&](const RealVector& n) { return is_zero(cross(n, out)) && dot(n, out).sign() > 0; };
    return support(other, out) == Real(-plane.offset) && std::any_of(normals.begin(), normals.end(), along);
  };
  return std::any_of(polytope.core->planes().begin(), polytope.core->planes().end(), on) && touch(polytope, other);
}

/// Whether a set that is taken away may leave places of the part without interior. Where it touches the face of a
/// polytope in a point or a line only, the face bounds what is left beside that.
bool may_leave_places(const CsgPart& part, const BodyPart& taken) {
  return std::any_of(part.within.begin(), part.within.end(), [&](const BodyPart& kept) {
    if (flat_sided(taken) && is_flush_within(taken, kept)) return true;
    if (!flat_sided(kept)) return false;
    return part.within.size() > 1 ? is_flush_within(kept, taken) : has_face_within(kept, taken);
  });
}

/// Whether the other set lies beyond a face of the polytope.
bool is_beyond(const BodyPart& polytope, const BodyPart& other) {
  return std::any_of(polytope.core->planes().begin(), polytope.core->planes().end(), [&](const Plane& plane) {
    return -support(other, negated(real(plane.normal))) >= Real(-plane.offset);
  });
}

/// Whether the faces of both sets, farthest along their normals, share a place of the part that no third set that is
/// taken away covers.
bool share(const CsgPart& part, const BodyPart& a, const RealVector& of_a, const BodyPart& b, const RealVector& of_b) {
  const Bounds3 box = in_both(in_both(face_box(a, of_a), face_box(b, of_b)), bounds(part));
  return holds_places(box) && std::none_of(part.without.begin(), part.without.end(), [&](const BodyPart& set) {
           return &set != &a && &set != &b && covers(set, box);
         });
}

/// Whether a flat face of a round set that is taken away lies on a face of another set of the part.
bool has_flush_face(const CsgPart& part, const BodyPart& round) {
  const auto on = [&](const RealVector& n) {
    const Real at = support(round, n);
    const RealVector back = negated(n);
    const auto ends_there = [&](const BodyPart& set) { return support(set, n) == at && share(part, round, n, set, n); };
    const auto starts_there = [&](const BodyPart& set) {
      return support(set, back) == -at && share(part, round, n, set, back);
    };
    return std::any_of(part.within.begin(), part.within.end(), ends_there) ||
           std::any_of(part.without.begin(), part.without.end(), starts_there);
  };
  const std::vector<RealVector> normals = face_normals(round);
  return std::any_of(normals.begin(), normals.end(), on);
}

using Edge = std::array<Point, 2>;

/// Of the core; none of a point.
std::vector<Edge> core_edges(const BodyPart& set) {
  std::vector<Edge> out;
  const auto corners = set.vertices();
  if (set.core) {
    for (const auto& h : set.core->half_edges()) {
      if (h.origin < h.target)
        out.push_back({corners[static_cast<std::size_t>(h.origin)], corners[static_cast<std::size_t>(h.target)]});
    }
    return out;
  }
  for (std::size_t k = 1; k < corners.size(); ++k) out.push_back({corners[k - 1], corners[k]});
  if (corners.size() > 2) out.push_back({corners.back(), corners[0]});
  return out;
}

/// Whether more than a point is common to both edges.
bool run_together(const Edge& a, const Edge& b) {
  const RealVector along = real(a[1] - a[0]), from = real(b[0] - a[0]), to = real(b[1] - a[0]);
  if (!is_zero(cross(along, from)) || !is_zero(cross(along, to))) return false;
  const Real s = dot(along, from), t = dot(along, to);
  return std::max(s, t).sign() > 0 && std::min(s, t) < dot(along, along);
}

/// The directions in which no place of the core of a is beyond p, nor one of b beyond q; those across an edge, if any.
ConvexRegion common_normals(const BodyPart& a, const Point& p, const BodyPart& b, const Point& q, const Edge* edge) {
  const Real one(1);
  ConvexRegion out({-one, -one, -one}, {one, one, one});
  const auto cut = [&](const Point& from, const Point& to) {
    if (from != to) out.cut(HalfSpace(real(to - from), Real()));
  };
  for (const Point& v : a.vertices()) cut(p, v);
  for (const Point& v : b.vertices()) cut(q, v);
  if (edge) {
    cut((*edge)[0], (*edge)[1]);
    cut((*edge)[1], (*edge)[0]);
  }
  return out;
}

/// Whether the sets have a piece of a sphere or of a cylinder in common: of one radius about one corner or edge.
bool same_rounding(const BodyPart& a, const BodyPart& b) {
  if (a.radius != b.radius || !touch(a, b)) return false;
  for (const Point& p : a.vertices()) {
    for (const Point& q : b.vertices()) {
      if (p == q && common_normals(a, p, b, q, nullptr).dimension() == 3) return true;
    }
  }
  const auto edges = core_edges(a), others = core_edges(b);
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
    return std::any_of(others.begin(), others.end(), [&](const Edge& o) {
      return run_together(e, o) && common_normals(a, e[0], b, o[0], &e).dimension() == 2;
    });
  });
}

/// Whether the surface of a round set that is taken away may lie on that of another set of the part.
bool has_round_flush(const CsgPart& part) {
  return std::any_of(part.without.begin(), part.without.end(), [&](const BodyPart& round) {
    if (round.radius.sign() == 0) return false;
    return has_flush_face(part, round) || std::any_of(part.within.begin(), part.within.end(),
                                                      [&](const BodyPart& set) { return same_rounding(round, set); });
  });
}

/// Whether polytopes that are taken away may leave something flat.
bool has_flush(const CsgPart& part) {
  const auto flush = [&](const BodyPart& taken) {
    const auto with = [&](const BodyPart& other) { return is_flush(taken, other); };
    const auto beside = [&](const BodyPart& other) { return &other != &taken && flat_sided(other) && with(other); };
    return flat_sided(taken) && (std::any_of(part.within.begin(), part.within.end(), with) ||
                                 std::any_of(part.without.begin(), part.without.end(), beside));
  };
  return std::any_of(part.without.begin(), part.without.end(), flush);
}

std::vector<Point> corners_of(const Point& low, const Point& high) {
  std::vector<Point> out;
  for (int i = 0; i < 8; ++i) out.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return out;
}

Polytope box_about(const CsgPart& part) {
  const Bounds3 box = bounds(part);
  const auto low = [&](std::size_t k) { return static_cast<std::int64_t>(floor(box.low[k])); };
  const auto high = [&](std::size_t k) { return static_cast<std::int64_t>(-floor(-box.high[k])); };
  return Polytope::hull(corners_of({low(0), low(1), low(2)}, {high(0), high(1), high(2)}));
}

/// By how much all coordinates, and those of boxes about parts, may be multiplied.
std::int64_t most_finer(const CsgSolid& body) {
  Real far(1);
  const auto extend = [&](const Bounds3& box) {
    for (std::size_t k = 0; k < 3; ++k) far = std::max({far, abs(box.low[k]), abs(box.high[k])});
  };
  for (const CsgPart& part : body.parts) {
    for (const BodyPart& set : part.within) extend(bounds(set));
    for (const BodyPart& set : part.without) extend(bounds(set));
  }
  for (const Body& container : body.containers) extend(bounds(container));
  for (const Body& obstacle : body.obstacles) extend(bounds(obstacle));
  return static_cast<std::int64_t>(floor(Real(kCoordinateLimit) / (far + Real(1))));
}

/// What the polytopes of the part leave, cell by cell, each with its round sets; nothing where cells do not come to lie
/// on a grid that is at most `most` times finer.
std::optional<CsgSolid> cells_of(const CsgPart& part, std::int64_t scale, std::int64_t most) {
  std::vector<Polytope> kept, taken;
  CsgPart round;
  for (const BodyPart& set : part.within) flat_sided(set) ? kept.push_back(*set.core) : round.within.push_back(set);
  for (const BodyPart& set : part.without) flat_sided(set) ? taken.push_back(*set.core) : round.without.push_back(set);
  if (kept.empty()) kept.push_back(box_about(part));
  ConvexParts made = parts_of_cells(cells_between(kept, taken));
  if (made.rounded > 0 || made.scale > most) return std::nullopt;
  CsgSolid out;
  out.scale = scale;
  out.parts.push_back(std::move(round));
  out = at_scale(out, scale * made.scale);
  const CsgPart rest = std::move(out.parts[0]);
  out.parts.assign(made.parts.size(), rest);
  for (std::size_t k = 0; k < made.parts.size(); ++k)
    out.parts[k].within.push_back({std::move(made.parts[k]), {}, Real()});
  return out;
}

/// Where cells need finer steps than those of the solid, they are taken if it may have such.
Tried<CsgSolid> cut_where_flush(const CsgSolid& body, bool finer) {
  CsgSolid out = bare(body);
  out.containers = body.containers;
  out.obstacles = body.obstacles;
  const std::int64_t most = finer ? most_finer(body) : 1;
  for (const CsgPart& part : body.parts) {
    out.walls = out.walls || has_round_flush(part);
    std::optional<CsgSolid> cells;
    if (has_flush(part)) cells = cells_of(part, body.scale, most);
    const std::int64_t had = out.scale / body.scale, more = cells ? cells->scale / body.scale : 1;
    if (!cells || exact::int128(had) / std::gcd(had, more) * more > most) cells = CsgSolid{{part}, {}, {}, body.scale};
    const std::int64_t scale = joint_scale(out.scale, cells->scale);
    if (scale != out.scale) out = at_scale(out, scale);
    *cells = at_scale(*cells, scale);
    for (CsgPart& cell : cells->parts) {
      if (!keep(std::move(cell), FlatParts::kDropped, out.parts)) return too_many();
    }
  }
  return out;
}

}  // namespace

bool may_be_flush(const CsgSolid& first, const CsgSolid& second) {
  const std::pair<CsgSolid, CsgSolid> both = together(first, second);
  const auto either = [](const BodyPart& p, const BodyPart& q, bool (*is)(const BodyPart&, const BodyPart&)) {
    return (flat_sided(p) && is(p, q)) || (flat_sided(q) && is(q, p));
  };
  const auto any = [&](const std::vector<BodyPart>& of, const std::vector<BodyPart>& to, auto* is) {
    return std::any_of(of.begin(), of.end(), [&](const BodyPart& p) {
      return std::any_of(to.begin(), to.end(), [&](const BodyPart& q) { return either(p, q, is); });
    });
  };
  return std::any_of(both.first.parts.begin(), both.first.parts.end(), [&](const CsgPart& x) {
    return std::any_of(both.second.parts.begin(), both.second.parts.end(), [&](const CsgPart& y) {
      const auto leaves = [&](const BodyPart& taken) { return may_leave_places(x, taken); };
      return !any(x.within, y.within, is_beyond) &&
             (std::any_of(y.within.begin(), y.within.end(), leaves) || any(x.without, y.within, is_flush));
    });
  });
}

Tried<CsgSolid> without_flat_places(const CsgSolid& body) { return cut_where_flush(body, true); }

CsgSolid translated(const CsgSolid& body, const Point& by) {
  return changed(body, body.scale, [&](Body b) { return translated(std::move(b), by); });
}

CsgSolid mirrored(const CsgSolid& body) {
  return changed(body, body.scale, [](Body b) { return mirrored(std::move(b)); });
}

Tried<CsgSolid> left_in_box(const CsgSolid& body, const Point& low, const Point& high) {
  CsgSolid out;
  out.scale = body.scale;
  out.parts.push_back({{part_of(corners_of(low, high), Real())}, {}});
  if (auto left = less(std::move(out.parts), body.parts, FlatParts::kDropped))
    out.parts = *std::move(left);
  else
    return left.refusal();
  return cut_where_flush(out, false);
}

CsgSolid at_scale(const CsgSolid& body, std::int64_t scale) {
  if (scale == body.scale) return body;
  return changed(body, scale, [&](const Body& b) { return at_scale(b, scale); });
}

Bounds3 bounds(const CsgPart& part) {
  Bounds3 box = bounds(part.within[0]);
  for (const BodyPart& p : part.within) box = in_both(std::move(box), bounds(p));
  return box;
}

Bounds3 bounds(const CsgSolid& body) {
  Bounds3 box = bounds(body.parts.at(0));
  for (const CsgPart& part : body.parts) {
    const Bounds3 next = bounds(part);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], next.low[k]);
      box.high[k] = std::max(box.high[k], next.high[k]);
    }
  }
  return box;
}

}  // namespace findspace::space
