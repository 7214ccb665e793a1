// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Minkowski sums of two sets as the sums of pairs of their parts, from the convolutions of these (convolution.h): the
// general way, for sets of any kind. Guarantee: exact. Cost: one arrangement of all curves; membership of single points
// in the sum of grid polygons needs none. Source: docs/decisions/0002-displaced-winding-numbers.md.
#pragma once

#include <optional>

#include "plane/grid/convolution_index.h"
#include "plane/sum/convolution.h"
#include "plane/sum/point_winding.h"

namespace findspace::plane {

/// A set whose sums are asked for; which marks belong to it; whether it is to be reflected through the origin.
struct Operand {
  const CellComplex& cells;
  bool (*wanted)(Mark);
  bool mirrored = false;
  bool flat = true;                                      // with its parts that have no interior
  const std::optional<GridFaces>* known_grid = nullptr;  // grid(), where it has been made

  std::vector<Part> solid_parts() const { return oriented(face_parts(cells, wanted)); }
  /// Calls `use` with one solid part after another, none of them kept.
  template <class Use>
  void each_solid_part(Use&& use) const {
    for (const Face& f : cells.faces) {
      if (!wanted(f.mark)) continue;
      Part part = face_part(cells, f, wanted);
      use(mirrored ? plane::mirrored(std::move(part)) : std::move(part));
    }
  }
  std::vector<Part> flat_parts() const {
    return flat ? oriented(plane::flat_parts(cells, wanted)) : std::vector<Part>();
  }
  std::optional<GridFaces> grid(Memory memory = kHeap) const { return grid_faces(cells, wanted, mirrored, memory); }

 private:
  std::vector<Part> oriented(std::vector<Part> parts) const;
};

/// Adds up the convolutions of pairs of parts; where an intersection of the two could be a ring, whose Euler
/// characteristic is 0, holes are bridged first so that every number counts simply connected components.
class SumOfPairs {
 public:
  /// The curves are added to the given geometry.
  explicit SumOfPairs(bool open, exact::Geometry geometry = {});

  void add(const Part& a, const Part& b);
  /// Room for so many more curves.
  void reserve(std::size_t more) { builder_.reserve(more); }

  /// -1 where the number is positive, 0 on the boundary of that, +1 elsewhere.
  SignMap open_sum() &&;
  /// 1 where the number is positive.
  Region closed_sum() &&;
  /// The numbers at single points, of solid parts bounded by segments.
  PointWinding numbers() && { return PointWinding(std::move(builder_), base_); }

 private:
  Arrangement arranged();
  void add_circled(const Arrangement& a, Windings& w) const;

  ConvolutionBuilder builder_;
  std::int32_t base_ = 0;
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
