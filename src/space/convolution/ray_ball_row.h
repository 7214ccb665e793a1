// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The work on one row of a BallRays. Internal to ray_ball.
#pragma once

#include <cmath>
#include <vector>

#include "exact/margins/rounding.h"
#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_ball_patch.h"

namespace findspace::space {

class BallRow {
 public:
  using Patch = BallSurface::Patch;
  using Kind = BallSurface::Kind;

  BallRow(const BallRays& rays, int j) : rays_(rays), of_(*rays.surface_), j_(j) {}
  /// The columns from `first` to `last`.
  RayRow run(int first, int last);

  const Point& base(const Patch& p) const {
    if (p.kind == Kind::kFace) return of_.body_.corner(p.feature, 0);
    if (p.kind == Kind::kEdge) return of_.body_.points[of_.body_.edges[p.feature].from];
    return of_.body_.points[of_.body_.vertices[p.feature].point];
  }
  /// Along the line.
  std::int64_t base_height(const Patch& p) const { return base(p).z - rays_.back_.z; }
  template <class T>
  BallPatchMeets<T> meet(const Patch& p, const T& radius, int i) const {
    const Point& at = base(p);
    T* kind = nullptr;
    const T x = number(rays_.u_at(i) - at.x, kind), y = number(rays_.v_at(j_) - at.y, kind);
    if (p.kind == Kind::kFace) return meet_face<T>(of_.body_, p.feature, radius, x, y);
    if (p.kind == Kind::kEdge) return meet_edge<T>(of_.body_, of_.body_.edges[p.feature], radius, x, y);
    return meet_vertex<T>(radius, x, y);
  }

 private:
  struct Hit {
    double at, error;
    int column, patch;
    std::int8_t which;
    std::int32_t jump;
  };

  void collect();
  bool add_hits(int patch, int column);
  /// The local index at the vertex in direction (x, y, height), or nothing where doubles cannot tell.
  bool vertex_index(const Patch& p, int column, const exact::Approx& height, int& index) const;
  bool emit_certain(int column, RayRow& row);
  void emit_exact(int column, RayRow& row);
  RayPosition position(const Hit& h) const;
  int against_radius(int column, double z) const;
  /// Of a height along the line, in the surface's.
  double lifted(double z) const { return z + static_cast<double>(rays_.back_.z); }
  int inside(int column, double at) const;
  /// As SurfaceDistance::compare() at a height along the line.
  template <class Exactly>
  int compare(int column, double height, double error, Exactly exactly) const {
    const double z = lifted(height);
    const std::int64_t by = rays_.back_.z;
    if (by != 0) error += margin::kFewRoundings * std::fabs(z);
    return of_.distance_->compare(rays_.u_at(column), rays_.v_at(j_), z, error,
                                  [&] { return by == 0 ? exactly() : exactly() + exact::Real(by); });
  }
  void push(RayRow& row, const RayPosition& at, int before, int here, int after) const;

  const BallRays& rays_;
  const BallSurface& of_;
  int j_;
  int left_ = 0, right_ = -1;  // the columns asked for
  std::vector<Hit> hits_, sorted_;
  std::vector<int> first_;  // of the columns asked for
  std::vector<char> unresolved_;
};

}  // namespace findspace::space
