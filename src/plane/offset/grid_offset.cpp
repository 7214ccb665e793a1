// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/grid_offset.h"

#include <algorithm>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/ring_map.h"
#include "plane/grid/boundary_box.h"
#include "plane/offset/offset_meetings.h"

namespace findspace::plane {
namespace {

/// The closed walks along curves that can be boundary.
class OuterWalks {
 public:
  OuterWalks(const OffsetCurves& curves, const OffsetMeetings& meetings)
      : c_(curves), m_(meetings), state_(meetings.part_count(), kNew) {
    parts_.reserve(state_.size());
  }

  struct Part {
    Index piece, slot;
  };

  /// The walk from a part, if it is closed and new.
  std::span<const Part> walk(Part from) {
    parts_.clear();
    Part at = from;
    do {
      char& state = state_[m_.part(at.piece, at.slot)];
      if (state == kDone) return {};
      state = kDone;
      parts_.push_back(at);
      if (!advance(at)) return {};
    } while (at.piece != from.piece || at.slot != from.slot);
    return parts_;
  }

 private:
  enum State : char { kNew, kDone };

  /// To the part that follows; false where the walk would pass into D.
  bool advance(Part& at) const {
    if (at.slot < m_.stop_count(at.piece)) {
      const OffsetMeetings::Stop& stop = m_.stop(at.piece, at.slot);
      if (turn(c_.geometry, stop.point, c_.heading(at.piece), c_.heading(stop.other)) > 0) return false;
      at = {stop.other, stop.twin + 1};
      return true;
    }
    if (c_.origins[at.piece].next == kNone) return false;
    at = {c_.origins[at.piece].next, 0};
    return true;
  }

  const OffsetCurves& c_;
  const OffsetMeetings& m_;
  std::vector<char> state_;
  std::vector<Part> parts_;
};

class Offset {
 public:
  Offset(OffsetCurves curves, OffsetEdges& edges) : c_(std::move(curves)), meetings_(c_, edges) {}

  /// `connected`: the set has one face, so D has.
  std::optional<SignMap> run(bool unbounded, bool connected) {
    if (!meetings_.find()) return std::nullopt;
    OuterWalks walks(c_, meetings_);
    edges_.reserve(meetings_.part_count());
    for (Index i = 0; i < c_.pieces.size(); ++i)
      for (Index k = 0; k <= meetings_.stop_count(i); ++k)
        if (auto walk = walks.walk({i, k}); !walk.empty()) add_ring(walk);
    drop_inner_rings(unbounded);
    if (starts_.empty()) return unbounded ? std::optional(CellComplex::uniform(-1)) : std::nullopt;
    const bool one_face = connected && (unbounded || starts_.size() == 1);
    const auto rings = one_face ? rings_of_one_face(starts_, unbounded) : nested_rings(c_.geometry, edges_, starts_);
    return ring_map(std::move(c_.geometry), edges_, rings, kOpenSetSigns, unbounded);
  }

 private:
  using Part = OuterWalks::Part;

  void add_ring(std::span<const Part> walk) {
    starts_.push_back(Index(edges_.size()));
    first_.push_back({walk.front().piece, walk.back().piece});
    for (const Part& p : walk) {
      const Index point = p.slot == 0 ? c_.start(p.piece) : meetings_.stop(p.piece, p.slot - 1).point;
      const Piece& piece = c_.pieces[p.piece];
      edges_.push_back({point, piece.supporting_curve, c_.origins[p.piece].right, piece.half});
    }
  }

  std::span<const RingEdge> ring(std::size_t r) const {
    const Index end = r + 1 < starts_.size() ? starts_[r + 1] : Index(edges_.size());
    return std::span(edges_).subspan(starts_[r], end - starts_[r]);
  }

  /// Rings whose other side is in D as well: wholly so, as everything between crossings is. The outer boundary of a
  /// bounded D is one that stays.
  void drop_inner_rings(bool unbounded) {
    if (!unbounded && starts_.size() == 1) return;
    std::vector<RingEdge> edges;
    std::vector<Index> starts;
    for (std::size_t r = 0; r < starts_.size(); ++r) {
      if (meetings_.is_inside(ring(r)[0].point, {first_[r][0], first_[r][1]})) continue;
      starts.push_back(Index(edges.size()));
      edges.insert(edges.end(), ring(r).begin(), ring(r).end());
    }
    edges_ = std::move(edges);
    starts_ = std::move(starts);
  }

  OffsetCurves c_;
  OffsetMeetings meetings_;
  std::vector<RingEdge> edges_;
  std::vector<Index> starts_;
  std::vector<std::array<Index, 2>> first_;  // ring -> the pieces at its first corner
};

/// Faces on both sides of one edge: then that is not a boundary of the set.
bool shares_edges(const CellComplex& set, bool (*wanted)(Mark)) {
  for (Index e = 0; e < set.edges.size(); ++e)
    if (wanted(set.faces[set.face(2 * e)].mark) && wanted(set.faces[set.face(2 * e + 1)].mark)) return true;
  return false;
}

}  // namespace

std::optional<SignMap> grid_offset(const CellComplex& set, bool (*wanted)(Mark), const exact::Real& radius) {
  auto faces = grid_faces(set, wanted, false);
  if (!faces || (faces->size() > 1 && shares_edges(set, wanted))) return std::nullopt;
  if (faces->empty()) return CellComplex::uniform(1);
  const bool unbounded = has_unbounded(*faces), connected = faces->size() == 1;
  const std::vector<GridCorner> corners = all_corners(*std::move(faces));
  if (corners.empty()) return CellComplex::uniform(-1);
  if (std::any_of(corners.begin(), corners.end(), [](const GridCorner& c) { return c.turn == 0; })) return std::nullopt;
  OffsetEdges edges(corners, radius);
  return Offset(offset_curves(corners, set.geometry, radius, edges), edges).run(unbounded, connected);
}

}  // namespace findspace::plane
