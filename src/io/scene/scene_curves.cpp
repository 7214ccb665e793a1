// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/scene_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "io/text/drawing_rules.h"
#include "io/text/outline_shapes.h"
#include "io/text/read_transform.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::CurvePoint;
using plane::ShapePtr;

CurvePoint read_place(const SceneReader& json, const JsonValue& value, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "a point [x, y]", label);
  if (value.size() != 2)
    json.fail(ErrorCode::kBadValue, fmt::format("a point needs 2 coordinates, not {}", value.size()), label, value);
  return {json.number(value.items()[0], label), json.number(value.items()[1], label)};
}

std::vector<CurvePoint> read_places(const SceneReader& json, const JsonValue& value, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "a list of points", label);
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < value.size(); ++i)
    points.push_back(read_place(json, value.items()[i], label.part("point", i)));
  return points;
}

std::vector<Real> read_numbers(const SceneReader& json, const JsonValue* value, const Label& label) {
  std::vector<Real> numbers;
  if (value == nullptr) return numbers;
  json.expect(*value, JsonValue::Kind::kArray, "a list of numbers", label);
  for (std::size_t i = 0; i < value->size(); ++i)
    numbers.push_back(json.number(value->items()[i], label.part("number", i)));
  return numbers;
}

bool read_flag(const SceneReader& json, const JsonValue* value, bool missing, const Label& label) {
  if (value == nullptr) return missing;
  json.expect(*value, JsonValue::Kind::kBoolean, fmt::format("\"{}\"", label.what), label);
  return value->boolean;
}

/// Draws into an outline, and makes a shape of it by `made`; errors get the place of `value`.
template <class Draw>
ShapePtr drawn_shape(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label,
                     Draw draw, decltype(&shape_of) made = &shape_of) {
  reader.use_dimension(2, label, value);
  const RulesBeside rules(reader, object, label);
  return reader.json().placed(label, value, [&] {
    Outline outline(reader.context());
    draw(outline);
    return made(outline.take(), reader.context(), reader.json().place(label, value));
  });
}

ShapePtr build_bezier(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  const std::vector<CurvePoint> points = read_places(json, value, label);
  if (points.size() < 2) json.fail(ErrorCode::kBadValue, "a Bezier curve needs two points or more", label, value);
  const std::vector<Real> weights = read_numbers(json, object.find("weights"), label.part("weights"));
  return drawn_shape(reader, object, value, label, [&](Outline& outline) {
    outline.move_to(points[0].x, points[0].y);
    outline.curve_to(std::span(points).subspan(1), weights);
  });
}

ShapePtr build_ellipse(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  static constexpr std::array<std::string_view, 3> kKeys{"center", "radii", "rotate"};
  json.expect(value, JsonValue::Kind::kObject, "\"ellipse\"", label);
  json.check_keys(value, kKeys, label);
  const CurvePoint center = read_place(json, json.need(value, "center", label), label.part("center"));
  const JsonValue& radii_value = json.need(value, "radii", label);
  const CurvePoint radii = read_place(json, radii_value, label.part("radii"));
  if (radii.x.sign() <= 0 || radii.y.sign() <= 0)
    json.fail(ErrorCode::kBadValue, "a radius must be more than 0", label.part("radii"), radii_value);
  Real degrees;
  if (const JsonValue* given = value.find("rotate")) degrees = json.number(*given, label.part("rotate"));
  const Direction axis = direction(degrees);
  return drawn_shape(reader, object, value, label, [&](Outline& outline) {
    if (radii.x == radii.y) return outline.circle(center.x, center.y, radii.x);
    outline.ellipse(
        {{center, {radii.x * axis.cosine, radii.x * axis.sine}, {-radii.y * axis.sine, radii.y * axis.cosine}},
         0,
         2 * std::numbers::pi});
  });
}

/// The knots of a spline that goes through its ends, or of one that closes smoothly.
std::vector<Real> usual_knots(std::size_t points, std::size_t degree, bool closed) {
  std::vector<Real> knots;
  const auto n = static_cast<std::int64_t>(points), p = static_cast<std::int64_t>(degree);
  for (std::int64_t i = 0; i < n + p + 1; ++i)
    knots.push_back(Real(closed ? i : std::clamp<std::int64_t>(i - p, 0, n - p)));
  return knots;
}

