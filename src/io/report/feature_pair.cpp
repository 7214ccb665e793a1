// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/report/feature_pair.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "findspace/text.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "io/write/json_text.h"
#include "io/write/write_witness.h"
#include "plane/complex/simplify.h"
#include "plane/query/curve_net.h"
#include "plane/query/nearest.h"

namespace findspace::io {
namespace {

using exact::Real;
using exact::RealPoint;

/// How much farther a vertex may be than an edge to be meant, in parts of the shape's size.
constexpr double kVertexFirst = 0.01;

struct PickedFeature {
  formula::FeatureAt feature;
  bool moving = false;
  plane::Region set;  // in the shape's own coordinates
};

distance::Coordinates rounded_place(const plane::Place& p) {
  return {Real::from_double(p[0]), Real::from_double(p[1])};
}

/// Nothing marked.
plane::Region unmarked(plane::Region region) {
  for (plane::Vertex& v : region.vertices) v.mark = 0;
  for (plane::Edge& e : region.edges) e.mark = 0;
  for (plane::Face& f : region.faces) f.mark = 0;
  return region;
}

/// The whole curve with its ends, alone.
plane::Region marked_curve(const plane::Region& shape, const plane::CurveNet& net,
                           const plane::CurveNet::Curve& curve) {
  plane::Region out = unmarked(shape);
  for (const plane::Index h : net.half_edges(curve)) {
    out.edges[h / 2].mark = 1;
    out.vertices[out.edges[h / 2].v0].mark = 1;
    out.vertices[out.edges[h / 2].v1].mark = 1;
  }
  return plane::simplify(std::move(out));
}

plane::Region marked_vertex(const plane::Region& shape, plane::Index vertex) {
  plane::Region out = unmarked(shape);
  out.vertices[vertex].mark = 1;
  return plane::simplify(std::move(out));
}

/// The vertices that people see as such.
plane::Region corners(const plane::Region& shape, const plane::CurveNet& net) {
  plane::Region out = unmarked(shape);
  for (const plane::Index v : net.vertices()) out.vertices[v].mark = 1;
  for (const plane::CurveNet::Curve& c : net.curves())
    if (c.from == c.to) out.vertices[c.from].mark = 0;  // of a whole circle
  return out;
}

class Picker {
 public:
  Picker(const formula::World& world, const RealPoint& at) : world_(world), at_(at) {}

  PickedFeature nearest(const RealPoint& place) const {
    const plane::Region* best = nullptr;
    std::string name;
    std::optional<plane::Nearest> near;
    for (const auto& [shape_name, shape] : world_.shapes) {
      const auto found = plane::nearest(
          shape, [](plane::Mark) { return true; }, within(shape_name, place));
      if (!found || (near && !(found->distance < near->distance))) continue;
      near = found;
      best = &*shape;
      name = shape_name;
    }
    if (!near) throw Error(ErrorCode::kBadValue, "no shape has a boundary to measure from");
    return feature(name, *best, within(name, place), *near);
  }

 private:
  bool moves(const std::string& name) const {
    return std::find(world_.moving.begin(), world_.moving.end(), name) != world_.moving.end();
  }

  /// In grid steps of the shape's own coordinates.
  RealPoint within(const std::string& name, const RealPoint& place) const {
    const bool moving = moves(name);
    return {(moving ? place.x - at_.x : place.x) / world_.step, (moving ? place.y - at_.y : place.y) / world_.step};
  }

  PickedFeature feature(const std::string& name, const plane::Region& shape, const RealPoint& p,
                        const plane::Nearest& near) const {
    using Kind = formula::FeatureAt::Kind;
    PickedFeature out;
    out.feature.shape = name;
    out.moving = moves(name);
    const plane::CurveNet net(shape, world_.step);
    const plane::Region marked = corners(shape, net);
    const auto corner = plane::nearest(
        marked, [](plane::Mark m) { return m > 0; }, p);
    const auto box = plane::summarize(shape, world_.step).bbox;
    const double size = box ? std::max(box->high[0] - box->low[0], box->high[1] - box->low[1]) : 0;
    const double farther = corner ? ((corner->distance - near.distance) * world_.step).to_double() : 0;
    const bool alone = near.cell.dimension == 0 && shape.vertices[near.cell.index].out == plane::kNone;
    if (alone || (corner && farther <= kVertexFirst * size)) {
      const plane::Index vertex = alone ? near.cell.index : corner->cell.index;
      out.set = marked_vertex(shape, vertex);
      out.feature.points = {rounded_place(net.at(vertex))};
      return out;
    }
    const plane::CurveNet::Curve& curve =
        net.curve_of(near.cell.dimension == 1 ? near.cell.index : shape.vertices[near.cell.index].out / 2);
    out.set = marked_curve(shape, net, curve);
    out.feature.kind = curve.arc ? Kind::kArc : Kind::kEdge;
    out.feature.points = {rounded_place(curve.arc ? curve.center : net.at(curve.from))};
    if (curve.arc)
      out.feature.radius = Real::from_double(curve.radius);
    else
      out.feature.points.push_back(rounded_place(net.at(curve.to)));
    return out;
  }

