// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes as values: what a scene file can say, said in C++. A shape is a plane set given by exact decimal numbers in
// the unit of the World it will stand in; the primitive ones are closed, operations are the plain ones of point sets,
// not regularised (docs/scene.md). Guarantee: a shape is the text it is made from; numbers keep every digit. Cost: that
// of copying text, nothing is computed here. Errors in a shape (a ring that crosses itself, a negative radius) are
// thrown by World, with the shape's name. Keywords: polygon with holes, disc, path, Boolean operation, Minkowski sum,
// offset.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace findspace {

/// A decimal number, exactly as written: Number("1.1") is 11/10. A double counts as the shortest decimal that reads
/// back as it; Error(kBadValue) for one that is not finite. Text that is no number is refused where it is used.
class Number {
 public:
  template <std::integral T>
  Number(T value) : text_(std::to_string(value)) {}           // NOLINT: implicit on purpose
  Number(double value);                                       // NOLINT
  Number(const char* decimal) : text_(decimal) {}             // NOLINT
  Number(std::string decimal) : text_(std::move(decimal)) {}  // NOLINT
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct Point {
  Number x, y;
};
using Ring = std::vector<Point>;

class Shape {
 public:
  /// The closed set within the ring and outside the holes: their interiors are left out. Rings are simple and run
  /// either way; holes lie inside the ring and touch neither it nor each other.
  static Shape polygon(const Ring& ring, const std::vector<Ring>& holes = {});
  /// Closed; the radius is more than 0.
  static Shape disc(const Point& center, const Number& radius);
  /// Closed, with sides along the axes and an area.
  static Shape box(const Point& min, const Point& max);
  /// SVG path data of M L H V A Z, circular arcs only; y points upwards. Rings nest by the even-odd rule, open parts
  /// are chains (docs/scene.md, "Paths").
  static Shape path(std::string_view data);
  /// Isolated points.
  static Shape points(const std::vector<Point>& points);
  /// A chain of closed segments, a set without interior; it may cross itself.
  static Shape polyline(const std::vector<Point>& points);
  /// What a scene file would say, e.g. R"({"file": "part.svg"})" or a region's "cells".
  static Shape json(std::string text) { return Shape(std::move(text)); }

  /// Plain set operations: what they make may lack parts of its boundary, or be a curve or a point.
  static Shape unite(const std::vector<Shape>& shapes);
  static Shape intersect(const std::vector<Shape>& shapes);
  /// The first without the others; of closed sets it is not closed.
  static Shape subtract(const std::vector<Shape>& shapes);
  static Shape complement(const Shape& shape);
  /// {a + b}: no reflection. The positions in which B + p meets A are A + (-B).
  static Shape minkowski_sum(const Shape& a, const Shape& b);
  /// Grown by the closed disc of that radius, with true arcs; eroded if negative: {p : the disc about p lies in it}.
  static Shape offset(const Shape& shape, const Number& radius);
  /// The convex hull; of arcs of different radii only where common tangents have directions in ratios of integers.
  static Shape hull(const Shape& shape);
  Shape translated(const Point& by) const;
  /// Counter-clockwise about the origin. Exact for multiples of 90 degrees; other angles round each vertex once to the
  /// nearest grid point.
  Shape rotated(const Number& degrees) const;

  /// The shape as a scene would have it.
  const std::string& text() const { return json_; }

 private:
  explicit Shape(std::string json) : json_(std::move(json)) {}
  std::string json_;
};

}  // namespace findspace
