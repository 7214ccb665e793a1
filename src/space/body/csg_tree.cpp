// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// csg_solid() of a shape tree, node by node.
#include <findspace/error.h>

#include <algorithm>

#include "space/body/csg_solid.h"
#include "space/body/erosion.h"
#include "space/body/shape_topology.h"

namespace findspace::space {

using exact::Refusal;
using exact::Tried;
using Kind = plane::Shape::Kind;

namespace {

Refusal boundary_stays() {
  return Refusal("boundary of an open set that is taken away may stay, without interior; let it stick out");
}

/// What a set leaves that is taken away; `taken` makes it. Where it lacks boundary, that of it which is flat would
/// stay.
template <class Taken>
Tried<CsgSolid> less(const CsgSolid& from, const plane::Shape& set, FlatParts flats, Taken&& taken) {
  const bool open = flats != FlatParts::kKept && !is_closed(set);
  const plane::ShapePtr inward = open ? moved_inward(set) : nullptr;
  if (inward) return less(from, *inward, flats, taken);
  if (open && set.kind == Kind::kUnion) {
    Tried<CsgSolid> left = from;
    for (std::size_t k = 0; left && k < set.children.size(); ++k) left = less(*left, *set.children[k], flats, taken);
    return left;
  }
  const Tried<CsgSolid> other = taken(set);
  if (!other) return other;
  if (open && set.kind != Kind::kDifference && (may_lack_walls(set) || may_be_flush(from, *other)))
    return boundary_stays();
  return space::less(from, *other, flats);
}

/// The first child less the others, or what all have in common; `kept` and `taken` make those that count and those that
/// are taken away.
template <class Kept, class Taken>
Tried<CsgSolid> clipped(const plane::Shape& shape, FlatParts flats, Kept&& kept, Taken&& taken) {
  const bool differs = shape.kind == Kind::kDifference;
  std::optional<CsgSolid> out;
  std::vector<const plane::Shape*> away;
  for (const plane::ShapePtr& c : shape.children) {
    if (differs && out) {
      away.push_back(c.get());
    } else if (!differs && c->kind == Kind::kComplement) {
      away.push_back(c->children[0].get());
    } else {
      Tried<CsgSolid> next = kept(*c);
      if (next && out) next = common(*out, *next, flats);
      if (!next) return next;
      out = *std::move(next);
    }
  }
  if (!out) return Refusal("an intersection of complements is not computed in 3D", shape.place);
  for (const plane::Shape* c : away) {
    Tried<CsgSolid> left = less(*out, *c, flats, taken);
    if (!left) return left;
    out = *std::move(left);
  }
  return *std::move(out);
}

/// By the translation or reflection that the node is.
Tried<CsgSolid> displaced(const Tried<CsgSolid>& child, const plane::Shape& shape) {
  if (!child) return child;
  if (shape.kind == Kind::kMirror) return mirrored(*child);
  return translated(*child, {shape.points[0].x, shape.points[0].y, shape.lift});
}

Tried<CsgSolid> of_erosion(const Erosion& made) {
  CsgSolid out = uncut(made.containers[0]);
  for (std::size_t k = 1; k < made.containers.size(); ++k) {
    Tried<CsgSolid> next = common(out, uncut(made.containers[k]), FlatParts::kKept);
    if (!next) return next;
    out = *std::move(next);
  }
  if (!made.obstacles) return out;
  return less(out, uncut(*made.obstacles), FlatParts::kKept);
}

/// A body, no complement.
Tried<Body> bounded_body(const plane::Shape& shape) {
  Tried<Body> made = try_body(shape);
  if (made && made->outside) return Refusal("a complement of this kind is not computed in 3D", shape.place);
  return made;
}

/// What another shape is shrunk by, no complement.
Tried<Body> shrinking(const plane::Shape& shape) {
  Tried<Body> made = try_body(shape);
  if (made && made->outside) return shrunk_by_complement();
  return made;
}

Tried<CsgSolid> eroded(const plane::Shape& shape, const Body& b);

/// The shape's Minkowski difference by the sum of another shape and b.
Tried<CsgSolid> eroded(const plane::Shape& shape, const plane::Shape& other, const Body& b) {
  const Tried<Body> by = shrinking(other);
  if (!by) return by.refusal();
  return eroded(shape, minkowski_sum(*by, b));
}

/// The shape's Minkowski difference by b: what several shapes have in common is shrunk one by one, what is taken away
/// grows.
Tried<CsgSolid> eroded(const plane::Shape& shape, const Body& b) {
  const auto& child = shape.children;
  const auto grown = [&](const plane::Shape& c) -> Tried<CsgSolid> {
    const Tried<Body> away = bounded_body(c);
    if (!away) return away.refusal();
    return uncut(minkowski_sum(*away, b));
  };
  switch (shape.kind) {
    case Kind::kIntersection:
    case Kind::kDifference:
      return clipped(
          shape, FlatParts::kKept, [&](const plane::Shape& c) { return eroded(c, b); }, grown);
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return eroded(*child[0], b);
    case Kind::kTranslate:
      return displaced(eroded(*child[0], b), shape);
    case Kind::kMirror:
      return displaced(eroded(*child[0], mirrored(b)), shape);
    case Kind::kMinkowskiDifference:
      return eroded(*child[0], *child[1], b);
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return eroded(*child[0], minkowski_sum(ball(-shape.amount), b));
      break;
    default:
      break;
  }
  if (may_lack_walls(shape)) return walls_are_lacking();
  const Tried<Body> whole = bounded_body(shape);
  if (!whole) return whole.refusal();
  const Tried<Erosion> made = erosion(*whole, b);
  if (!made) return made.refusal();
  return of_erosion(*made);
}

Tried<CsgSolid> union_of(const plane::Shape& shape) {
  Tried<CsgSolid> out = try_csg_solid(*shape.children[0]);
  for (std::size_t k = 1; out && k < shape.children.size(); ++k) {
    Tried<CsgSolid> next = try_csg_solid(*shape.children[k]);
    if (!next) return next;
    out = united(*out, *next);
  }
  return out;
}

/// As distances see it.
Tried<CsgSolid> bulk_of(Tried<CsgSolid> made, const plane::Shape& shape, FlatParts flats) {
  if (made) made = without_flat_places(*made, flats);
  return made ? std::move(made) : made.refusal().at(shape.place);
}

Tried<CsgSolid> node(const plane::Shape& shape) {
  const auto& children = shape.children;
  switch (shape.kind) {
    case Kind::kUnion:
      return union_of(shape);
    case Kind::kDifference:
    case Kind::kIntersection:
      return bulk_of(clipped(shape, FlatParts::kRefused, try_csg_solid, try_csg_solid), shape, FlatParts::kDropped);
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return try_csg_solid(*children[0]);
    case Kind::kTranslate:
    case Kind::kMirror:
      return displaced(try_csg_solid(*children[0]), shape);
    case Kind::kMinkowskiDifference:
      return bulk_of(cut_erosion(shape), shape, FlatParts::kRefused);
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return bulk_of(cut_erosion(shape), shape, FlatParts::kRefused);
      break;
    default:
      break;
  }
  const Tried<Body> made = try_body(shape);
  if (!made) return made.refusal();
  return uncut(*made);
}

bool is_round(const plane::Shape& shape) {
  if (const Solid* solid = solid_of(shape)) return solid->form == Solid::Form::kBall;
  return shape.kind == Kind::kOffset ||
         std::any_of(shape.children.begin(), shape.children.end(), [](const auto& c) { return is_round(*c); });
}

bool is_cut(const plane::Shape& shape) {
  const Kind k = shape.kind;
  if (k == Kind::kIntersection || k == Kind::kDifference || k == Kind::kMinkowskiDifference) return true;
  if (k == Kind::kOffset && shape.amount.sign() < 0) return true;
  const bool passes = k == Kind::kUnion || k == Kind::kTranslate || k == Kind::kMirror || k == Kind::kInterior ||
                      k == Kind::kClosure || k == Kind::kRegularize;
  return passes && std::any_of(shape.children.begin(), shape.children.end(), [](const auto& c) { return is_cut(*c); });
}

}  // namespace

// As a body, else node by node where something round is cut out of it.
Tried<CsgSolid> try_csg_solid(const plane::Shape& shape) {
  Tried<Body> made = bounded_body(shape);
  if (made) return uncut(*std::move(made));
  if (made.refusal().fault() || !is_cut(shape) || !is_round(shape)) return made.refusal();
  return node(shape);
}

CsgSolid csg_solid(const plane::Shape& shape) { return try_csg_solid(shape).or_throw(); }

Tried<CsgSolid> cut_erosion(const plane::Shape& shape) {
  try {
    const Tried<Body> by = shape.kind == Kind::kOffset ? ball(-shape.amount) : shrinking(*shape.children[1]);
    Tried<CsgSolid> out = by ? eroded(*shape.children[0], *by) : by.refusal();
    return out ? std::move(out) : out.refusal().at(shape.place);
  } catch (const Error& e) {
    throw shape.place.empty() || !e.place().empty() ? e : e.within(shape.place);
  }
}

}  // namespace findspace::space
