// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// csg_solid() of a shape tree, node by node.
#include <findspace/error.h>

#include <algorithm>

#include "space/body/cell_parts.h"
#include "space/body/csg_solid.h"
#include "space/body/csg_thin.h"
#include "space/body/erosion.h"
#include "space/body/shape_topology.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {

using exact::Refusal;
using exact::Tried;
using Kind = plane::Shape::Kind;

namespace {

template <class Taken>
Tried<CsgSolid> less(const CsgSolid& from, const plane::Shape& set, FlatParts flats, Taken&& taken);

/// The solid, which is what the second leaves of the first, with the form that serves containment if these have it.
Tried<CsgSolid> as_container(const CsgSolid& solid, CsgSolid first, const CsgSolid& second) {
  first.parts.clear();
  const Tried<CsgSolid> form = space::less(first, second, FlatParts::kDropped);
  if (!form) return form;
  const std::int64_t scale = joint_scale(solid.scale, form->scale);
  CsgSolid out = at_scale(solid, scale), other = at_scale(*form, scale);
  out.containers = std::move(other.containers);
  out.obstacles = std::move(other.obstacles);
  return out;
}

/// What a set leaves that may lack boundary, by the sets that it is made of; nothing where it is not taken apart.
template <class Taken>
std::optional<Tried<CsgSolid>> less_by_sets(const CsgSolid& from, const plane::Shape& set, FlatParts flats,
                                            Taken&& taken) {
  const auto& c = set.children;
  if (const plane::ShapePtr inward = moved_inward(set)) return less_by_sets(from, *inward, flats, taken);
  if (set.kind == Kind::kInterior && is_open(*c[0])) return less_by_sets(from, *c[0], flats, taken);
  Tried<CsgSolid> out = from;
  if (set.kind == Kind::kUnion) {
    for (std::size_t k = 0; out && k < c.size(); ++k) out = less(*out, *c[k], flats, taken);
    return out;
  }
  const bool differs = set.kind == Kind::kDifference;
  if (!differs && set.kind != Kind::kIntersection) return std::nullopt;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const bool outside = c[k]->kind == Kind::kComplement, stays = differs ? k > 0 : outside;
    Tried<CsgSolid> next =
        stays ? taken(outside && !differs ? *c[k]->children[0] : *c[k]) : less(from, *c[k], flats, taken);
    if (next && stays) next = common(from, *next, FlatParts::kKept);
    if (!next) return next;
    out = k > 0 ? united(*out, *next) : *std::move(next);
  }
  if (!drop_thin(out->parts)) return Tried<CsgSolid>(thin_part("the difference"));
  const Tried<CsgSolid> whole = from.containers.empty() ? out : taken(set);
  return from.containers.empty() || !whole ? out : as_container(*out, from, *whole);
}

/// What a set leaves that is taken away; `taken` makes it. Where it lacks boundary, that of it which is flat would
/// stay.
template <class Taken>
Tried<CsgSolid> less(const CsgSolid& from, const plane::Shape& set, FlatParts flats, Taken&& taken) {
  const bool open = flats != FlatParts::kKept && !is_closed(set);
  if (open) {
    if (auto left = less_by_sets(from, set, flats, taken)) return *std::move(left);
  }
  const Tried<CsgSolid> other = taken(set);
  if (!other && flats != FlatParts::kKept && set.kind == Kind::kIntersection && !other.refusal().fault())
    return *less_by_sets(from, set, flats, taken);  // of what is taken away a thin piece does not count
  if (!other) return other;
  if (open && (may_lack_walls(set) || may_be_flush(from, *other))) return boundary_stays();
  return space::less(from, *other, flats);
}

