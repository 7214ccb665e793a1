// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_ball.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/space.h"
#include "plane/base/parallel.h"
#include "space/convolution/ray_ball_patch.h"
#include "space/convolution/ray_ball_row.h"
#include "space/convolution/ray_cones.h"

namespace findspace::space {
namespace {

using exact::Real;

/// Features whose patches are found together.
constexpr std::size_t kAtOnce = 4096;

/// The range of one component over the directions of a cone about a direction where it is c.
std::pair<double, double> range(double c, double cos_angle, double sin_angle) {
  c = std::clamp(c, -1.0, 1.0);
  const double across = std::sqrt(1 - c * c) * sin_angle, along = c * cos_angle;
  return {(c <= -cos_angle ? -1 : along - across) - margin::kWiderPatchBox,
          (c >= cos_angle ? 1 : along + across) + margin::kWiderPatchBox};
}

RayBody prepared(const Triangles& a, const RayGrid& grid, bool complement) {
  Triangles t = with_axis(scaled(a, grid.parts), grid.axis);
  return RayBody(complement ? inside_out(std::move(t)) : std::move(t));
}

}  // namespace

BallRays::BallRays(const Triangles& a, const Real& radius, const RayGrid& grid, Side side)
    : grid_(grid),
      body_(prepared(a, grid, side == Side::kComplement)),
      complement_(side == Side::kComplement),
      radius_(radius * Real(grid.parts)),
      rounded_radius_(radius_.to_double()) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "the radius of a ball is more than 0");
  plane::parallel_for(2, [&](std::size_t k) { k == 0 ? make_patches() : void(distance_.emplace(body_, radius_)); });
}

void BallRays::add_patch(std::vector<Patch>& patches, Kind kind, int feature, const Point& low, const Point& high,
                         const Cone& cone) const {
  const double angle = std::min(cone.angle, M_PI), cos_angle = std::cos(angle), sin_angle = std::sin(angle);
  const std::pair<double, double> normal[2] = {range(cone.axis.x, cos_angle, sin_angle),
                                               range(cone.axis.y, cos_angle, sin_angle)};
  const auto lines = [&](std::int64_t from, std::int64_t to, int axis, std::int64_t start, std::int64_t step,
                         int count) {
    const double a = static_cast<double>(from - start) + rounded_radius_ * normal[axis].first;
    const double b = static_cast<double>(to - start) + rounded_radius_ * normal[axis].second;
    const auto clamp = [&](double line) {
      return static_cast<int>(std::clamp(line, -1.0, static_cast<double>(count)));
    };
    return std::pair(std::max(0, clamp(std::ceil(a / static_cast<double>(step)))),
                     std::min(count - 1, clamp(std::floor(b / static_cast<double>(step)))));
  };
  const auto [left, right] = lines(low.x, high.x, 0, grid_.u, grid_.du, grid_.nu);
  const auto [bottom, top] = lines(low.y, high.y, 1, grid_.v, grid_.dv, grid_.nv);
  if (left <= right && bottom <= top) patches.push_back({kind, feature, left, right, bottom, top});
}

/// Of features first to last - 1: faces, then edges, then vertices.
std::vector<BallRays::Patch> BallRays::patches_of(const std::vector<Approx3>& units, std::size_t first,
                                                  std::size_t last) const {
  std::vector<Patch> out;
  const auto box = [&](std::initializer_list<Point> points, Point& low, Point& high) {
    low = high = *points.begin();
    for (const Point& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
    }
  };
  Point low, high;
  std::vector<Approx3> about;
  const std::size_t faces = body_.faces.size(), edges = body_.edges.size();
  for (std::size_t k = first; k < last; ++k) {
    if (k < faces) {
      const int f = static_cast<int>(k);
      box({body_.corner(f, 0), body_.corner(f, 1), body_.corner(f, 2)}, low, high);
      add_patch(out, Kind::kFace, f, low, high, {units[k], 0});
    } else if (k < faces + edges) {
      const RayEdge& edge = body_.edges[k - faces];
      if (edge.bend == 0) continue;
      box({body_.points[edge.from], body_.points[edge.to]}, low, high);
      const Approx3 two[2] = {units[edge.left], units[edge.right]};
      add_patch(out, Kind::kEdge, static_cast<int>(k - faces), low, high, cone_of(two));
    } else {
      const RayVertex& vertex = body_.vertices[k - faces - edges];
      about.clear();
      for (int c = 0; c < vertex.count; ++c) about.push_back(units[body_.corners[vertex.first + c].face]);
      const Point& p = body_.points[vertex.point];
      add_patch(out, Kind::kVertex, static_cast<int>(k - faces - edges), p, p, cone_of(about));
    }
  }
  return out;
}

void BallRays::make_patches() {
  std::vector<Approx3> units;
  for (const Approx3& n : body_.normal_approx) units.push_back(unit(n));
  const std::size_t count = body_.faces.size() + body_.edges.size() + body_.vertices.size();
  std::vector<std::vector<Patch>> parts((count + kAtOnce - 1) / kAtOnce);
  plane::parallel_for(parts.size(), [&](std::size_t k) {
    parts[k] = patches_of(units, k * kAtOnce, std::min(count, (k + 1) * kAtOnce));
  });
  for (const std::vector<Patch>& part : parts) patches_.insert(patches_.end(), part.begin(), part.end());
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

exact::Tried<RayRow> BallRays::try_row(int j) const { return BallRow(*this, j).run(); }

}  // namespace findspace::space
