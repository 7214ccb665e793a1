// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact sets of positions in space as values: unions of boxes (solids with faces along the axes), or what one convex
// polytope, perhaps grown by a ball, cuts out of space. Slits, lines and points without volume are kept. Guarantee:
// which positions belong is exact; sizes are the exact ones rounded. Keywords: feasible region, boundary
// representation, H-representation.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "findspace/number.h"
#include "findspace/surface.h"

namespace findspace {

class Query;

/// Which positions of a formula are wanted, and what is made of them.
struct SpaceQuestion {
  std::string apply{};     // interior closure boundary regularize complement, or nothing
  std::string minimize{};  // only those where this objective is least: "x", "distance to [1, 2, 3]"; or
  std::string maximize{};  // greatest
};

class SpaceRegion {
 public:
  /// What it is made of.
  enum class Form { kBoxes, kConvex };
  /// Which of the two it is.
  Form form() const;
  /// Whether nothing belongs to it; whether all of space does; within some ball; open and closed as a point set.
  bool empty() const;
  bool whole() const;
  bool bounded() const;
  bool open() const;
  bool closed() const;
  /// Nothing where it is unbounded.
  std::optional<double> volume() const;
  struct Bounds3 {
    /// Its corners.
    Position3 low{}, high{};
  };
  /// Nothing where it is empty or unbounded.
  std::optional<Bounds3> bounds() const;
  /// The number of connected parts.
  std::size_t components() const;

  /// Exact, on boundaries too.
  bool contains(const Point3& p) const;
  void contains(std::span<const Position3> positions, std::span<bool> inside) const;

  /// A product of intervals; infinite where a coordinate has no end.
  struct Box {
    /// Its corners.
    Position3 low{}, high{};
    /// Whether its ends belong to it, for each coordinate.
    std::array<bool, 3> low_belongs{};
    std::array<bool, 3> high_belongs{};
  };
  /// Disjoint boxes, flat ones among them, whose union it is; none of the form kConvex.
  std::vector<Box> boxes() const;
  /// The boundary of the closure of its interior; a ball around a polytope is not part of it.
  Surface surface() const;
  /// What is left of it without that closure.
  struct Thin {
    /// Flat parts by their corners, in order around each.
    std::vector<std::vector<Position3>> sheets{};
    /// Segments by their ends, and single positions.
    std::vector<std::vector<Position3>> curves{};
    std::vector<Position3> points{};
  };
  /// Cut off at the window where it goes on for ever.
  Thin thin(const Bounds3& window) const;
  /// As `findspace map --json` writes it (docs/results.md).
  std::string json() const;
  /// The surface, seen from the side.
  std::string svg() const;
  /// What it answers: the formula over its world,
  const Query& query() const;
  /// and what of its positions.
  const SpaceQuestion& question() const;

  struct Data;
  explicit SpaceRegion(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
