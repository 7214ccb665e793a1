// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/plane.h"
#include "exact/number/real_text.h"
#include "exact/planar/geometry_signs.h"
#include "plane/complex/marked_curves.h"

namespace findspace::io {
namespace {

using exact::Geometry;
using exact::Real;
using exact::SupportingCurve;
using plane::Index;
using plane::Mark;
using Kind = JsonValue::Kind;

class CellsReader {
 public:
  CellsReader(const SceneReader& json, const Label& label) : json_(json), label_(label) {}

  plane::Region region(const JsonValue& value, const Real& scale) {
    static constexpr std::array<std::string_view, 7> kKeys{
        "step", "unit", "numbers", "outside", "supporting_curves", "vertices", "edges"};
    json_.expect(value, Kind::kObject, "\"cells\"", label_);
    json_.check_keys(value, kKeys, label_);
    if (const JsonValue* numbers = value.find("numbers")) define(*numbers);
    find_factor(value, scale);
    const Mark outside = truth(json_.need(value, "outside", label_));
    plane::MarkedCurves curves(outside);
    for (const JsonValue& item : list(value, "supporting_curves")) add_supporting_curve(curves.curves.geometry, item);
    const std::span<const JsonValue> vertices = list(value, "vertices");
    for (const JsonValue& item : vertices) points_.push_back(point(curves.curves.geometry, item));
    ends_.assign(vertices.size(), 0);
    for (const JsonValue& item : list(value, "edges")) add_edge(curves, item);
    add_vertices(curves, vertices);
    if (vertices.empty()) return plane::CellComplex::uniform(outside);
    return json_.placed(label_, value, [&] { return complex(std::move(curves)); });
  }

 private:
  [[noreturn]] void fail(const std::string& why, const JsonValue& at) const {
    json_.fail(ErrorCode::kGeometry, why, label_, at);
  }

  std::span<const JsonValue> list(const JsonValue& value, std::string_view key) const {
    const JsonValue& items = json_.need(value, key, label_);
    json_.expect(items, Kind::kArray, fmt::format("\"{}\"", key), label_);
    return items.items();
  }

  Mark truth(const JsonValue& value) const {
    json_.expect(value, Kind::kBoolean, "whether a cell belongs", label_);
    return value.boolean;
  }

  Real number(const JsonValue& value) const {
    if (!value.is(Kind::kNumber)) json_.expect(value, Kind::kString, "an exact number", label_);
    return json_.placed(label_, value, [&] {
      return value.is(Kind::kNumber) ? Real::parse_decimal(value.text()) : numbers_.read(value.text());
    });
  }

  std::int64_t whole(const JsonValue& value, std::int64_t low, std::int64_t high, const char* meaning) const {
    const auto n = json_.number(value, label_).integer();
    if (!n || *n < low || *n > high) {
      json_.fail(ErrorCode::kBadValue, fmt::format("{} is a whole number from {} to {}", meaning, low, high), label_,
                 value);
    }
    return static_cast<std::int64_t>(*n);
  }

  Index index(const JsonValue& value, std::size_t count, const char* meaning) const {
    return static_cast<Index>(whole(value, 0, static_cast<std::int64_t>(count) - 1, meaning));
  }

  void define(const JsonValue& definitions) {
    json_.expect(definitions, Kind::kArray, "\"numbers\"", label_);
    for (const JsonValue& item : definitions.items()) {
      json_.expect(item, Kind::kString, "the definition of a number", label_);
      json_.placed(label_, item, [&] { numbers_.define(item.text()); });
    }
  }

  /// How many of the scene's grid steps make one of the value's.
  void find_factor(const JsonValue& value, const Real& scale) {
    const JsonValue& step = json_.need(value, "step", label_);
    Real unit = scale;
    if (const JsonValue* name = value.find("unit")) {
      const Unit given = json_.placed(label_, *name, [&] { return parse_unit(json_.text(*name, "\"unit\"", label_)); });
      if (!json_.context().unit)
        json_.fail(ErrorCode::kBadValue, "the cells have a unit, so the scene needs \"unit\" too", label_, *name);
      unit = formula::factor(given, *json_.context().unit);
    }
    const Real size = number(step);
    if (size.sign() <= 0) json_.fail(ErrorCode::kBadValue, "\"step\" must be more than 0", label_, step);
    factor_ = size * unit / json_.context().grid.step();
  }

