// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a body B of polyhedra and balls lies within V, the union of the parts of A each grown by a level: {mu(B + p, A)
// <= level} on rays, A not convex. V has creases and pockets, so a position can be lost at an edge or in a face of B
// between vertices that are all in V. On each line the places that all vertices allow are found exactly. A
// branch-and-bound search (solid_max_min.h) through what B sweeps over a stretch of them then proves that nothing
// protrudes, or gives a point of B outside V; all places at which that point is outside are cut away, and the search
// goes on with the rest. The places of these points are tried on the next line of the row before it is searched.
// Guarantee: the sign is - or + only where that is certain; 0 where the distance is within kCertain of the shapes' size
// and the level of the level; at levels this near to 0 what lies within no part of A, and no further set, is not seen
// to be inside. Ends of {<= level} that a vertex decides are exact. Cost: a search a stretch, and some for an end that
// no vertex decides. Keywords: directed Hausdorff distance, cutting planes, certified bounds.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "distance/search/round_solid.h"
#include "distance/search/solid_max_min.h"
#include "exact/margins/space_distance.h"
#include "space/body/body.h"
#include "space/body/wall_bridges.h"
#include "space/convolution/ray_solids.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// The body A that another protrudes from: by its convex parts, or by the triangles of its surface
/// (surface_max_min.cpp).
class ProtrusionField {
 public:
  virtual ~ProtrusionField() = default;
  /// The length of its diagonal.
  virtual double size() const = 0;
  /// The point of the solids that is farthest out, as in solid_max_min.h.
  virtual SolidMaxMin max_min(const Solids& solids, double slack, double share) const = 0;
  /// How far x may run along the way and stay farther than `cut` from the body, at least, and about that; x is farther.
  /// `size`: of all.
  virtual double run(const space::Vector& x, const space::Vector& way, double cut, double size) const = 0;
};

/// `further`: sets within the body.
std::unique_ptr<ProtrusionField> field_of_parts(const space::Body& body,
                                                std::span<const space::WallBridge> further = {});
/// Of the union of solids, which are not too far out. Distances inside are at most 0.
std::unique_ptr<ProtrusionField> field_of_surfaces(const std::vector<space::RaySolid>& solids);

class ProtrusionRays : public space::RaySource {
 public:
  /// How near to the level the sign is 0, of the size of both bodies and the level.
  static constexpr double kCertain = margin::kRayCertain;

  /// Makes the sign map that the vertices of B have for a level.
  using Vertices = std::function<space::RaySourcePointer(const exact::Real& level)>;

  /// B of polyhedra and balls, of the same scale as A; the level is not less than 0.
  ProtrusionRays(const space::Body& b, std::unique_ptr<ProtrusionField> a, const exact::Real& level,
                 const Vertices& vertices, const space::RayGrid& grid);

  const space::RayGrid& grid() const override { return grid_; }
  exact::Tried<space::RayRow> try_row(int j) const override;
  bool searched() const override { return true; }

 private:
  /// Where a line runs, in the bodies' steps: from `start` along `unit`.
  struct Line {
    space::Vector start, unit;
  };
  /// Places along a line.
  struct Stretch {
    double from, to;
  };
  /// Places outside V that B reached on lines before, the last one first.
  using Places = std::vector<space::Vector>;
  /// A side of the region: what is kept certainly holds it, or lies in it.
  struct Side {
    space::RaySourcePointer vertices;
    double cut;     // beyond this distance from A a point of B is outside
    double enough;  // up to this nothing protrudes
  };

  /// A polyhedron or, with a radius, a ball.
  struct Part {
    std::vector<Tetrahedron> solid;
    std::vector<std::array<space::Vector, 3>> faces;  // triangles
    std::vector<space::Vector> normals;               // of the triangles, outward
    std::vector<space::HalfSpace> planes;
    space::Vector center;
    double radius = 0;
  };

  Line line(int i, int j) const;
  std::vector<Stretch> stretches(const space::RayRow& row, int i) const;
  /// `seen`: of each line.
  exact::Tried<space::RayRow> kept(const Side& side, int j, const space::RayRow* inner,
                                   std::vector<Places>& seen) const;
  Stretch whole(const space::RayEvent& first, const space::RayEvent& last) const;
  void keep(std::span<const Stretch> gone, const space::RayEvent& first, const space::RayEvent& last,
            std::vector<space::RayEvent>& out) const;
  exact::Tried<std::vector<Stretch>> cuts(const Side& side, const Line& line, const Stretch& whole,
                                          std::span<const Stretch> known, Places& seen) const;
  /// What a place that was outside before cuts away of the stretch, if that is much of it.
  std::optional<Stretch> cut_again(const Side& side, const Line& line, const Stretch& stretch, Places& seen) const;
  Solids swept(const Line& line, const Stretch& stretch) const;
  Stretch outside(const Side& side, const Line& line, const space::Vector& x, const Stretch& within) const;
  Stretch chord(const Line& line, const space::Vector& x, const Stretch& within) const;
  /// The places at which the part of B, drawn at 0, holds `off`.
  Stretch held(const Part& part, const Line& line, const space::Vector& off) const;

  space::RayGrid grid_;
  std::unique_ptr<ProtrusionField> field_;  // of A
  double unit_, size_;                      // grid parts to the bodies' steps
  std::vector<Part> parts_;                 // of B
  std::array<Side, 2> sides_;               // outer, inner
};

}  // namespace findspace::distance
