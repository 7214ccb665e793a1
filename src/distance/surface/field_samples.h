// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds of signed distances to a surface, for searches that ask at very many places, or of all places of a cell, how
// these compare with a number: as no step changes a distance by more than its length, one that is known nearby mostly
// tells. Those in the middles of boxes of an octree are kept, which is made where it is asked, one box at a time.
// Guarantee: doubles, as surface_field.h; what is told of a place is so, whatever was asked before. Cost: a hundred
// bytes and some ten nanoseconds a box that is known, a signed distance for one that is new. Threads: safe. Keywords:
// adaptively sampled distance field, octree.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "distance/search/boundary_cells.h"
#include "distance/surface/surface_field.h"
#include "exact/number/interval.h"

namespace findspace::distance {

/// From the middle of a cube to its corners, in halves of its side.
inline constexpr double kRootOfThree = 1.7320508075688774;

class FieldSamples {
 public:
  /// Keeps a reference.
  explicit FieldSamples(const space::SurfaceSet& set);

  const SurfaceField& field() const { return field_; }

  /// Tells enough() numbers between which the signed distance of the place lies, and closer ones, until it says yes.
  /// Last, after those of the boxes whose halves are not below `finest`, the distance itself.
  template <class Enough>
  void ask(const space::Vector& x, double finest, Enough enough) const {
    exact::Interval known = beside(x);
    if (enough(known)) return;
    const Box* box = &root_;
    space::Vector middle = middle_;
    double half = half_;
    const bool held = grown({middle, middle}, half).holds(x, 0);
    while (true) {
      known = meet(known, around(*box, space::length(x - middle)));
      if (enough(known)) return;
      if (!held || half < finest) break;
      const std::size_t k = part_at(x, middle);
      half /= 2;
      middle = middle_of(k, middle, half);
      const Box* const part = part_of(*box, k, middle, half);
      if (part == nullptr) break;
      box = part;
    }
    enough(itself(x, known, *box));
  }
  /// Not less than the value at x, and above it by no more than about `off`, or what the smallest boxes of cells say.
  double most_at(const space::Vector& x, double off) const;
  /// True where no place of the tetrahedron, or of the box, has more than `most`; false where the boxes do not tell.
  bool within(const Tetrahedron& corners, double most) const;
  bool within(const space::Extent& box, double most) const;
  /// Half the side of the smallest boxes that cells are asked of.
  double least_half() const { return std::ldexp(half_, -kDepth); }

 private:
  struct Box {
    double value = 0;      // signed, in the middle
    bool certain = false;  // else its side is not known
    int nearest = -1;      // part of the surface
    mutable std::array<std::atomic<Box*>, 8> parts{};
    ~Box() {
      for (auto& part : parts) delete part.load();
    }
  };

  static exact::Interval meet(const exact::Interval& a, const exact::Interval& b) {
    return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  }
  /// At a place that is so far from the middle.
  static exact::Interval around(const Box& box, double away) {
    const double size = std::fabs(box.value) + away;
    return box.certain ? exact::Interval{box.value - away, box.value + away} : exact::Interval{-size, size};
  }
  /// By the box about the surface alone.
  exact::Interval beside(const space::Vector& x) const;
  /// By what is known, and a box nearby.
  exact::Interval itself(const space::Vector& x, const exact::Interval& known, const Box& box) const;
  void sample(const space::Vector& x, const SurfaceField::Known& known, Box& box) const;
  static SurfaceField::Known known_of(const exact::Interval& value, const Box& box) {
    return {box.nearest, value.lo > 0 ? 1 : value.hi < 0 ? -1 : 0};
  }
  /// The number of the part that x lies in.
  static std::size_t part_at(const space::Vector& x, const space::Vector& middle) {
    return (x.x > middle.x ? 1U : 0U) | (x.y > middle.y ? 2U : 0U) | (x.z > middle.z ? 4U : 0U);
  }
  /// The middle of number k of the eight parts of a box about `whole`, whose half is given.
  static space::Vector middle_of(std::size_t k, const space::Vector& whole, double half) {
    return {whole.x + ((k & 1) != 0 ? half : -half), whole.y + ((k & 2) != 0 ? half : -half),
            whole.z + ((k & 4) != 0 ? half : -half)};
  }
  /// That part, whose middle and half are given; null where it is new and there are very many.
  const Box* part_of(const Box& whole, std::size_t k, const space::Vector& middle, double half) const;
  struct Asked;
  bool within(const Asked& asked) const;
  bool within(const Box& box, const space::Vector& middle, double half, const Asked& asked) const;

  static constexpr int kDepth = 9;  // of the boxes that cells are asked of

  SurfaceField field_;
  space::Extent about_;
  space::Vector middle_;
  double half_ = 0;
  Box root_;
  mutable std::atomic<int> made_{0};
};

}  // namespace findspace::distance
