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
#include <mutex>
#include <optional>
#include <span>
#include <vector>

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

  /// Of bodies scaled to the parts of the grid, the lines along z, and the second one mirrored through the origin; A is
  /// the solid.
  using BodyPointer = std::shared_ptr<const RayBody>;
  PairRays(BodyPointer a, BodyPointer b, const RayBody& mirrored, const RayGrid& grid);

  /// The solid by itself: - inside, 0 on its surface, + outside.
  PairRays(const Triangles& a, const RayGrid& grid);

  ~PairRays() override;

  const RayGrid& grid() const override { return sheets_->grid(); }
  exact::Tried<RayRow> try_row(int j) const override;
  const RayCounts& counts() const { return counts_; }

 private:
  friend class RowWork;
  void set_facets(std::vector<RayFacet> facets, const RayGrid& grid);

  /// Rows' working memory that no thread uses just now.
  struct Spare;

  bool complement_;
  BodyPointer a_, b_;  // b_: null of a solid by itself
  int base_winding_;
  std::unique_ptr<Sheets> sheets_;
  std::optional<RayOverlap> overlap_;  // none of a solid by itself
  mutable RayCounts counts_;
  std::unique_ptr<Spare> spare_;
};

/// The least of the maps of all pairs of several solids: gamma1 of their unions. A pair is made when a row first meets
/// it, and goes after its last row. Guarantee: as of each pair. Cost: that of the pairs; memory for those on one row.
class UnitedPairs : public RaySource {
 public:
  UnitedPairs(std::span<const Triangles> a, std::span<const Triangles> b, const RayGrid& grid);

  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int j) const override;
  bool apart(int j) const override { return on_row(j).empty(); }

 private:
  using BodyPointer = PairRays::BodyPointer;
  struct Pair {
    int a = 0, b = 0, rows = 0;
  };
  struct Made {
    std::shared_ptr<const PairRays> rays;
    int asked = 0;  // rows
  };

  /// The first and the last row that the pair may meet.
  std::array<int, 2> rows_of(const RayBody& a, const RayBody& b) const;
  std::span<const std::size_t> on_row(int j) const {
    const std::size_t first = first_[static_cast<std::size_t>(j)], end = first_[static_cast<std::size_t>(j) + 1];
    return std::span(of_row_).subspan(first, end - first);
  }
  std::shared_ptr<const PairRays> made(std::size_t pair) const;

  RayGrid grid_;
  std::vector<BodyPointer> a_, b_, mirrored_;
  std::vector<Pair> pairs_;  // that meet some row
  std::vector<std::size_t> first_, of_row_;
  mutable std::mutex guard_;
  mutable std::vector<Made> made_;  // of each pair
};

}  // namespace findspace::space