/// The first child less the others, or what all have in common; `kept` and `taken` make those that count and those that
/// are taken away.
template <class Kept, class Taken>
Tried<CsgSolid> clipped(const plane::Shape& shape, FlatParts flats, Kept&& kept, Taken&& taken) {
  const bool differs = shape.kind == Kind::kDifference;
  const auto outside = [&](const plane::Shape& c) { return !differs && c.kind == Kind::kComplement; };
  std::vector<plane::ShapePtr> children = shape.children;
  std::stable_partition(children.begin(), children.end(), [&](const auto& c) { return !outside(*c); });
  if (outside(*children[0])) return Refusal("an intersection of complements is not computed in 3D", shape.place);
  Tried<CsgSolid> out = kept(*children[0]);
  if (!out) return out;
  const auto clip = [&](const plane::Shape& c) -> std::optional<Refusal> {
    Tried<CsgSolid> next = *out;
    if (differs || outside(c))
      next = less(*out, outside(c) ? *c.children[0] : c, flats, taken);
    else if (next = kept(c); next)
      next = common(*out, *next, flats);
    if (!next) return next.refusal();
    out = std::move(next);
    return std::nullopt;
  };
  if (auto why = in_any_order({children.begin() + 1, children.end()}, clip)) return *std::move(why);
  return out;
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
Tried<CsgSolid> bulk_of(Tried<CsgSolid> made, const plane::Shape& shape) {
  if (made) made = without_flat_places(*made);
  return made ? std::move(made) : made.refusal().at(shape.place);
}

plane::ShapePtr without_closed(const plane::ShapePtr& shape);

/// The intersection or difference without closed sets that are taken away.
plane::ShapePtr kept_sets(const plane::ShapePtr& shape) {
  const bool differs = shape->kind == Kind::kDifference;
  plane::Shape out = *shape;
  out.children.clear();
  for (std::size_t k = 0; k < shape->children.size(); ++k) {
    const plane::ShapePtr& c = shape->children[k];
    const bool outside = !differs && c->kind == Kind::kComplement, away = outside || (differs && k > 0);
    if (!away)
      out.children.push_back(without_closed(c));
    else if (!is_closed(outside ? *c->children[0] : *c))
      out.children.push_back(c);
  }
  if (out.children == shape->children) return shape;
  return out.children.size() == 1 ? out.children[0] : std::make_shared<const plane::Shape>(std::move(out));
}

/// A shape that is shrunk, without closed sets that are taken away: these leave nothing thin where they end. The shape
/// itself where there are none.
plane::ShapePtr without_closed(const plane::ShapePtr& shape) {
  switch (shape->kind) {
    case Kind::kIntersection:
    case Kind::kDifference:
      return kept_sets(shape);
    case Kind::kInterior:
    case Kind::kTranslate:
    case Kind::kMirror:
    case Kind::kMinkowskiDifference:
    case Kind::kOffset: {
      if (shape->kind == Kind::kOffset && shape->amount.sign() > 0) return shape;
      const plane::ShapePtr child = without_closed(shape->children[0]);
      if (child == shape->children[0]) return shape;
      plane::Shape out = *shape;
      out.children[0] = child;
      return std::make_shared<const plane::Shape>(std::move(out));
    }
    default:
      return shape;
  }
}

/// A shrunk shape as distances see it.
Tried<CsgSolid> shrunk_bulk(const plane::Shape& shape) {
  Tried<CsgSolid> made = cut_erosion(shape);
  if (!made) return made;
  const auto self = std::make_shared<const plane::Shape>(shape);
  const plane::ShapePtr open = without_closed(self);
  const Tried<CsgSolid> left = open == self ? made : cut_erosion(*open);
  if (!left) return left;
  if (keeps_thin(*left, *made)) return thin_left_over().at(shape.place);
  return bulk_of(std::move(made), shape);
}

Tried<CsgSolid> node(const plane::Shape& shape) {
  const auto& children = shape.children;
  switch (shape.kind) {
    case Kind::kUnion:
      return union_of(shape);
    case Kind::kDifference:
    case Kind::kIntersection:
      return bulk_of(clipped(shape, FlatParts::kRefused, try_csg_solid, try_csg_solid), shape);
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return try_csg_solid(*children[0]);
    case Kind::kTranslate:
    case Kind::kMirror:
      return displaced(try_csg_solid(*children[0]), shape);
    case Kind::kMinkowskiDifference:
      return shrunk_bulk(shape);
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return shrunk_bulk(shape);
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
