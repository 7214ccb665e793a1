// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// `simplify`: runs of short segments become arcs within a bound, on a side where one is asked for, by the same proofs
// as curves do (plane/curve). Arcs and sharp corners stay. Keywords: polyline simplification, arc fitting, one-sided.
#include <algorithm>
#include <array>
#include <cmath>

#include "findspace/error.h"
#include "io/scene/scene_curves.h"
#include "io/text/drawing_rules.h"
#include "io/text/outline_shapes.h"

namespace findspace::io {
namespace {

using plane::Contour;
using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

/// A corner that turns by more than about 30 degrees stays, as does one at an arc. A choice, not a tolerance.
bool stays(const Contour& c, std::size_t before, std::size_t at, std::size_t after) {
  constexpr double kSmooth = 0.866;
  if (c[before].arc || c[at].arc) return true;
  const double ux = double(c[at].start.x - c[before].start.x), uy = double(c[at].start.y - c[before].start.y);
  const double vx = double(c[after].start.x - c[at].start.x), vy = double(c[after].start.y - c[at].start.y);
  return ux * vx + uy * vy < kSmooth * std::hypot(ux, uy) * std::hypot(vx, vy);
}

/// The segments from one corner to another.
plane::Curve run_of(const std::vector<GridPoint>& corners) {
  const GridPoint o = corners.front();
  plane::Curve curve{o, corners.back(), {}};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const GridPoint a = corners[k], b = corners[k + 1];
    curve.pieces.push_back({{exact::enclose(a.x - o.x), exact::enclose(b.x - o.x)},
                            {exact::enclose(a.y - o.y), exact::enclose(b.y - o.y)},
                            {}});
  }
  return curve;
}

/// The chain of a closed contour, or of an open one whose last edge is only its end.
Chain chain_of(Contour c, bool closed) {
  const std::size_t n = c.size();
  if (n == 0) return {{}, closed};
  const std::size_t edges = closed ? n : n - 1;
  std::vector<bool> kept(n, false);
  for (std::size_t i = closed ? 0 : 1; i < edges; ++i) kept[i] = stays(c, (i + n - 1) % n, i, (i + 1) % n);
  if (!closed) kept[0] = kept[n - 1] = true;
  const auto first = std::find(kept.begin(), kept.end(), true) - kept.begin();
  const std::size_t start = std::size_t(first) % n;  // any corner where none stays
  kept[start] = true;
  Chain chain{{}, closed};
  for (std::size_t i = 0; i < edges;) {
    std::vector<GridPoint> corners{c[(start + i) % n].start};
    const std::size_t begin = (start + i) % n;
    do {
      ++i;
      corners.push_back(c[(start + i) % n].start);
    } while (i < edges && !kept[(start + i) % n]);
    chain.edges.push_back(corners.size() == 2 ? c[begin] : plane::ContourEdge{.start = corners[0]});
    chain.curves.push_back(corners.size() == 2 ? nullptr : std::make_shared<const plane::Curve>(run_of(corners)));
  }
  if (closed) return chain;
  chain.edges.push_back({.start = c.back().start});
  chain.curves.push_back(nullptr);
  return chain;
}

ShapePtr simplified(const ShapePtr& shape, ReadContext& context) {
  if (shape->solid) throw Error(ErrorCode::kUnsupported, "\"simplify\" is for shapes in the plane");
  switch (shape->kind) {
    case Shape::Kind::kDisc:
    case Shape::Kind::kPoints:
      return shape;
    case Shape::Kind::kRings:
    case Shape::Kind::kPolyline: {
      const bool rings = shape->kind == Shape::Kind::kRings;
      Drawing drawing;
      for (const Contour& c : shape->contours) drawing.chains.push_back(chain_of(c, rings));
      Shape made = *(rings ? polygon_of : shape_of)(std::move(drawing), context, shape->place);
      made.name = shape->name;
      return share(std::move(made));
    }
    case Shape::Kind::kUnion: {
      Shape made = *shape;
      for (ShapePtr& child : made.children) child = simplified(child, context);
      return share(std::move(made));
    }
    default:
      throw Error(ErrorCode::kUnsupported,
                  "\"simplify\" is for polygons, paths, drawings and unions of them, not for what is made from others");
  }
}

ShapePtr build_simplify(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  const ShapePtr shape = reader.shape(json.need(object, "of", label), label.part("of"));
  ReadContext& context = reader.context();
  const RulesBeside rules(reader, object, label);
  if (!value.is(JsonValue::Kind::kNumber) && !value.is(JsonValue::Kind::kString))
    json.fail(ErrorCode::kBadValue, "\"simplify\" is a length: a number, or a text such as \"0.01mm\"", label, value);
  json.placed(label.part("simplify"), value, [&] { parse_length(value.text(), context.unit); });
  return json.placed(label, value, [&] {
    DrawingRules own = read_drawing_rules(json, object, label).over(context.scene_rules);
    own = context.options.drawings.over(own);
    own.tolerance = value.text();
    context.use(own);
    return simplified(shape, context);
  });
}

}  // namespace

std::span<const ShapeKind> simplify_kinds() {
  static const std::array<ShapeKind, 1> kinds{{{"simplify", {"of", "curves"}, build_simplify}}};
  return kinds;
}

}  // namespace findspace::io
