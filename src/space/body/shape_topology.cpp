// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/shape_topology.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "space/body/body.h"
#include "space/body/cell_parts.h"
#include "space/body/union_frontier.h"
#include "space/polytope/polytope_sets.h"
#include "space/polytope/solid.h"

namespace findspace::space {

using exact::Real;
using Kind = plane::Shape::Kind;

namespace {

template <class Property>
bool each_child(const plane::Shape& shape, Property&& property) {
  return std::all_of(shape.children.begin(), shape.children.end(), [&](const auto& c) { return property(*c); });
}

/// Whether a shape is open (or closed) because its children are; nothing where more than that decides.
std::optional<bool> by_children(const plane::Shape& shape, bool (*same)(const plane::Shape&),
                                bool (*opposite)(const plane::Shape&)) {
  const auto& c = shape.children;
  switch (shape.kind) {
    case Kind::kUnion:
    case Kind::kIntersection:
    case Kind::kTranslate:
    case Kind::kRotate:
    case Kind::kMirror:
    case Kind::kHull:
      return each_child(shape, same);
    case Kind::kDifference:
      return same(*c[0]) && std::all_of(c.begin() + 1, c.end(), [&](const auto& o) { return opposite(*o); });
    case Kind::kComplement:
      return opposite(*c[0]);
    default:
      return std::nullopt;
  }
}

using Places = std::vector<RealVector>;
using Known = std::vector<std::optional<bool>>;  // of each place

Known negation(Known of) {
  for (auto& one : of) {
    if (one) one = !*one;
  }
  return of;
}

Known in_shape(const plane::Shape& shape, const Places& places);

/// Whether one of the sets from `first` on holds the place, or (`out`) lacks it.
Known in_any(const plane::Shape& shape, std::size_t first, bool out, const Places& places) {
  Known any(places.size(), false);
  for (std::size_t c = first; c < shape.children.size(); ++c) {
    const Known in = in_shape(*shape.children[c], places), one = out ? negation(in) : in;
    for (std::size_t k = 0; k < any.size(); ++k) {
      if (any[k] != true && one[k] != false) any[k] = one[k];
    }
  }
  return any;
}

/// Of a set that has a body.
Known in_body(const plane::Shape& shape, const Places& places) {
  Known out(places.size());
  const exact::Tried<Body> made = try_body(shape);
  if (!made || made->outside || made->rounded > 0) return out;
  const bool closed = is_closed(shape);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const RealVector at = scaled(Real(made->scale), places[k]);
    int least = 1;
    for (const BodyPart& part : made->parts) least = std::min(least, side(part, at));
    if (least > 0 || least < 0 || closed) out[k] = least <= 0;
  }
  return out;
}

/// Whether the set holds the places, where that is known.
Known in_shape(const plane::Shape& shape, const Places& places) {
  const auto& c = shape.children;
  const auto moved = [&](auto&& change) {
    Places out;
    for (const RealVector& p : places) out.push_back(change(p));
    return in_shape(*c[0], out);
  };
  switch (shape.kind) {
    case Kind::kUnion:
      return in_any(shape, 0, false, places);
    case Kind::kIntersection:
      return negation(in_any(shape, 0, true, places));
    case Kind::kDifference: {
      const Known others = in_any(shape, 1, false, places);
      Known out = in_shape(*c[0], places);
      for (std::size_t k = 0; k < out.size(); ++k) {
        if (out[k] != false && others[k] != false) out[k] = others[k] ? std::optional(false) : std::nullopt;
      }
      return out;
    }
    case Kind::kComplement:
      return negation(in_shape(*c[0], places));
    case Kind::kTranslate: {
      const RealVector by = real(Point{shape.points[0].x, shape.points[0].y, shape.lift});
      return moved([&](const RealVector& p) { return minus(p, by); });
    }
    case Kind::kMirror:
      return moved([](const RealVector& p) { return negated(p); });
    default:
      return in_body(shape, places);
  }
}

/// A hull is closed if the set has all its corners.
bool has_corners(const plane::Shape& hull) {
  const exact::Tried<Body> made = try_body(hull);
  if (!made || made->round() || made->rounded > 0) return false;
  Places corners;
  for (const Point& v : made->parts[0].vertices()) corners.push_back(scaled(Real::ratio(1, made->scale), real(v)));
  const Known in = in_any(hull, 0, false, corners);
  return std::all_of(in.begin(), in.end(), [](const auto& one) { return one == true; });
}

}  // namespace

