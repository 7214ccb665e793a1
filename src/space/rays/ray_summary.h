// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a region given on rays is like, in numbers, row by row: only two rows are kept, and the components.
// Guarantee: exact on the lines; of the region itself these are samples: the volume is that of boxes about the
// intervals, and components are connections of intervals of neighbouring lines that overlap (parts that only meet
// between lines count apart, parts nearer than a step may count as one).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "space/rays/ray_map.h"

namespace findspace::space {

struct RayComponent {
  double volume = 0;                              // in cubic grid steps
  std::array<double, 3> low{}, high{}, sample{};  // the sample: the middle of the longest interval
  double longest = -1;
  bool certified = false;  // its lines cross in it: certainly connected (ray_axes.h)
};

struct RaySummary {
  bool empty = true;  // no line meets the region
  double volume = 0;
  double precision = 0;  // the largest bound of the rounding of a place, in grid steps
  std::array<double, 3> low{}, high{};
  std::vector<RayComponent> components;               // by falling volume
  std::int64_t lines = 0, intervals = 0, points = 0;  // points: intervals of length 0
};

/// The intervals of the region on the lines of a row, from line to line; signs of at most 0 belong to it. Where one has
/// no end, that is infinite.
struct RowIntervals {
  std::vector<std::int32_t> lines;
  std::vector<double> from, to;
  double radius = 0;  // the largest bound of the rounding of a place
};
RowIntervals intervals_of(const RayRow& row);

class RaySummarizer {
 public:
  /// Intervals without end are cut at the box (grid steps).
  RaySummarizer(const RayGrid& grid, const Point& low, const Point& high);
  /// Rows in order.
  void add(int j, const RayRow& row) { add(j, intervals_of(row)); }
  void add(int j, const RowIntervals& row);
  RaySummary finish();

 private:
  struct Interval {
    double from, to;
    int component;
  };
  int find(int k);
  void join(int a, int b);
  void take(Interval interval, int i, int j);
  void end_row();

  /// A component as far as it is known; `born`: its first interval.
  struct Part {
    RayComponent component;
    std::int64_t born = 0;
  };

  RayGrid grid_;
  double low_, high_;  // the box along the lines, in parts of a grid step
  RaySummary summary_;
  std::vector<std::vector<Interval>> before_, now_;  // of each line of the row before and of this one
  std::vector<Part> parts_;                          // those that the two rows meet
  std::vector<int> root_;
  std::vector<Part> done_;
};

}  // namespace findspace::space
