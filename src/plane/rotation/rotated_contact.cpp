// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_contact.h"

#include <algorithm>
#include <memory>

#include "exact/margins/plane.h"
#include "plane/base/search_work.h"
#include "plane/complex/overlay.h"
#include "plane/query/summary.h"
#include "plane/rotation/rotation_events.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;

namespace {

// Cells of work, as measured.
constexpr long kOfContact = 15, kOfContactMap = 10, kEdgesOfCell = 2, kPairsOfCell = 16, kPairsOfLook = 400;

/// What exact steps cost: a cosine that is not of closed form makes them expensive.
long cells_of(const RotatedContact::Steps& steps, const ExactAngle& angle) {
  constexpr long kDeepLine = 3, kDeepArc = 8;
  if (angle.cos.is_closed() && angle.sin.is_closed()) return steps.lines / 2 + steps.arcs;
  return kDeepLine * steps.lines + kDeepArc * steps.arcs;
}

MarkSet bit(Mark m) { return 1u << (m + 1); }

/// Whether one of the places may lie in a set with these edges, moved so. No edge is longer than half a circle, so it
/// lies within half its chord of the chord's middle. `size` is that of the numbers that the places were made of.
bool may_hold_one(const RotatedNet& net, RoughPoint rotation, RoughPoint shift, const std::vector<RoughPoint>& places,
                  double size) {
  std::vector<RoughPoint> middles;
  std::vector<double> halves;
  RoughPoint center = 0;
  for (const Index e : net.edges()) {
    const RotatedEdge edge = net.edge(e);
    const RoughPoint p = rotation * rough(edge.p) + shift, q = rotation * rough(edge.q) + shift;
    middles.push_back((p + q) / 2.0);
    halves.push_back(length(q - p) / 2);
    center += middles.back() / double(net.edges().size());
    size = std::max({size, length(p), length(q)});
  }
  double reach = 0;
  for (std::size_t k = 0; k < middles.size(); ++k) reach = std::max(reach, length(middles[k] - center) + halves[k]);
  return std::any_of(places.begin(), places.end(), [&](const RoughPoint& p) {
    return length(p - center) <= reach + margin::kRotatedTolerance * (size + length(p));
  });
}

}  // namespace

RotatedContact::RotatedContact(const Pair& pair)
    : rotation_(pair.rotating),
      fixed_(pair.fixed),
      about_(pair.about),
      to_(pair.to),
      net_(rotation_, about_, [](Mark m) { return m != 0; }),
      fixed_net_(fixed_, to_),
      rough_(net_, fixed_net_),
      unbounded_(rotation_.faces[0].mark != 0),
      locate_rotation_(rotation_),
      locate_fixed_(fixed_) {
  fixed_vertices_.reserve(fixed_net_.vertex_count());
  for (Index v = 0; v < fixed_net_.vertex_count(); ++v) fixed_vertices_.push_back(rough(fixed_net_.vertex(v)));
}

const std::vector<RealVector>& RotatedContact::samples(Mark m) {
  std::optional<std::vector<RealVector>>& known = samples_[m + 1];
  if (known) return *known;
  known.emplace();
  const Region part = remark(fixed_, [m](Mark k) { return Mark(k == m); });
  for (const Component& c : summarize(part, Real(1)).components) {
    // What is unbounded leaves a bounded set, and is met by an unbounded one.
    if (c.bbox) known->push_back(c.sample_point - to_);
  }
  return *known;
}

std::vector<ExactAngle> RotatedContact::events() const { return contact_rotations(net_, fixed_net_); }

const RealVector& RotatedContact::vertex(Index v) {
  if (place_[v] == kNone) {
    place_[v] = Index(vertices_.size());
    vertices_.push_back(angle_(net_.vertex(v)) + shift_);
  }
  return vertices_[place_[v]];
}

RotatedEdge RotatedContact::edge(Index e) {
  RotatedEdge now = net_.edge(e);
  now.p = vertex(now.v0);
  now.q = vertex(now.v1);
  if (now.arc) now.center = angle_(now.center) + shift_;
  return now;
}

/// Where a vertex lies: in the cell of any point near it, where no edge is near.
Cell RotatedContact::cell_of(Index v) {
  const std::optional<RoughPoint> clear = rough_.clear(v);
  if (!clear) return locate_fixed_.locate(vertex(v) + to_);
  return locate_fixed_.locate(RealVector{Real::from_double(clear->real()), Real::from_double(clear->imag())} + to_);
}

