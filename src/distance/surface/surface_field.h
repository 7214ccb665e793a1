// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Signed distances of places to a set that is given by its surfaces, in doubles: those to the nearest triangle of trees
// of boxes, with the side by the triangles above. And how far solids protrude from the set (tetrahedral_max_min.h):
// what bounds a cell are the distances of a few triangles, and the signed distance of its middle. Guarantee: doubles; a
// side is only said where it is certain. Cost: a microsecond or so. Keywords: signed distance field, bounding volume
// hierarchy.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "distance/search/round_solid.h"
#include "space/polytope/extent.h"
#include "space/polytope/plane_tree.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

/// Of no radius: none.
struct InnerBall {
  space::Vector center;
  double radius = 0;
};

/// The boxes of a surface's tree, as doubles.
class FaceBoxes {
 public:
  explicit FaceBoxes(const space::BoxTree& tree);
  /// visit(face) of those whose boxes are not farther from x than `most`, which it may lower, the nearer ones first;
  /// stops where it is false.
  template <class Visit>
  void near(const space::Vector& x, double& most, Visit visit) const;

 private:
  struct Box {
    space::Vector low, high;
  };
  struct Node {
    Box box;
    int first = 0, count = 0;  // as in the tree
  };
  static double squared_gap(const Box& box, const space::Vector& x) {
    const auto gap = [](double low, double high, double at) { return std::max(std::max(low - at, at - high), 0.0); };
    const space::Vector d{gap(box.low.x, box.high.x, x.x), gap(box.low.y, box.high.y, x.y),
                          gap(box.low.z, box.high.z, x.z)};
    return space::dot(d, d);
  }

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;
  std::vector<int> faces_;
};

class SurfaceField {
 public:
  /// Moved by `by`. Keeps a reference.
  SurfaceField(const space::SurfaceSet& set, const space::Vector& by);

  struct Signed {
    double value = 0;            // negative inside
    double distance = 0;         // from the surface that is nearest
    bool certain = false;        // near the surface the side is not decided; the value counts as outside
    space::Vector projection{};  // the nearest place of the surface
    int part = -1;               // by number
  };
  /// What is known of a place: a part that may be the nearest one, and + outside the set, - inside, by some distance.
  struct Known {
    int part = -1;
    int side = 0;
  };
  /// Inside a union it is not less than the true one; outside it is that.
  Signed at(const space::Vector& x, const Known& known) const;
  Signed at(const space::Vector& x) const { return at(x, {}); }
  /// A triangle or a ball, by number, and the distance from it; of a ball it is signed.
  struct Nearest {
    double distance = exact::kInfinity;
    int part = -1;
  };
  /// Where the distance is not more than `enough` any that is so near. `likely`: tried first.
  Nearest nearest(const space::Vector& x, double enough, std::span<const int> likely) const;
  /// Whether x, which is so far from the nearest surface, lies in the set; nothing where that is not certain.
  std::optional<bool> inside(const space::Vector& x, double away) const;
  /// The triangles and balls to which some place within `within` of x may be nearest, by number, if they are not more
  /// than `most`.
  std::optional<std::vector<int>> near(const space::Vector& x, double within, std::size_t most) const;
  /// A plane that all of the set within `reach` of x is on one side of: of one of few triangles nearby, if none of
  /// these is beyond it.
  std::optional<space::PlaneTree::Plane> bounding_plane(const space::Vector& x, double reach) const;
  /// From one of them.
  double distance(int part, const space::Vector& x) const;
  /// From a place of one of them, mostly the nearest one: twice as quick.
  double distance_to_place(int part, const space::Vector& x) const;
  std::size_t parts() const { return static_cast<std::size_t>(first_.back()) + set_.balls().size(); }
  /// The largest ball within the set that touches one of them at its middle, more or less; the radius is surely not too
  /// large.
  std::optional<InnerBall> inner_ball(int part) const;
  /// Outward, of length 1; nothing of a ball.
  std::optional<space::Vector> normal(int part) const;
  /// The nearest place of one of them.
  space::Vector place(int part, const space::Vector& x) const;
  const space::SurfaceSet& set() const { return set_; }
  /// That holds the set.
  space::Extent box() const;
  const space::Vector& by() const { return by_; }

 private:
  double distance_to_ball(int part, const space::Vector& x) const;
  /// From a triangle; or infinite where it is not less than `than`.
  double nearer(int part, const space::Vector& x, double than) const;

  const space::SurfaceSet& set_;
  space::Vector by_;
  std::vector<FaceBoxes> boxes_;                       // of the surfaces, not moved
  std::vector<std::array<space::Vector, 3>> corners_;  // of the triangles, moved
  double blur_ = 0;         // what the place of a triangle that is found quickly may be too far
  std::vector<int> first_;  // the numbers of the triangles of each surface begin there; those of the balls last
};

/// What of the solids counts where their parts are not known: what lies in the field, and so in the hull.
struct SolidOfSurface {
  const SurfaceField* field = nullptr;
  space::PlaneTree hull{};
};
/// How far they protrude from the set, which does not hold them; signed. `b` may be null: then all of them counts.
SolidMaxMin surface_max_min(const Solids& solids, const SolidOfSurface* b, const SurfaceField& a);

}  // namespace findspace::distance
