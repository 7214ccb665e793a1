// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search behind farthest_from_set.h, in numbers: where over B + p is the distance to A greatest? See there for the
// method. Guarantee: bounds hold up to rounding (about 1e-14 of the coordinates).
#pragma once

#include <array>
#include <queue>
#include <span>
#include <vector>

#include "distance/farthest_from_set.h"
#include "plane/locate.h"

namespace findspace::distance {

class PeakSearch {
 public:
  PeakSearch(const plane::Region& a, const plane::Region& b, std::span<const Site> a_sites,
             std::span<const Site> b_sites, double px, double py, double scale, double room, double least_value);
  std::vector<Peak> run();

 private:
  using List = std::vector<plane::Index>;
  struct Spot {
    double x, y;
  };
  /// A box, or a part of an edge of B (t from t0 to t1), with what can matter in it.
  struct Range {
    double bound = 0;
    int edge = -1;
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box
    double t0 = 0, t1 = 1;                  // part of an edge
    List a, b;                              // parts of A's boundary; parts of B's (boxes only)
    bool operator<(const Range& other) const { return bound < other.bound; }
  };

  Spot on_edge(int edge, double t) const;
  std::vector<Spot> hull(const Range& r) const;
  double farthest(const Range& r, std::span<const Spot> hull, double x, double y) const;
  double nearest(const Range& r, std::span<const Spot> hull, double x, double y) const;
  double most(const Site& s, const Range& r, std::span<const Spot> hull) const;
  double bound(const Range& r) const;
  double least(const List& list, Spot at) const;
  List close_to(const List& list, Spot at, double radius) const;
  bool in_a(Spot at);
  bool in_b(Spot at);
  double height(const List& list, Spot at);
  void record(const Peak& peak);
  void visit_vertices(const Range& box);
  bool matters(const Range& r) const;
  void push(Range r);
  void split_box(const Range& box);
  void split_edge(const Range& part);
  void leaf(const Range& box);
  void inner_candidates(const Range& box);

  const plane::Region& a_region_;
  std::span<const Site> a_, b_;
  double px_, py_, scale_, room_, least_value_;
  plane::Locator locate_a_, locate_b_;
  std::vector<char> arc_done_;
  std::priority_queue<Range> todo_;
  double best_ = 0;
  std::vector<Peak> peaks_;
};

}  // namespace findspace::distance
