// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/mended_rings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/margins/rounding.h"
#include "plane/contour/contour.h"
#include "plane/query/measure_cells.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"

namespace findspace::plane {
namespace {

using Spot = std::array<double, 2>;

/// Where a vertex is, but for the last digits: what doubles alone find is far off where circles nearly touch.
Spot spot(const CellComplex& c, Index vertex) {
  const exact::RealPoint p = c.geometry.exact(c.vertices[vertex].point);
  return {p.x.to_double(), p.y.to_double()};
}

/// From a chord to the tangent of its arc, half of a circle at most; nothing for a segment.
Spot rise(const CellComplex& c, Index edge, const Spot& p, const Spot& q) {
  if (!c.is_arc(edge)) return {};
  const double r = c.supporting_curve(edge).z().value, dx = (q[0] - p[0]) / 2, dy = (q[1] - p[1]) / 2,
               half2 = dx * dx + dy * dy;
  const double share = c.edges[edge].half * std::sqrt(half2) / (r + std::sqrt(std::max(r * r - half2, 0.0)));
  return {-dy * share, dx * share};
}

double apart(const Spot& p, const Spot& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

/// Of the strip along p -> q that holds the points.
double strip_along(const Spot& p, const Spot& q, const std::vector<Spot>& points) {
  const double dx = q[0] - p[0], dy = q[1] - p[1];
  double low = 0, high = 0;
  for (const auto& [x, y] : points) {
    const double beside = ((x - p[0]) * dy - (y - p[1]) * dx) / apart(p, q);
    low = std::min(low, beside);
    high = std::max(high, beside);
  }
  return high - low;
}

/// An edge of a face, as a circle sees it.
struct FaceEdge {
  Spot p, q;
  Index edge = 0;
};

Spot center_of(const CellComplex& c, Index arc) {
  const exact::SupportingCurve& circle = c.supporting_curve(arc);
  return {circle.center_x().to_double(), circle.center_y().to_double()};
}

/// Whether the half circle of the arc has the point, which lies on its circle, between its ends.
bool spans(const CellComplex& c, const FaceEdge& e, const Spot& center, const Spot& point) {
  return (point[1] - center[1]) * c.edges[e.edge].half >= 0 && (point[0] - e.p[0]) * (point[0] - e.q[0]) <= 0;
}

/// Adds the places of an edge that are nearest to a point and farthest from it.
void add_distances(const CellComplex& c, const FaceEdge& e, const Spot& from, std::vector<double>& all) {
  all.push_back(apart(e.p, from));
  all.push_back(apart(e.q, from));
  if (c.is_arc(e.edge)) {
    const Spot center = center_of(c, e.edge);
    const double r = c.supporting_curve(e.edge).z().value, off = apart(center, from);
    for (const double way : {r, -r}) {
      const Spot point{center[0] + way * (center[0] - from[0]) / off, center[1] + way * (center[1] - from[1]) / off};
      if (off > 0 && spans(c, e, center, point)) all.push_back(apart(point, from));  // off > 0: else all are as far
    }
  } else {
    const double dx = e.q[0] - e.p[0], dy = e.q[1] - e.p[1];
    const double share = ((from[0] - e.p[0]) * dx + (from[1] - e.p[1]) * dy) / (dx * dx + dy * dy);
    if (share > 0 && share < 1) all.push_back(apart({e.p[0] + share * dx, e.p[1] + share * dy}, from));
  }
}

/// Of the ring about the centre of an arc that holds a face with these edges round it; infinite where the face may hold
/// the centre, since its area is not less than that of the disc within the ring.
double ring_about(const CellComplex& c, Index arc, const std::vector<FaceEdge>& edges, double area) {
  std::vector<double> all;
  for (const FaceEdge& e : edges) add_distances(c, e, center_of(c, arc), all);
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  return area < 2 * *low * *low ? *high - *low : exact::kInfinity;
}

/// Of a strip that holds a bounded face, along its longest chord or diagonal, or of a ring along an arc, with what
/// doubles lose.
double strip(const CellComplex& c, const Face& face, double area) {
  std::vector<Spot> corners, hull;  // the hull of `hull` holds the face
  std::vector<FaceEdge> edges;
  double error = 0;
  for (Index h = face.outer;;) {
    const Spot p = spot(c, c.edges[h / 2].v0), q = spot(c, c.edges[h / 2].v1), up = rise(c, h / 2, p, q);
    edges.push_back({p, q, h / 2});
    if (c.is_arc(h / 2)) error = std::max(error, c.supporting_curve(h / 2).z().value * margin::kRoundings32);
    for (const auto& [x, y] : {p, q}) {
      corners.push_back({x, y});
      hull.push_back(corners.back());
      hull.push_back({x + up[0], y + up[1]});
      error = std::max(error, std::max(std::abs(x), std::abs(y)) * margin::kRoundings32);
    }
    if ((h = c.next(h)) == face.outer) break;
  }
  const auto farthest = [&](const Spot& from) {
    return *std::max_element(corners.begin(), corners.end(),
                             [&](const Spot& p, const Spot& q) { return apart(p, from) < apart(q, from); });
  };
  std::size_t chord = 0;  // corners come in pairs, a chord each
  for (std::size_t k = 2; k < corners.size(); k += 2)
    if (apart(corners[k], corners[k + 1]) > apart(corners[chord], corners[chord + 1])) chord = k;
  const Spot from = farthest(corners[0]), to = farthest(from);
  double width = std::min(strip_along(corners[chord], corners[chord + 1], hull), strip_along(from, to, hull));
  const Index arc = edges[chord / 2].edge;
  if (c.is_arc(arc) && face.inner.empty()) width = std::min(width, ring_about(c, arc, edges, area));
  return width + 4 * error;
}

double widest(const Region& set) {
  double width = 0;
  const std::vector<Twofold> areas = CellMeasures(set).face_areas();
  for (std::size_t f = 0; f < set.faces.size(); ++f)
    if (set.faces[f].mark != 0) width = std::max(width, strip(set, set.faces[f], areas[f].value()));
  return width;
}

double longer_side(const Component& c) {
  return std::max(c.bbox->high[0] - c.bbox->low[0], c.bbox->high[1] - c.bbox->low[1]);
}

double longest(const Region& set) {
  double length = 0;
  for (const Component& c : summarize(set, 1).components) length = std::max(length, longer_side(c));
  return length;
}

bool is_ordered(const std::vector<Loop>& loops) {
  return std::all_of(loops.begin(), loops.end(),
                     [&](const Loop& loop) { return loop.depth % 2 == 0 || loops[loop.within].depth % 2 == 0; });
}

void count_places(const Region& set, MendedRings& result) {
  for (const Component& c : summarize(set, 1).components) {
    ++result.places;
    if (longer_side(c) < result.longest) continue;
    result.longest = longer_side(c);
    result.place = c.sample;
  }
}

std::vector<std::size_t> every(const std::vector<Loop>& loops) {
  std::vector<std::size_t> all(loops.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return all;
}

MendedPart part_of(const std::vector<Loop>& loops, const std::vector<std::size_t>& group, const WoundLoops& all) {
  MendedPart part;
  const auto as_rings = [&] {
    for (const std::size_t i : group)
      part.rings.push_back(is_turned(loops[i]) ? reversed(loops[i].edges) : loops[i].edges);
    return part;
  };
  if (all.are_apart(group)) return as_rings();
  const WoundLoops alone(loops, group);
  if (alone.are_apart(group)) return as_rings();
  part.cells = alone.faces([](std::int32_t w) { return w >= 1; });
  return part;
}

}  // namespace

RingMender::RingMender(std::span<const Contour> rings)
    : loops_(loosely_nested(rings)),
      all_(loops_, every(loops_)),
      excess_(all_.faces([](std::int32_t w) { return w < 0 || w > 1; })),
      spikes_(all_.run_back(loops_)),
      width_(is_ordered(loops_) ? widest(excess_) : exact::kInfinity),
      spike_(longest(spikes_)) {}

MendedRings RingMender::mended() const {
  std::vector<std::vector<std::size_t>> groups(loops_.size());  // outer loops, each with its holes
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const bool hole = loops_[i].depth % 2 != 0;
    std::vector<std::size_t>& group = groups[hole ? loops_[i].within : i];
    group.insert(hole ? group.end() : group.begin(), i);
  }
  MendedRings result;
  for (const std::vector<std::size_t>& group : groups) {
    if (group.empty()) continue;
    MendedPart part = part_of(loops_, group, all_);
    if (!part.cells || !is_empty(*part.cells)) result.parts.push_back(std::move(part));
  }
  count_places(excess_, result);
  count_places(spikes_, result);
  return result;
}

std::optional<bool> RingMender::set_on_left(std::size_t ring) const {
  std::optional<bool> answer;
  for (const Loop& loop : loops_) {
    if (loop.ring != ring) continue;
    if (answer && *answer == is_turned(loop)) return std::nullopt;
    answer = !is_turned(loop);
  }
  return answer;
}

bool RingMender::is_hole(std::size_t ring) const {
  return std::any_of(loops_.begin(), loops_.end(),
                     [&](const Loop& loop) { return loop.ring == ring && loop.depth % 2 != 0; });
}

bool RingMender::winds_round_nothing() const {
  return is_empty(all_.faces([](std::int32_t w) { return w != 0; }));
}

}  // namespace findspace::plane
