// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Upper bounds of a function of which no step changes more than its length (a signed distance), on the boxes of an
// octree that is made where it is asked: so what searches in nearby places have in common is looked at once.
// Guarantee: doubles; what `within` says is so; the same for any number of threads. Cost: a value of the function for
// each box that is made, some ten nanoseconds for each that is looked at again. Threads: safe. Keywords: adaptively
// sampled distance field.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>

#include "distance/search/solid_max_min.h"

namespace findspace::distance {

class FieldBoxes {
 public:
  using Value = std::function<double(const space::Vector&)>;
  /// Of the cube about the middle; at most that deep.
  FieldBoxes(const space::Vector& middle, double half, int depth, Value value);
  ~FieldBoxes();
  FieldBoxes(const FieldBoxes&) = delete;
  FieldBoxes& operator=(const FieldBoxes&) = delete;

  /// True where no place of the tetrahedron has more than `most`; false where the boxes do not tell.
  bool within(const Tetrahedron& corners, double most) const;
  /// Of a box.
  bool within(const space::Extent& box, double most) const;
  /// Not less than the value at x, and above it by no more than about `off`; infinite where x is beyond the cube.
  double most_at(const space::Vector& x, double off) const;
  /// Half the side of the smallest boxes.
  double least_half() const { return least_half_; }

 private:
  struct Box;
  struct Asked;
  bool within(const Asked& asked) const;
  bool within(const Box& box, const space::Vector& middle, double half, const Asked& asked) const;
  const std::array<Box, 8>& children(const Box& box, const space::Vector& middle, double half) const;

  space::Vector middle_;
  double half_, least_half_;
  Value value_;
  std::unique_ptr<Box> root_;
};

}  // namespace findspace::distance
