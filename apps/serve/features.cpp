// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/features.h"

#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "io/write/json_text.h"
#include "io/write/write_witness.h"
#include "plane/complex/simplify.h"
#include "plane/query/curve_net.h"
#include "plane/query/nearest.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;

/// How much farther a vertex may be than an edge to be meant, in parts of the shape's size.
constexpr double kVertexFirst = 0.01;

struct Feature {
  std::string shape;
  bool moving = false;
  plane::Region set;  // in the shape's own coordinates
  std::string json;
};

std::string spot_json(const plane::Place& p) {
  return fmt::format("[{}, {}]", io::json_number(p[0]), io::json_number(p[1]));
}

/// Nothing marked.
plane::Region unmarked(plane::Region region) {
  for (plane::Vertex& v : region.vertices) v.mark = 0;
  for (plane::Edge& e : region.edges) e.mark = 0;
  for (plane::Face& f : region.faces) f.mark = 0;
  return region;
}

/// The curve of the net that has the edge.
const plane::CurveNet::Curve& curve_with(const plane::CurveNet& net, plane::Index edge) {
  return *std::find_if(net.curves().begin(), net.curves().end(), [&](const plane::CurveNet::Curve& c) {
    return std::any_of(c.half_edges.begin(), c.half_edges.end(), [&](plane::Index h) { return h / 2 == edge; });
  });
}

/// The whole curve with its ends, alone.
plane::Region marked_curve(const plane::Region& shape, const plane::CurveNet::Curve& curve) {
  plane::Region out = unmarked(shape);
  for (const plane::Index h : curve.half_edges) {
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

std::string curve_json(const plane::CurveNet& net, const plane::CurveNet::Curve& curve, const plane::Place& by) {
  const auto moved = [&](plane::Place p) { return spot_json({p[0] + by[0], p[1] + by[1]}); };
  if (curve.arc)
    return fmt::format(R"("arc": {{"center": {}, "radius": {}}})", moved(curve.center), io::json_number(curve.radius));
  return fmt::format(R"("edge": [{}, {}])", moved(net.at(curve.from)), moved(net.at(curve.to)));
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

  Feature nearest(const RealPoint& place) const {
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

  Feature feature(const std::string& name, const plane::Region& shape, const RealPoint& p,
                  const plane::Nearest& near) const {
    Feature out;
    out.shape = name;
    out.moving = moves(name);
    const plane::Place by = out.moving ? plane::Place{at_.x.to_double(), at_.y.to_double()} : plane::Place{};
    const plane::CurveNet net(shape, world_.step);
    const plane::Region marked = corners(shape, net);
    const auto corner = plane::nearest(
        marked, [](plane::Mark m) { return m > 0; }, p);
    const auto box = plane::summarize(shape, world_.step).bbox;
    const double size = box ? std::max(box->high[0] - box->low[0], box->high[1] - box->low[1]) : 0;
    std::string what;
    const double farther = corner ? ((corner->distance - near.distance) * world_.step).to_double() : 0;
    const bool alone = near.cell.dimension == 0 && shape.vertices[near.cell.index].out == plane::kNone;
    if (alone || (corner && farther <= kVertexFirst * size)) {
      const plane::Index vertex = alone ? near.cell.index : corner->cell.index;
      out.set = marked_vertex(shape, vertex);
      const plane::Place q = net.at(vertex);
      what = "\"vertex\": " + spot_json({q[0] + by[0], q[1] + by[1]});
    } else {
      const plane::CurveNet::Curve& curve =
          curve_with(net, near.cell.dimension == 1 ? near.cell.index : shape.vertices[near.cell.index].out / 2);
      out.set = marked_curve(shape, curve);
      what = curve_json(net, curve, by);
    }
    out.json = fmt::format(R"({{"shape": {}, {}}})", io::json_string(name), what);
    return out;
  }

  const formula::World& world_;
  RealPoint at_;
};

}  // namespace

std::string features_between(const formula::World& world, const RealPoint& at, const std::array<RealPoint, 2>& places,
                             const std::string& unit) {
  const Picker picker(world, at);
  Feature from = picker.nearest(places[0]), to = picker.nearest(places[1]);
  const std::string pair = fmt::format(R"("from": {}, "to": {})", from.json, to.json);
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
  const formula::Check check = solver.check(formula, moves ? at : RealPoint{});
  const formula::DistanceAt& found = check.atoms.at(0).distance;
  std::string points;
  if (found.answer && found.answer->witness.size() == 2) {
    auto shown = [&](std::size_t k) {
      distance::Coordinates p = found.answer->witness[k].at;
      if (both) p = {p[0] + at.x, p[1] + at.y};
      return io::json_point(p);
    };
    const std::size_t first = backwards ? 1 : 0;
    points = fmt::format(", \"points\": [{}, {}]", shown(first), shown(1 - first));
  }
  const auto closed = found.closed_form();
  return fmt::format(R"({{{}{}, "distance": {}{}{}}})", io::unit_key(unit), pair, io::number(found.value()),
                     closed ? ", \"closed_form\": " + io::json_string(*closed) : "", points);
}

}  // namespace findspace::app
