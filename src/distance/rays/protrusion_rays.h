// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a body B of polyhedra and balls lies within V, the union of the parts of A each grown by a level: {mu(B + p, A)
// <= level} on rays, A not convex. V has creases and pockets, so a position can be lost at an edge or in a face of B
// between vertices that are all in V. On each line the places that all vertices allow are found exactly. A
// branch-and-bound search (solid_max_min.h) through what B sweeps over a stretch of them then proves that nothing
// protrudes, or gives a point of B outside V. It is moved to where most of the line is cut away by it
// (protrusion_end.h); all places at which it is outside are cut away, and the search goes on with the rest. The places
// of these points are tried on the next line of the row before it is searched.
// The triangles of its surface stand for B where the places within B are known that may be farthest
// (void_places.h): then no convex parts of B are needed.
// Guarantee: the sign is - or + only where that is certain; 0 where the distance is within kCertain of the shapes' size
// and the level of the level; at levels this near to 0 what lies within no part of A, and no further set, is not seen
// to be inside. Ends of {<= level} that a vertex decides are exact. Cost: a search a stretch, and some for an end that
// no vertex decides. Keywords: directed Hausdorff distance, cutting planes, certified bounds.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "distance/rays/corner_rays.h"
#include "distance/rays/protrusion_end.h"
#include "distance/search/round_solid.h"
#include "distance/search/solid_max_min.h"
#include "exact/margins/space_distance.h"
#include "space/body/body.h"
#include "space/body/wall_bridges.h"
#include "space/convolution/ray_solids.h"
#include "space/polytope/extent_tree.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// A cube of so many steps about its middle that lies in a void.
struct VoidPlace {
  space::Vector middle;
  double room = 0;
};

/// The body A that another protrudes from: by its convex parts, or by the triangles of its surface
/// (surface_max_min.cpp).
class ProtrusionField : public EndField {
 public:
  /// The length of its diagonal.
  virtual double size() const = 0;
  /// The point of the solids that is farthest out, as in solid_max_min.h.
  virtual SolidMaxMin max_min(const Solids& solids, double slack, double share) const = 0;
  /// How far x may run along the way and stay farther than `cut` from the body, at least, and about that, or
  /// `farthest`; x is farther. `size`: of all.
  virtual double run(const space::Vector& x, const space::Vector& way, double cut, double size,
                     double farthest) const = 0;
  /// A place in each part of space that is farther than `most` and may be one that a place at which the distance is
  /// greater than around it, and than `least`, lies in; nothing where such are not known.
  virtual std::optional<std::vector<VoidPlace>> voids(double /*least*/, double /*most*/) const { return {}; }
  /// Whether x, which is farther than a level above 0 from the frontier, is outside for sure.
  virtual bool outside(const space::Vector& x) const = 0;
  /// True only where no place of the box is farther than `most`.
  virtual bool within(const space::Extent& /*box*/, double /*most*/) const { return false; }
};

/// How far a line runs until a convex function, positive at 0, is no longer so, at least, and about that; a shorter
/// run is as good.
double convex_run(const std::function<double(double)>& f, double size, double farthest);

/// `further`: sets within the body.
std::shared_ptr<ProtrusionField> field_of_parts(const space::Body& body,
                                                std::span<const space::WallBridge> further = {});
/// Of the union of solids, which are not too far out. Distances inside are at most 0.
std::shared_ptr<ProtrusionField> field_of_surfaces(const std::vector<space::RaySolid>& solids);

/// What B is made of: polyhedra, balls (of a radius), and triangles, in the steps of A.
struct ProtrusionPart {
  std::vector<Tetrahedron> solid;
  std::vector<std::array<space::Vector, 3>> faces;  // triangles
  std::vector<space::Vector> normals;               // of the triangles, outward
  std::vector<NearPlane> planes;
  space::Vector center;
  double radius = 0;
  int surface = 0;  // that a triangle is of
};
struct ProtrusionParts {
  std::vector<ProtrusionPart> parts;
  double size = 0;    // of B
  double moved = 0;   // what the parts may be off
  double room = 0;    // half of how thick the triangles are
  bool flat = false;  // they are the triangles of a surface, to go with these places about A
  std::vector<VoidPlace> voids{};
};
/// In steps of the body, times `factor`.
ProtrusionParts protrusion_parts(const space::Body& body, double factor = 1);
/// The triangles of its surface; nothing where the voids of A are not known.
std::optional<ProtrusionParts> protrusion_parts(const std::vector<space::RaySolid>& solids, const ProtrusionField& a,
                                                double level);

class ProtrusionRays : public space::RaySource {
 public:
  /// How near to the level the sign is 0, of the size of both bodies and the level.
  static constexpr double kCertain = margin::kRayCertain;
  /// So far below the level what is certainly kept ends.
  static constexpr double kInner = kCertain / 8;

  /// Makes what the vertices of B allow for a level.
  using Vertices = std::function<std::unique_ptr<LineStretches>(const exact::Real& level)>;

