// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_svg_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "exact/planar/angle.h"
#include "findspace/error.h"
#include "io/text/units.h"

namespace findspace::io {
namespace {

using exact::Real;

constexpr std::string_view kBlanks = " \t\r\n\f,";

std::string_view trim(std::string_view text) {
  std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Numbers with blanks and commas between; throws where anything else is there.
std::vector<Real> numbers(std::string_view text) {
  std::vector<Real> all;
  while (!(text = trim(text)).empty()) {
    std::size_t length = scan_number(text);
    if (length == 0) throw Error(ErrorCode::kSyntax, fmt::format("a number is expected at '{}'", text.substr(0, 20)));
    all.push_back(Real::parse_decimal(text.substr(0, length)));
    text.remove_prefix(length);
  }
  return all;
}

Affine skew(const Real& degrees, bool x) {
  Real tangent = Real::from_double(std::tan(exact::rounded_degrees(degrees) * (std::numbers::pi / 180)));
  return x ? Affine::matrix(1, 0, tangent, 1, 0, 0) : Affine::matrix(1, tangent, 0, 1, 0, 0);
}

Affine one_transform(std::string_view name, const std::vector<Real>& v) {
  std::size_t n = v.size();
  if (name == "translate" && (n == 1 || n == 2)) return Affine::translation(v[0], n == 2 ? v[1] : Real(0));
  if (name == "scale" && (n == 1 || n == 2)) return Affine::scaling(v[0], n == 2 ? v[1] : v[0]);
  if (name == "rotate" && n == 1) return Affine::rotation(v[0]);
  if (name == "rotate" && n == 3) {
    return Affine::translation(v[1], v[2]) * Affine::rotation(v[0]) * Affine::translation(-v[1], -v[2]);
  }
  if (name == "matrix" && n == 6) return Affine::matrix(v[0], v[1], v[2], v[3], v[4], v[5]);
  if ((name == "skewX" || name == "skewY") && n == 1) return skew(v[0], name == "skewX");
  throw Error(ErrorCode::kSyntax, fmt::format("no such transform: {} of {} numbers", name, n));
}

struct LengthUnit {
  std::string_view name;
  int numerator, denominator;  // millimetres
};
constexpr std::array<LengthUnit, 6> kLengthUnits{
    {{"mm", 1, 1}, {"cm", 10, 1}, {"in", 254, 10}, {"pt", 254, 720}, {"pc", 254, 60}, {"Q", 1, 4}}};
/// Lengths of the page it is shown on.
constexpr std::string_view kPageUnits[] = {"", "px", "%", "em", "ex", "rem", "ch", "vw", "vh", "vmin", "vmax"};

std::optional<Real> physical(std::string_view text) {
  text = trim(text);
  std::size_t length = scan_number(text);
  if (length == 0) return std::nullopt;
  const std::string_view name = text.substr(length);
  for (const LengthUnit& unit : kLengthUnits) {
    if (name == unit.name)
      return Real::parse_decimal(text.substr(0, length)) * Real::ratio(unit.numerator, unit.denominator);
  }
  if (std::find(std::begin(kPageUnits), std::end(kPageUnits), name) != std::end(kPageUnits)) return std::nullopt;
  throw Error(ErrorCode::kUnknownName, fmt::format("a width or height with the unknown unit '{}'", name));
}

/// In user units, where it does not depend on the page.
std::optional<Real> fixed_length(std::string_view text) {
  text = trim(text);
  const std::size_t length = scan_number(text);
  if (length == 0) return std::nullopt;
  const std::string_view unit = text.substr(length);
  if (unit.empty() || unit == "px") return Real::parse_decimal(text.substr(0, length));
  const auto millimetres = physical(text);
  if (!millimetres) return std::nullopt;
  return *millimetres * Real::ratio(960, 254);
}

bool states_length(const pugi::xml_node& node, const char* name) {
  const std::string_view text = trim(node.attribute(name).value());
  return !text.empty() && text != "auto";
}

/// What a percentage of a length of this name is of.
std::optional<Real> whole_of(std::string_view name, const SvgFrame& frame) {
  if (name == "width" || name.find('x') != std::string_view::npos) return frame.width;
  if (name == "height" || name.find('y') != std::string_view::npos) return frame.height;
  if (!frame.width || !frame.height) return std::nullopt;
  return sqrt((*frame.width * *frame.width + *frame.height * *frame.height) / Real(2));
}

bool has_view_box(const pugi::xml_node& node) { return !trim(node.attribute("viewBox").value()).empty(); }

/// x, y, width and height of a viewBox.
std::vector<Real> view_box(const pugi::xml_node& node) {
  std::vector<Real> box = numbers(node.attribute("viewBox").value());
  if (box.size() != 4 || box[2].sign() <= 0 || box[3].sign() <= 0)
    throw Error(ErrorCode::kBadValue, "a viewBox is x, y, width and height, both more than 0");
  return box;
}

/// The lengths of an element.
struct SvgLengths {
  const pugi::xml_node& node;
  const SvgFrame& frame;

  Real of(const char* name, const Real& missing = 0) const { return svg_length(node, name, missing, frame); }
  /// Of an element, which draws nothing where it is 0.
  Real extent(const char* name, const Real& missing = 0) const {
    Real value = of(name, missing);
    if (value.sign() < 0) throw Error(ErrorCode::kGeometry, fmt::format("'{}' must not be less than 0", name));
    return value;
  }
};

void draw_points(std::string_view text, bool closed, const char* what, Placed& out) {
  std::vector<Real> v = numbers(text);
  if (v.empty()) return;
  if (v.size() % 2 != 0) throw Error(ErrorCode::kSyntax, "an odd number of coordinates");
  if (v.size() < 4) throw Error(ErrorCode::kGeometry, fmt::format("{} of fewer than two points", what));
  out.move_to(v[0], v[1]);
  for (std::size_t i = 2; i < v.size(); i += 2) out.line_to(v[i], v[i + 1]);
  if (closed) out.close();
}

void draw_rectangle(const SvgLengths& given, Placed& out) {
  Real x = given.of("x"), y = given.of("y");
  Real w = given.extent("width"), h = given.extent("height");
  if (w.sign() == 0 || h.sign() == 0) return;
  Real rx = given.of("rx", given.of("ry")), ry = given.of("ry", rx);
  if (w < rx + rx) rx = w / Real(2);  // the rule of SVG
  if (h < ry + ry) ry = h / Real(2);
  if (rx.sign() <= 0 || ry.sign() <= 0) rx = ry = Real(0);
  bool wide = rx + rx < w, high = ry + ry < h;  // otherwise a side is all corner
  int quarter = -1;
  auto corner = [&](const Real& cx, const Real& cy) {
    ++quarter;
    if (rx.sign() <= 0) return;
    if (compare(rx, ry) == 0) return out.arc_to(rx, false, true, cx, cy);
    const bool right = quarter < 2, low = quarter == 1 || quarter == 2;
    EllipseArc arc = whole_ellipse(right ? x + w - rx : x + rx, low ? y + h - ry : y + ry, rx, ry);
    arc.sweep = std::numbers::pi / 2;
    arc.first = (quarter - 1) * arc.sweep;
    out.ellipse_to(arc, cx, cy);
  };
  out.move_to(x + rx, y);
  if (wide) out.line_to(x + w - rx, y);
  corner(x + w, y + ry);
  if (high) out.line_to(x + w, y + h - ry);
  corner(x + w - rx, y + h);
  if (wide) out.line_to(x + rx, y + h);
  corner(x, y + h - ry);
  if (high) out.line_to(x, y + ry);
  corner(x + rx, y);
  out.close();
}

enum class StyleNumber { kLength, kAngle, kPlain };

/// Numbers of a function in a style, in user units and degrees.
std::vector<Real> style_numbers(std::string_view text, StyleNumber kind) {
  std::vector<Real> all;
  while (!(text = trim(text)).empty()) {
    const std::size_t length = scan_number(text);
    const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
    if (length == 0) throw Error(ErrorCode::kSyntax, fmt::format("a number is expected at '{}'", text.substr(0, 20)));
    const Real value = Real::parse_decimal(text.substr(0, length));
    const std::string_view unit = text.substr(length, end - length);
    const bool angle = kind == StyleNumber::kAngle;
    std::optional<Real> number;
    if (unit.empty() && (kind == StyleNumber::kPlain || value.sign() == 0)) number = value;
    if (kind == StyleNumber::kLength && !unit.empty() && unit != "%") number = fixed_length(text.substr(0, end));
    if (kind == StyleNumber::kPlain && unit == "%") number = value / Real(100);
    if (angle && unit == "deg") number = value;
    if (angle && unit == "grad") number = value * Real::ratio(9, 10);
    if (angle && unit == "turn") number = value * Real(360);
    if (angle && unit == "rad") number = Real::from_double(value.to_double() * (180 / std::numbers::pi));
    if (!number)
      throw Error(ErrorCode::kUnsupported,
                  fmt::format("'{}' in the transform of a style; a length in px or mm, an angle in deg is read",
                              text.substr(0, end)));
    all.push_back(*number);
    text.remove_prefix(end);
  }
  return all;
}

/// A function of CSS by those of SVG; `name` in small letters.
Affine one_style_transform(std::string_view name, std::string_view text) {
  const bool turns = name.starts_with("rotate") || name.starts_with("skew");
  const StyleNumber others = turns ? StyleNumber::kAngle : StyleNumber::kPlain;
  std::vector<Real> v = style_numbers(text, name.starts_with("translate") ? StyleNumber::kLength : others);
  const bool one = v.size() == 1;
  if (name == "translatex" && one) return Affine::translation(v[0], 0);
  if (name == "translatey" && one) return Affine::translation(0, v[0]);
  if (name == "scalex" && one) return Affine::scaling(v[0], 1);
  if (name == "scaley" && one) return Affine::scaling(1, v[0]);
  if (name == "skewx" && one) return skew(v[0], true);
  if (name == "skewy" && one) return skew(v[0], false);
  if (name == "rotatez" && one) return Affine::rotation(v[0]);
  if (name == "skew" && (one || v.size() == 2)) {
    const Affine x = skew(v[0], true), y = one ? Affine() : skew(v[1], false);
    return Affine::matrix(1, y.b, x.c, 1, 0, 0);
  }
  if (name == "rotate" && !one) v.clear();  // a place to turn about is for attributes
  return one_transform(name, v);
}

/// `transform`, of one after the other.
template <class One>
Affine chain_of(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work, One one) {
  constexpr std::uint64_t kLonger = 4;  // units of work for each operation before, by each operation after
  Affine all;
  while (!(text = trim(text)).empty()) {
    ++operations;
    work.charge(kLonger * operations * operations, "a chain of so many transforms");
    std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      throw Error(ErrorCode::kSyntax, fmt::format("the transform '{}' is incomplete", text.substr(0, 40)));
    }
    all = all * one(trim(text.substr(0, open)), text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
  return all;
}

}  // namespace

Real svg_length(const pugi::xml_node& node, const char* name, const Real& missing, const SvgFrame& frame) {
  std::string_view text = trim(node.attribute(name).value());
  if (text.empty() || text == "auto") return missing;
  std::size_t length = scan_number(text);
  std::string_view unit = text.substr(length);
  if (length == 0)
    throw Error(ErrorCode::kSyntax, fmt::format("'{}' of attribute {} is not a number", text.substr(0, 20), name));
  if (unit.empty()) return Real::parse_decimal(text);
  if (const auto fixed = fixed_length(text)) return *fixed;
  const std::optional<Real> whole = whole_of(name, frame);
  if (unit == "%" && whole) return Real::parse_decimal(text.substr(0, length)) / Real(100) * *whole;
  throw Error(ErrorCode::kUnsupported,
              fmt::format("attribute {} with the unit '{}', which depends on the page", name, unit));
}

Affine read_svg_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work) {
  return chain_of(text, operations, work,
                  [](std::string_view name, std::string_view v) { return one_transform(name, numbers(v)); });
}

Affine read_svg_style_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work) {
  return chain_of(text, operations, work, one_style_transform);
}

plane::CurvePoint read_svg_origin(std::string_view text, const SvgFrame& frame) {
  std::vector<std::string_view> words;
  for (std::string_view rest = trim(text); !rest.empty(); rest = trim(rest)) {
    const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
    words.push_back(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  if (words.size() == 1) words.emplace_back("center");
  const auto place = [&](std::string_view word, const std::optional<Real>& whole) -> Real {
    std::optional<Real> part;  // of the whole
    if (word == "left" || word == "top") part = Real(0);
    if (word == "center") part = Real::ratio(1, 2);
    if (word == "right" || word == "bottom") part = Real(1);
    if (word.ends_with('%') && scan_number(word) + 1 == word.size())
      part = Real::parse_decimal(word.substr(0, word.size() - 1)) / Real(100);
    if (part && part->sign() == 0) return 0;
    if (part && whole) return *part * *whole;
    if (const auto fixed = fixed_length(word)) return *fixed;
    throw Error(ErrorCode::kUnsupported, fmt::format("the transform-origin '{}'", text));
  };
  if (words.size() < 2 || words.size() > 3)
    throw Error(ErrorCode::kUnsupported, fmt::format("the transform-origin '{}'", text));
  if (words[0] == "top" || words[0] == "bottom" || words[1] == "left" || words[1] == "right")
    std::swap(words[0], words[1]);
  return {place(words[0], frame.width), place(words[1], frame.height)};
}

std::optional<Real> svg_millimetres(const pugi::xml_node& root) {
  const auto stated = [&](const char* name) { return physical(root.attribute(name).value()); };
  const bool has_unit = stated("width") || stated("height");
  std::optional<Real> width = fixed_length(root.attribute("width").value()),
                      height = fixed_length(root.attribute("height").value());
  const Real pixel = Real::ratio(254, 960);
  if (has_unit && !has_view_box(root)) return pixel;
  if (!has_view_box(root) || !(width || height)) return std::nullopt;
  const std::vector<Real> box = view_box(root);
  if (!width || !height)
    return has_unit ? std::optional((width ? *width / box[2] : *height / box[3]) * pixel) : std::nullopt;
  const Real x = *width / box[2] * pixel, y = *height / box[3] * pixel;
  const std::string_view kept = root.attribute("preserveAspectRatio").value();
  if (kept.find("none") != std::string_view::npos && compare(x, y) != 0)
    throw Error(ErrorCode::kUnsupported, "preserveAspectRatio=\"none\" stretches the drawing in one direction");
  if (!has_unit) return std::nullopt;
  const bool fills = kept.find("slice") != std::string_view::npos;
  return (x < y) != fills ? x : y;  // by default the smaller scale in both directions
}

SvgFrame svg_frame(const pugi::xml_node& root) {
  if (!has_view_box(root))
    return {fixed_length(root.attribute("width").value()), fixed_length(root.attribute("height").value())};
  const std::vector<Real> box = view_box(root);
  return {box[2], box[3]};
}

SvgView svg_view(const pugi::xml_node& node, const pugi::xml_node& user, const SvgFrame& around) {
  SvgView view;
  view.map = Affine::translation(svg_length(node, "x", 0, around), svg_length(node, "y", 0, around));
  const auto side = [&](const char* name, const std::optional<Real>& whole) -> std::optional<Real> {
    for (const pugi::xml_node& one : {user, node}) {
      if (!states_length(one, name)) continue;
      const Real length = svg_length(one, name, 0, around);
      if (length.sign() < 0) throw Error(ErrorCode::kGeometry, fmt::format("'{}' must not be less than 0", name));
      view.empty = view.empty || length.sign() == 0;
      return length;
    }
    return whole;
  };
  view.frame.width = side("width", around.width);
  view.frame.height = side("height", around.height);
  if (!has_view_box(node) || view.empty) return view;
  const std::vector<Real> box = view_box(node);
  if (!view.frame.width || !view.frame.height)
    throw Error(ErrorCode::kUnsupported, "a view without width or height, which depends on the page");
  const auto [width, height] = std::pair(*view.frame.width, *view.frame.height);
  Real sx = width / box[2], sy = height / box[3];
  const std::string_view kept = node.attribute("preserveAspectRatio").value();
  const bool stretches = kept.find("none") != std::string_view::npos;
  if (!stretches) {
    const bool fills = kept.find("slice") != std::string_view::npos;
    sx = sy = (sx < sy) != fills ? sx : sy;
  }
  auto aligned = [&](const Real& room, const char* least, const char* most) {
    if (stretches || kept.find(least) != std::string_view::npos) return Real(0);
    return kept.find(most) != std::string_view::npos ? room : room / Real(2);
  };
  view.map =
      view.map *
      Affine::translation(aligned(width - sx * box[2], "xMin", "xMax"), aligned(height - sy * box[3], "YMin", "YMax")) *
      Affine::scaling(sx, sy) * Affine::translation(-box[0], -box[1]);
  view.frame = {box[2], box[3]};
  return view;
}

void draw_svg_element(const pugi::xml_node& node, std::string_view kind, const Affine& map, const SvgFrame& frame,
                      Outline& outline) {
  Placed out(map, outline);
  const SvgLengths given{node, frame};
  if (kind == "path") {
    const std::string_view path = node.attribute("d").value();
    if (!trim(path).empty()) read_svg_path(path, out);
    return;
  }
  if (kind == "polygon") return draw_points(node.attribute("points").value(), true, "a polygon", out);
  if (kind == "polyline") return draw_points(node.attribute("points").value(), false, "a polyline", out);
  if (kind == "rect") return draw_rectangle(given, out);
  if (kind == "line") {
    out.move_to(given.of("x1"), given.of("y1"));
    return out.line_to(given.of("x2"), given.of("y2"));
  }
  const bool circle = kind == "circle";
  const Real rx = circle ? given.extent("r") : given.extent("rx", given.of("ry"));
  const Real ry = circle ? rx : given.extent("ry", rx);
  if (rx.sign() == 0 || ry.sign() == 0) return;
  const Real cx = given.of("cx"), cy = given.of("cy");
  if (compare(rx, ry) != 0) return out.ellipse(whole_ellipse(cx, cy, rx, ry));
  out.circle(cx, cy, rx);
}

}  // namespace findspace::io
