// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_facets.h"

#include <algorithm>
#include <cstdlib>

namespace findspace::space {
namespace {

const Point& corner_of(const RayFacet& facet, int k) {
  return facet.corner[static_cast<std::size_t>(k % facet.corners)];
}

/// A plane along the edge from corner k on that crosses the plane of the facet.
HalfSpace side_plane(const RayFacet& facet, int k, const Vector& normal) {
  const Point &p = corner_of(facet, k), e = corner_of(facet, k + 1) - p;
  const Vector size{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  const bool z = size.z >= size.x && size.z >= size.y, y = !z && size.y >= size.x;
  const Wide3 across = exact::primitive(exact::cross(e, Point{!z && !y, y, z}));
  return HalfSpace(Plane{across, -exact::dot(across, p)});
}

/// Whether all places are surely beyond the edges of a piece at one of them.
bool beyond_an_edge(const FlatPiece& piece, std::span<const Vector> places) {
  return std::any_of(piece.corners.begin(), piece.corners.end(), [&](const FlatPiece::Corner& c) {
    double inner = 0;
    for (const FlatPiece::Corner& other : piece.corners) {
      const double value = c.side->approx_value(other.near);
      if (std::fabs(value) > std::fabs(inner)) inner = value;
    }
    return std::all_of(places.begin(), places.end(), [&](const Vector& v) {
      return std::copysign(1.0, inner) * c.side->approx_value(v) < -c.side->error(v);
    });
  });
}

}  // namespace

bool FacetCut::meets(const FlatPiece& piece) const {
  if (beyond_an_edge(piece, all())) return false;
  for (int k = 0; corners > 2 && k < corners; ++k) {
    const Vector &from = corner[static_cast<std::size_t>(k)], &to = corner[static_cast<std::size_t>((k + 1) % corners)];
    const Vector outward = space::cross(to - from, plane->unit);
    const double bound = margin::kRoundings128 * length(to - from);
    const bool apart = std::all_of(piece.corners.begin(), piece.corners.end(), [&](const FlatPiece::Corner& c) {
      return dot(outward, c.near - from) > bound * (size_of(c.near) + size_of(from));
    });
    if (apart) return false;
  }
  return true;
}

TouchFacets::TouchFacets(const std::vector<RayFacet>& all) {
  std::vector<Extent> boxes;
  for (const RayFacet& f : all) {
    if (!f.outer) continue;
    facets_.push_back(f);
    const Wide3 normal = exact::primitive(f.normal());
    planes_.emplace_back(Plane{normal, -exact::dot(normal, f.corner[0])});
    Extent box{exact::approx(f.corner[0]), exact::approx(f.corner[0])};
    for (int k = 1; k < f.corners; ++k) box.add({exact::approx(corner_of(f, k)), exact::approx(corner_of(f, k))});
    boxes.push_back(box);
  }
  tree_ = ExtentTree(std::move(boxes));
}

FlatPiece TouchFacets::piece(std::size_t k, Planes& made) const {
  const RayFacet& f = facets_[k];
  FlatPiece out{&planes_[k], {}};
  for (int c = 0; c < f.corners; ++c) {
    const Point& p = corner_of(f, c);
    made.push_back(side_plane(f, c, planes_[k].unit));
    out.corners.push_back({real(p), exact::approx(p), &made.back()});
  }
  return out;
}

FacetCut TouchFacets::cut_of(std::size_t k) const {
  FacetCut out{&planes_[k], {}, facets_[k].corners};
  for (int c = 0; c < out.corners; ++c)
    out.corner[static_cast<std::size_t>(c)] = exact::approx(corner_of(facets_[k], c));
  return out;
}

void TouchFacets::add_cuts(std::size_t k, std::size_t other, Planes& made, std::vector<FacetCut>& out) const {
  const RayFacet &own = facets_[k], &f = facets_[other];
  bool above = false, below = false, inside = false;  // on the plane, and not along the rim
  int on = 0;
  std::ptrdiff_t before = -1;  // the corner of its own that another one on the plane is
  for (int c = 0; c < f.corners; ++c) {
    const Point& p = corner_of(f, c);
    const int sign = planes_[k].sign(real(p), exact::approx(p));
    above = above || sign > 0;
    below = below || sign < 0;
    on += sign == 0;
    if (sign != 0) continue;
    const auto end = own.corner.begin() + own.corners;
    const auto at = std::find(own.corner.begin(), end, p) - own.corner.begin();
    // An edge between opposite corners runs across.
    inside = inside || at == own.corners || (before >= 0 && std::abs(at - before) == 2 && own.corners == 4);
    before = at;
  }
  if (on < f.corners) {
    if (inside || (above && below)) out.push_back(cut_of(other));
    return;
  }
  for (int c = 0; c < f.corners; ++c) {
    made.push_back(side_plane(f, c, planes_[k].unit));
    out.push_back({&made.back(), {exact::approx(corner_of(f, c)), exact::approx(corner_of(f, c + 1))}, 2});
  }
}

std::size_t TouchFacets::meeting(std::size_t k) const {
  std::size_t out = 0;
  const Extent& own = box(k);
  tree_.each([&](const Extent& e) { return e.meets(own); }, [&](std::size_t) { ++out; });
  return out;
}

std::vector<FacetCut> TouchFacets::cuts(std::size_t k, Planes& made) const {
  std::vector<FacetCut> out;
  const Extent& own = box(k);
  tree_.each([&](const Extent& e) { return e.meets(own); },
             [&](std::size_t other) {
               if (other != k) add_cuts(k, other, made, out);
             });
  return out;
}

}  // namespace findspace::space