MarkSet RotatedContact::marks_met(const ExactAngle& angle, MarkSet enough, const RealVector& shift) {
  MarkSet met = unbounded_ ? bit(fixed_.faces[0].mark) : 0;
  angle_ = angle;
  shift_ = shift;
  steps_ = {};
  rough_.set(angle, shift);
  place_.assign(net_.vertex_count(), kNone);
  vertices_.clear();
  in_face_.assign(net_.vertex_count(), 0);
  for (Index v = 0; v < net_.vertex_count() && (met & enough) == 0; ++v) {
    if (rotation_.vertices[v].mark == 0) continue;
    const Cell cell = cell_of(v);
    met |= bit(mark_of(fixed_, cell));
    in_face_[v] = cell.dimension == 2;
  }
  for (const Index e : net_.edges()) {
    if ((met & enough) != 0) return met;
    const auto crossed = rough_.crossed(rotation_.edges[e]);
    if (!crossed) meet_edge(edge(e), met, enough);
    if (!crossed) continue;
    for (const Index k : *crossed) {
      const Index cell = fixed_net_.edges()[k];
      met |= bit(fixed_.edges[cell].mark);
      for (const Index side : {2 * cell, 2 * cell + 1}) met |= bit(fixed_.faces[fixed_.face(side)].mark);
    }
  }
  if ((met & enough) != 0) return met;
  return met | marks_inside(met);
}

void RotatedContact::meet_edge(const RotatedEdge& e, MarkSet& met, MarkSet enough) {
  const RoughBox box = box_of(e);
  std::vector<RealVector> stops;
  for (Index k = 0; k < fixed_net_.edges().size(); ++k) {
    if (box.apart(rough_.fixed_box(k))) continue;
    const RotatedEdge f = fixed_net_.edge(fixed_net_.edges()[k]);
    ++(e.arc || f.arc ? steps_.arcs : steps_.lines);
    for (RealVector& p : meetings(e, f)) {
      met |= bit(fixed_.edges[f.cell].mark);
      stops.push_back(std::move(p));
    }
  }
  for (Index v = 0; v < fixed_vertices_.size(); ++v) {
    if (box.apart(fixed_vertices_[v].real(), fixed_vertices_[v].imag())) continue;
    RealVector p = fixed_net_.vertex(v);
    ++(e.arc ? steps_.arcs : steps_.lines);
    if (!lies_on(e, p)) continue;
    met |= bit(fixed_.vertices[v].mark);
    stops.push_back(std::move(p));
  }
  if ((met & enough) != 0) return;
  std::sort(stops.begin(), stops.end(), [&](const auto& s, const auto& t) { return compare_along(e, s, t) < 0; });
  stops.insert(stops.begin(), e.p);
  stops.push_back(e.q);
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    const bool first = k == 0, last = k + 2 == stops.size();
    // A piece that begins or ends in a face lies in it, and that has been seen.
    if ((first && in_face_[e.v0] != 0) || (last && in_face_[e.v1] != 0)) continue;
    if (!first && !last && compare_along(e, stops[k], stops[k + 1]) == 0) continue;
    met |= bit(locate_fixed_.mark(point_between(e, stops[k], stops[k + 1]) + to_));
  }
}

MarkSet RotatedContact::marks_inside(MarkSet met) {
  // A component in T has a vertex there. Without one none has to be found.
  const auto is_known = [&](Mark m) { return (met & bit(m)) != 0 || samples_[m + 1]; };
  if (!unbounded_ && !(is_known(-1) && is_known(0) && is_known(1))) {
    const RoughPoint rotation{rough(angle_.cos), rough(angle_.sin)};
    const double size = length(rough(about_)) + length(rough(to_));
    if (!may_hold_one(net_, rotation, rough(shift_), fixed_vertices_, size)) return 0;
  }
  MarkSet inside = 0;
  for (const Mark m : {-1, 0, 1}) {
    if ((met & bit(m)) != 0) continue;
    const std::vector<RealVector>& places = samples(m);
    if (std::any_of(places.begin(), places.end(),
                    [&](const RealVector& s) { return locate_rotation_.mark((-angle_)(s - shift_) + about_) != 0; }))
      inside |= bit(m);
  }
  return inside;
}

RotationMap RotatedContact::rotation_map(const Pair& pair, Mark (*rule)(MarkSet), MarkSet enough,
                                         const RotationMap& within) {
  const RotatedContact whole(pair);
  const std::vector<ExactAngle> events = whole.events();
  const long edges = long(whole.net_.edges().size()), fixed = long(whole.fixed_net_.edges().size());
  count_cells(kOfContactMap + (edges + fixed) / kEdgesOfCell + edges * fixed / kPairsOfCell + long(events.size()));
  const long look = 1 + edges * fixed / kPairsOfLook;
  return marks_within(within, events, [&]() -> AngleMark {
    count_cells(kOfContact);
    const auto contact = std::make_shared<RotatedContact>(pair);
    return [contact, rule, enough, look](std::size_t, const ExactAngle& angle) {
      const MarkSet met = contact->marks_met(angle, enough);
      count_cells(look + cells_of(contact->steps(), angle));
      return rule(met);
    };
  });
}

}  // namespace findspace::plane
