// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How rings lie in each other: from the leftmost corner of each a ray goes straight down, a little to the left of the
// corner; of those rings whose box holds the box of this one, what it meets first tells the face about the ring. From
// left to right, so that this is known. Others that the ray meets are round neither end of it and change nothing.
#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/around_vertex.h"
#include "plane/complex/piece_meet.h"
#include "plane/complex/ring_map.h"
#include "plane/complex/sequence_boxes.h"
#include "plane/complex/side_by_side.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

class RingNesting {
 public:
  RingNesting(const Geometry& g, std::span<const RingEdge> edges, std::span<const Index> starts)
      : g_(g), edges_(edges), starts_(starts) {}

  std::vector<NestedRing> run() {
    std::vector<NestedRing> rings;
    Index faces = 1;
    for (Index r = 0; r < starts_.size(); ++r) {
      leftmost_.push_back(leftmost(r));
      // The ring goes round its left side if it leaves its leftmost corner below the way it comes.
      rings.push_back({starts_[r], 0, 0, leaves_below(leftmost_.back(), r)});
      (rings[r].outer ? rings[r].inside : rings[r].outside) = faces++;
    }
    const bool no_hole = std::all_of(rings.begin(), rings.end(), [](const NestedRing& r) { return r.outer; });
    if (no_hole || rings.size() == 1) return rings;
    make_pieces();
    find_boxes_around();
    std::vector<Index> order(starts_.size());
    for (Index r = 0; r < order.size(); ++r) order[r] = r;
    std::sort(order.begin(), order.end(), [&](Index r, Index s) {
      return r != s && compare_xy(g_, edges_[leftmost_[r]].point, edges_[leftmost_[s]].point) < 0;
    });
    for (Index r : order) (rings[r].outer ? rings[r].outside : rings[r].inside) = face_around(r, rings);
    return rings;
  }

 private:
  Index end(Index r) const { return r + 1 < starts_.size() ? starts_[r + 1] : Index(edges_.size()); }
  Index next(Index k, Index r) const { return k + 1 == end(r) ? starts_[r] : k + 1; }
  Index before(Index k, Index r) const { return k == starts_[r] ? end(r) - 1 : k - 1; }

  Index leftmost(Index r) const {
    Index best = starts_[r];
    for (Index k = starts_[r] + 1; k < end(r); ++k) {
      const int x = compare_x(g_, edges_[k].point, edges_[best].point);
      if (x < 0 || (x == 0 && compare_y(g_, edges_[k].point, edges_[best].point) < 0)) best = k;
    }
    return best;
  }

  /// Of an edge, travelled from left to right or the other way.
  exact::Heading heading(const RingEdge& e, bool right) const {
    return {e.supporting_curve,
            e.half != 0 ? (e.half < 0) == right : (g_.supporting_curves[e.supporting_curve].b > 0) == right};
  }

  bool leaves_below(Index k, Index r) const {
    const RingEdge &out = edges_[k], &in = edges_[before(k, r)];
    return comes_before(g_, out.point, false, heading(out, true), out.half, heading(in, true));
  }

  void make_pieces() {
    double error = 0, largest = 0;
    for (Index r = 0; r < starts_.size(); ++r)
      for (Index k = starts_[r]; k < end(r); ++k) {
        const RingEdge& e = edges_[k];
        const Index to = edges_[next(k, r)].point;
        pieces_.push_back({.supporting_curve = e.supporting_curve,
                           .p0 = e.right ? e.point : to,
                           .p1 = e.right ? to : e.point,
                           .half = e.half});
        ring_of_.push_back(r);
        const exact::Point& p = g_.points[e.point];
        error = std::max<double>(error, p.error);
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      }
    slack_ = box_slack(error, largest);
  }