  const formula::World& world_;
  RealPoint at_;
};

/// Where it stands in the scene.
std::string place_in_scene(const distance::Coordinates& p, const RealPoint& stand) {
  return fmt::format("[{}, {}]", json_number(p[0].to_double() + stand.x.to_double()),
                     json_number(p[1].to_double() + stand.y.to_double()));
}

std::string feature_json(const formula::FeatureAt& f, const RealPoint& stand) {
  const std::string first = place_in_scene(f.points[0], stand);
  std::string what = "\"vertex\": " + first;
  if (f.kind == formula::FeatureAt::Kind::kArc)
    what = fmt::format(R"("arc": {{"center": {}, "radius": {}}})", first, json_number(f.radius.to_double()));
  if (f.kind == formula::FeatureAt::Kind::kEdge)
    what = fmt::format(R"("edge": [{}, {}])", first, place_in_scene(f.points[1], stand));
  return fmt::format(R"({{"shape": {}, {}}})", json_string(f.shape), what);
}

}  // namespace

FeaturePair features_between(const formula::World& world, const RealPoint& at, const std::array<RealPoint, 2>& places) {
  const Picker picker(world, at);
  PickedFeature from = picker.nearest(places[0]), to = picker.nearest(places[1]);
  const bool both = from.moving && to.moving;
  const bool backwards = to.moving && !both;
  formula::World two;
  two.step = world.step;
  two.moving = {"first"};
  two.shapes.emplace("first", std::move(backwards ? to.set : from.set));
  two.shapes.emplace("second", std::move(backwards ? from.set : to.set));
  formula::Context context;
  context.shapes = {"first", "second"};
  context.moving = two.moving;
  const formula::Solver solver(std::move(two));
  const formula::Formula formula = formula::parse_formula("distance(first, second) >= 0", context);
  const bool moves = (from.moving || to.moving) && !both;
  FeaturePair out{std::move(solver.check(formula, moves ? at : RealPoint{}).atoms.at(0).distance), {}};
  out.distance.features = {std::move(from.feature), std::move(to.feature)};
  if (from.moving) out.stand[0] = at;
  if (to.moving) out.stand[1] = at;
  if (!out.distance.answer || out.distance.answer->witness.size() != 2) return out;
  auto& witness = out.distance.answer->witness;
  if (both)
    for (auto& w : witness) w.at = {w.at[0] + at.x, w.at[1] + at.y};
  if (backwards) std::swap(witness[0], witness[1]);
  return out;
}

std::string feature_pair_json(const FeaturePair& pair, const std::string& unit) {
  const formula::DistanceAt& found = pair.distance;
  std::string points;
  if (found.answer && found.answer->witness.size() == 2)
    points = fmt::format(", \"points\": [{}, {}]", json_point(found.answer->witness[0].at),
                         json_point(found.answer->witness[1].at));
  const auto closed = found.closed_form();
  return fmt::format(R"({{{}"from": {}, "to": {}, "distance": {}{}{}}})", unit_key(unit),
                     feature_json(found.features[0], pair.stand[0]), feature_json(found.features[1], pair.stand[1]),
                     number(found.value()), closed ? ", \"closed_form\": " + json_string(*closed) : "", points);
}

std::string feature_pair_text(const FeaturePair& pair, const std::string& unit) {
  const std::string value = fmt::format("{:.9g}", pair.distance.value().value_or(0));
  return fmt::format("{}{}{} between {}\n", value, unit.empty() ? "" : " ", unit, witness_words(pair.distance));
}

}  // namespace findspace::io