bool is_solid(const plane::Shape& shape) {
  if (solid_of(shape)) return true;
  const bool keeps = shape.kind == Kind::kUnion || shape.kind == Kind::kTranslate || shape.kind == Kind::kMirror ||
                     shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || shape.kind == Kind::kClosure ||
                     shape.kind == Kind::kRegularize || (shape.kind == Kind::kOffset && shape.amount.sign() >= 0);
  return keeps && each_child(shape, is_solid);
}

bool is_closed(const plane::Shape& shape) {
  switch (shape.kind) {
    case Kind::kMinkowskiDifference:
      return is_closed(*shape.children[0]);
    case Kind::kMinkowskiSum:
      return each_child(shape, is_closed);
    case Kind::kOffset:
      return shape.amount.sign() > 0 || is_closed(*shape.children[0]);
    case Kind::kClosure:
    case Kind::kRegularize:
    case Kind::kBoundary:
      return true;
    case Kind::kHull:
      return each_child(shape, is_closed) || has_corners(shape);
    default:
      if (const auto by = by_children(shape, is_closed, is_open)) return *by;
      return is_solid(shape);
  }
}

bool is_open(const plane::Shape& shape) {
  const auto& c = shape.children;
  switch (shape.kind) {
    case Kind::kInterior:
      return true;
    case Kind::kMinkowskiSum:
      return std::any_of(c.begin(), c.end(), [](const auto& o) { return is_open(*o); });
    case Kind::kMinkowskiDifference:
      return is_open(*c[0]) && is_closed(*c[1]);
    case Kind::kOffset:
      return shape.amount.sign() <= 0 && is_open(*c[0]);
    default:
      return by_children(shape, is_open, is_closed).value_or(false);
  }
}

namespace {

/// Each part of a body as one of its own.
std::vector<Body> parted(const Body& body) {
  std::vector<Body> out;
  for (const BodyPart& part : body.parts) {
    Body& one = out.emplace_back();
    one.parts.push_back(part);
    one.scale = body.scale;
  }
  return out;
}

/// A set that may lack boundary. Of a closed set less closed ones: only where one of these begins, part by part.
struct LackingSet {
  Body body;
  std::optional<std::vector<Body>> taken{};

  /// Where it lies beneath the plane n . x = at.
  bool may_lack(const RealVector& n, const Real& at) const {
    return !taken ||
           std::any_of(taken->begin(), taken->end(), [&](const Body& t) { return -support(t, negated(n)) == at; });
  }
};

/// Of one part each: whether a face of one may lie on a face of the other, which is beyond it, and both lack it.
bool lack_wall(const LackingSet& a, const LackingSet& b) {
  const auto on = [&](const HalfSpace& h) {
    const Real at = support(a.body, h.normal);
    return at == -support(b.body, negated(h.normal)) && a.may_lack(h.normal, at) && b.may_lack(negated(h.normal), -at);
  };
  const std::vector<HalfSpace> planes = a.body.parts[0].planes();
  if (std::none_of(planes.begin(), planes.end(), on)) return false;
  const Bounds3 p = bounds(a.body), q = bounds(b.body);
  for (std::size_t k = 0; k < 3; ++k) {
    if (p.high[k] < q.low[k] || q.high[k] < p.low[k]) return false;
  }
  return true;
}

/// Whether parts of different sets do so.
bool walls_between(const std::vector<LackingSet>& sets) {
  std::int64_t scale = 1;
  for (const LackingSet& s : sets) {
    scale = joint_scale(scale, s.body.scale);
    for (const Body& t : s.taken.value_or(std::vector<Body>())) scale = joint_scale(scale, t.scale);
  }
  std::vector<std::pair<std::size_t, LackingSet>> parts;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    std::optional<std::vector<Body>> taken = sets[k].taken;
    if (taken) {
      for (Body& t : *taken) t = at_scale(t, scale);
    }
    for (Body& part : parted(at_scale(sets[k].body, scale))) parts.emplace_back(k, LackingSet{std::move(part), taken});
  }
  return std::any_of(parts.begin(), parts.end(), [&](const auto& a) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const auto& b) { return a.first < b.first && lack_wall(a.second, b.second); });
  });
}

