// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search behind open_union.h: planes seen from p (so that p is the origin), projections of p on up to three of
// them, and the queue of projections by distance. A projection's constraints are n . y + c >= 0: "not in the set that
// this plane bounds".
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "plane/base/subdivide.h"
#include "space/body/open_union.h"

namespace findspace::space {

class ProjectionSearch {
 public:
  ProjectionSearch(const OpenUnion& cover, const RealVector& p);
  std::optional<RealVector> run();

 private:
  struct Seen {  // a plane seen from p
    Vector unit;
    double gap = 0;  // its value at p, to an ulp or so
    const HalfSpace* plane = nullptr;
  };
  struct Projection {
    double distance = 0;
    double error = 0;  // of `at`
    Vector at;         // relative to p
    std::array<int, 3> active{-1, -1, -1};
    int count = 0;
    bool operator<(const Projection& other) const { return distance > other.distance; }  // the nearest is on top
  };

  const std::vector<int>& seen_planes(std::size_t part);
  int seen(const HalfSpace& plane);
  /// The part that holds the projection deepest, or -1.
  int covering_part(const Projection& projection, std::optional<RealVector>& exact);
  bool covers_exactly(std::size_t part, const Projection& projection, std::optional<RealVector>& exact);
  void beyond(const Projection& projection, int plane);
  std::optional<Projection> projection_on(std::array<int, 3> planes, int count) const;
  bool multipliers(const std::array<int, 3>& planes, int count, std::array<double, 3>& out, double& error) const;
  bool exact_multipliers(const std::array<int, 3>& planes, int count, std::array<exact::Real, 3>& out) const;
  RealVector exact_projection(const Projection& projection) const;

  const OpenUnion& cover_;
  RealVector p_;
  Vector near_;
  std::vector<Seen> planes_;
  std::vector<std::vector<int>> of_part_;
  std::multimap<std::array<double, 4>, int> by_approx_;
  plane::Subdivision<Projection> queue_;
  std::set<std::array<int, 3>> known_;
};

}  // namespace findspace::space
