// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact sets of the plane as values: every vertex, edge and face says whether it belongs. A Region can be asked, walked
// along its boundary, and combined. A SignMap holds the sign of a distance minus its level at every position. Both are
// immutable and cheap to copy; reading them from many threads is safe. Numbers are in the unit of the world or shape
// they come from. Guarantee: which cells belong, and what is counted, is exact; coordinates, lengths and areas in
// doubles are right to the last place or two. Cost: one pass over the edges when a kind of question is first asked; a
// position then costs about the logarithm of their number, many positions at once 10 to 100 ns each. Keywords: marked
// subdivision, level set, sublevel set, Nef polygon.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"
#include "findspace/number.h"
#include "findspace/options.h"

namespace findspace {

/// An exact real number of a result: a fraction, or made of square roots.
class Exact {
 public:
  /// The nearest double but for an ulp.
  double value() const;
  /// "3", "-5/3", "(1+2*sqrt(5))/3"; of numbers that are more nested the nearest decimal, with a leading "~".
  std::string text() const;
  /// Every number in full, over several lines where it is nested, and the same number back. Error(kSyntax).
  std::string full_text() const;
  static Exact read(std::string_view full_text);
  friend bool operator==(const Exact& a, const Exact& b);
  friend std::weak_ordering operator<=>(const Exact& a, const Exact& b);

