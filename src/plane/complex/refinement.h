// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The common refinement of the cells of some marked complexes, kept: many functions of their marks are made of it, each
// the same complex as by overlay() (overlay.h, which has the code). Cells on which all operands have the same marks are
// of one kind, so that a rule is asked once for each kind. Guarantee: exact. Cost: one overlay; each function then
// linear in the cells. Of a function that is a sum over the operands no marks are kept: its cost does not grow with
// their number. Keywords: overlay, minterm, cell labels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "plane/base/sign_sum.h"
#include "plane/base/work_budget.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// One value for each face, edge and vertex.
template <class Value>
struct CellValues {
  std::vector<Value> faces, edges, vertices;
};

class Refinement {
 public:
  /// Of several operands a cell costs a unit for so many of them, before their marks take memory.
  static constexpr std::uint64_t kMarksAUnit = 16;

  /// Throws Error(kLimit), which names `what` causes the work.
  Refinement(std::span<const CellComplex* const> operands, WorkBudget& work, std::string_view what);

  std::size_t kinds() const { return kinds_; }
  /// Those of all operands on the cells of a kind.
  std::span<const Mark> marks(std::size_t kind) const { return {kind_marks_.data() + kind * width_, width_}; }
  /// The complex with the mark of its kind on every cell, cells that agree merged.
  CellComplex complex(std::span<const Mark> of_kind) const;
  std::size_t edge_count() const { return alone_ ? alone_->edges.size() : cells_.edge_count(); }

 private:
  std::size_t width_, kinds_ = 0;
  std::vector<Mark> kind_marks_;      // kind after kind
  std::optional<CellComplex> alone_;  // of one operand: the operand
  Arrangement cells_;                 // of several
  CellValues<Index> kind_;
};

/// Where the sum over the marks of the maps is more than 0. `apart`: the curves of one map meet none of another.
Region summed(std::span<const SignMap* const> maps, const SignSum& sum, bool apart);

}  // namespace findspace::plane
