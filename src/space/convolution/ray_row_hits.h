// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the lines of a row meet facets, in order on each line. Hits are counted first, so that each is written once,
// where it belongs; lines through corners and along edges (dirty ones) are done by themselves, exactly.
// Guarantee: exact: places on which doubles leave the order open are compared as fractions.
// Cost: some ten nanoseconds a hit. Internal to ray_pair.
#pragma once

#include <cstdint>
#include <vector>

#include "space/convolution/ray_sheets.h"

namespace findspace::space {

struct RowHit {
  double at, error;
  int column, sheet;
  int exact = -1;              // its place in RowHits::exacts: of dirty lines, and of steep facets
  std::int32_t jump : 31 = 0;  // with the next one in four bytes: there are many hits
  bool touch : 1 = false;      // the line meets the facet at its edge, or runs in it
};

/// Where a facet's section runs.
struct RowCut {
  Section section;
  int sheet;
};

/// Where a line runs in a facet parallel to it.
struct RowWall {
  exact::Fraction from, to;
};

/// The hits of one row, and memory that the next row uses again.
struct RowHits {
  explicit RowHits(const Sheets& of) : sheets(of), columns(of.grid().nu) {}

  const Sheets& sheets;
  int columns;
  int j = 0;
  std::int64_t y = 0;
  std::vector<RowCut> cuts;
  std::vector<RowHit> sorted;     // of column i from first[i] to first[i + 1] - 1
  std::vector<RowHit> unordered;  // of dirty lines, before they are put in order
  std::vector<int> first, next;
  std::vector<exact::Fraction> exacts;
  std::vector<char> dirty;
  std::vector<int> dirty_number;            // of dirty lines
  std::vector<std::vector<RowWall>> walls;  // of dirty lines, by number
};

/// Finds the hits of row j.
void find_hits(RowHits& hits, int j);

/// Where a hit is, exactly.
exact::Fraction place(const RowHits& hits, const RowHit& h);

/// By the doubles where they tell, which is nearly always.
inline bool comes_before(const RowHits& hits, const RowHit& a, const RowHit& b) {
  if (a.at + a.error < b.at - b.error) return true;
  return !(b.at + b.error < a.at - a.error) && exact::compare_fractions(place(hits, a), place(hits, b)) < 0;
}

inline bool coincide(const RowHits& hits, const RowHit& a, const RowHit& b) {
  if (a.at + a.error < b.at - b.error || b.at + b.error < a.at - a.error) return false;
  return exact::compare_fractions(place(hits, a), place(hits, b)) == 0;
}

}  // namespace findspace::space
