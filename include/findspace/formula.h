// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Formulas as objects, in the words of the formula language (docs/formula.md):
//     using namespace findspace::words;
//     gap("chip", "holes") >= "0.5 mm" && inside("chip", "board", 1) && !touches("chip", "rim")
// Shapes are named; the world that a formula is asked of knows them. A Formula is its text, so text and objects mix.
// Guarantee: an atom that was made can be read: its level, unit and directions are checked where it is built
// (Error kSyntax, kBadValue); names are checked by the world (kUnknownName). Cost: that of its text. Keywords:
// constraint, predicate, expression template (not used).
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

#include "findspace/number.h"

namespace findspace {

/// A number, or one with a unit: 0.5, "0.5 mm".
class Level {
 public:
  /// A number without a unit, or text that has one.
  template <class T>
  requires std::convertible_to<T, Number> Level(T value)
      : text_(Number(std::move(value)).text()) {}  // NOLINT: implicit on purpose
  /// As the formula language writes it.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class Formula {
 public:
  /// Text of the formula language. Read by the world that it is asked of.
  Formula(std::string text) : text_(std::move(text)) {}  // NOLINT
  /// Text, as well.
  Formula(const char* text) : text_(text) {}       // NOLINT
  Formula(std::string_view text) : text_(text) {}  // NOLINT
  const std::string& text() const { return text_; }

  /// Both, either, not.
  friend Formula operator&&(const Formula& a, const Formula& b);
  friend Formula operator||(const Formula& a, const Formula& b);
  friend Formula operator!(const Formula& a);

 private:
  std::string text_;
};

/// A distance of two shapes, to be compared with a level. Several shapes as one are joined by a plus: "a + b".
class Distance {
 public:
  /// By its word in the formula language: "gap", "gamma1", "distance", ...
  Distance(std::string_view word, std::string_view first, std::string_view second);
  /// Text of the formula language, as text() gives it. Read by the world that it is asked of.
  explicit Distance(std::string text) : text_(std::move(text)) {}
  /// Moved both ways along a direction, or one way.
  Distance along(const Point& direction) const { return with("along", direction); }
  Distance toward(const Point& direction) const { return with("toward", direction); }
  /// Rotated about a point; the value is in degrees.
  Distance rotating(const Point& about) const { return with("rotating", about); }
  /// The least and the greatest value over the time of a motion.
  Distance inf() const { return Distance("inf " + text_); }
  Distance sup() const { return Distance("sup " + text_); }
  /// distance -> min
  Formula minimal() const;
  const std::string& text() const { return text_; }

  /// Compared with a level.
  friend Formula operator<(const Distance& d, const Level& level) { return d.compared("<", level); }
  friend Formula operator<=(const Distance& d, const Level& level) { return d.compared("<=", level); }
  friend Formula operator==(const Distance& d, const Level& level) { return d.compared("=", level); }
  friend Formula operator!=(const Distance& d, const Level& level) { return d.compared("!=", level); }
  friend Formula operator>=(const Distance& d, const Level& level) { return d.compared(">=", level); }
  friend Formula operator>(const Distance& d, const Level& level) { return d.compared(">", level); }

 private:
  Distance with(std::string_view mode, const Point& vector) const;
  Formula compared(std::string_view relation, const Level& level) const;

  std::string text_;
};

/// The words of the formula language: `using namespace findspace::words`. A name is that of a shape, or of several as
/// one: "a + b".
namespace words {

/// Separation, or minus the depth of penetration.
inline Distance gap(std::string_view a, std::string_view b) { return {"gap", a, b}; }
/// The largest distance between points of the two.
inline Distance reach(std::string_view a, std::string_view b) { return {"reach", a, b}; }
/// How far inside b the shape a is; negative where it is not.
inline Distance margin(std::string_view a, std::string_view b) { return {"margin", a, b}; }
/// The same of a around b.
inline Distance cover(std::string_view a, std::string_view b) { return {"cover", a, b}; }
/// The greatest distance of a point of a from b.
inline Distance protrusion(std::string_view a, std::string_view b) { return {"protrusion", a, b}; }
/// The greater protrusion of the two.
inline Distance hausdorff(std::string_view a, std::string_view b) { return {"hausdorff", a, b}; }
/// The least distance between points of the two; 0 where they meet.
inline Distance distance(std::string_view a, std::string_view b) { return {"distance", a, b}; }
/// The depth of penetration; 0 where they do not overlap.
inline Distance depth(std::string_view a, std::string_view b) { return {"depth", a, b}; }
/// The diameter of both together.
inline Distance diameter(std::string_view a, std::string_view b) { return {"diameter", a, b}; }

/// gap < 0: the insides meet.
Formula overlaps(std::string_view a, std::string_view b);
/// gap = 0: only boundaries meet.
Formula touches(std::string_view a, std::string_view b);
/// gap > 0: no common point.
Formula disjoint(std::string_view a, std::string_view b);
/// gap >= level: at least so far apart.
Formula clear(std::string_view a, std::string_view b, const Level& level = 0);
/// gap <= level: at most so far apart.
Formula within(std::string_view a, std::string_view b, const Level& level);
/// The same, of parts of a board: `near` as `within`, `far` and `keepout` as `clear`.
Formula near(std::string_view a, std::string_view b, const Level& level);
Formula far(std::string_view a, std::string_view b, const Level& level);
Formula keepout(std::string_view a, std::string_view b, const Level& level = 0);
/// diameter <= level: both together at most so far across.
Formula group(std::string_view a, std::string_view b, const Level& level);
/// margin >= level: a inside b with so much to spare.
Formula inside(std::string_view a, std::string_view b, const Level& level = 0);
/// cover >= level: a around b with so much to spare.
Formula covers(std::string_view a, std::string_view b, const Level& level = 0);

}  // namespace words
}  // namespace findspace
