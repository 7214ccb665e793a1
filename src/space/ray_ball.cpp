// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/ray_ball.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "space/ray_ball_patch.h"
#include "space/ray_ball_row.h"
#include "space/ray_cones.h"

namespace findspace::space {
namespace {

using exact::Real;

constexpr double kWiden = 0x1p-20;  // boxes of patches are wider than they need to be

/// The range of x (axis 0) or y (1) over the directions of a cone.
std::pair<double, double> range(const Cone& cone, int axis) {
  const double c = axis == 0 ? cone.axis.x : cone.axis.y, angle = std::acos(std::clamp(c, -1.0, 1.0));
  return {std::cos(std::min(angle + cone.angle, M_PI)) - kWiden, std::cos(std::max(angle - cone.angle, 0.0)) + kWiden};
}

RayBody prepared(const Triangles& a, const RayGrid& grid, bool complement) {
  Triangles t = with_axis(scaled(a, grid.parts), grid.axis);
  return RayBody(complement ? turned_inside_out(std::move(t)) : std::move(t));
}

}  // namespace

BallRays::BallRays(const Triangles& a, const Real& radius, const RayGrid& grid, Side side)
    : grid_(grid),
      body_(prepared(a, grid, side == Side::kComplement)),
      complement_(side == Side::kComplement),
      radius_(radius * Real(grid.parts)),
      rounded_radius_(radius_.to_double()),
      distance_(body_, radius_) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "the radius of a ball is more than 0");
  make_patches();
}

void BallRays::add_patch(Kind kind, int feature, const Point& low, const Point& high, const double low_normal[2],
                         const double high_normal[2]) {
  const auto lines = [&](std::int64_t from, std::int64_t to, int axis, std::int64_t start, std::int64_t step,
                         int count) {
    const double a = static_cast<double>(from - start) + rounded_radius_ * low_normal[axis];
    const double b = static_cast<double>(to - start) + rounded_radius_ * high_normal[axis];
    const auto clamp = [&](double line) {
      return static_cast<int>(std::clamp(line, -1.0, static_cast<double>(count)));
    };
    return std::pair(std::max(0, clamp(std::ceil(a / static_cast<double>(step)))),
                     std::min(count - 1, clamp(std::floor(b / static_cast<double>(step)))));
  };
  const auto [left, right] = lines(low.x, high.x, 0, grid_.u, grid_.du, grid_.nu);
  const auto [bottom, top] = lines(low.y, high.y, 1, grid_.v, grid_.dv, grid_.nv);
  if (left <= right && bottom <= top) patches_.push_back({kind, feature, left, right, bottom, top});
}

void BallRays::make_patches() {
  std::vector<Shadow3> units;
  for (const Shadow3& n : body_.normal_shadows) units.push_back(unit(n));
  const auto add = [&](Kind kind, int feature, const Point& low, const Point& high, const Cone& cone) {
    const auto [x0, x1] = range(cone, 0);
    const auto [y0, y1] = range(cone, 1);
    const double from[2] = {x0, y0}, to[2] = {x1, y1};
    add_patch(kind, feature, low, high, from, to);
  };
  const auto box = [&](std::initializer_list<Point> points, Point& low, Point& high) {
    low = high = *points.begin();
    for (const Point& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
    }
  };
  Point low, high;
  for (int f = 0; f < static_cast<int>(body_.faces.size()); ++f) {
    box({body_.corner(f, 0), body_.corner(f, 1), body_.corner(f, 2)}, low, high);
    add(Kind::kFace, f, low, high, {units[f], 0});
  }
  for (std::size_t e = 0; e < body_.edges.size(); ++e) {
    const RayEdge& edge = body_.edges[e];
    if (edge.bend == 0) continue;
    box({body_.points[edge.from], body_.points[edge.to]}, low, high);
    const Shadow3 two[2] = {units[edge.left], units[edge.right]};
    add(Kind::kEdge, static_cast<int>(e), low, high, cone_of(two));
  }
  std::vector<Shadow3> about;
  for (std::size_t v = 0; v < body_.vertices.size(); ++v) {
    about.clear();
    for (int k = 0; k < body_.vertices[v].count; ++k)
      about.push_back(units[body_.corners[body_.vertices[v].first + k].face]);
    const Point& p = body_.points[body_.vertices[v].point];
    add(Kind::kVertex, static_cast<int>(v), p, p, cone_of(about));
  }
  first_.assign(grid_.nv + 1, 0);
  for (const Patch& p : patches_) {
    for (int j = p.first_row; j <= p.last_row; ++j) ++first_[j + 1];
  }
  for (int j = 0; j < grid_.nv; ++j) first_[j + 1] += first_[j];
  of_row_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    for (int j = patches_[k].first_row; j <= patches_[k].last_row; ++j) of_row_[next[j]++] = static_cast<int>(k);
  }
}

Real BallRays::root(int patch, int which, int i, int j) const {
  const Patch& p = patches_[patch];
  return BallRow::meet<Real>(*this, p, radius_, i, j).height[which] + Real(BallRow::base(*this, p).z);
}

RayRow BallRays::row(int j) const { return BallRow(*this, j).run(); }

}  // namespace findspace::space
