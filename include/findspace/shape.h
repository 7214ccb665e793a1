// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes as values: what a scene file can say, said in C++. A shape is a closed plane set given by exact decimal
// numbers; operations are the plain ones of point sets, not regularised (docs/scene.md). Nothing is computed here;
// errors in a shape are reported by World. Keywords: polygon with holes, disc, path, Boolean operation, Minkowski sum,
// offset.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace findspace {

/// A decimal number, exactly as written: Number("1.1") is 11/10. A double counts as the shortest decimal that reads
/// back as it.
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
  /// The closed set within the ring and outside the holes.
  static Shape polygon(const Ring& ring, const std::vector<Ring>& holes = {});
  static Shape disc(const Point& center, const Number& radius);
  static Shape box(const Point& min, const Point& max);
  /// SVG path data of M L H V A Z, circular arcs only.
  static Shape path(std::string_view data);
  static Shape points(const std::vector<Point>& points);
  /// An open chain, a set without interior.
  static Shape polyline(const std::vector<Point>& points);
  /// What a scene file would say, e.g. R"({"file": "part.svg"})" or a region's "cells".
  static Shape json(std::string text) { return Shape(std::move(text)); }

  static Shape unite(const std::vector<Shape>& shapes);
  static Shape intersect(const std::vector<Shape>& shapes);
  /// The first without the others.
  static Shape subtract(const std::vector<Shape>& shapes);
  static Shape complement(const Shape& shape);
  /// {a + b}.
  static Shape minkowski_sum(const Shape& a, const Shape& b);
  /// Grown by the closed disc of that radius; eroded if negative.
  static Shape offset(const Shape& shape, const Number& radius);
  static Shape hull(const Shape& shape);
  Shape translated(const Point& by) const;
  /// Counter-clockwise about the origin.
  Shape rotated(const Number& degrees) const;

  const std::string& text() const { return json_; }

 private:
  explicit Shape(std::string json) : json_(std::move(json)) {}
  std::string json_;
};

}  // namespace findspace
