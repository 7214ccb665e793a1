// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where B + p touches the surface of a solid A from outside, or from inside: the frontiers of U = {p : the interiors
// meet} and of E = {p : B + p lies in A}, as closed convex polygons, segments and points. No convex parts of A are
// needed. With S the convex parts of B, the interior of S + p meets the surface of A where p is in one of the open
// convex sets t - int S, t a triangle; elsewhere S + p is wholly outside A or inside. So both frontiers are the facets
// of these sets less the sets, decided apart by the side of A on which a point of each S lies. Facets that a triangle
// next to their own covers are left out: where S is convex every touching position lies on another one, too. Guarantee:
// exact, slits and single positions included; pieces may overlap. Cost: a set is made when it is first looked at (some
// ten microseconds); for a facet the sets whose boxes meet its own, some hundred nanoseconds each, some microseconds
// for each corner of a piece that is made. Threads: safe. Source: docs/decisions/0016. Keywords: boundary of a
// Minkowski sum, contact surface, configuration space obstacle.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "space/polytope/flat_piece.h"
#include "space/surface/surface_set.h"
#include "space/surface/touch_facets.h"

namespace findspace::space {

class TouchSets {
 public:
  using Sheet = SurfaceSet::Sheet;
  /// Of a part of B and a triangle.
  struct Pair {
    std::size_t triangle = 0, part = 0;
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// Coordinates of one scale, at most 2^38; B is the union of its parts and not empty.
  TouchSets(std::shared_ptr<const Sheet> a, std::vector<Polytope> b, TouchSide side);

  const Sheet& sheet() const { return *a_; }
  const std::vector<Polytope>& parts() const { return b_; }
  const TouchSet& set(const Pair& pair) const;

  /// The corners of a facet of the set, and the box about them; none where the triangles about its own cover it.
  struct Facet {
    Pair of;
    int facet = 0;
    std::vector<Point> ring;
    GridBox box;
  };
  std::vector<Facet> facets(const Pair& of) const;
  /// Adds the touching positions on the facet; they keep pointers to planes of the sets.
  void add_pieces(const Facet& facet, std::vector<FlatPiece>& out) const;

 private:
  struct Cutter {
    double depth;  // of the middle of the facet, the deeper the less
    Pair pair;
  };
  struct Shard {
    std::mutex guard;
    std::unordered_map<std::size_t, std::unique_ptr<const TouchSet>> sets;
  };
  static constexpr std::size_t kShards = 64;

  bool find_cutters(const Facet& facet, std::vector<Cutter>& cutters) const;
  bool encloses_part(std::size_t part, const RealVector& p) const;
  /// Whether all of B + p lies in A, all of it outside, or neither; no set holds p.
  enum class Lies { kAcross, kOutside, kInside };
  Lies sides(const RealVector& p) const;

  std::shared_ptr<const Sheet> a_;
  std::vector<Polytope> b_;
  TouchSide side_;
  TouchFacets facets_;
  std::vector<GridBox> boxes_;
  std::unique_ptr<std::array<Shard, kShards>> shards_;
};

}  // namespace findspace::space
