// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/tied_rings.h"

#include <utility>

#include "plane/offset/joined_pieces.h"

namespace findspace::plane {
namespace {

/// Points at one tie are one.
Index leading_point(const OffsetMeetings& meetings, Index point) {
  const Index tie = meetings.tie_at(point);
  return tie == kNone ? point : meetings.tie_point(tie);
}

Piece plain_piece(const RingEdge& e, Index from, Index to) {
  Piece p;
  p.supporting_curve = e.supporting_curve;
  p.p0 = e.right ? from : to;
  p.p1 = e.right ? to : from;
  p.half = e.half;
  return p;
}

/// Piece k is that of edge k.
std::vector<Piece> ring_pieces(const OffsetMeetings& meetings, std::span<const RingEdge> edges,
                               std::span<const Index> starts) {
  std::vector<Piece> pieces;
  pieces.reserve(edges.size());
  for (std::size_t r = 0; r < starts.size(); ++r) {
    const Index end = r + 1 < starts.size() ? starts[r + 1] : Index(edges.size());
    for (Index k = starts[r]; k < end; ++k)
      pieces.push_back(plain_piece(edges[k], leading_point(meetings, edges[k].point),
                                   leading_point(meetings, edges[k + 1 == end ? starts[r] : k + 1].point)));
  }
  return pieces;
}

Piece slit_piece(const OffsetCurves& c, const OffsetMeetings& meetings, OffsetPart part) {
  const auto [i, k] = part;
  Piece p = c.pieces[i];
  p.p0 = leading_point(meetings, k == 0 ? c.start(i) : meetings.stop(i, k - 1).point);
  p.p1 = leading_point(meetings, k == meetings.stop_count(i) ? c.end(i) : meetings.stop(i, k).point);
  return p;
}

}  // namespace

SignMap tied_ring_map(OffsetCurves&& curves, const OffsetMeetings& meetings, const OffsetTies& ties,
                      std::span<const RingEdge> edges, std::span<const Index> starts, RingMarks marks, bool unbounded) {
  std::vector<Piece> pieces = ring_pieces(meetings, edges, starts);
  for (const OffsetPart& slit : ties.slits) pieces.push_back(slit_piece(curves, meetings, slit));
  Arrangement a = arrange_joined(std::move(curves.geometry), std::move(pieces), ties.single_points);
  Marks of{std::vector<Mark>(a.face_count, marks.inside), std::vector<Mark>(a.edge_count(), marks.on),
           std::vector<Mark>(a.vertex_count(), marks.on)};
  if (!unbounded) of.faces[0] = marks.outside;
  for (Index e = 0; e < edges.size(); ++e) of.faces[a.face[2 * e + (edges[e].right ? 1 : 0)]] = marks.outside;
  return extract(std::move(a), of);
}

}  // namespace findspace::plane
