// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/meeting_curves.h"

#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

DirectedEdge directed_edge(const MeetingCurves& curves, const exact::Geometry& g, Index degenerate, CurvePart part,
                           bool starts, bool hides) {
  const exact::SupportingCurve& k = g.supporting_curves[curves.supporting_curve(part.curve)];
  // To the right along a*x + b*y = c: (b, -a) or its opposite.
  const bool forward = ((k.b > 0) == curves.right(part.curve)) == starts;
  return {.degenerate = degenerate,
          .curve = part.curve,
          .slot = part.slot,
          .starts = starts,
          .hides = hides,
          .dx = forward ? k.b : -k.b,
          .dy = forward ? -k.a : k.a};
}

/// The half-edges of all degenerate vertices.
void add_directed_edges(const MeetingCurves& curves, const DirectedCurves& c, DegenerateVertices& all) {
  const auto add = [&](Index degenerate, CurvePart part, bool starts, bool hides) {
    all.add(directed_edge(curves, c.geometry, degenerate, part, starts, hides));
  };
  all.reserve(2 * curves.part_count());
  for (Index i = 0; i < curves.size(); ++i) {
    const InnerSide& side = c.sides[i];
    if (const Index from = all.at(curves.start(i)); from != kNone)
      add(from, {i, 0}, true, curves.right(i) ? side.hides_at_p0 : side.hides_at_p1);
    if (const Index to = all.at(curves.end(i)); to != kNone)
      add(to, {i, curves.stop_count(i)}, false, curves.right(i) ? side.hides_at_p1 : side.hides_at_p0);
    for (Index k = 0; k < curves.stop_count(i); ++k) {
      if (curves.stop(i, k).other != kNone) continue;
      add(curves.stop(i, k).twin, {i, k}, false, true);
      add(curves.stop(i, k).twin, {i, k + 1}, true, true);
    }
  }
}

}  // namespace

MeetingCurves::MeetingCurves(DirectedCurves& c, Memory memory) : MeetingCurves(c, find_stops(c, memory), memory) {}

MeetingCurves::MeetingCurves(const DirectedCurves& c, CurveStops found, Memory memory)
    : c_(c), found_(std::move(found)), curves_(memory), memory_(memory) {
  std::pmr::vector<Index> ends_at(c.geometry.points.size(), kNone, memory);
  const Index n = Index(c.pieces.size());
  curves_.resize(n + 1);
  Curve* const curves = curves_.data();
  const Index* const first = found_.first.data();
  for (Index i = 0; i < n; ++i) {
    const Piece& p = c.pieces[i];
    const bool runs_on = right(i);
    const Index end = runs_on ? p.p1 : p.p0;
    curves[i].start = runs_on ? p.p0 : p.p1;
    curves[i].end = end;
    curves[i].first_part = first[i] + i;
    ends_at[end] = i;
  }
  curves[n].first_part = part_count();
  for (Index i = 0; i < n; ++i) curves[i].before = ends_at[curves[i].start];
  if (!found_.degenerate_vertices.empty()) add_directed_edges(*this, c_, found_.degenerate_vertices);
}

std::pmr::vector<CurvePart> MeetingCurves::parts_with_two_inner_sides() const {
  std::pmr::vector<CurvePart> found(memory_);
  for (const auto& both : found_.opposite) {
    auto on_other = [&](Index point) { return within(c_.geometry, c_.pieces[both.second], point) != Within::kOutside; };
    for (CurvePart p{both.first, 0}; p.slot <= stop_count(p.curve); ++p.slot)
      if (on_other(start(p)) && on_other(end(p))) found.push_back(p);
  }
  return found;
}

}  // namespace findspace::plane
