// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ray map of a solid grown by a ball: on the lines of a grid, whether the distance of p to A is less than `radius`
// (-), equal (0) or more (+). So gamma1 of a ball of radius r against A at level l, radius = r + l. With A as the
// complement of the solid given, the negative of it: - where p lies deeper than `radius` in the solid: eta1 of a ball.
//
// Lines meet the true surface: planes moved along normals, cylinders about edges, spheres about vertices (the
// convolution of the boundary with a sphere, signed as in ray_convolution.h). The winding number at p is the Euler
// characteristic of what A and the ball about p have in common; 0 is ambiguous and decided by a distance. Guarantee:
// exact. Doubles with running bounds decide first; a line on which they cannot (it passes through a seam of two
// patches, or touches one) is done again with real numbers, its cells decided by distances.
// Cost: about a tenth of a microsecond for each patch and line in its box. Keywords: offset surface, dilation, parallel
// body.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "space/convolution/ray_cones.h"
#include "space/convolution/ray_distance.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

class BallRays : public RaySource, private RayRoots {
 public:
  enum class Side { kSolid, kComplement };

  /// In grid steps. Throws Error(kBadValue) unless radius > 0.
  BallRays(const Triangles& a, const exact::Real& radius, const RayGrid& grid, Side side = Side::kSolid);

  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int j) const override;
  /// How many lines were done with real numbers, and cells decided by distances.
  std::int64_t exact_lines() const { return exact_lines_; }
  std::int64_t cell_tests() const { return cell_tests_; }

 private:
  friend class BallRow;
  enum class Kind : std::int8_t { kFace, kEdge, kVertex };
  struct Patch {
    Kind kind;
    int feature;
    int first_column, last_column, first_row, last_row;
  };

  exact::Real root(int patch, int which, int i, int j) const override;
  void add_patch(std::vector<Patch>& patches, Kind kind, int feature, const Point& low, const Point& high,
                 const Cone& cone) const;
  std::vector<Patch> patches_of(const std::vector<Approx3>& units, std::size_t first, std::size_t last) const;
  void make_patches();

  RayGrid grid_;
  RayBody body_;
  bool complement_;
  exact::Real radius_;
  double rounded_radius_;
  std::optional<SurfaceDistance> distance_;
  std::vector<Patch> patches_;
  std::vector<std::size_t> first_;
  std::vector<int> of_row_;
  mutable std::atomic<std::int64_t> exact_lines_{0}, cell_tests_{0};
};

}  // namespace findspace::space
