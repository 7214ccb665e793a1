// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ray map of two solids A (fixed) and B (moved by p) of any shape: on the lines of a grid, whether their interiors
// meet (-), they only touch (0), or they are apart (+): gamma1(B, A) against 0. With A as the complement of the solid
// given, the negative of it: - where B lies in the interior of A, 0 where it lies in A and touches the frontier, +
// elsewhere: eta1.
//
// From the signed convolution: a winding number other than 0 means overlap. 0 is ambiguous (a ring about a bar has
// Euler characteristic 0); such cells are joined over neighbouring lines of a row where no facet comes between
// (certified), and each joined set is decided by one exact overlap test. Places on facets belong to the touching set at
// least; whether they overlap follows from their neighbours, from the number of sheets, or from an exact test.
// Guarantee: exact on every line, also where it runs along edges or in walls.
// Cost: the convolution; then some ten nanoseconds for each facet a line meets, and the tests (counted in `RayCounts`).
// Keywords: configuration space obstacle, Minkowski sum, free space, no-fit volume.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "space/convolution/ray_overlap.h"
#include "space/convolution/ray_sheets.h"

namespace findspace::space {

/// What it took; for tests and benchmarks.
struct RayCounts {
  std::atomic<std::int64_t> facets{0}, hits{0}, cell_tests{0}, wall_tests{0}, sheet_tests{0}, dirty_lines{0};
};

class PairRays : public RaySource {
 public:
  enum class Side { kSolid, kComplement };

  /// Coordinates in grid steps. Throws Error(kOutOfRange) when coordinates times grid.parts exceed 2^38.
  PairRays(const Triangles& a, const Triangles& b, const RayGrid& grid, Side side_of_a = Side::kSolid);

  /// The solid by itself: - inside, 0 on its surface, + outside.
  PairRays(const Triangles& a, const RayGrid& grid);

  ~PairRays() override;

  const RayGrid& grid() const override { return sheets_->grid(); }
  exact::Tried<RayRow> try_row(int j) const override;
  const RayCounts& counts() const { return counts_; }

 private:
  friend class RowWork;

  /// Rows' working memory that no thread uses just now.
  struct Spare;

  bool complement_;
  RayBody a_;
  std::optional<RayBody> b_;
  int base_winding_;
  std::unique_ptr<Sheets> sheets_;
  std::optional<RayOverlap> overlap_;  // none of a solid by itself
  mutable RayCounts counts_;
  std::unique_ptr<Spare> spare_;
};

}  // namespace findspace::space