  /// All boxes are too large by the same slack.
  void find_boxes_around() {
    std::vector<PieceBox> boxes;
    for (Index r = 0; r < starts_.size(); ++r) {
      boxes.push_back(box_of(g_, pieces_[starts_[r]], slack_));
      for (Index k = starts_[r] + 1; k < end(r); ++k)
        boxes.back() = joined(boxes.back(), box_of(g_, pieces_[k], slack_));
    }
    around_.resize(starts_.size());
    trees_.resize(starts_.size());
    const auto holds = [&](const PieceBox& a, const PieceBox& b) {
      return a.x0 <= b.x0 + 2 * slack_ && b.x1 <= a.x1 + 2 * slack_ && a.y0 <= b.y0 + 2 * slack_ &&
             b.y1 <= a.y1 + 2 * slack_;
    };
    meeting_boxes(boxes, [&](Index r, Index s) {
      if (holds(boxes[r], boxes[s])) around_[s].push_back(r);
      if (holds(boxes[s], boxes[r])) around_[r].push_back(s);
      return true;
    });
  }

  Index face_around(Index r, const std::vector<NestedRing>& rings) {
    const auto is_hole = [&](Index s) { return !rings[s].outer; };
    // Between a ring and one around it is a ring of a hole.
    if (rings[r].outer && std::none_of(around_[r].begin(), around_[r].end(), is_hole)) return 0;
    const Index below = edge_below(r);
    if (below == kNone) return 0;
    const NestedRing& ring = rings[ring_of_[below]];
    return edges_[below].right ? ring.inside : ring.outside;
  }

  /// Of the rings around this one, the edge that a ray straight down from a little to the left of its leftmost corner
  /// meets first; kNone: none.
  Index edge_below(Index r) {
    const Index from = edges_[leftmost_[r]].point;
    const exact::Point& p = g_.points[from];
    Index best = kNone;
    for (const Index s : around_[r])
      tree(s).any_meeting({p.x - slack_, -exact::kInfinity, p.x + slack_, p.y + slack_}, [&](Index i) {
        const Index k = starts_[s] + i;
        const Piece& piece = pieces_[k];
        const bool vertical = piece.half == 0 && g_.supporting_curves[piece.supporting_curve].b == 0;
        if (!vertical && compare_x(g_, piece.p0, from) < 0 && compare_x(g_, piece.p1, from) >= 0 &&
            height(g_, piece, from) > 0 && (best == kNone || is_higher(k, best, from)))
          best = k;
        return false;
      });
    return best;
  }

  /// Of the edges of a ring, made when it is asked for.
  const SequenceBoxes& tree(Index r) {
    if (!trees_[r]) {
      std::vector<PieceBox> boxes;
      boxes.reserve(SequenceBoxes::size_with_joined(end(r) - starts_[r]));
      for (Index k = starts_[r]; k < end(r); ++k) boxes.push_back(box_of(g_, pieces_[k], slack_));
      trees_[r].emplace(std::move(boxes));
    }
    return *trees_[r];
  }

  bool is_higher(Index k, Index l, Index at) const {
    if (const int s = compare_heights(g_, pieces_[k], pieces_[l], at); s != 0) return s > 0;
    return comes_before(g_, pieces_[k].p1, true, heading(edges_[k], false), pieces_[k].half, heading(edges_[l], false));
  }

  const Geometry& g_;
  std::span<const RingEdge> edges_;
  std::span<const Index> starts_;
  std::vector<Index> leftmost_;  // ring -> the edge that leaves its leftmost corner
  std::vector<Piece> pieces_;    // of the edges
  std::vector<Index> ring_of_;   // edge -> ring
  double slack_ = 0;
  std::vector<std::vector<Index>> around_;  // ring -> those whose box holds its box
  std::vector<std::optional<SequenceBoxes>> trees_;
};

}  // namespace

std::vector<NestedRing> nested_rings(const Geometry& geometry, std::span<const RingEdge> edges,
                                     std::span<const Index> starts) {
  return RingNesting(geometry, edges, starts).run();
}

}  // namespace findspace::plane
