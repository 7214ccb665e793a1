// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part of B + p in the search for the place that is farthest from A: a box of the plane, or a part of an edge of B;
// and bounds of distances over it. Guarantee: bounds hold up to rounding (about 1e-14 of the coordinates). Keywords:
// branch and bound.
#pragma once

#include <vector>

#include "distance/planar_features/sites.h"

namespace findspace::distance {

struct Spot {
  double x = 0, y = 0;
};

/// With what can matter in it.
struct SearchRange {
  using List = std::vector<plane::Index>;

  double bound = 0;
  int edge = -1;                          // of the sites of B, or a box
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box
  double t0 = 0, t1 = 1;                  // part of the edge
  List a, b;                              // parts of A's boundary; parts of B's (boxes only)
  bool operator<(const SearchRange& other) const { return bound < other.bound; }
};

/// Ranges of a set whose sites are moved by (px, py).
class MovedSites {
 public:
  MovedSites(const std::vector<Site>& sites, double px, double py) : sites_(sites), px_(px), py_(py) {}

  const Site& operator[](std::size_t k) const { return sites_[k]; }
  std::size_t size() const { return sites_.size(); }
  /// A point of the moved edge.
  Spot on_edge(int edge, double t) const;
  /// At least the length of the part.
  double length(const SearchRange& part) const;
  /// At least the greatest distance of a point of the range from the nearest of its parts of A.
  double bound(const SearchRange& r, const std::vector<Site>& a) const;
  /// The places inside a part of an edge where the distance to one part of A can be greatest.
  std::vector<Spot> peaks(const SearchRange& part, const Site& a) const;

 private:
  std::vector<Spot> hull(const SearchRange& r) const;
  Site arc_part(const SearchRange& part) const;
  double farthest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const;
  double nearest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const;
  double most(const Site& s, const SearchRange& r, const std::vector<Spot>& hull) const;

  const std::vector<Site>& sites_;
  double px_, py_;
};

}  // namespace findspace::distance
