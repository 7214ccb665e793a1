// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/csg_solid.h"

#include <findspace/error.h>

#include <algorithm>
#include <numeric>

#include "space/body/cell_parts.h"
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

/// `change` takes a body and returns it in other coordinates.
template <class Change>
CsgSolid changed(const CsgSolid& body, std::int64_t scale, Change&& change) {
  CsgSolid out;
  out.scale = scale;
  out.walls = body.walls;
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

bool meet(const Bounds3& a, const Bounds3& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
  }
  return true;
}

/// Whether a set whose boxes have this in common may have interior.
bool bulky(const Bounds3& box) {
  return box.low[0] < box.high[0] && box.low[1] < box.high[1] && box.low[2] < box.high[2];
}

/// Whether it may hold a place.
bool holds_places(const Bounds3& box) {
  return box.low[0] <= box.high[0] && box.low[1] <= box.high[1] && box.low[2] <= box.high[2];
}

Refusal too_many() { return Refusal("shapes cut by round ones into more than 10,000 parts are not computed"); }

/// False where there are too many already.
bool keep(CsgPart part, FlatParts flats, std::vector<CsgPart>& out) {
  const Bounds3 box = bounds(part);
  if (flats == FlatParts::kKept ? !holds_places(box) : !bulky(box)) return true;
  std::erase_if(part.without, [&](const BodyPart& o) { return !meet(bounds(one(o)), box); });
  if (out.size() == kMostParts) return false;
  out.push_back(std::move(part));
  return true;
}

std::pair<CsgSolid, CsgSolid> together(const CsgSolid& a, const CsgSolid& b) {
  const std::int64_t scale = std::lcm(a.scale, b.scale);
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

}  // namespace

CsgSolid uncut(Body body) {
  CsgSolid out;
  out.scale = body.scale;
  for (const BodyPart& part : body.parts) out.parts.push_back({{part}, {}});
  out.containers.push_back(std::move(body));
  return out;
}

CsgSolid united(const CsgSolid& first, const CsgSolid& second) {
  auto [a, b] = together(first, second);
  a.parts.insert(a.parts.end(), b.parts.begin(), b.parts.end());
  a.containers.clear();
  a.obstacles.clear();
  a.walls = a.walls || b.walls;
  return std::move(a);
}

// The second form is kept where both have it.
Tried<CsgSolid> common(const CsgSolid& first, const CsgSolid& second, FlatParts flats) {
  const auto [a, b] = together(first, second);
  CsgSolid out;
  out.scale = a.scale;
  out.walls = a.walls || b.walls;
  for (const CsgPart& x : a.parts) {
    for (const CsgPart& y : b.parts) {
      CsgPart part = x;
      part.within.insert(part.within.end(), y.within.begin(), y.within.end());
      part.without.insert(part.without.end(), y.without.begin(), y.without.end());
      if (!keep(std::move(part), flats, out.parts)) return too_many();
    }
  }
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

bool flat_sided(const BodyPart& set) { return set.core && set.radius.sign() == 0; }

bool touch(const BodyPart& a, const BodyPart& b) { return holds_places(bounds(CsgPart{{a, b}, {}})); }

/// Whether a face of the polytope and the other set may lie on each other.
bool is_flush(const BodyPart& polytope, const BodyPart& other) {
  const auto on = [&](const Plane& plane) {
    if (!flat_sided(other)) return support(other, real(plane.normal)) == Real(-plane.offset);
    const auto corners = other.vertices();
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Point& v) { return exact::dot(plane.normal, v) + plane.offset == 0; });
  };
  return touch(polytope, other) && std::any_of(polytope.core->planes().begin(), polytope.core->planes().end(), on);
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

/// Whether a flat face of a round set that is taken away lies on a face of another set of the part.
bool has_round_flush(const CsgPart& part) {
  const auto flush = [&](const BodyPart& round) {
    const auto on = [&](const RealVector& n) {
      const Real at = support(round, n);
      const auto ends_there = [&](const BodyPart& set) { return support(set, n) == at && touch(set, round); };
      const auto starts_there = [&](const BodyPart& set) {
        return support(set, negated(n)) == -at && touch(set, round);
      };
      return std::any_of(part.within.begin(), part.within.end(), ends_there) ||
             std::any_of(part.without.begin(), part.without.end(), starts_there);
    };
    const std::vector<RealVector> normals = face_normals(round);
    return round.radius.sign() > 0 && std::any_of(normals.begin(), normals.end(), on);
  };
  return std::any_of(part.without.begin(), part.without.end(), flush);
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

/// What the polytopes of the part leave, cell by cell, each with its round sets; nothing where cells do not come to lie
/// on a grid.
std::optional<CsgSolid> cells_of(const CsgPart& part, std::int64_t scale) {
  std::vector<Polytope> kept, taken;
  CsgPart round;
  for (const BodyPart& set : part.within) flat_sided(set) ? kept.push_back(*set.core) : round.within.push_back(set);
  for (const BodyPart& set : part.without) flat_sided(set) ? taken.push_back(*set.core) : round.without.push_back(set);
  if (kept.empty()) kept.push_back(box_about(part));
  std::vector<ConvexRegion> cells = difference_cells(std::span(kept).first(1), taken);
  for (const Polytope& other : std::span(kept).subspan(1)) {
    for (ConvexRegion& cell : cells) {
      for (const Plane& plane : other.planes()) cell.cut(HalfSpace(plane));
    }
  }
  std::erase_if(cells, [](const ConvexRegion& cell) { return cell.dimension() < 3; });
  ConvexParts made = parts_of_cells(cells);
  if (made.rounded > 0) return std::nullopt;
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
  CsgSolid out{{}, body.containers, body.obstacles, body.scale, body.walls};
  for (const CsgPart& part : body.parts) {
    out.walls = out.walls || has_round_flush(part);
    std::optional<CsgSolid> cells = has_flush(part) ? cells_of(part, body.scale) : std::nullopt;
    if (!cells || (!finer && cells->scale != body.scale)) cells = CsgSolid{{part}, {}, {}, body.scale};
    const std::int64_t scale = std::lcm(out.scale, cells->scale);
    if (scale != out.scale) out = at_scale(out, scale);
    *cells = at_scale(*cells, scale);
    for (CsgPart& cell : cells->parts) {
      if (!keep(std::move(cell), FlatParts::kDropped, out.parts)) return too_many();
    }
  }
  return out;
}

}  // namespace

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
  Bounds3 box = bounds(one(part.within[0]));
  for (const BodyPart& p : part.within) {
    const Bounds3 next = bounds(one(p));
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::max(box.low[k], next.low[k]);
      box.high[k] = std::min(box.high[k], next.high[k]);
    }
  }
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