plane::Spline read_spline(const SceneReader& json, const JsonValue& value, const Label& label) {
  static constexpr std::array<std::string_view, 5> kKeys{"degree", "points", "knots", "weights", "closed"};
  json.expect(value, JsonValue::Kind::kObject, "\"spline\"", label);
  json.check_keys(value, kKeys, label);
  plane::Spline spline;
  if (const JsonValue* degree = value.find("degree")) {
    const auto n = json.number(*degree, label.part("degree")).integer();
    if (!n || *n < 1 || *n > static_cast<int>(plane::kMostDegree))
      json.fail(ErrorCode::kBadValue, fmt::format("\"degree\" is a whole number from 1 to {}", plane::kMostDegree),
                label, *degree);
    spline.degree = static_cast<std::size_t>(*n);
  }
  spline.points = read_places(json, json.need(value, "points", label), label.part("points"));
  spline.weights = read_numbers(json, value.find("weights"), label.part("weights"));
  spline.knots = read_numbers(json, value.find("knots"), label.part("knots"));
  const bool closed = read_flag(json, value.find("closed"), false, label.part("closed"));
  if (closed && !spline.knots.empty())
    json.fail(ErrorCode::kBadValue, "a closed spline has knots of its own", label.part("knots"), value);
  for (std::size_t i = 0; closed && i < spline.degree && i < spline.points.size(); ++i) {
    spline.points.push_back(spline.points[i]);
    if (!spline.weights.empty()) spline.weights.push_back(spline.weights[i]);
  }
  if (spline.knots.empty() && spline.points.size() > spline.degree)
    spline.knots = usual_knots(spline.points.size(), spline.degree, closed);
  return spline;
}

ShapePtr build_spline(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const plane::Spline spline = read_spline(reader.json(), value, label);
  return drawn_shape(reader, object, value, label, [&](Outline& outline) {
    plane::check_spline(spline);
    const CurvePoint first = plane::spline_end(spline, false);
    outline.move_to(first.x, first.y);
    outline.spline_to(spline);
  });
}

/// Where an outline is, exactly.
struct Pen {
  const SceneReader& json;
  Outline& outline;
  CurvePoint start, at;

  void center_arc(const JsonValue& step, const CurvePoint& to, const Label& label);
  void step(const JsonValue& value, const Label& label);
};

void Pen::center_arc(const JsonValue& step, const CurvePoint& to, const Label& label) {
  const CurvePoint c = read_place(json, *step.find("center"), label.part("center"));
  const bool ccw = read_flag(json, step.find("ccw"), true, label.part("ccw"));
  const Real dx = at.x - c.x, dy = at.y - c.y, ex = to.x - c.x, ey = to.y - c.y;
  const Real r = sqrt(dx * dx + dy * dy);
  const double step_size = json.context().grid.step_size();
  if (std::abs((sqrt(ex * ex + ey * ey) - r).to_double()) > 2 * step_size)
    json.fail(ErrorCode::kGeometry, "the center is not equally far from both ends of the arc", label, step);
  if (to.x == at.x && to.y == at.y) {  // the whole circle
    outline.bulge_to(Real(ccw ? 1 : -1), c.x - dx, c.y - dy);
    return outline.bulge_to(Real(ccw ? 1 : -1), to.x, to.y);
  }
  const int turn = (dx * ey - dy * ex).sign();
  outline.arc_to(r, turn == (ccw ? -1 : 1), ccw, to.x, to.y);
}

/// A step goes one way; what belongs to another has no meaning in it.
void check_way(const SceneReader& json, const JsonValue& step, const Label& label) {
  struct Way {
    std::string_view key;
    std::array<std::string_view, 2> beside;
  };
  static constexpr std::array<Way, 4> kWays{
      {{"through", {"to"}}, {"center", {"to", "ccw"}}, {"bulge", {"to"}}, {"bezier", {"weights"}}}};
  const auto way = std::find_if(kWays.begin(), kWays.end(), [&](const Way& w) { return step.find(w.key) != nullptr; });
  const Way own = way == kWays.end() ? Way{"to", {}} : *way;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const std::string_view key = step.keys()[i];
    if (key == own.key || std::find(own.beside.begin(), own.beside.end(), key) != own.beside.end()) continue;
    json.fail(ErrorCode::kBadValue,
              own.key == "to" ? fmt::format("\"{}\" has no meaning in a straight step", key)
                              : fmt::format("\"{}\" and \"{}\" do not go together", own.key, key),
              label, step.items()[i]);
  }
}

