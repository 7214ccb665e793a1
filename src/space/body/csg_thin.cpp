// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/csg_thin.h"

#include <algorithm>
#include <span>
#include <utility>

#include "space/body/body_boxes.h"
#include "space/body/cell_parts.h"
#include "space/body/open_union.h"
#include "space/body/union_frontier.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {

using exact::Real;

namespace {

Bounds3 bounds_of(const ConvexRegion& region) {
  Bounds3 box{region.vertices()[0].at, region.vertices()[0].at};
  for (const ConvexRegion::Vertex& v : region.vertices()) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], v.at[k]);
      box.high[k] = std::max(box.high[k], v.at[k]);
    }
  }
  return box;
}

/// Whether no place of the piece lies in the closed set; false where that is not found out.
bool misses(const BodyPart& set, const ConvexRegion& piece) {
  if (!meet_or_touch(bounds(set), bounds_of(piece))) return true;
  return set.point() && side(set, *nearest_in(piece.planes(), real(set.center))) > 0;
}

}  // namespace

bool flat_sided(const BodyPart& set) { return set.core && set.radius.sign() == 0; }

Bounds3 face_box(const BodyPart& set, const RealVector& n) {
  const RealVector out = scaled(set.radius / sqrt(dot(n, n)), n);
  std::optional<Bounds3> box;
  const auto corners = set.vertices();
  Real top = dot(n, real(corners[0]));
  for (const Point& v : corners) top = std::max(top, dot(n, real(v)));
  for (const Point& v : corners) {
    if (dot(n, real(v)) < top) continue;
    const RealVector at = plus(real(v), out);
    if (!box) box = Bounds3{at, at};
    for (std::size_t k = 0; k < 3; ++k) {
      box->low[k] = std::min(box->low[k], at[k]);
      box->high[k] = std::max(box->high[k], at[k]);
    }
  }
  return *box;
}

std::vector<ConvexRegion> cells_between(std::span<const Polytope> kept, std::span<const Polytope> taken) {
  std::vector<ConvexRegion> cells = difference_cells(kept.first(1), taken);
  for (const Polytope& other : kept.subspan(1)) {
    for (ConvexRegion& cell : cells) {
      for (const Plane& plane : other.planes()) cell.cut(HalfSpace(plane));
    }
  }
  std::erase_if(cells, [](const ConvexRegion& cell) { return cell.dimension() < 3; });
  return cells;
}

bool round_sets_remove(const CsgPart& part, const ConvexRegion& piece) {
  const auto takes = [&](const BodyPart& set) {
    return !flat_sided(set) && std::all_of(piece.vertices().begin(), piece.vertices().end(),
                                           [&](const auto& v) { return side(set, v.at) < 0; });
  };
  return std::any_of(part.without.begin(), part.without.end(), takes) ||
         std::any_of(part.within.begin(), part.within.end(),
                     [&](const BodyPart& set) { return !flat_sided(set) && misses(set, piece); });
}

