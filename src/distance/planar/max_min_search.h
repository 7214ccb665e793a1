// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search behind farthest_from_set.h, in numbers: where over B + p is the distance to A greatest? See there for the
// method. A range keeps the parts of A that can be nearest in it (voronoi_cells.h), so that one along which two parts
// are equally near, or one part is equally far, is not halved on and on: with one part left (or several that agree) the
// places come from a formula, and only the neighbourhoods of places between two parts of A on an edge, and of places
// equally far from four and more, are halved down to the precision of doubles, or as far as the effort goes. (So are,
// needlessly, boxes along the common normal of four and more edges that touch in one vertex; `most_ranges` ends that.)
// Guarantee: bounds hold up to rounding (about 1e-14 of the coordinates); the greatest value is within
// the effort's short part.
#pragma once

#include <vector>

#include "distance/planar/farthest_from_set.h"
#include "distance/planar_features/search_range.h"
#include "distance/planar_features/voronoi_cells.h"
#include "plane/base/subdivide.h"
#include "plane/query/locate.h"

namespace findspace::distance {

struct MaxMinSets {
  const plane::Region &a, &b;
  const std::vector<BoundaryFeature>&a_features, &b_features;
  const VoronoiCells& a_reach;
};

/// Which max-min places are asked for: those of value at least greatest - tolerance and more than `least_value`.
struct MaxMinQuery {
  double scale, tolerance, least_value;
  MaxMinEffort effort;  // a search that needs more ranges ends with what it has found
};

class MaxMinSearch {
 public:
  MaxMinSearch(const MaxMinSets& sets, double px, double py, const MaxMinQuery& query);
  std::vector<MaxMinPlace> run();
  /// After run(), what that took for places looked at with more effort; the max-min places that are asked for now.
  std::vector<MaxMinPlace> finer(const MaxMinQuery& query);
  /// What no place left aside is farther than; 0 where all was looked at.
  double open() const { return todo_.empty() ? 0 : todo_.best().bound; }

 private:
  using List = SearchRange::List;
  /// Parts of A and the distance to them.
  struct Close {
    List list;
    double least;
  };

  /// Where the distance to a part of A is the level, on one side of it.
  struct OuterCurve {
    plane::Index part;
    LevelCurve curve;
  };

  double least(const List& list, Spot at) const;
  Close close_to(const List& list, Spot at, double radius) const;
  bool agree(const List& list, Spot at) const;
  bool unnamed(const SearchRange& part, Spot at) const;
  bool in_a(Spot at);
  bool in_b(Spot at);
  double height(const List& list, Spot at);
  void record(const MaxMinPlace& max_min);
  void visit_vertices(const SearchRange& box);
  bool matters(const SearchRange& r) const;
  void push(SearchRange r);
  SearchRange root() const;
  void look(SearchRange& r);
  void split_box(const SearchRange& box);
  void split_edge(SearchRange& part);
  void leaf(const SearchRange& box);
  std::vector<OuterCurve> outer_curves(const List& list) const;
  void inner_candidates(const SearchRange& box);
  std::vector<MaxMinPlace> found();

  const MaxMinSets sets_;
  const std::vector<BoundaryFeature>& a_;
  MovedFeatures b_;
  double px_, py_;
  MaxMinQuery query_;
  plane::Locator locate_a_, locate_b_;
  std::vector<char> arc_done_;
  plane::Subdivision<SearchRange> todo_{"boxes of the farthest place of a set from another", true};
  std::vector<SearchRange> places_;  // parts of edges that were too short for more
  double best_ = 0;
  std::vector<MaxMinPlace> places_found_;
};

}  // namespace findspace::distance