  /// The level is not less than 0. `step`: steps of A to a grid step. `first`: if there is one, the sign is the greater
  /// one of both, and where that is + nothing is searched.
  ProtrusionRays(ProtrusionParts b, std::shared_ptr<const ProtrusionField> a, const exact::Real& level,
                 const Vertices& vertices, const space::RayGrid& grid, double step,
                 space::RaySourcePointer first = nullptr);

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
  static constexpr Stretch kAllOfIt{-exact::kInfinity, exact::kInfinity};
  /// Places outside V that B reached on lines before, the last one first.
  using Places = std::vector<space::Vector>;
  /// A side of the region: what is kept certainly holds it, or lies in it.
  struct Side {
    std::unique_ptr<LineStretches> vertices;
    double cut;     // beyond this distance from A a point of B is outside
    double enough;  // up to this nothing protrudes
  };

  using Part = ProtrusionPart;
  /// Where the part holds a point on its way; nothing of it: none does.
  struct Chord {
    Stretch held;
    const Part* part = nullptr;
    bool exact = false;  // it does for sure
  };

  Line line(int i, int j) const;
  /// Of what its vertices allow. `seen`: of each line.
  exact::Tried<space::RayRow> kept(const Side& side, int j, const space::RayRow& allowed, const space::RayRow* inner,
                                   std::vector<Places>& seen) const;
  Stretch whole(const space::RayEvent& first, const space::RayEvent& last) const;
  void keep(std::span<const Stretch> gone, const space::RayEvent& first, const space::RayEvent& last,
            std::vector<space::RayEvent>& out) const;
  exact::Tried<std::vector<Stretch>> cuts(const Side& side, const Line& line, const Stretch& whole,
                                          std::span<const Stretch> known, Places& seen) const;
  /// What a place that was outside before cuts away of the stretch, if that is much of it.
  std::optional<Stretch> cut_again(const Side& side, const Line& line, const Stretch& stretch, Places& seen) const;
  /// What the stretch is cut by, or nothing where nothing protrudes.
  exact::Tried<std::vector<Stretch>> cut(const Side& side, const Line& line, const Stretch& stretch,
                                         std::span<const Stretch> known, Places& seen) const;
  static std::vector<Stretch> joined(std::vector<Stretch> all);
  /// The cut of x and more, by the places near x that are outermost.
  std::vector<Stretch> lengthened(const Side& side, const Line& line, const Stretch& within, const space::Vector& x,
                                  const Stretch& cut, Places& seen) const;
  /// What is cut away beside an end, by places from y inward.
  std::optional<Stretch> inward(const Side& side, const Line& line, const Part& part, const EndPlace& y,
                                double until) const;
  /// By a void that B holds.
  exact::Tried<std::optional<Stretch>> cut_by_void(const Side& side, const Line& line, const Stretch& stretch,
                                                   Places& seen) const;
  std::optional<Stretch> cut_beside(const Side& side, const Line& line, const Stretch& stretch,
                                    std::span<const Stretch> known, Places& seen) const;
  std::optional<Stretch> tested(const Side& side, const Line& line, const Stretch& within,
                                const space::Vector& x) const;
  static void remember(const space::Vector& x, Places& seen);
  /// Towards the lower places, or the higher ones; from B at a place.
  std::optional<EndPlace> outermost(const Side& side, const Line& line, const Part& part, const space::Vector& x,
                                    double at, int way, double reach) const;
  /// Whether B protrudes by so little beside the stretches known that it does not protrude on this one.
  bool settled(const Side& side, const Stretch& stretch, std::span<const Stretch> known) const;
  Solids swept(const Line& line, const Stretch& stretch, double enough) const;
  void add_swept(const Part& part, const Line& line, const Stretch& stretch, Solids& out) const;
  Stretch outside(const Side& side, const Line& line, const space::Vector& x, const Stretch& held) const;
  /// Those of the parts whose boxes meet the line of a point, at places in the stretch.
  std::vector<std::size_t> parts_along(const Line& line, const space::Vector& off, const Stretch& within) const;
  /// Where a flat B comes to hold the point, and where it leaves it.
  struct SolidChord {
    Stretch held;
    const Part *first, *last;
  };
  std::optional<std::vector<SolidChord>> chords_of_surface(const Line& line, const space::Vector& off,
                                                           std::span<const std::size_t> parts) const;
  std::optional<std::vector<SolidChord>> solid_chords(const Line& line, const space::Vector& off,
                                                      const std::vector<std::size_t>& parts) const;
  std::optional<Chord> solid_chord(const Line& line, const space::Vector& off, const std::vector<std::size_t>& parts,
                                   const Stretch& within) const;
  Chord chord(const Line& line, const space::Vector& x, const Stretch& within) const;
  /// The places at which the part of B, drawn at 0, holds `off`.
  Stretch held(const Part& part, const Line& line, const space::Vector& off) const;

  space::RayGrid grid_;
  std::shared_ptr<const ProtrusionField> field_;  // of A
  double unit_, size_;                            // grid parts to the bodies' steps
  std::vector<Part> parts_;                       // of B
  bool flat_;                                     // of them: the surface of B alone
  double room_;                                   // half of how thick that is
  std::vector<VoidPlace> voids_;
  space::ExtentTree boxes_;    // of the parts
  std::array<Side, 2> sides_;  // outer, inner
  space::RaySourcePointer first_;
};

}  // namespace findspace::distance