  std::span<const JsonValue> numbers_of(const JsonValue& value, std::size_t count, const char* meaning) const {
    json_.expect(value, Kind::kArray, meaning, label_);
    if (value.size() != count) {
      json_.fail(ErrorCode::kBadValue, fmt::format("{} has {} numbers, not {}", meaning, count, value.size()), label_,
                 value);
    }
    return value.items();
  }

  void add_supporting_curve(Geometry& g, const JsonValue& item) const {
    static constexpr std::array<std::string_view, 3> kKeys{"line", "shift", "circle"};
    json_.expect(item, Kind::kObject, "a supporting curve", label_);
    json_.check_keys(item, kKeys, label_);
    if (const JsonValue* circle = item.find("circle")) {
      const std::span<const JsonValue> n = numbers_of(*circle, 3, "a circle [x, y, radius]");
      const Real radius = number(n[2]) * factor_;
      if (radius.sign() <= 0) json_.fail(ErrorCode::kBadValue, "a radius must be more than 0", label_, item);
      g.add(SupportingCurve::circle_at(number(n[0]) * factor_, number(n[1]) * factor_, radius));
      return;
    }
    g.add(line(item));
  }

  SupportingCurve line(const JsonValue& item) const {
    constexpr std::int64_t kMost = std::int64_t(1) << 42;
    const std::span<const JsonValue> n = numbers_of(json_.need(item, "line", label_), 3, "a line [a, b, c]");
    std::int64_t a = whole(n[0], -kMost, kMost, "a normal"), b = whole(n[1], -kMost, kMost, "a normal");
    if (a == 0 && b == 0) json_.fail(ErrorCode::kBadValue, "a line needs a normal", label_, item);
    const Real parts(exact::make_primitive(a, b)), c = number(n[2]) * factor_ / parts;
    const JsonValue* shift = item.find("shift");
    if (shift == nullptr) return SupportingCurve::line(a, b, c);
    const Real by = number(*shift) * factor_ / Real(parts.sign());
    if (const auto k = c.integer()) return SupportingCurve::displaced_line(a, b, *k, by);
    return SupportingCurve::line(a, b, c + by * sqrt(Real(exact::int128(a) * a + exact::int128(b) * b)));
  }

  Index point(Geometry& g, const JsonValue& item) const {
    static constexpr std::array<std::string_view, 5> kKeys{"at", "on", "root", "in", "around"};
    json_.expect(item, Kind::kObject, "a vertex", label_);
    json_.check_keys(item, kKeys, label_);
    const Index p = item.find("on") ? crossing(g, item) : place(g, item);
    if (std::fabs(g.points[p].x) > margin::kFarthestVertex || std::fabs(g.points[p].y) > margin::kFarthestVertex)
      json_.fail(ErrorCode::kOutOfRange, "a vertex is more than 2^42 grid steps away", label_, item);
    return p;
  }

  Index place(Geometry& g, const JsonValue& item) const {
    const std::span<const JsonValue> n = numbers_of(json_.need(item, "at", label_), 2, "a place [x, y]");
    return g.add_real_point(number(n[0]) * factor_, number(n[1]) * factor_);
  }

  Index crossing(Geometry& g, const JsonValue& item) const {
    const std::span<const JsonValue> n = numbers_of(json_.need(item, "on", label_), 2, "\"on\"");
    const Index i = index(n[0], g.supporting_curves.size(), "a supporting curve"),
                j = index(n[1], g.supporting_curves.size(), "a supporting curve");
    const auto root = static_cast<int>(whole(json_.need(item, "root", label_), -1, 1, "\"root\""));
    if (i >= j || exact::same_supporting_curve(g.supporting_curves[i], g.supporting_curves[j]))
      fail("a vertex is on two supporting curves [i, j], i < j", item);
    const exact::Meeting meeting = meet(g, i, j);
    const auto end = meeting.root.begin() + meeting.count;
    if (std::find(meeting.root.begin(), end, root) == end)
      fail(fmt::format("supporting curves {} and {} do not meet with root {}", i, j, root), item);
    return g.add_crossing(i, j, root);
  }

