// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The point nearest to p that no set of a union of open convex sets holds, in all of space or in a box: planes seen
// from p (so that p is the origin), projections of p on up to three of them, and the queue of projections by distance.
// A projection's constraints are n . y + c >= 0: "not in the set that this plane bounds". Beyond each side of the box
// there is an open half space. Guarantee: as in open_union.h. Cost: the projections that are covered, whose number
// grows like the cube of the number of planes; a caller says how many are worth a look. Each counts for the question,
// and so does each set whose exact planes it takes. Keywords: dual simplex.
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
  static constexpr long kLooksOfCell = 8;  // that cost as much as a cell of other searches
  /// A box, sides included, and the sets that meet it.
  struct Within {
    Extent box;
    std::vector<std::size_t> sets;
  };
  ProjectionSearch(const OpenUnion& cover, const RealVector& p, std::optional<Within> within = {});
  /// Looks at `most` projections, none of them farther than `bound`. Where it ends unspent with nothing found, there is
  /// no such point so near.
  plane::SubdivisionEnd run(long most, double bound);
  const std::optional<RealVector>& found() const { return found_; }
  /// Of the point that is found from p.
  double distance() const { return distance_; }

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

  /// The half spaces beyond the sides of the box that are finite.
  void add_walls(const Extent& box);
  /// Of a set, those that it needs within the box; of a wall, numbered after the sets.
  const std::vector<int>& seen_planes(std::size_t part);
  int seen(const HalfSpace& plane);
  /// Whether the place is surely not in the set, by planes that doubles know sooner than its exact ones.
  bool surely_out(std::size_t part, const Vector& at, double error) const;
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
  std::map<std::size_t, std::vector<int>> of_part_;
  std::optional<Within> within_;
  std::vector<HalfSpace> walls_;
  std::multimap<std::array<double, 4>, int> by_approx_;
  plane::Subdivision<Projection> queue_;
  std::set<std::array<int, 3>> known_;
  std::optional<RealVector> found_;
  double distance_ = 0;
  long looks_ = 0;
};

}  // namespace findspace::space
