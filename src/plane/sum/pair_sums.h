// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Minkowski sums of two sets as the sums of pairs of their parts, from the convolutions of these (convolution.h): the
// general way, for sets of any kind. Guarantee: exact. Cost: one arrangement of all curves; membership of single points
// in the sum of grid polygons needs none. Source: docs/decisions/0002-displaced-winding-numbers.md.
#pragma once

#include <optional>
#include <span>

#include "plane/grid/convolution_index.h"
#include "plane/grid/inner_mask.h"
#include "plane/sum/convolution.h"
#include "plane/sum/operand.h"
#include "plane/sum/point_winding.h"

namespace findspace::plane {

/// Adds up the convolutions of pairs of parts; where an intersection of the two could be a ring, whose Euler
/// characteristic is 0, holes are bridged first so that every number counts simply connected components.
class SumOfPairs {
 public:
  /// The curves are added to the given geometry.
  explicit SumOfPairs(bool open, exact::Geometry geometry = {});

  void add(const Part& a, const Part& b);
  /// Room for so many more curves.
  void reserve(std::size_t more) { builder_.reserve(more); }

  /// Leaves out what certainly lies in the open sum, where that pays: of all pairs of parts of a and b, b bounded.
  void prune(const Operand& a, const Operand& b);
  /// The same of what lies in the cells, whether it pays or not.
  void prune(const InnerMask& mask);
  /// -1 where the number is positive, 0 on the boundary of that, +1 elsewhere.
  SignMap open_sum() &&;
  /// 1 where the number is positive.
  Region closed_sum() &&;
  /// The numbers at single points, of solid parts bounded by segments.
  PointWinding numbers() && { return PointWinding(std::move(builder_), base_); }

 private:
  Arrangement arranged(std::span<const Index> more_points);
  void add_circled(const Arrangement& a, Windings& w) const;

  ConvolutionBuilder builder_;
  std::int32_t base_ = 0;
  std::optional<InnerPart> inner_;
  std::vector<Chain> chains_;
  std::vector<Corner> corners_;
  std::vector<Index> lonely_;
  std::vector<ConvolutionBuilder::Circled> circled_;
};

/// Whether points lie in the open sum of the solid parts of grid polygons: by their winding numbers, found one by one;
/// by those of the bridged parts, made when first needed, only where an intersection could be a ring.
class SolidSum {
 public:
  /// Keeps references to all.
  SolidSum(const Operand& a, const Operand& b, const ConvolutionIndex& index) : a_(a), b_(b), index_(index) {}

  bool holds(exact::Geometry& g, Index point);

 private:
  void build(exact::Geometry& g);

  const Operand &a_, &b_;
  const ConvolutionIndex& index_;
  std::optional<PointWinding> numbers_;
};

}  // namespace findspace::plane
