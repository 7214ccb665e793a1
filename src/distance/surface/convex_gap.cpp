// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/convex_gap.h"

#include <algorithm>

#include "exact/margins/space_distance.h"
#include "space/convolution/ray_solids.h"

namespace findspace::distance {

using space::BodyPart;
using space::GridBox;
using space::Point;
using space::Vector;
using Sheet = space::SurfaceSet::Sheet;

namespace {

GridBox box_of(const BodyPart& part) {
  GridBox out;
  bool any = false;
  for (const Point& v : part.vertices()) space::extend_box(v, out.low, out.high, any);
  return out;
}

/// The square of the distance of two boxes, the second moved by p.
double box_gap(const GridBox& a, const GridBox& b, const Vector& p) {
  const auto gap = [](std::int64_t low_a, std::int64_t high_a, std::int64_t low_b, std::int64_t high_b, double by) {
    return std::max({static_cast<double>(low_b - high_a) + by, static_cast<double>(low_a - high_b) - by, 0.0});
  };
  const Vector d{gap(a.low.x, a.high.x, b.low.x, b.high.x, p.x), gap(a.low.y, a.high.y, b.low.y, b.high.y, p.y),
                 gap(a.low.z, a.high.z, b.low.z, b.high.z, p.z)};
  return space::dot(d, d);
}

}  // namespace

bool ConvexGap::few(const space::SurfaceSet& a) {
  std::size_t count = 0;
  for (const auto& sheet : a.sheets()) count += sheet->body.faces.size();
  return count <= kMostTriangles;
}

ConvexGap::ConvexGap(std::shared_ptr<const space::SurfaceSet> a, BodyPart b)
    : a_(std::move(a)), b_(std::move(b)), box_(box_of(b_)), radius_(b_.radius.to_double()) {
  const auto farthest = [&](const Point& v) { size_ = std::max(size_, space::size_of(exact::approx(v))); };
  for (const auto& sheet : a_->sheets()) {
    triangles_.push_back(std::make_unique<Triangle[]>(sheet->body.faces.size()));
    farthest(sheet->body.low);
    farthest(sheet->body.high);
  }
  for (const auto& ball : a_->balls()) {
    balls_.push_back(grown_distance(difference(BodyPart{std::nullopt, ball.center, ball.radius}, b_)));
    farthest(ball.center);
    size_ += ball.radius.to_double();
  }
  double own = 0;
  for (const Point& v : b_.vertices()) own = std::max(own, space::size_of(exact::approx(v)));
  size_ += own + radius_;
}

double ConvexGap::error(const Vector& p) const { return margin::kNumbersOff * (size_ + space::size_of(p)); }

double ConvexGap::distance(const Sheet& sheet, const Triangle& triangle, int face, const Vector& p) const {
  return triangle.of([&] {
    BodyPart part{std::nullopt, sheet.body.corner(face, 0), exact::Real()};
    for (int k = 0; k < 3; ++k) part.flat.push_back(sheet.body.corner(face, k));
    return grown_distance(difference(part, b_));
  })(p);
}

double ConvexGap::operator()(const Vector& p) const {
  double least = exact::kInfinity;
  for (const ConvexDistance& f : balls_) least = std::min(least, f(p));
  // Boxes have no radius; beyond 0 none is nearer than touching.
  const auto worth = [&](double gap) {
    const double reach = least + radius_ + error(p);
    return gap <= (reach > 0 ? reach * reach : 0);
  };
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Sheet& sheet = *a_->sheets()[i];
    const auto gap = [&](const GridBox& box) { return box_gap(box, box_, p); };
    sheet.tree.nearest_first(gap, worth, [&](int k) {
      const int face = sheet.tree.face(k);
      least = std::min(least, distance(sheet, triangles_[i][std::size_t(face)], face, p));
      return true;
    });
  }
  return least;
}

}  // namespace findspace::distance