void Pen::step(const JsonValue& value, const Label& label) {
  if (value.is(JsonValue::Kind::kArray)) {
    at = read_place(json, value, label);
    return outline.line_to(at.x, at.y);
  }
  static constexpr std::array<std::string_view, 7> kKeys{"to",    "through", "center", "ccw",
                                                         "bulge", "bezier",  "weights"};
  json.expect(value, JsonValue::Kind::kObject, "a step of an outline (if it is not a point)", label);
  json.check_keys(value, kKeys, label);
  check_way(json, value, label);
  if (const JsonValue* bezier = value.find("bezier")) {
    const std::vector<CurvePoint> points = read_places(json, *bezier, label.part("bezier"));
    if (points.empty()) json.fail(ErrorCode::kBadValue, "\"bezier\" is an empty list", label, *bezier);
    outline.curve_to(points, read_numbers(json, value.find("weights"), label.part("weights")));
    at = points.back();
    return;
  }
  const CurvePoint to = read_place(json, json.need(value, "to", label), label.part("to"));
  if (const JsonValue* through = value.find("through")) {
    const CurvePoint m = read_place(json, *through, label.part("through"));
    outline.through_to(m.x, m.y, to.x, to.y);
  } else if (value.find("center")) {
    center_arc(value, to, label);
  } else if (const JsonValue* bulge = value.find("bulge")) {
    outline.bulge_to(json.number(*bulge, label.part("bulge")), to.x, to.y);
  } else {
    outline.line_to(to.x, to.y);
  }
  at = to;
}

void draw_outline(const SceneReader& json, const JsonValue& value, Outline& outline, const Label& label) {
  json.expect(value, JsonValue::Kind::kArray, "\"outline\"", label);
  if (value.size() < 2) json.fail(ErrorCode::kGeometry, "an outline needs a point and a step", label, value);
  const CurvePoint first = read_place(json, value.items()[0], label.part("step", 0));
  Pen pen{json, outline, first, first};
  outline.move_to(first.x, first.y);
  for (std::size_t i = 1; i < value.size(); ++i) {
    const Label at = label.part("step", i);
    json.placed(at, value.items()[i], [&] { pen.step(value.items()[i], at); });
  }
  outline.close();
}

ShapePtr build_outline(ShapeReader& reader, const JsonValue& object, const JsonValue& value, const Label& label) {
  const SceneReader& json = reader.json();
  const JsonValue* holes = object.find("holes");
  const auto draw = [&](Outline& outline) {
    draw_outline(json, value, outline, label);
    if (holes == nullptr) return;
    json.expect(*holes, JsonValue::Kind::kArray, "\"holes\"", label);
    for (std::size_t i = 0; i < holes->size(); ++i)
      draw_outline(json, holes->items()[i], outline, label.part("hole", i));
  };
  return drawn_shape(reader, object, value, label, draw, holes == nullptr ? &shape_of : &polygon_of);
}

}  // namespace

DrawingRules read_drawing_rules(const SceneReader& json, const JsonValue& object, const Label& label) {
  DrawingRules rules;
  auto length = [&](const char* key, std::optional<std::string>& to) {
    const JsonValue* value = object.find(key);
    if (value == nullptr) return;
    if (!value->is(JsonValue::Kind::kNumber) && !value->is(JsonValue::Kind::kString))
      json.fail(ErrorCode::kBadValue, fmt::format("\"{}\" is a number, or a text such as \"0.01mm\"", key), label,
                *value);
    json.placed(label.part(key), *value, [&] { parse_length(value->text(), json.context().unit); });
    to = value->text();
  };
  if (const JsonValue* curves = object.find("curves")) {
    const std::string_view word = json.text(*curves, "\"curves\"", label);
    rules.curves = json.placed(label.part("curves"), *curves, [&] { return parse_curve_rule(word); });
  }
  length("tolerance", rules.tolerance);
  length("join", rules.join);
  length("mend", rules.mend);
  length("repair", rules.repair);
  length("close_holes", rules.close_holes);
  if (const JsonValue* lines = object.find("open_lines"))
    rules.open_lines = read_flag(json, lines, false, label.part("open_lines"));
  if (const JsonValue* parts = object.find("parts")) {
    const std::string_view word = json.text(*parts, "\"parts\"", label);
    rules.parts = json.placed(label.part("parts"), *parts, [&] { return parse_part_rule(word); });
  }
  return rules;
}

RulesBeside::RulesBeside(ShapeReader& reader, const JsonValue& object, const Label& label)
    : context_(reader.context()), before_(context_.drawing) {
  const DrawingRules own = read_drawing_rules(reader.json(), object, label);
  reader.json().placed(label, object,
                       [&] { context_.use(context_.options.drawings.over(own.over(context_.scene_rules))); });
}

std::span<const ShapeKind> curve_kinds() {
  static const std::array<ShapeKind, 4> kinds{{{"bezier", {"weights", "curves", "tolerance"}, build_bezier},
                                               {"ellipse", {"curves", "tolerance"}, build_ellipse},
                                               {"spline", {"curves", "tolerance"}, build_spline},
                                               {"outline", {"holes", "curves", "tolerance"}, build_outline}}};
  return kinds;
}

}  // namespace findspace::io
