// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_svg_attributes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
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

void draw_points(std::string_view text, bool closed, const char* what, Placed& out) {
  std::vector<Real> v = numbers(text);
  if (v.empty()) return;
  if (v.size() % 2 != 0) throw Error(ErrorCode::kSyntax, "an odd number of coordinates");
  if (v.size() < 4) throw Error(ErrorCode::kGeometry, fmt::format("{} of fewer than two points", what));
  out.move_to(v[0], v[1]);
  for (std::size_t i = 2; i < v.size(); i += 2) out.line_to(v[i], v[i + 1]);
  if (closed) out.close();
}

/// Of an element, which draws nothing where it is 0.
Real extent_of(const pugi::xml_node& node, const char* name, const Real& missing = 0) {
  Real value = svg_length(node, name, missing);
  if (value.sign() < 0) throw Error(ErrorCode::kGeometry, fmt::format("'{}' must not be less than 0", name));
  return value;
}

void draw_rectangle(const pugi::xml_node& node, Placed& out) {
  Real x = svg_length(node, "x", 0), y = svg_length(node, "y", 0);
  Real w = extent_of(node, "width"), h = extent_of(node, "height");
  if (w.sign() == 0 || h.sign() == 0) return;
  Real rx = svg_length(node, "rx", svg_length(node, "ry", 0)), ry = svg_length(node, "ry", rx);
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

}  // namespace

Real svg_length(const pugi::xml_node& node, const char* name, const Real& missing) {
  std::string_view text = trim(node.attribute(name).value());
  if (text.empty()) return missing;
  std::size_t length = scan_number(text);
  std::string_view unit = text.substr(length);
  if (length == 0)
    throw Error(ErrorCode::kSyntax, fmt::format("'{}' of attribute {} is not a number", text.substr(0, 20), name));
  const Real value = Real::parse_decimal(text.substr(0, length));
  if (unit.empty() || unit == "px") return value;
  if (const auto millimetres = physical(text)) return *millimetres * Real::ratio(960, 254);
  throw Error(ErrorCode::kUnsupported,
              fmt::format("attribute {} with the unit '{}', which depends on the page", name, unit));
}

/// Units of work for each operation before, by each operation after.
constexpr std::uint64_t kLonger = 4;

Affine read_svg_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work) {
  Affine all;
  while (!(text = trim(text)).empty()) {
    ++operations;
    work.charge(kLonger * operations * operations, "a chain of so many transforms");
    std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      throw Error(ErrorCode::kSyntax, fmt::format("the transform '{}' is incomplete", text.substr(0, 40)));
    }
    all = all * one_transform(trim(text.substr(0, open)), numbers(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
  return all;
}

std::optional<Real> svg_millimetres(const pugi::xml_node& root) {
  std::optional<Real> width = physical(root.attribute("width").value()),
                      height = physical(root.attribute("height").value());
  if (!width && !height) return std::nullopt;
  std::vector<Real> box = numbers(root.attribute("viewBox").value());
  if (box.empty()) return Real::ratio(254, 960);  // a user unit is a px, 1/96 in
  if (box.size() != 4 || box[2].sign() <= 0 || box[3].sign() <= 0) {
    throw Error(ErrorCode::kBadValue, "a viewBox is x, y, width and height, both more than 0");
  }
  if (width && height) {
    const Real x = *width / box[2], y = *height / box[3];
    const std::string_view kept = root.attribute("preserveAspectRatio").value();
    if (kept.find("none") != std::string_view::npos && compare(x, y) != 0)
      throw Error(ErrorCode::kUnsupported, "preserveAspectRatio=\"none\" stretches the drawing in one direction");
    const bool fills = kept.find("slice") != std::string_view::npos;
    return (x < y) != fills ? x : y;  // by default the smaller scale in both directions
  }
  return width ? *width / box[2] : *height / box[3];
}

Affine svg_view(const pugi::xml_node& node, const pugi::xml_node& frame) {
  const std::vector<Real> box = numbers(node.attribute("viewBox").value());
  if (box.size() != 4 || box[2].sign() <= 0 || box[3].sign() <= 0)
    throw Error(ErrorCode::kBadValue, "a viewBox is x, y, width and height, both more than 0");
  const Real width = svg_length(frame, "width", svg_length(node, "width", box[2]));
  const Real height = svg_length(frame, "height", svg_length(node, "height", box[3]));
  Real sx = width / box[2], sy = height / box[3];
  const std::string_view kept = node.attribute("preserveAspectRatio").value();
  if (kept.find("none") == std::string_view::npos) {
    const bool fills = kept.find("slice") != std::string_view::npos;
    sx = sy = (sx < sy) != fills ? sx : sy;
  }
  auto aligned = [&](const Real& room, const char* least, const char* most) {
    if (kept.find("none") != std::string_view::npos || kept.find(least) != std::string_view::npos) return Real(0);
    return kept.find(most) != std::string_view::npos ? room : room / Real(2);
  };
  return Affine::translation(aligned(width - sx * box[2], "xMin", "xMax"),
                             aligned(height - sy * box[3], "YMin", "YMax")) *
         Affine::scaling(sx, sy) * Affine::translation(-box[0], -box[1]);
}

void draw_svg_element(const pugi::xml_node& node, std::string_view kind, const Affine& map, Outline& outline) {
  Placed out(map, outline);
  if (kind == "path") {
    const std::string_view path = node.attribute("d").value();
    if (!trim(path).empty()) read_svg_path(path, out);
    return;
  }
  if (kind == "polygon") return draw_points(node.attribute("points").value(), true, "a polygon", out);
  if (kind == "polyline") return draw_points(node.attribute("points").value(), false, "a polyline", out);
  if (kind == "rect") return draw_rectangle(node, out);
  if (kind == "line") {
    out.move_to(svg_length(node, "x1", 0), svg_length(node, "y1", 0));
    return out.line_to(svg_length(node, "x2", 0), svg_length(node, "y2", 0));
  }
  const bool circle = kind == "circle";
  const Real rx = circle ? extent_of(node, "r") : extent_of(node, "rx", svg_length(node, "ry", 0));
  const Real ry = circle ? rx : extent_of(node, "ry", rx);
  if (rx.sign() == 0 || ry.sign() == 0) return;
  const Real cx = svg_length(node, "cx", 0), cy = svg_length(node, "cy", 0);
  if (compare(rx, ry) != 0) return out.ellipse(whole_ellipse(cx, cy, rx, ry));
  out.circle(cx, cy, rx);
}

}  // namespace findspace::io
