// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape/shape_topology.h"

#include <algorithm>
#include <optional>

#include "space/polytope/solid.h"

namespace findspace::space {

using Kind = plane::Shape::Kind;

namespace {

template <class Property>
bool all_children(const plane::Shape& shape, Property&& property) {
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
      return all_children(shape, same);
    case Kind::kDifference:
      return same(*c[0]) && std::all_of(c.begin() + 1, c.end(), [&](const auto& o) { return opposite(*o); });
    case Kind::kComplement:
      return opposite(*c[0]);
    default:
      return std::nullopt;
  }
}

}  // namespace

bool is_solid(const plane::Shape& shape) {
  if (solid_of(shape)) return true;
  const bool keeps = shape.kind == Kind::kUnion || shape.kind == Kind::kTranslate || shape.kind == Kind::kMirror ||
                     shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum || shape.kind == Kind::kClosure ||
                     shape.kind == Kind::kRegularize || (shape.kind == Kind::kOffset && shape.amount.sign() >= 0);
  return keeps && all_children(shape, is_solid);
}

bool is_closed(const plane::Shape& shape) {
  switch (shape.kind) {
    case Kind::kMinkowskiDifference:
      return is_closed(*shape.children[0]);
    case Kind::kMinkowskiSum:
      return all_children(shape, is_closed);
    case Kind::kOffset:
      return shape.amount.sign() > 0 || is_closed(*shape.children[0]);
    case Kind::kClosure:
    case Kind::kRegularize:
    case Kind::kBoundary:
      return true;
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

}  // namespace findspace::space
