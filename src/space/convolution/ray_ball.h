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
// Cost: about a tenth of a microsecond for each patch and line in its box; a nanosecond for each beside it. Keywords:
// offset surface, dilation, parallel body.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "space/convolution/ray_cones.h"
#include "space/convolution/ray_distance.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

/// The solid and the patches of its offset surface, which the ray maps of many translations of it share.
class BallSurface {
 public:
  enum class Side { kSolid, kComplement };
  enum class Kind : std::int8_t { kFace, kEdge, kVertex };
  struct Patch {
    Kind kind;
    int feature;
    double left, right, bottom, top;  // of the box across the lines
  };

  /// In grid steps, for grids of this axis and of so many parts. `lines`: a patch that meets none of them is left out.
  /// Throws Error(kBadValue) unless radius > 0.
  BallSurface(const Triangles& a, const exact::Real& radius, const RayGrid& grid, Side side,
              const RayGrid* lines = nullptr);

  /// visit(number of the patch) of those whose box holds a place (u, v) for some u; numbers grow.
  template <class Visit>
  void each_at(double v, Visit visit) const {
    const double row = (v - lowest_) / height_;
    if (!(row >= 0 && row < static_cast<double>(first_.size() - 1))) return;
    const auto bin = static_cast<std::size_t>(row);
    for (std::size_t k = first_[bin]; k < first_[bin + 1]; ++k) {
      const Patch& p = patches_[static_cast<std::size_t>(in_bin_[k])];
      if (p.bottom <= v && v <= p.top) visit(in_bin_[k]);
    }
  }

 private:
  friend class BallRays;
  friend class BallRow;
  void add_patch(std::vector<Patch>& patches, Kind kind, int feature, const Point& low, const Point& high,
                 const Cone& cone, const RayGrid* lines) const;
  std::vector<Patch> patches_of(const std::vector<Approx3>& units, std::size_t first, std::size_t last,
                                const RayGrid* lines) const;
  void make_patches(const RayGrid* lines);
  void make_bins();

  RayBody body_;
  bool complement_;
  exact::Real radius_;
  double rounded_radius_;
  std::optional<SurfaceDistance> distance_;
  std::vector<Patch> patches_;
  double lowest_ = 0, height_ = 1;  // of the bins: ranges of the second coordinate
  std::vector<std::size_t> first_{0};
  std::vector<int> in_bin_;
};

class BallRays : public RaySource, private RayRoots {
 public:
  using Side = BallSurface::Side;

  /// In grid steps. Throws Error(kBadValue) unless radius > 0.
  BallRays(const Triangles& a, const exact::Real& radius, const RayGrid& grid, Side side = Side::kSolid);
  /// Of the solid moved by -`back`, which may be far out.
  BallRays(std::shared_ptr<const BallSurface> surface, const Point& back, const RayGrid& grid);

  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int j) const override;
  /// A row of line (i, j) alone.
  RayRow line(int i, int j) const;
  /// How many lines were done with real numbers, and cells decided by distances.
  std::int64_t exact_lines() const { return exact_lines_; }
  std::int64_t cell_tests() const { return cell_tests_; }

 private:
  friend class BallRow;
  exact::Real root(int patch, int which, int i, int j) const override;
  /// Of the lines, as the surface has them.
  std::int64_t u_at(int i) const { return grid_.u_at(i) + back_.x; }
  std::int64_t v_at(int j) const { return grid_.v_at(j) + back_.y; }
  /// The columns from `first` to `last` that the patch may meet.
  std::pair<int, int> columns(const BallSurface::Patch& p, int first, int last) const;

  RayGrid grid_;
  std::shared_ptr<const BallSurface> surface_;
  Point back_;  // along the grid's axes, in its parts
  mutable std::atomic<std::int64_t> exact_lines_{0}, cell_tests_{0};
};

}  // namespace findspace::space
