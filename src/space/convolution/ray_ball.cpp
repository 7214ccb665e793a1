// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_ball.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
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
/// Bins of patches, at most.
constexpr double kMostBins = 1 << 14;

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

/// Whether one of the places start, start + step ... is in the range.
bool any_place(double low, double high, std::int64_t start, std::int64_t step, int count) {
  const double first = std::max(0.0, std::ceil((low - static_cast<double>(start)) / static_cast<double>(step)));
  const double last = std::floor((high - static_cast<double>(start)) / static_cast<double>(step));
  return first <= std::min(last, static_cast<double>(count - 1));
}

/// Along the grid's axes, in its parts.
Point along_axes(const Point& p, const RayGrid& grid) {
  const auto at = [&](int k) { return component(p, (grid.axis + k) % 3) * grid.parts; };
  return {at(1), at(2), at(0)};
}

}  // namespace

BallSurface::BallSurface(const Triangles& a, const Real& radius, const RayGrid& grid, Side side, const RayGrid* lines)
    : body_(prepared(a, grid, side == Side::kComplement)),
      complement_(side == Side::kComplement),
      radius_(radius * Real(grid.parts)),
      rounded_radius_(radius_.to_double()) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "the radius of a ball is more than 0");
  plane::parallel_for(2,
                      [&](std::size_t k) { k == 0 ? make_patches(lines) : void(distance_.emplace(body_, radius_)); });
}

void BallSurface::add_patch(std::vector<Patch>& patches, Kind kind, int feature, const Point& low, const Point& high,
                            const Cone& cone, const RayGrid* lines) const {
  const double angle = std::min(cone.angle, M_PI), cos_angle = std::cos(angle), sin_angle = std::sin(angle);
  const auto reach = [&](double c, std::int64_t from, std::int64_t to) {
    const auto [least, most] = range(c, cos_angle, sin_angle);
    const double a = static_cast<double>(from), b = static_cast<double>(to);
    const double room = margin::kFewRoundings * (std::fabs(a) + std::fabs(b) + rounded_radius_);
    return std::pair(a + rounded_radius_ * least - room, b + rounded_radius_ * most + room);
  };
  const auto [left, right] = reach(cone.axis.x, low.x, high.x);
  const auto [bottom, top] = reach(cone.axis.y, low.y, high.y);
  if (lines && !(any_place(left, right, lines->u, lines->du, lines->nu) &&
                 any_place(bottom, top, lines->v, lines->dv, lines->nv)))
    return;
  patches.push_back({kind, feature, left, right, bottom, top});
}

/// Of features first to last - 1: faces, then edges, then vertices.
std::vector<BallSurface::Patch> BallSurface::patches_of(const std::vector<Approx3>& units, std::size_t first,
                                                        std::size_t last, const RayGrid* lines) const {
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
      add_patch(out, Kind::kFace, f, low, high, {units[k], 0}, lines);
    } else if (k < faces + edges) {
      const RayEdge& edge = body_.edges[k - faces];
      if (edge.bend == 0) continue;
      box({body_.points[edge.from], body_.points[edge.to]}, low, high);
      const Approx3 two[2] = {units[edge.left], units[edge.right]};
      add_patch(out, Kind::kEdge, static_cast<int>(k - faces), low, high, cone_of(two), lines);
    } else {
      const RayVertex& vertex = body_.vertices[k - faces - edges];
      about.clear();
      for (int c = 0; c < vertex.count; ++c) about.push_back(units[body_.corners[vertex.first + c].face]);
      const Point& p = body_.points[vertex.point];
      add_patch(out, Kind::kVertex, static_cast<int>(k - faces - edges), p, p, cone_of(about), lines);
    }
  }
  return out;
}

void BallSurface::make_patches(const RayGrid* lines) {
  std::vector<Approx3> units;
  for (const Approx3& n : body_.normal_approx) units.push_back(unit(n));
  const std::size_t count = body_.faces.size() + body_.edges.size() + body_.vertices.size();
  std::vector<std::vector<Patch>> parts((count + kAtOnce - 1) / kAtOnce);
  plane::parallel_for(parts.size(), [&](std::size_t k) {
    parts[k] = patches_of(units, k * kAtOnce, std::min(count, (k + 1) * kAtOnce), lines);
  });
  for (const std::vector<Patch>& part : parts) patches_.insert(patches_.end(), part.begin(), part.end());
  make_bins();
}

/// About as high as the patches are.
void BallSurface::make_bins() {
  if (patches_.empty()) return;
  double highest = patches_[0].top, sum = 0;
  lowest_ = patches_[0].bottom;
  for (const Patch& p : patches_) {
    lowest_ = std::min(lowest_, p.bottom);
    highest = std::max(highest, p.top);
    sum += p.top - p.bottom;
  }
  const double bins = (highest - lowest_) * static_cast<double>(patches_.size()) / sum;
  const std::size_t count = static_cast<std::size_t>(std::clamp(bins, 1.0, kMostBins)) + 1;
  height_ = (highest - lowest_) / static_cast<double>(count) * (1 + margin::kFewRoundings);
  const auto bin = [&](double v) { return std::min(count - 1, static_cast<std::size_t>((v - lowest_) / height_)); };
  first_.assign(count + 1, 0);
  for (const Patch& p : patches_) {
    for (std::size_t b = bin(p.bottom); b <= bin(p.top); ++b) ++first_[b + 1];
  }
  for (std::size_t b = 0; b < count; ++b) first_[b + 1] += first_[b];
  in_bin_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    for (std::size_t b = bin(patches_[k].bottom); b <= bin(patches_[k].top); ++b)
      in_bin_[next[b]++] = static_cast<int>(k);
  }
}

BallRays::BallRays(const Triangles& a, const Real& radius, const RayGrid& grid, Side side)
    : grid_(grid), surface_(std::make_shared<const BallSurface>(a, radius, grid, side, &grid)) {}

BallRays::BallRays(std::shared_ptr<const BallSurface> surface, const Point& back, const RayGrid& grid)
    : grid_(grid), surface_(std::move(surface)), back_(along_axes(back, grid)) {}

std::pair<int, int> BallRays::columns(const BallSurface::Patch& p, int first, int last) const {
  const auto start = static_cast<double>(u_at(0)), step = static_cast<double>(grid_.du);
  const double low = std::ceil((p.left - start) / step), high = std::floor((p.right - start) / step);
  return {static_cast<int>(std::clamp(low, static_cast<double>(first), last + 1.0)),
          static_cast<int>(std::clamp(high, first - 1.0, static_cast<double>(last)))};
}

Real BallRays::root(int patch, int which, int i, int j) const {
  const BallSurface::Patch& p = surface_->patches_[static_cast<std::size_t>(patch)];
  const BallRow row(*this, j);
  return row.meet<Real>(p, surface_->radius_, i).height[static_cast<std::size_t>(which)] + Real(row.base_height(p));
}

exact::Tried<RayRow> BallRays::try_row(int j) const { return BallRow(*this, j).run(0, grid_.nu - 1); }

RayRow BallRays::line(int i, int j) const { return BallRow(*this, j).run(i, i); }

}  // namespace findspace::space
