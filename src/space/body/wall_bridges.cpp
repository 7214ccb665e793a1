// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/wall_bridges.h"

#include <algorithm>

#include "space/polytope/convex_region.h"

namespace findspace::space {
namespace {

/// Whether the planes are one.
bool coplanar(const HalfSpace& a, const HalfSpace& b) {
  return is_zero(cross(a.normal, b.normal)) && is_zero(minus(scaled(a.offset, b.normal), scaled(b.offset, a.normal)));
}

bool one_wall(const HalfSpace& a, const HalfSpace& b) { return dot(a.unit, b.unit) < 0 && coplanar(a, b); }
bool one_face(const HalfSpace& a, const HalfSpace& b) { return dot(a.unit, b.unit) > 0 && coplanar(a, b); }

Extent box_about(const ConvexRegion& region) {
  std::vector<Vector> points;
  for (const ConvexRegion::Vertex& v : region.vertices()) points.push_back(v.near);
  return space::extent_of(points);
}

Extent box_about(const BodyPart& part) {
  std::vector<Vector> points;
  for (const Point& v : part.vertices()) points.push_back(exact::approx(v));
  return space::extent_of(points);
}

bool lies_within(const ConvexRegion& region, const WallBridge& set) {
  return std::all_of(set.planes.begin(), set.planes.end(),
                     [&](const HalfSpace& h) { return !region.sides(h).outside; });
}

/// Of the planes those of facets.
std::vector<HalfSpace> facet_planes(const ConvexRegion& region, const std::vector<HalfSpace>& planes) {
  std::vector<HalfSpace> out;
  for (const HalfSpace& h : planes) {
    const auto on = std::count_if(region.vertices().begin(), region.vertices().end(),
                                  [&](const ConvexRegion::Vertex& v) { return h.sign(v.at, v.near) == 0; });
    if (on >= 3) out.push_back(h);
  }
  return out;
}

class WallBridges {
 public:
  explicit WallBridges(const Body& body) : box_(bounds(body)) {
    for (const BodyPart& part : body.parts) {
      if (part.core && part.radius.sign() == 0) sets_.push_back({part.planes(), box_about(part)});
    }
    parts_ = sets_.size();
  }

  std::vector<WallBridge> run() {
    for (std::size_t k = 1; k < sets_.size(); ++k) {
      for (std::size_t m = 0; m < k; ++m) join(m, k);
    }
    return {sets_.begin() + static_cast<std::ptrdiff_t>(parts_), sets_.end()};
  }

 private:
  void join(std::size_t m, std::size_t k) {
    if (!sets_[m].extent.meets(sets_[k].extent)) return;
    for (std::size_t i = 0; i < sets_[m].planes.size(); ++i) {
      for (std::size_t j = 0; j < sets_[k].planes.size(); ++j) {
        if (sets_.size() - parts_ == kMostBridges) return;
        if (one_wall(sets_[m].planes[i], sets_[k].planes[j])) add_bridge(sets_[m].planes, i, sets_[k].planes, j);
      }
    }
  }

  /// Of what lies within all planes but i of the one and j of the other.
  void add_bridge(const std::vector<HalfSpace>& one, std::size_t i, const std::vector<HalfSpace>& other,
                  std::size_t j) {
    std::vector<HalfSpace> planes = one;
    planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t k = 0; k < other.size(); ++k) {
      const auto same = [&](const HalfSpace& h) { return one_face(h, other[k]); };
      if (k != j && std::none_of(planes.begin(), planes.end(), same)) planes.push_back(other[k]);
    }
    ConvexRegion region(box_.low, box_.high);
    for (const HalfSpace& h : planes) region.cut(h);
    if (region.dimension() < 3) return;
    if (std::any_of(sets_.begin(), sets_.end(), [&](const WallBridge& s) { return lies_within(region, s); })) return;
    sets_.push_back({facet_planes(region, planes), box_about(region)});
  }

  Bounds3 box_;
  std::vector<WallBridge> sets_;  // the parts, then the bridges
  std::size_t parts_ = 0;
};

}  // namespace

std::vector<WallBridge> wall_bridges(const Body& body) { return WallBridges(body).run(); }

}  // namespace findspace::space
