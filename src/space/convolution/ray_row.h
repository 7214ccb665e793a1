// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The work on one row of a PairRays: the events of its lines, the cells between them, and their signs.
// Internal to ray_pair.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "space/convolution/ray_pair.h"

namespace findspace::space {

/// A place on a line where it meets facets.
struct RayGroup {
  double at = 0, error = 0;
  int first = 0, count = 0;  // the facets met, in RowWork::sorted_
  int exact = -1;            // its place in RowWork::exacts_, once asked for
};

/// What lies after group k - 1 and before group k of a line.
struct RayCell {
  int winding = 0;
  bool wall = false;     // inside facets parallel to the lines
  std::int8_t sign = 2;  // 2: not known yet
};

class RowWork {
 public:
  explicit RowWork(const PairRays& pair);
  /// May be called again: its memory is used again.
  RayRow run(int j);

 private:
  struct Hit {
    double at, error;
    int column, sheet;
    int exact = -1;  // its place in exacts_: of dirty lines, and of steep facets
    std::int8_t jump = 0;
    bool touch = false;  // the line meets the facet at its edge, or runs in it
  };
  struct Wall {
    exact::Fraction from, to;
  };

  void find_sections();
  void collect();
  void place_hits();
  Hit exact_hit(int column, int sheet, const exact::Fraction& z, int jump, bool touch);
  void collect_dirty(int column);
  void meet_upright(const Sheet& s, int sheet, int column, std::vector<Wall>& walls);
  void sort_column(int column);
  void group_column(int column);
  void mark_walls(int column, const std::vector<Wall>& walls);
  bool comes_before(const Hit& a, const Hit& b) const {
    if (a.at + a.error < b.at - b.error) return true;
    return !(b.at + b.error < a.at - a.error) && compare_exactly(a, b) < 0;
  }
  bool coincide(const Hit& a, const Hit& b) const {
    if (a.at + a.error < b.at - b.error || b.at + b.error < a.at - a.error) return false;
    return compare_exactly(a, b) == 0;
  }
  int compare_exactly(const Hit& a, const Hit& b) const;
  exact::Fraction place(const Hit& h) const;
  exact::Fraction place(int column, int group);

  int cells_of(int column) const { return group_first_[column] + column; }
  int groups_of(int column) const { return group_first_[column + 1] - group_first_[column]; }

  void settle_cells();
  void settle_walls(int column);
  bool strip_needed(int column) const { return open_[column] != 0 || open_[column + 1] != 0; }
  void join_cells();
  void collect_ranges();
  void join_over_edge(int column, std::span<std::pair<double, double>> ranges);
  int cell_at(int column, double level) const;
  void test_joined();
  bool meets(int column, const exact::Fraction& z);

  std::int8_t sign_here(int column, int group);
  std::int8_t sign_between(int column, int group);
  void emit(int column, RayRow& row);

  /// Where a facet's section runs.
  struct Cut {
    Section section;
    int sheet;
  };
  /// What is known of a set of joined cells: the sign of an outer cell in it, and otherwise its widest cell.
  struct Known {
    std::int8_t sign = 2;
    int column = -1, cell = -1;
    double width = -1;
  };

  const PairRays& pair_;
  const Sheets& sheets_;
  int j_ = 0, columns_;
  std::int64_t y_ = 0;
  std::vector<Cut> cuts_;
  std::vector<Hit> dirty_hits_;  // of dirty lines, before they are put in order
  std::vector<Hit> sorted_;      // of column i from hit_first_[i] on
  std::vector<exact::Fraction> exacts_;
  RayOverlap::Recent recent_;
  std::vector<char> dirty_;
  std::vector<std::vector<Wall>> walls_;  // of dirty lines, by number
  std::vector<int> dirty_number_;
  std::vector<int> hit_first_, next_;
  std::vector<RayGroup> groups_;  // longer than what is in use, like cells_, root_ and known_: of one row after another
  std::vector<int> group_first_;  // of column i: groups group_first_[i] to group_first_[i + 1] - 1
  std::vector<RayCell> cells_;    // of column i from group_first_[i] + i on, one more than groups
  std::vector<char> open_;        // whether a column has cells that winding numbers do not decide
  std::vector<int> range_first_;  // over the strip from column i to i + 1: ranges_ from range_first_[i] on
  std::vector<std::pair<double, double>> ranges_;
  std::vector<int> root_;
  std::vector<Known> known_;
};

}  // namespace findspace::space