  void add_edge(plane::MarkedCurves& out, const JsonValue& item) {
    static constexpr std::array<std::string_view, 7> kKeys{"on", "half", "from", "to", "in", "left", "right"};
    json_.expect(item, Kind::kObject, "an edge", label_);
    json_.check_keys(item, kKeys, label_);
    const Geometry& g = out.curves.geometry;
    const auto member = [&](const char* key) -> const JsonValue& { return json_.need(item, key, label_); };
    plane::Piece piece;
    piece.supporting_curve = index(member("on"), g.supporting_curves.size(), "a supporting curve");
    const Index from = index(member("from"), points_.size(), "a vertex");
    const Index to = index(member("to"), points_.size(), "a vertex");
    ends_[from] = ends_[to] = 1;
    piece.p0 = points_[from];
    piece.p1 = points_[to];
    const bool circle = g.supporting_curves[piece.supporting_curve].circle;
    if (circle) piece.half = static_cast<std::int8_t>(whole(member("half"), -1, 1, "\"half\" (1 upper, -1 lower)"));
    if (circle != (item.find("half") != nullptr) || (circle && piece.half == 0))
      fail("an edge has a \"half\", 1 or -1, where it is on a circle", item);
    for (const Index p : {piece.p0, piece.p1}) {
      if (!lies_on(g, p, piece.supporting_curve)) fail("an end of an edge is not on its supporting curve", item);
      if (circle && above_center(g, p, piece.supporting_curve) * piece.half < 0)
        fail("an end of an edge is on the other half of its circle", item);
    }
    if (compare_xy(g, piece.p0, piece.p1) >= 0) fail("an edge runs to the right (or straight up)", item);
    out.curves.pieces.push_back(piece);
    out.curves.forward.push_back(1);
    out.mark({truth(member("in")), truth(member("left")), truth(member("right"))});
  }

  void add_vertices(plane::MarkedCurves& out, std::span<const JsonValue> vertices) const {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Mark in = truth(json_.need(vertices[v], "in", label_));
      const JsonValue* around = vertices[v].find("around");
      if ((around == nullptr) == (ends_[v] == 0))
        fail("a vertex has \"around\" exactly where no edge ends in it", vertices[v]);
      if (around)
        out.add_isolated(points_[v], in, truth(*around));
      else
        out.add_vertex(points_[v], in);
    }
  }

  plane::Region complex(plane::MarkedCurves curves) const {
    auto result = std::move(curves).complex();
    if (auto* region = std::get_if<plane::CellComplex>(&result)) return std::move(*region);
    const plane::CurveFault& at = std::get<plane::CurveFault>(result);
    const double step = json_.context().grid.step_size();
    throw Error(ErrorCode::kGeometry,
                fmt::format("near ({:g}, {:g}) curves meet without a vertex, vertices coincide, or the sides of the "
                            "edges around a face disagree",
                            at.x * step, at.y * step));
  }

  const SceneReader& json_;
  const Label& label_;
  exact::RealReader numbers_;
  Real factor_{1};
  std::vector<Index> points_;
  std::vector<char> ends_;  // vertex: some edge ends there
};

}  // namespace

plane::ShapePtr read_cells(const SceneReader& json, const JsonValue& value, const Label& label, const Real& scale) {
  plane::Shape shape;
  shape.kind = plane::Shape::Kind::kCells;
  shape.place = json.place(label, value);
  shape.cells = std::make_shared<const plane::CellComplex>(CellsReader(json, label).region(value, scale));
  return std::make_shared<const plane::Shape>(std::move(shape));
}

}  // namespace findspace::io