/// Whether the open parts leave something without interior of the space about them; true where they are round.
bool leaves_walls(const Body& body) {
  if (body.round()) return true;
  std::vector<Polytope> parts;
  for (const BodyPart& part : body.parts) parts.push_back(*part.core);
  Point low = parts[0].vertices()[0], high = low;
  for (const Polytope& p : parts) {
    for (const Point& v : p.vertices()) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i) {
    const Point in{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    corners.push_back(in + Point{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  }
  const Polytope about = Polytope::hull(corners);
  return !thin_pieces({&about, 1}, parts, difference_cells({&about, 1}, parts)).empty();
}

/// What is taken away, part by part, where the shape is a closed set less closed ones.
std::optional<std::vector<Body>> closed_taken(const plane::Shape& shape) {
  if (shape.kind != Kind::kDifference || !each_child(shape, is_closed)) return std::nullopt;
  std::vector<Body> out;
  for (std::size_t k = 1; k < shape.children.size(); ++k) {
    const exact::Tried<Body> made = try_body(*shape.children[k]);
    if (!made || made->outside) return std::nullopt;
    const std::vector<Body> parts = parted(*made);
    out.insert(out.end(), parts.begin(), parts.end());
  }
  return out;
}

}  // namespace

bool may_lack_walls(const plane::Shape& shape) {
  const auto& c = shape.children;
  const auto lacks = [](const auto& child) { return may_lack_walls(*child); };
  switch (shape.kind) {
    case Kind::kUnion: {
      if (std::any_of(c.begin(), c.end(), lacks)) return true;
      std::vector<LackingSet> sets;
      for (const plane::ShapePtr& child : c) {
        if (is_closed(*child)) continue;
        if (const exact::Tried<Body> made = try_body(*child)) sets.push_back({*made, closed_taken(*child)});
      }
      return walls_between(sets);
    }
    case Kind::kIntersection:
      return std::any_of(c.begin(), c.end(), lacks);
    case Kind::kInterior:
    case Kind::kDifference:
    case Kind::kMinkowskiDifference:
    case Kind::kTranslate:
    case Kind::kMirror:
      return lacks(c[0]);
    case Kind::kOffset:
      if (shape.amount.sign() <= 0) return lacks(c[0]);
      [[fallthrough]];
    case Kind::kMinkowskiSum: {
      if (is_closed(shape)) return false;
      const exact::Tried<Body> made = try_body(shape);
      if (!made) return false;
      std::vector<LackingSet> sets;
      for (Body& part : parted(*made)) sets.push_back({std::move(part)});
      return walls_between(sets) && leaves_walls(*made);
    }
    default:
      return false;
  }
}

exact::Refusal walls_are_lacking() {
  return exact::Refusal(
      "open sets of a union meet in a wall that the union lacks; in 3D that is computed only where all faces of all "
      "shapes are flat and parallel to the axes");
}

exact::Refusal boundary_stays() {
  return exact::Refusal(
      "a set that is taken away lacks boundary, of which a part may stay, without interior; let the set stick out, or "
      "take its closure away");
}

namespace {

bool shrinks(const plane::Shape& shape) {
  return shape.kind == Kind::kMinkowskiDifference || (shape.kind == Kind::kOffset && shape.amount.sign() < 0);
}

bool moves(const plane::Shape& shape) { return shape.kind == Kind::kTranslate || shape.kind == Kind::kMirror; }

plane::ShapePtr with_child(plane::Shape shape, plane::ShapePtr child) {
  shape.children[0] = std::move(child);
  return std::make_shared<const plane::Shape>(std::move(shape));
}

/// What keeps the shape that shrinks another out of the set.
plane::Shape growing(plane::Shape shape) {
  if (shape.kind == Kind::kOffset)
    shape.amount = -shape.amount;
  else
    shape.kind = Kind::kMinkowskiSum;
  return shape;
}

}  // namespace

plane::ShapePtr moved_inward(const plane::Shape& shape) {
  const bool shrunk = shrinks(shape);
  if (!shrunk && !moves(shape)) return nullptr;
  plane::ShapePtr of = shape.children[0];
  if (shrinks(*of) || moves(*of)) of = moved_inward(*of);
  if (!of) return nullptr;
  const bool differs = of->kind == Kind::kDifference;
  if (!differs && of->kind != Kind::kIntersection && (shrunk || of->kind != Kind::kUnion)) return nullptr;
  plane::Shape out = *of;
  for (std::size_t k = 0; k < out.children.size(); ++k) {
    plane::ShapePtr& child = out.children[k];
    const bool outside = child->kind == Kind::kComplement, grows = (differs && k > 0) != outside;
    const plane::ShapePtr set = outside ? child->children[0] : child;
    if (shrunk && shape.kind == Kind::kOffset && grows && !is_closed(*set)) return nullptr;
    plane::ShapePtr changed = with_child(shrunk && grows ? growing(shape) : shape, set);
    child = outside ? with_child(*child, std::move(changed)) : std::move(changed);
  }
  return std::make_shared<const plane::Shape>(std::move(out));
}

}  // namespace findspace::space
