// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How near a point comes to a part of a solid that balls are cut out of or cut off by (csg_solid.h), by the features
// of the part: its planes and spheres, the edges and circles in which two of them meet, the points in which three do.
// The nearest place is on one of them, and there the nearest to the point, so each feature names one place; the nearest
// of those that belong to the part is it. Along a line steps as long as the distance leave nothing out. Guarantee:
// doubles, off by less than margin::kFoundError of the sizes; a part of another form has no features, nor has one whose
// surfaces nearly touch, and places about which rounding decides are not told. Cost: a microsecond a point,
// as features are in a tree. Keywords: closest point, stratification, sphere tracing, constructive solid geometry.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "distance/search/boundary_search.h"
#include "space/body/csg_solid.h"
#include "space/polytope/extent_tree.h"

namespace findspace::distance {

/// A stretch of a line.
struct PointWay {
  space::Vector start, unit;
  double from = 0, to = 0;
};

class CsgFeatures {
 public:
  /// Null where the part has none. `size`: of its coordinates and radii.
  static std::unique_ptr<const CsgFeatures> of(const space::CsgPart& part, double size);

  /// The least distance of the points of a stretch from the part, between `low` and `high`; the latter is that of
  /// `place` from the stretch.
  struct Nearest {
    double low = 0, high = 0;
    space::Vector place;
  };
  /// Nothing where the features do not tell, or not soon.
  std::optional<Nearest> nearest(const PointWay& way, const Until& until) const;

 private:
  /// The part is where the value is at most 0.
  struct Surface {
    space::Vector at;  // of a plane the normal, of length 1
    double by = 0;     // the shift, or the radius
    int ball = 0;      // 1: within it, -1: outside, 0: a plane
    double value(const space::Vector& x) const;
  };
  enum class Kind { kPlane, kSphere, kEdge, kCircle, kPoint };
  struct Feature {
    Kind kind;
    std::array<int, 3> on;  // surfaces; -1: none
    space::Vector at, unit{};
    double radius = 0;
    space::Vector nearest(const space::Vector& x) const;
  };

  CsgFeatures() = default;
  bool add_surfaces(const space::CsgPart& part);
  void add_plane_or_sphere(int k);
  /// False where surfaces nearly touch.
  bool add_pair(int i, int j);
  bool add_edge(int i, int j);
  bool add_circle(int sphere, int other);
  bool add_on_edge(const Feature& edge, double from, double to);
  bool add_on_circle(const Feature& circle);
  void add_point(const space::Vector& x, const std::array<int, 3>& on);
  void add(const Feature& feature, const space::Extent& box);
  /// The plane itself, or that of the circle in which two spheres would meet; none of spheres about one centre.
  std::optional<Surface> plane_with(int sphere, int other) const;
  /// By how much x breaks the worst rule of those of no surface in `on`.
  double breaks(const space::Vector& x, const std::array<int, 3>& on) const;
  std::optional<Nearest> nearest(const space::Vector& x, const std::optional<space::Vector>& known) const;

  double noise_ = 0, tolerance_ = 0;
  space::Extent box_{};
  std::vector<Surface> surfaces_;
  std::vector<int> plain_;  // surfaces that are asked one by one: all but balls that are cut out
  std::vector<int> cuts_;
  space::ExtentTree cut_tree_, tree_;  // of cuts_, of features_
  std::vector<Feature> features_;
  std::vector<space::Extent> boxes_;
};

}  // namespace findspace::distance
