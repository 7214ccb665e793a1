// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/locate_line.h"

#include <algorithm>

#include "plane/locate.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::RealPoint;

/// Parameters count in vectors `direction`, so that those of grid points are rational.
class LineMeetings {
 public:
  LineMeetings(const Region& s, const GridPoint& through, const GridPoint& direction)
      : s_(s), x_(through.x), y_(through.y), dx_(direction.x), dy_(direction.y), square_(dx_ * dx_ + dy_ * dy_) {}

  std::vector<Real> parameters() {
    for (Index v = 0; v < s_.vertices.size(); ++v) add_if_on(s_.geometry.exact(s_.vertices[v].point));
    for (Index e = 0; e < s_.edges.size(); ++e) s_.is_arc(e) ? meet_circle(e) : meet_line(e);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

  RealPoint at(const Real& t) const { return {x_ + t * dx_, y_ + t * dy_}; }

 private:
  Real offset_from_line(const RealPoint& p) const { return dx_ * (p.y - y_) - dy_ * (p.x - x_); }
  Real parameter(const RealPoint& p) const { return (dx_ * (p.x - x_) + dy_ * (p.y - y_)) / square_; }

  void add_if_on(const RealPoint& p) {
    if (offset_from_line(p).sign() == 0) found_.push_back(parameter(p));
  }

  RealPoint end(Index vertex) const { return s_.geometry.exact(s_.vertices[vertex].point); }

  void meet_line(Index e) {
    // Where the ends lie strictly on different sides; touching ends are vertices, which have been seen.
    const int side0 = offset_from_line(end(s_.edges[e].v0)).sign(),
              side1 = offset_from_line(end(s_.edges[e].v1)).sign();
    if (side0 * side1 >= 0) return;
    const exact::Carrier& k = s_.carrier(e);
    const Real a(k.a), b(k.b);
    found_.push_back((k.offset() - a * x_ - b * y_) / (a * dx_ + b * dy_));
  }

  void meet_circle(Index e) {
    const exact::Carrier& k = s_.carrier(e);
    const RealPoint center{k.center_x(), k.center_y()};
    const Real height = offset_from_line(center), rest = k.w * k.w * square_ - height * height;
    if (rest.sign() < 0) return;
    const Real middle = parameter(center), half = sqrt(rest) / square_;
    add_if_on_arc(e, middle - half);
    if (rest.sign() > 0) add_if_on_arc(e, middle + half);
  }

  void add_if_on_arc(Index e, const Real& t) {
    const RealPoint p = at(t);
    const bool half = (p.y - s_.carrier(e).center_y()).sign() * s_.edges[e].half >= 0;
    if (half && p.x >= end(s_.edges[e].v0).x && p.x <= end(s_.edges[e].v1).x) found_.push_back(t);
  }

  const Region& s_;
  const Real x_, y_, dx_, dy_, square_;
  std::vector<Real> found_;
};

}  // namespace

std::vector<LineInterval> along_line(const Region& region, const GridPoint& through, const GridPoint& direction) {
  LineMeetings line(region, through, direction);
  const std::vector<Real> stops = line.parameters();
  const Real length = sqrt(Real(direction.x) * Real(direction.x) + Real(direction.y) * Real(direction.y));
  Locator locator(region);
  std::vector<LineInterval> out;
  // In turn: the ray before the first stop, a stop, what lies between, ..., the ray after the last one.
  bool inside = region.faces[0].mark != 0;
  if (inside) out.push_back({});
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const bool here = locator.mark(line.at(stops[k])) != 0;
    const bool after = k + 1 == stops.size() ? region.faces[0].mark != 0
                                             : locator.mark(line.at((stops[k] + stops[k + 1]) / Real(2))) != 0;
    const Real t = stops[k] * length;
    if (inside && !(here && after)) out.back().to = t, out.back().to_in = here;
    if (after && !(here && inside)) out.push_back({t, std::nullopt, here && !inside, false});
    if (here && !inside && !after) out.push_back({t, t, true, true});
    inside = after;
  }
  return out;
}

}  // namespace findspace::plane