  struct Data;
  explicit Exact(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

struct ExactPoint {
  /// Coordinates.
  Exact x, y;
};

/// A box whose closure holds a set, and the least such.
struct Bounds {
  /// Its corners.
  Position low{}, high{};
};

class Region {
 public:
  /// Whether nothing belongs to it.
  bool empty() const;
  /// The whole plane.
  bool whole() const;
  /// As point sets of the plane; the empty set and the plane are both.
  bool open() const;
  bool closed() const;
  /// Within some disc.
  bool bounded() const;
  /// Nothing where the region is unbounded.
  std::optional<double> area() const;
  /// Nothing where the region is empty or unbounded.
  std::optional<Bounds> bounds() const;
  /// Bounded components of the complement.
  std::size_t holes() const;

  /// Exact, on boundaries too; p need not lie on the grid. Error(kSyntax) for what is not a decimal.
  bool contains(const Point& p) const;
  template <std::same_as<Position> P>
  bool contains(const P& p) const {
    return contains_position(p);
  }
  /// Of many positions, with all threads; `inside` is as long as `positions`.
  void contains(std::span<const Position> positions, std::span<bool> inside) const;

  /// A vertex of the boundary, or an isolated point of the set or of its complement.
  struct Vertex {
    /// Rounded; exact() has it in full.
    Position at;
    /// To the set.
    bool belongs = false;
  };
  /// A segment or an arc of the boundary without its ends.
  struct Edge {
    std::size_t start = 0, end = 0;  // in vertices(); equal for a whole circle
    /// Whether it is in the set itself.
    bool belongs = false;
    bool left_belongs = false, right_belongs = false;  // what lies beside it
    bool arc = false;                                  // counter-clockwise from start to end
    Position center{};                                 // of an arc
    double radius = 0;                                 // of an arc
    double angle = 0;                                  // it spans, in radians
  };
  /// An edge as a part of a ring: which, and whether it is gone along from start to end.
  struct Side {
    std::size_t edge = 0;  // in edges()
    bool forward = true;   // from its start to its end
  };
  /// A closed boundary, the set on its left.
  using Ring = std::vector<Side>;
  /// A connected part of the point set.
  struct Component {
    int dimension = 0;             // 2: it has an area; 1: curves alone; 0: a point
    std::optional<double> area;    // nothing where it is unbounded
    std::size_t holes = 0;         // bounded components of its complement
    Position sample{};             // a point of it, inside where it has an inside
    std::optional<Bounds> bounds;  // nothing where it is unbounded
    /// The boundaries of its faces, the face on the left: the outer one of a face counter-clockwise, then its holes.
    std::vector<Ring> rings;
    std::vector<std::size_t> curves;    // edges without area beside them
    std::vector<std::size_t> isolated;  // vertices
  };
  /// Numbered from left to right.
  const std::vector<Vertex>& vertices() const;
  const std::vector<Edge>& edges() const;
  /// Faces that share only a vertex of the set are one. Unbounded first, then by dimension, then from left to right.
  const std::vector<Component>& components() const;
  /// A vertex, exactly.
  ExactPoint exact(std::size_t vertex) const;

  /// The nearest point of the closure, and whether it belongs to the set. Nothing of the empty set.
  struct Nearest {
    Position at{};          // where it is
    double distance = 0;    // how far that is
    bool attained = false;  // whether it belongs to the set
  };
  /// Nothing of the empty set.
  std::optional<Nearest> nearest(const Position& to) const;
  /// Where something that is dragged to a place snaps to: a corner that belongs to the set and is no farther than
  /// `within`, or else such a point of its boundary; nothing where there is none.
  std::optional<Position> snapped(const Position& to, const Number& within) const;
  /// A position that belongs to it, an isolated one where there is one. Nothing of the empty set.
  std::optional<Position> some() const;
  /// Points of the inside, evenly spread by the options' seed; fewer than `count` never. Error(kUnsupported) where the
  /// region has no area, or an unbounded one; Stopped at a limit.
  std::vector<Position> sample(std::size_t count, const Options& options = {}) const;

  /// Plain operations of point sets; of regions of one grid. Error(kBadValue) otherwise.
  friend Region operator|(const Region& a, const Region& b);
  friend Region operator&(const Region& a, const Region& b);
  friend Region operator-(const Region& a, const Region& b);
  Region complement() const;
  Region interior() const;
  Region closure() const;
  Region boundary() const;
  /// The closure of the interior.
  Region regularized() const;
  /// All points no farther than the radius from it; where that is negative, those whose closed disc lies in it.
  Region offset(const Number& radius) const;
  /// The same set, whatever it is made of.
  friend bool operator==(const Region& a, const Region& b);

  /// Where corners of flattened arcs lie: in the closure of the set, not inside of it, or on the arcs.
  enum class Towards { kInside, kOutside, kOnArcs };
  /// Rings as points, arcs cut so finely that no chord is farther from its arc than `bound`. Of faces alone, a
  /// component's rings one after the other.
  std::vector<std::vector<Position>> flattened(double bound, Towards side) const;
  /// The closure as a GeoJSON geometry, its arcs flattened. Error(kUnsupported) where unbounded.
  std::string geojson(double bound, Towards side = Towards::kOnArcs) const;

  /// As `findspace map --json` writes it (docs/results.md): cells with marks, arcs as arcs. `exact`: with
  /// exact_json()'s cells too.
  std::string json(bool exact = false) const;
  /// What it is like, in words: whether it is open, its area, box and components.
  std::string text(std::string_view title = "region") const;
  /// A scene with this one shape, stated by polygons, discs, segments and points where the grid's decimals say them
  /// exactly: the same set.
  std::string scene_json(std::string_view name = "region") const;
  /// The set by its exact boundary, as the shape kind "cells" of a scene has it (docs/scene.md): Shape::json brings the
  /// same set back.
  std::string exact_json() const;
  /// Closed sets only: what is open is lost. Error(kUnsupported) where unbounded.
  std::string wkt() const;
  /// A drawing in true size. Error(kUnsupported) where unbounded.
  std::string svg() const;

  /// The text of a file, and what it does not say of the set, in words: open ends, cracks; empty if nothing.
  struct Drawn {
    /// See there.
    std::string text, lost;
  };
  /// In the unit, by the ending: ".svg", ".dxf", ".wkt", ".geojson"; the name is that of a layer or of a feature.
  /// Error(kUnsupported) where unbounded, for another ending, and of arcs in GeoJSON.
  Drawn drawn(std::string_view ending, std::string_view name = "region", DxfVersion dxf = DxfVersion::kR12) const;
  /// How it looks, for a program that draws it itself: SVG path data and places in the unit, with y downwards.
  struct Paths {
    std::string faces;                       // what is filled, by the even-odd rule
    std::string closed, open;                // edges of faces that belong, and that do not
    std::string free;                        // curves without area beside them
    std::vector<Position> points{};          // isolated ones
    std::vector<Position> full{}, hollow{};  // ends of curves that belong where these do not, and the reverse
  };
  /// What is unbounded is cut off at the window. `y_down`: its coordinates run downwards already, as those of boards.
  Paths paths(const Bounds& window, bool y_down = false) const;
  /// A box that holds all its vertices and curves, also where the set goes on beyond it; nothing where it has none.
  std::optional<Bounds> extent() const;
  /// A picture with a frame, for people; unbounded ones are cut off.
  std::string picture(std::string_view title, std::string_view subtitle = {}) const;

  struct Data;
  explicit Region(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }
  const std::shared_ptr<const Data>& shared_data() const { return data_; }

 private:
  bool contains_position(const Position& p) const;

  std::shared_ptr<const Data> data_;
};

class SignMap {
 public:
  /// -1, 0 or +1, exact; a distance that is undefined counts as +infinity.
  int sign(const Point& p) const;
  /// Of each position; `out` is as long as `positions`.
  void signs(std::span<const Position> positions, std::span<std::int8_t> out) const;
  /// The positions whose sign is one of those wanted.
  Region where(bool negative, bool zero, bool positive) const;

  struct Data;
  explicit SignMap(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
