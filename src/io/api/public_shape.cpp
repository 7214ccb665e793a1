// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// include/findspace/shape.h: a shape is the text that a scene would have.

#include <fmt/format.h>

#include <cmath>

#include "findspace/error.h"
#include "findspace/shape.h"
#include "io/write/write_json.h"

namespace findspace {
namespace {

std::string json_of(const Point& p) { return fmt::format("[{}, {}]", p.x.text(), p.y.text()); }

std::string json_of(const Ring& ring) {
  std::string out = "[";
  for (const Point& p : ring) out += (out.size() > 1 ? ", " : "") + json_of(p);
  return out + "]";
}

std::string list(const std::vector<Shape>& shapes) {
  std::string out = "[";
  for (const Shape& s : shapes) out += (out.size() > 1 ? ", " : "") + s.text();
  return out + "]";
}

}  // namespace

Number::Number(double value) : text_(fmt::format("{}", value)) {
  if (!std::isfinite(value)) throw Error(ErrorCode::kBadValue, "a number must be finite");
}

Shape Shape::polygon(const Ring& ring, const std::vector<Ring>& holes) {
  std::string out = fmt::format("{{\"polygon\": {}", json_of(ring)), inner;
  for (const Ring& h : holes) inner += (inner.empty() ? "" : ", ") + json_of(h);
  return Shape(out + (inner.empty() ? "}" : fmt::format(", \"holes\": [{}]}}", inner)));
}
Shape Shape::disc(const Point& center, const Number& radius) {
  return Shape(fmt::format("{{\"disc\": {{\"center\": {}, \"radius\": {}}}}}", json_of(center), radius.text()));
}
Shape Shape::box(const Point& min, const Point& max) {
  return Shape(fmt::format("{{\"box\": {{\"min\": {}, \"max\": {}}}}}", json_of(min), json_of(max)));
}
Shape Shape::path(std::string_view data) { return Shape(fmt::format("{{\"path\": {}}}", io::json_string(data))); }
Shape Shape::points(const std::vector<Point>& points) {
  return Shape(fmt::format("{{\"points\": {}}}", json_of(points)));
}
Shape Shape::polyline(const std::vector<Point>& points) {
  return Shape(fmt::format("{{\"polyline\": {}}}", json_of(points)));
}

Shape Shape::unite(const std::vector<Shape>& shapes) { return Shape(fmt::format("{{\"union\": {}}}", list(shapes))); }
Shape Shape::intersect(const std::vector<Shape>& shapes) {
  return Shape(fmt::format("{{\"intersection\": {}}}", list(shapes)));
}
Shape Shape::subtract(const std::vector<Shape>& shapes) {
  return Shape(fmt::format("{{\"difference\": {}}}", list(shapes)));
}
Shape Shape::complement(const Shape& shape) { return Shape(fmt::format("{{\"complement\": {}}}", shape.text())); }
Shape Shape::minkowski_sum(const Shape& a, const Shape& b) {
  return Shape(fmt::format("{{\"minkowski_sum\": {}}}", list({a, b})));
}
Shape Shape::offset(const Shape& shape, const Number& radius) {
  return Shape(fmt::format("{{\"offset\": {}, \"of\": {}}}", radius.text(), shape.text()));
}
Shape Shape::hull(const Shape& shape) { return Shape(fmt::format("{{\"hull\": {}}}", shape.text())); }
Shape Shape::translated(const Point& by) const {
  return Shape(fmt::format("{{\"translate\": {}, \"of\": {}}}", json_of(by), json_));
}
Shape Shape::rotated(const Number& degrees) const {
  return Shape(fmt::format("{{\"rotate\": {}, \"of\": {}}}", degrees.text(), json_));
}

}  // namespace findspace
