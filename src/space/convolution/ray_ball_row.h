// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The work on one row of a BallRays. Internal to ray_ball.
#pragma once

#include <vector>

#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_ball_patch.h"

namespace findspace::space {

class BallRow {
 public:
  BallRow(const BallRays& rays, int j) : rays_(rays), j_(j) {}
  RayRow run();

  using Patch = BallRays::Patch;
  static const Point& base(const BallRays& rays, const Patch& p) {
    if (p.kind == BallRays::Kind::kFace) return rays.body_.corner(p.feature, 0);
    if (p.kind == BallRays::Kind::kEdge) return rays.body_.points[rays.body_.edges[p.feature].from];
    return rays.body_.points[rays.body_.vertices[p.feature].point];
  }
  template <class T>
  static BallPatchMeets<T> meet(const BallRays& rays, const Patch& p, const T& radius, int i, int j) {
    const Point& at = base(rays, p);
    T* kind = nullptr;
    const T x = number(rays.grid_.u_at(i) - at.x, kind), y = number(rays.grid_.v_at(j) - at.y, kind);
    if (p.kind == BallRays::Kind::kFace) return meet_face<T>(rays.body_, p.feature, radius, x, y);
    if (p.kind == BallRays::Kind::kEdge) return meet_edge<T>(rays.body_, rays.body_.edges[p.feature], radius, x, y);
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
  int inside(int column, double z) const;
  void push(RayRow& row, const RayPosition& at, int before, int here, int after) const;

  const BallRays& rays_;
  int j_;
  std::vector<Hit> hits_, sorted_;
  std::vector<int> first_;
  std::vector<char> unresolved_;
};

}  // namespace findspace::space
