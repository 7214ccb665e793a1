// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/meeting_curves.h"

#include "plane/base/append_made.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

/// The half-edges of all degenerate vertices.
class DirectedEdges {
 public:
  DirectedEdges(const MeetingCurves& curves, const DirectedCurves& c, DegenerateVertices& all)
      : curves_(curves), lines_(c.geometry.supporting_curves.data()), sides_(c.sides.data()), all_(all) {
    all.reserve(2 * curves.part_count());
  }

  void add_all() {
    for (Index i = 0, n = curves_.size(); i < n; ++i) {
      const Index from = all_.at(curves_.start(i)), to = all_.at(curves_.end(i)), stops = curves_.stop_count(i);
      if (from != kNone) add(from, {i, 0}, true, curves_.right(i) ? sides_[i].hides_at_p0 : sides_[i].hides_at_p1);
      if (to != kNone) add(to, {i, stops}, false, curves_.right(i) ? sides_[i].hides_at_p1 : sides_[i].hides_at_p0);
      for (Index k = 0; k < stops; ++k) {
        const Stop& stop = curves_.stop(i, k);
        if (stop.other != kNone) continue;
        add(stop.twin, {i, k}, false, true);
        add(stop.twin, {i, k + 1}, true, true);
      }
    }
  }

 private:
  void add(Index degenerate, CurvePart part, bool starts, bool hides) {
    const exact::SupportingCurve& k = lines_[curves_.supporting_curve(part.curve)];
    // To the right along a*x + b*y = c: (b, -a) or its opposite.
    const bool forward = ((k.b > 0) == curves_.right(part.curve)) == starts;
    all_.add({.degenerate = degenerate,
              .curve = part.curve,
              .slot = part.slot,
              .starts = starts,
              .hides = hides,
              .dx = forward ? k.b : -k.b,
              .dy = forward ? -k.a : k.a});
  }

  const MeetingCurves& curves_;
  const exact::SupportingCurve* lines_;
  const InnerSide* sides_;
  DegenerateVertices& all_;
};

}  // namespace

MeetingCurves::MeetingCurves(DirectedCurves& c, Memory memory) : MeetingCurves(c, find_stops(c, memory), memory) {}

MeetingCurves::MeetingCurves(const DirectedCurves& c, CurveStops found, Memory memory)
    : c_(c), found_(std::move(found)), curves_(memory), memory_(memory) {
  ArenaVector<Index> ends_at(c.geometry.points.size(), kNone, memory);
  const Index n = Index(c.pieces.size());
  curves_.reserve(n + 1);
  append_made(curves_, n,
              [first = found_.first.data(), pieces = c.pieces.data(), sides = c.sides.data(),
               ends_at = ends_at.data()](std::size_t i) {
                const Piece& p = pieces[i];
                const bool right = sides[i].left;
                const Index start = right ? p.p0 : p.p1, end = right ? p.p1 : p.p0;
                ends_at[end] = Index(i);
                return Curve{start, end, kNone, first[i] + Index(i)};
              });
  Curve* const curves = curves_.data();
  for (Index i = 0; i < n; ++i) curves[i].before = ends_at[curves[i].start];
  curves_.push_back({kNone, kNone, kNone, part_count()});
  if (!found_.degenerate_vertices.empty()) DirectedEdges(*this, c_, found_.degenerate_vertices).add_all();
}

ArenaVector<CurvePart> MeetingCurves::parts_with_two_inner_sides() const {
  ArenaVector<CurvePart> found(memory_);
  for (const auto& both : found_.opposite) {
    auto on_other = [&](Index point) { return within(c_.geometry, c_.pieces[both.second], point) != Within::kOutside; };
    for (CurvePart p{both.first, 0}; p.slot <= stop_count(p.curve); ++p.slot)
      if (on_other(start(p)) && on_other(end(p))) found.push_back(p);
  }
  return found;
}

}  // namespace findspace::plane
