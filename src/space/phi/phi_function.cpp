// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/phi_function.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/margins/rounding.h"
#include "space/phi/phi_level.h"
#include "space/phi/plane_scan.h"

namespace findspace::space {
namespace {

Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

}  // namespace

Highest highest_plane(std::span<const PlaneBlock> blocks, const Vector& u) {
  return scan_planes(blocks.data(), blocks.size(), u);
}

PhiFunction::PhiFunction(const Polytope& a, const Polytope& b) : PhiFunction(ContactSurface(a, b)) {}

PhiFunction::PhiFunction(ContactSurface surface) : surface_(std::move(surface)) {
  const int n = surface_.facet_count();
  for (const Point& v : surface_.vertices()) vertices_.push_back(exact::approx(v));
  for (int f = 0; f < n; ++f) {
    const Vector normal = exact::approx(surface_.raw_plane(f).normal);
    const double size = length(normal);
    unit_normals_.push_back({normal.x / size, normal.y / size, normal.z / size});
    offsets_.push_back(static_cast<double>(surface_.raw_plane(f).offset) / size);
    reach_ = std::max(reach_, std::fabs(offsets_.back()));
  }
  blocks_ = pack_planes(unit_normals_, offsets_);
}

/// Unit normals carry four roundings, offsets four, the evaluation three products and three sums: below 11 * 2^-53 of
/// the sum of the magnitudes, which |u|_1 + reach bounds.
double PhiFunction::error_bound(const Vector& u) const {
  return margin::kRoundings16 * (std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z) + reach_);
}

double PhiFunction::max_form(const Vector& u) const {
  check_position({u.x, u.y, u.z});
  return highest_plane(blocks_, u).value;
}

int PhiFunction::sign(const Vector& u) const {
  const double value = max_form(u), bound = error_bound(u);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  int highest = -1;
  for (int f = 0; f < surface_.facet_count() && highest < 1; ++f) {
    if (plane_value(f, u) < -bound) continue;
    const Plane& plane = surface_.raw_plane(f);
    highest = std::max(highest, exact::sign_plane_at(plane.normal, plane.offset, u.x, u.y, u.z));
  }
  return highest;
}

State PhiFunction::state(const Vector& u) const {
  const int s = sign(u);
  return s < 0 ? State::kOverlap : s > 0 ? State::kApart : State::kContact;
}

std::vector<int> PhiFunction::active(const Vector& u) const {
  const double threshold = max_form(u) - 2 * error_bound(u);
  std::vector<int> best;
  for (int f = 0; f < surface_.facet_count(); ++f) {
    if (plane_value(f, u) < threshold) continue;
    int order = 0;
    if (!best.empty()) {
      const Plane &p = surface_.raw_plane(f), &q = surface_.raw_plane(best[0]);
      order = exact::compare_planes_at(p.normal, p.offset, q.normal, q.offset, u.x, u.y, u.z);
    }
    if (order > 0) best.clear();
    if (order >= 0) best.push_back(f);
  }
  return best;
}

Vector PhiFunction::gradient(const Vector& u) const { return unit_normals_[active(u)[0]]; }

Vector nearest_on_polygon(const Vector& u, const Vector& n, std::span<const Vector> corners) {
  bool inside = true;
  Vector best = corners[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector &p = corners[i], &q = corners[(i + 1) % corners.size()];
    const Vector e = q - p, w = u - p;
    if (dot(cross(e, w), n) >= 0) continue;
    inside = false;
    const double t = std::clamp(dot(e, w) / dot(e, e), 0.0, 1.0);
    const Vector projection = p + t * e;
    const double d = length(u - projection);
    if (d < least) {
      least = d;
      best = projection;
    }
  }
  return inside ? u + (-dot(u - corners[0], n)) * n : best;
}

Vector PhiFunction::nearest(const Vector& u) const {
  double least = std::numeric_limits<double>::infinity();
  Vector best = u;
  std::vector<Vector> corners;
  const auto look = [&](int f) {
    corners.clear();
    for (const int v : surface_.circuit(f)) corners.push_back(vertices_[v]);
    const Vector projection = nearest_on_polygon(u, unit_normals_[f], corners);
    const double d = length(u - projection);
    if (d < least) {
      least = d;
      best = projection;
    }
  };
  // The distance to a facet is at least the value of its plane, so most are passed over once a good one is known.
  look(highest_plane(blocks_, u).plane);
  for (int f = 0; f < surface_.facet_count(); ++f) {
    const double value = plane_value(f, u);
    if (value >= 0 && value < least) look(f);
  }
  return best;
}

double PhiFunction::normalised(const Vector& u) const {
  const double value = max_form(u);
  return value <= 0 ? value : std::max(value, length(u - nearest(u)));
}

Vector PhiFunction::normalised_gradient(const Vector& u) const {
  if (sign(u) <= 0) return gradient(u);
  const Vector off = u - nearest(u);
  const double size = length(off);
  return size > error_bound(u) ? (1 / size) * off : gradient(u);
}

double PhiFunction::depth(const Vector& u) const { return std::max(0.0, -max_form(u)); }

Vector PhiFunction::penetration_depth(const Vector& u) const {
  check_position({u.x, u.y, u.z});
  const Highest top = highest_plane(blocks_, u);
  return std::max(0.0, -top.value) * unit_normals_[top.plane];
}

void PhiFunction::evaluate(std::span<const Vector> at, std::span<double> values, std::span<int> facets) const {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Highest top = highest_plane(blocks_, at[i]);
    values[i] = top.value;
    if (!facets.empty()) facets[i] = top.plane;
  }
}

}  // namespace findspace::space
