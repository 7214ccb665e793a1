// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// csg_solid() of a shape tree, node by node.
#include <findspace/error.h>

#include <algorithm>

#include "space/body/csg_solid.h"
#include "space/body/erosion.h"

namespace findspace::space {

using Kind = plane::Shape::Kind;

namespace {

/// The first child less the others, or what all have in common; `kept` and `taken` make those that count and those that
/// are taken away.
template <class Kept, class Taken>
CsgSolid clipped(const plane::Shape& shape, Kept&& kept, Taken&& taken) {
  const bool differs = shape.kind == Kind::kDifference;
  std::optional<CsgSolid> out;
  std::vector<const plane::Shape*> away;
  for (const plane::ShapePtr& c : shape.children) {
    if (differs && out) {
      away.push_back(c.get());
    } else if (!differs && c->kind == Kind::kComplement) {
      away.push_back(c->children[0].get());
    } else {
      CsgSolid next = kept(*c);
      out = out ? common(*out, next) : std::move(next);
    }
  }
  if (!out) throw Error(ErrorCode::kUnsupported, "an intersection of complements is not computed in 3D", shape.place);
  for (const plane::Shape* c : away) out = less(*out, taken(*c));
  return *std::move(out);
}

/// By the translation or reflection that the node is.
CsgSolid displaced(const CsgSolid& child, const plane::Shape& shape) {
  if (shape.kind == Kind::kMirror) return mirrored(child);
  return translated(child, {shape.points[0].x, shape.points[0].y, shape.lift});
}

CsgSolid of_erosion(const Erosion& made) {
  CsgSolid out = uncut(made.containers[0]);
  for (std::size_t k = 1; k < made.containers.size(); ++k) out = common(out, uncut(made.containers[k]));
  return made.obstacles ? less(out, uncut(*made.obstacles)) : out;
}

/// The shape's Minkowski difference by b: what several shapes have in common is shrunk one by one, what is taken away
/// grows.
CsgSolid eroded(const plane::Shape& shape, const Body& b) {
  const auto& child = shape.children;
  switch (shape.kind) {
    case Kind::kIntersection:
    case Kind::kDifference:
      return clipped(
          shape, [&](const plane::Shape& c) { return eroded(c, b); },
          [&](const plane::Shape& c) { return uncut(minkowski_sum(body(c), b)); });
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return eroded(*child[0], b);
    case Kind::kTranslate:
      return displaced(eroded(*child[0], b), shape);
    case Kind::kMirror:
      return displaced(eroded(*child[0], mirrored(b)), shape);
    case Kind::kMinkowskiDifference:
      return eroded(*child[0], minkowski_sum(body(*child[1]), b));
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return eroded(*child[0], minkowski_sum(ball(-shape.amount), b));
      break;
    default:
      break;
  }
  const Body whole = body(shape);
  if (whole.outside)
    throw Error(ErrorCode::kUnsupported, "a complement of this kind is not computed in 3D", shape.place);
  return of_erosion(erosion(whole, b));
}

CsgSolid node(const plane::Shape& shape) {
  const auto& children = shape.children;
  switch (shape.kind) {
    case Kind::kUnion: {
      CsgSolid out = csg_solid(*children[0]);
      for (std::size_t k = 1; k < children.size(); ++k) out = united(out, csg_solid(*children[k]));
      return out;
    }
    case Kind::kDifference:
    case Kind::kIntersection:
      return clipped(shape, csg_solid, csg_solid);
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return csg_solid(*children[0]);
    case Kind::kTranslate:
    case Kind::kMirror:
      return displaced(csg_solid(*children[0]), shape);
    case Kind::kMinkowskiDifference:
      return cut_erosion(shape);
    case Kind::kOffset:
      if (shape.amount.sign() < 0) return cut_erosion(shape);
      break;
    default:
      break;
  }
  return uncut(body(shape));  // which says why not
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

CsgSolid csg_solid(const plane::Shape& shape) {
  try {
    Body made = body(shape);
    if (made.outside)
      throw Error(ErrorCode::kUnsupported, "a complement of this kind is not computed in 3D", shape.place);
    return uncut(std::move(made));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported || !is_cut(shape) || !is_round(shape)) throw;
  }
  return node(shape);
}

CsgSolid cut_erosion(const plane::Shape& shape) {
  try {
    return eroded(*shape.children[0], shape.kind == Kind::kOffset ? ball(-shape.amount) : body(*shape.children[1]));
  } catch (const Error& e) {
    throw shape.place.empty() || !e.place().empty() ? e : e.within(shape.place);
  }
}

}  // namespace findspace::space
