// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/grid_offset.h"

#include <algorithm>
#include <utility>

#include "plane/grid/boundary_box.h"
#include "plane/offset/offset_walks.h"
#include "plane/offset/tied_rings.h"

namespace findspace::plane {
namespace {

class Offset {
 public:
  Offset(OffsetCurves curves, OffsetEdges& edges) : c_(std::move(curves)), meetings_(c_, edges) {}

  /// `connected`: the set has one face, so D has.
  SignMap run(bool unbounded, bool connected, RingMarks marks) {
    meetings_.find();
    const OffsetTies ties(c_, meetings_);
    find_rings(ties, unbounded);
    if (meetings_.tie_count() > 0)
      return tied_ring_map(std::move(c_), meetings_, ties, edges_, starts_, marks, unbounded);
    if (starts_.empty()) return CellComplex::uniform(marks.inside);  // of an unbounded set
    const bool one_face = connected && (unbounded || starts_.size() == 1);
    const auto rings = one_face ? rings_of_one_face(starts_, unbounded) : nested_rings(c_.geometry, edges_, starts_);
    return ring_map(std::move(c_.geometry), edges_, rings, marks, unbounded);
  }

 private:
  /// Closed walks but for those whose other side is in D as well: wholly so, as everything between crossings is. The
  /// outer boundary of a bounded D is one that stays.
  void find_rings(const OffsetTies& ties, bool unbounded) {
    OffsetWalks walks = offset_walks(c_, meetings_, ties);
    const auto& rings = walks.rings;
    edges_ = std::move(walks.edges);
    const bool all_stay = !unbounded && rings.size() == 1;
    Index kept = 0;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const Index start = rings[r].start, end = r + 1 < rings.size() ? rings[r + 1].start : Index(edges_.size());
      const auto& [piece, before] = rings[r].pieces;
      if (!all_stay && !rings[r].tied && meetings_.is_inside(edges_[start].point, {piece, before})) continue;
      starts_.push_back(kept);
      if (kept != start) std::copy(edges_.begin() + start, edges_.begin() + end, edges_.begin() + kept);
      kept += end - start;
    }
    edges_.resize(kept);
  }

  OffsetCurves c_;
  OffsetMeetings meetings_;
  std::vector<RingEdge> edges_;
  std::vector<Index> starts_;
};

/// Faces on both sides of one edge: then that is not a boundary of the set.
bool shares_edges(const CellComplex& set, bool (*wanted)(Mark)) {
  for (Index e = 0; e < set.edges.size(); ++e)
    if (wanted(set.faces[set.face(2 * e)].mark) && wanted(set.faces[set.face(2 * e + 1)].mark)) return true;
  return false;
}

}  // namespace

std::optional<SignMap> grid_offset(const CellComplex& set, bool (*wanted)(Mark), const exact::Real& radius,
                                   RingMarks marks, const std::function<void()>& drop) {
  auto faces = grid_faces(set, wanted, false);
  if (!faces || (faces->size() > 1 && shares_edges(set, wanted))) return std::nullopt;
  if (faces->empty()) return CellComplex::uniform(marks.outside);
  const bool unbounded = has_unbounded(*faces), connected = faces->size() == 1;
  const GridCorners corners = all_corners(*std::move(faces));
  if (corners.empty()) return CellComplex::uniform(marks.inside);
  if (std::any_of(corners.begin(), corners.end(), [](const GridCorner& c) { return c.turn == 0; })) return std::nullopt;
  OffsetEdges edges(corners, radius);
  Offset offset(offset_curves(corners, set.geometry, radius, edges), edges);
  if (drop) drop();
  return offset.run(unbounded, connected, marks);
}

}  // namespace findspace::plane