namespace {

bool same_set(const BodyPart& a, const BodyPart& b) {
  return a.radius == b.radius && a.core.has_value() == b.core.has_value() &&
         std::ranges::equal(a.vertices(), b.vertices());
}

bool among(const std::vector<BodyPart>& sets, const BodyPart& set) {
  return std::any_of(sets.begin(), sets.end(), [&](const BodyPart& s) { return same_set(s, set); });
}

/// Cut by the box about the places of the set farthest along an axis in which the box is flat and ends there.
void cut_by_contact(const BodyPart& set, const Bounds3& flat, ConvexRegion& region) {
  const Bounds3 around = bounds(set);
  for (std::size_t k = 0; k < 3; ++k) {
    if (flat.low[k] < flat.high[k]) continue;
    RealVector n;
    n[k] = Real(around.high[k] == flat.low[k] ? 1 : -1);
    if (n[k].sign() < 0 && around.low[k] < flat.high[k]) continue;
    for (const HalfSpace& h : walls(face_box(set, n))) region.cut(h);
  }
}

/// What the polytopes of the part have in common within its box, where its round sets touch that.
ConvexRegion region_of(const CsgPart& part, const Bounds3& box) {
  ConvexRegion region(box.low, box.high);
  for (const BodyPart& set : part.within) {
    if (!flat_sided(set))
      cut_by_contact(set, box, region);
    else
      for (const Plane& plane : set.core->planes()) region.cut(HalfSpace(plane));
  }
  return region;
}

std::vector<Polytope> polytopes_of(const std::vector<BodyPart>& sets) {
  std::vector<Polytope> out;
  for (const BodyPart& set : sets)
    if (flat_sided(set)) out.push_back(*set.core);
  return out;
}

/// The pieces that the polytopes of the part keep.
std::vector<ConvexRegion> kept_pieces(const CsgPart& part) {
  const std::vector<Polytope> kept = polytopes_of(part.within), taken = polytopes_of(part.without);
  if (kept.empty() || taken.empty()) return {};
  return thin_pieces(kept, taken, cells_between(kept, taken));
}

/// What another part has of the box about a piece of the part: nothing where its round sets do not hold the piece as
/// the part's do, or take of it what the part keeps.
std::vector<ConvexRegion> held_by(const CsgPart& other, const CsgPart& part, const Bounds3& box) {
  const Bounds3 around = bounds(other);
  const auto holds = [&](const BodyPart& set) { return flat_sided(set) || among(part.within, set); };
  if (!meet_or_touch(around, box) || !std::all_of(other.within.begin(), other.within.end(), holds)) return {};
  std::vector<BodyPart> near;
  for (const BodyPart& set : other.without)
    if (meet_or_touch(bounds(set), box) && !among(part.without, set)) near.push_back(set);
  if (near.empty()) return {region_of(other, around)};
  const std::vector<Polytope> kept = polytopes_of(other.within);
  if (kept.empty() || !std::all_of(near.begin(), near.end(), flat_sided)) return {};
  return cells_between(kept, polytopes_of(near));
}

/// Of a piece of one part, without interior, what others do not hold.
std::vector<ConvexRegion> held_by_none(const CsgPart& part, const ConvexRegion& piece,
                                       const std::vector<CsgPart>& others) {
  const Bounds3 box = bounds_of(piece);
  std::vector<ConvexRegion> held;
  for (const CsgPart& other : others) {
    const std::vector<ConvexRegion> more = held_by(other, part, box);
    held.insert(held.end(), more.begin(), more.end());
  }
  return uncovered(piece, held);
}

/// What may be left of the region of a part that has no interior, and that no other part holds.
bool is_left(const CsgPart& part, const ConvexRegion& region, const std::vector<CsgPart>& others) {
  std::vector<ConvexRegion> pieces{region}, next;
  for (const BodyPart& set : part.without) {
    if (!flat_sided(set)) continue;
    next.clear();
    for (ConvexRegion& piece : pieces) subtract(std::move(piece), set.planes(), next);
    pieces.swap(next);
  }
  return std::any_of(pieces.begin(), pieces.end(), [&](const ConvexRegion& piece) {
    const std::vector<ConvexRegion> left = held_by_none(part, piece, others);
    return !std::all_of(left.begin(), left.end(), [&](const ConvexRegion& l) { return round_sets_remove(part, l); });
  });
}

}  // namespace

bool keeps_thin(const CsgSolid& solid, const CsgSolid& whole) {
  const std::int64_t scale = joint_scale(solid.scale, whole.scale);
  const CsgSolid open = at_scale(solid, scale), all = at_scale(whole, scale);
  std::vector<CsgPart> parts = open.parts;
  if (!drop_thin(parts) && !parts.empty()) return true;
  for (const CsgPart& part : parts) {
    CsgPart round;
    std::vector<ConvexRegion> closed;
    for (const BodyPart& set : all.parts.size() == 1 ? all.parts[0].without : std::vector<BodyPart>()) {
      if (among(part.without, set)) continue;
      if (flat_sided(set))
        closed.push_back(common_region({&*set.core, 1}));
      else
        round.without.push_back(set);
    }
    for (const ConvexRegion& piece : kept_pieces(part)) {
      for (const ConvexRegion& left : uncovered(piece, closed)) {
        if (!round_sets_remove(part, left) && !round_sets_remove(round, left)) return true;
      }
    }
  }
  return false;
}

bool drop_thin(std::vector<CsgPart>& parts) {
  std::vector<std::pair<CsgPart, ConvexRegion>> thin;
  std::erase_if(parts, [&](const CsgPart& part) {
    const Bounds3 box = bounds(part);
    if (bulky(box) && std::count_if(part.within.begin(), part.within.end(), flat_sided) < 2) return false;
    ConvexRegion region = region_of(part, box);
    if (region.dimension() == 3) return false;
    if (!region.empty()) thin.emplace_back(part, std::move(region));
    return true;
  });
  return std::none_of(thin.begin(), thin.end(),
                      [&](const auto& piece) { return is_left(piece.first, piece.second, parts); });
}

}  // namespace findspace::space
