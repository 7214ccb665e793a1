// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The marks of a complex at many points, in doubles where these decide: a lattice of buckets over the complex, most of
// them within one face. Guarantee: a mark that is given is that of every point within the stated error; nothing where
// doubles leave it open (on or beside an edge that is not a line of the grid), for the exact Locator. Method: a bucket
// that no edge enters holds its mark; elsewhere a ray upwards, a little to the right of the point, finds the lowest
// edge above it, bucket by bucket. Cost: building O(n) and some three buckets an edge, fewer where edges are long; a
// query about 10 ns in a bucket of one face, 50 ns beside edges. Threads: safe, nothing changes. Source: the bucket
// method of Asano, Edahiro, Imai, Iri and Murota (1985). Keywords: point location, point in polygon, batched queries,
// uniform grid.
#pragma once

#include <optional>
#include <vector>

#include "plane/query/boundary_items.h"

namespace findspace::plane {

class MarkGrid {
 public:
  explicit MarkGrid(const CellComplex& complex);

  using Query = BlurredPoint;
  std::optional<Mark> mark(const Query& q) const;
  /// How many entries the lists of all buckets have.
  std::size_t listed() const { return listed_.size(); }

 private:
  /// What one bucket tells: nothing, a mark, or that doubles do not decide.
  struct Look {
    bool open = false;
    std::optional<Mark> mark;
  };

  void choose_size();
  void shorten_lists();
  Index column(double x) const;
  Index row(double y) const;
  template <class Visit>
  void each_bucket(const BoundaryItem& item, Visit visit) const;
  void fill();
  void settle(const CellComplex& c);
  Look look(std::size_t bucket, double top, const Query& q) const;
  std::optional<Mark> climb(Index column, Index row, const Query& q) const;

  BoundaryItems items_;
  Mark outside_ = 0;
  double width_ = 1, height_ = 1;  // of a bucket
  Index columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> start_;  // of a bucket: where its items begin; below 0 it lies in one face
  std::vector<Index> listed_;        // bucket after bucket, each ended by kNone; those that are as near as the slack
};

}  // namespace findspace::plane
