// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/shape_topology.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "space/body/body.h"
#include "space/body/cell_parts.h"
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
      return walls_between(sets);
    }
    default:
      return false;
  }
}

exact::Refusal walls_are_lacking() {
  return exact::Refusal(
      "open sets of a union meet in a wall that the union lacks; in 3D only shapes with axis-parallel faces may");
}

plane::ShapePtr moved_inward(const plane::Shape& shape) {
  if (shape.kind != Kind::kTranslate && shape.kind != Kind::kMirror) return nullptr;
  plane::ShapePtr of = shape.children[0];
  if (of->kind == Kind::kTranslate || of->kind == Kind::kMirror) of = moved_inward(*of);
  if (!of || (of->kind != Kind::kUnion && of->kind != Kind::kIntersection && of->kind != Kind::kDifference))
    return nullptr;
  plane::Shape out = *of;
  for (plane::ShapePtr& child : out.children) {
    plane::Shape moved = shape;
    moved.children = {std::move(child)};
    child = std::make_shared<const plane::Shape>(std::move(moved));
  }
  return std::make_shared<const plane::Shape>(std::move(out));
}

}  // namespace findspace::space
