// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Numbers and points as users give them, exactly. A Number is a decimal as written, or a fraction: Number("1.1") is
// 11/10. A double stands for the shortest decimal that reads back as it, so Number(1.1) is 11/10 too. Positions in bulk
// are plain arrays of doubles, which count the same way. Keywords: decimal, fixed point.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace findspace {

class Number {
 public:
  /// An integer.
  template <std::integral T>
  Number(T value) : text_(std::to_string(value)) {}  // NOLINT: implicit on purpose
  /// Error(kBadValue) for one that is not finite.
  Number(double value);  // NOLINT
  /// A decimal as written: "-1.25", "3e-2"; or a fraction of two: "1/3".
  Number(const char* decimal) : text_(decimal) {}             // NOLINT
  Number(std::string decimal) : text_(std::move(decimal)) {}  // NOLINT
  /// Text that is not a number is refused where it is used, with Error(kSyntax).
  const std::string& text() const { return text_; }
  /// The nearest double but for an ulp. Error(kSyntax).
  double value() const;
  /// By value, exactly. Error(kSyntax).
  friend bool operator==(const Number& a, const Number& b) { return (a <=> b) == 0; }
  friend std::weak_ordering operator<=>(const Number& a, const Number& b);

 private:
  std::string text_;
};

/// A point of the plane, exactly.
struct Point {
  /// Coordinates.
  Number x, y;
};
/// A point of space, exactly.
struct Point3 {
  /// Coordinates.
  Number x, y, z;
};
/// The corners of a closed ring, in order.
using Ring = std::vector<Point>;

/// A place of the plane or of space in doubles.
using Position = std::array<double, 2>;
using Position3 = std::array<double, 3>;

/// The size of the grid on which a shape's coordinates lie, in its unit. What is off the grid is rounded to it once.
struct Grid {
  /// The distance of neighbouring grid lines.
  Number step = "0.000001";
};

}  // namespace findspace
