// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/round_part.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "exact/planar/geometry_signs.h"
#include "packing/problem/arc_corners.h"
#include "plane/build/transform.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/decimal_grid.h"
#include "plane/query/measure_cells.h"
#include "plane/query/topology.h"

namespace findspace::packing {
namespace {

using plane::Index;

std::int64_t on_grid(int128 c) {
  if (c < -plane::Grid::kLimit || c > plane::Grid::kLimit)
    throw Error(ErrorCode::kOutOfRange, "a part has too many digits for its size");
  return std::int64_t(c);
}

void check(const plane::Region& region) {
  const auto fail = [](const char* why) { throw Error(ErrorCode::kGeometry, why); };
  if (plane::is_empty(region)) fail("it is empty");
  if (!plane::is_bounded(region)) fail("it is unbounded");
  if (!plane::is_regular(region)) fail("it has points or curves without area, or lacks some of its boundary");
}

/// The half-edges about each face of the set, the set on their left.
std::vector<std::vector<Index>> cycles_of(const plane::Region& region) {
  std::vector<std::vector<Index>> result;
  const auto add = [&](Index first) {
    std::vector<Index>& cycle = result.emplace_back();
    Index h = first;
    do {
      cycle.push_back(h);
      h = region.next(h);
    } while (h != first);
  };
  for (const plane::Face& face : region.faces) {
    if (face.mark == 0) continue;
    add(face.outer);
    for (const Index first : face.inner) add(first);
  }
  return result;
}

Vec place_of(const plane::Region& region, Index vertex) {
  const exact::RealPoint p = region.geometry.exact(region.vertices[vertex].point);
  return {p.x.to_double(), p.y.to_double()};
}

LatticePoint nearest(Vec v) { return {int128(std::round(v.x)), int128(std::round(v.y))}; }

Polygon polygon_about(const plane::Region& region) {
  Polygon result;
  for (const std::vector<Index>& cycle : cycles_of(region)) {
    Ring& ring = result.rings.emplace_back();
    for (const Index h : cycle) {
      const Vec from = place_of(region, region.origin(h));
      ring.push_back(nearest(from));
      if (!region.is_arc(h / 2)) continue;
      const exact::SupportingCurve& circle = region.supporting_curve(h / 2);
      const Arc arc{{circle.center_x().to_double(), circle.center_y().to_double()},
                    circle.w().to_double(),
                    from,
                    place_of(region, region.target(h)),
                    (region.edges[h / 2].half < 0) == ((h & 1U) == 0)};
      for (const Vec corner : corners_of(arc, arc.ccw)) ring.push_back(nearest(corner));
    }
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  }
  return result;
}

/// Arcs are monotone in x, so only their tops and bottoms are no vertices.
void find_box(RoundPart::Form& form) {
  const plane::Region& region = form.region;
  const auto see = [](exact::Real& low, exact::Real& high, const exact::Real& value) {
    if (value < low) low = value;
    if (high < value) high = value;
  };
  form.low = form.high = region.geometry.exact(region.vertices[0].point);
  for (const plane::Vertex& v : region.vertices) {
    const exact::RealPoint p = region.geometry.exact(v.point);
    see(form.low.x, form.high.x, p.x);
    see(form.low.y, form.high.y, p.y);
  }
  for (Index e = 0; e < region.edges.size(); ++e) {
    if (!region.is_arc(e)) continue;
    const auto side = [&](Index v) {
      return right_of_center(region.geometry, region.vertices[v].point, region.edges[e].supporting_curve);
    };
    if (side(region.edges[e].v0) >= 0 || side(region.edges[e].v1) <= 0) continue;
    const exact::SupportingCurve& circle = region.supporting_curve(e);
    see(form.low.y, form.high.y,
        region.edges[e].half > 0 ? circle.center_y() + circle.w() : circle.center_y() - circle.w());
  }
  form.box = {{exact::floor(form.low.x), exact::floor(form.low.y)},
              {-exact::floor(-form.high.x), -exact::floor(-form.high.y)}};
}

double twice_area_of(const plane::Region& region) {
  const std::vector<plane::Twofold> areas = plane::CellMeasures(region).face_areas();
  double sum = 0;
  for (std::size_t f = 0; f < region.faces.size(); ++f)
    if (region.faces[f].mark != 0) sum += 2 * areas[f].value();
  return sum;
}

}  // namespace

RoundPart::RoundPart(plane::Region region, double step) : region_(std::move(region)), step_(step) {
  check(region_);
  twice_area_ = twice_area_of(region_);
}

const RoundPart::Form& RoundPart::at(const Fraction& angle, bool mirrored) const {
  const std::lock_guard lock(guard_);
  std::unique_ptr<const Form>& known = forms_[{angle, mirrored}];
  if (known) return *known;
  plane::Rounding rounding;
  plane::Region turned = mirrored ? plane::mirrored_in_y_axis(region_) : *region_;
  const exact::Real degrees = exact::Real(angle.numerator()) / exact::Real(angle.denominator());
  auto form = std::make_unique<Form>(Form{plane::rotated(turned, {}, degrees, step_, rounding), {}, {}, {}, {}});
  find_box(*form);
  form->about = polygon_about(form->region);
  known = std::move(form);
  return *known;
}

double RoundPart::area_left_of(double most) const {
  const LatticeBox& box = at(0, false).box;
  const int128 end = int128(std::floor(most));
  if (end >= box.high.x) return twice_area_ / 2;
  if (end <= box.low.x) return 0;
  const plane::Region left =
      region_of(Polygon{{{box.low, {end, box.low.y}, {end, box.high.y}, {box.low.x, box.high.y}}}});
  const std::array<const plane::Region*, 2> both{&*region_, &left};
  return twice_area_of(plane::intersect(both)) / 2;
}

std::shared_ptr<const RoundPart> what_is_about(const RoundPart& inner, const Polygon& polygon) {
  const plane::Region all = region_of(polygon);
  const std::array<const plane::Region*, 2> both{&all, &*inner.at(0, false).region};
  return std::make_shared<const RoundPart>(plane::closure(plane::subtract(both)), inner.step());
}

std::optional<std::vector<Ring>> rings_of(const plane::Region& region) {
  const auto is_face = [](const plane::Face& face) { return face.mark != 0; };
  if (std::count_if(region.faces.begin(), region.faces.end(), is_face) != 1) return std::nullopt;
  std::vector<Ring> result;
  for (const std::vector<Index>& cycle : cycles_of(region)) {
    Ring& ring = result.emplace_back();
    std::set<Index> met;
    for (const Index h : cycle) {
      const exact::Point& p = region.point(region.origin(h));
      if (region.is_arc(h / 2) || p.kind != exact::Point::Kind::kGrid || !met.insert(region.origin(h)).second)
        return std::nullopt;
      ring.push_back({p.gx, p.gy});
    }
  }
  return result;
}

plane::SharedRegion region_of(const Part& part, const Fraction& angle, bool mirrored) {
  if (part.round) return part.round->at(angle, mirrored).region;
  return region_of(rotated(part.shape, angle, mirrored));
}

plane::Region region_of(const Polygon& shape) {
  std::vector<plane::Contour> contours;
  for (const Ring& ring : shape.rings) {
    plane::Contour& contour = contours.emplace_back();
    for (const LatticePoint& p : ring) contour.push_back({.start = {on_grid(p.x), on_grid(p.y)}});
  }
  return plane::region_of_rings(contours);
}

}  // namespace findspace::packing
