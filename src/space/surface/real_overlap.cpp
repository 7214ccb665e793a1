// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/real_overlap.h"

#include <algorithm>

#include "exact/solid/moved_sign.h"
#include "space/convolution/face_overlap.h"
#include "space/surface/surface_side.h"

namespace findspace::space {
namespace {

using exact::Real;

constexpr std::size_t kRemembered = 8;

Point below(const Vector& near) {
  const auto down = [](double c) { return static_cast<std::int64_t>(std::floor(c)) - 1; };
  return {down(near.x), down(near.y), down(near.z)};
}

RealVector middle_of(const RayBody& body, int f) {
  const RealVector sum = real(body.corner(f, 0) + body.corner(f, 1) + body.corner(f, 2));
  return scaled(Real::ratio(1, 3), sum);
}

}  // namespace

RealOverlap::RealOverlap(const SurfaceSet::Sheet& a, const SurfaceSet::Sheet& b, bool a_inside_out) : a_(a), b_(b) {
  if (a_inside_out) inside_out_ = std::make_unique<const RayBody>(inside_out(Triangles{a.body.points, a.body.faces}));
}

bool RealOverlap::interiors_meet(const RealVector& p, Recent& recent) const {
  const exact::Movement by(p);
  const auto overlap = [&](int f, int g) {
    return faces::overlap<exact::MovedPoint>(this->a(), f, b_.body, g, Point{}, by);
  };
  for (auto pair = recent.begin(); pair != recent.end(); ++pair) {
    if (!overlap((*pair)[0], (*pair)[1])) continue;
    std::rotate(recent.begin(), pair, pair + 1);
    return true;
  }
  const bool found = any_pair(a_.tree, b_.tree, below(by.rough.near), Point{2, 2, 2}, [&](int f, int g) {
    if (!overlap(f, g)) return false;
    if (recent.size() == kRemembered) recent.pop_back();
    recent.insert(recent.begin(), {f, g});
    return true;
  });
  return found || pieces_inside(p);
}

bool RealOverlap::surely_meet(const Vector& p, double off, const Recent& recent) const {
  return surely_meet(std::array{p}, off, recent);
}

/// A pair meets in a convex set of positions.
bool RealOverlap::surely_meet(std::span<const Vector> hull, double off, const Recent& recent) const {
  return std::any_of(recent.begin(), recent.end(), [&](const std::array<int, 2>& pair) {
    return std::all_of(hull.begin(), hull.end(), [&](const Vector& p) {
      return faces::surely_cross<exact::MovedPoint>(a(), pair[0], b_.body, pair[1], exact::RoughMovement{p, off});
    });
  });
}

/// One point a piece is enough; one on the surface of the other says that the piece lies outside, or along it.
bool RealOverlap::pieces_inside(const RealVector& p) const {
  const auto side = [](const SurfaceSet::Sheet& sheet, const RealVector& x) {
    return side_of(sheet.body, sheet.tree, x, rounded(x));
  };
  const SurfaceSide in_a = inside_out_ ? SurfaceSide::kOutside : SurfaceSide::kInside;
  const auto a_in_b = [&](int f) { return side(b_, minus(middle_of(a_.body, f), p)) == SurfaceSide::kInside; };
  const auto b_in_a = [&](int g) { return side(a_, plus(middle_of(b_.body, g), p)) == in_a; };
  const std::vector<int>&of_a = a_.body.first_face, &of_b = b_.body.first_face;
  return std::any_of(of_a.begin(), of_a.end(), a_in_b) || std::any_of(of_b.begin(), of_b.end(), b_in_a);
}

}  // namespace findspace::space
