// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Unions of sets that lie apart: nothing has to be arranged then, their cells are written one after the other.
// Guarantee: exact; boxes only choose, and sets whose boxes meet, or may surround each other, are not taken for apart.
// Cost: linear, and pairs of boxes that overlap in one coordinate. Keywords: disjoint union, collection, locality.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Calls visit(i, k) once for each pair of boxes that meet, until it returns false.
void meeting_boxes(std::span<const PieceBox> boxes, const std::function<bool(Index, Index)>& visit);

/// Numbers in groups.
class IndexGroups {
 public:
  /// of[k]: the group of k, below `count`.
  IndexGroups(std::span<const Index> of, std::size_t count);

  std::size_t size() const { return start_.size() - 1; }
  /// Ascending.
  std::span<const Index> operator[](std::size_t group) const {
    return std::span(members_).subspan(start_[group], start_[group + 1] - start_[group]);
  }

 private:
  std::vector<Index> members_, start_;  // group by group; where each begins, and the end
};

/// Sets with these boxes in groups that lie apart: no box of one meets a box of another, and none lies in a hole that
/// the sets of another one leave, as its box lies in none of theirs. In the order of their first members.
IndexGroups groups_apart(const std::vector<PieceBox>& boxes);

/// The union of bounded sets, of groups that lie apart.
Region side_by_side(std::span<const Region* const> regions);

/// Writes the cells of a complex beside those that are there: the two lie apart, as groups do, and the unbounded faces
/// have one mark.
void put_beside(CellComplex& to, const CellComplex& from);

/// Appends a geometry; returns the offset of its points. SupportingCurves keep their order, so crossings keep their
/// roots.
Index append(exact::Geometry& to, const exact::Geometry& from);

}  // namespace findspace::plane
