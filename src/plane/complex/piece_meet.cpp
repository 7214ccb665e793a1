// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/piece_meet.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "exact/planar/geometry_signs.h"

namespace findspace::plane {

using exact::Geometry;
using exact::Real;

namespace {

/// Exact y of a non-vertical piece at the x of a point.
Real exact_y_at(const Geometry& g, const Piece& p, Index point) {
  const exact::SupportingCurve& k = g.supporting_curves[p.supporting_curve];
  Real x = g.exact_x(point);
  if (!k.circle) return (k.offset() - Real(k.a) * x) / Real(k.b);
  Real dx = x - k.center_x(), root = sqrt(k.w() * k.w() - dx * dx);
  return p.half > 0 ? k.center_y() + root : k.center_y() - root;
}

constexpr std::size_t kManyToMeet = 2000;  // from here on strips of the grid are looked at at once

bool certainly_inside(const Geometry& g, Index point, const exact::SupportingCurve& circle) {
  const exact::Point& p = g.points[point];
  const exact::Approx dx = exact::Approx{p.x, p.error} - circle.x(), dy = exact::Approx{p.y, p.error} - circle.y();
  return (dx * dx + dy * dy - circle.z() * circle.z()).sign() < 0;
}

/// A segment with both ends inside the circle of an arc: they do not meet. Of nested outlines most are such.
bool is_chord_inside(const Geometry& g, const Piece& segment, const Piece& arc) {
  if (segment.half != 0 || arc.half == 0) return false;
  const exact::SupportingCurve& circle = g.supporting_curves[arc.supporting_curve];
  return certainly_inside(g, segment.p0, circle) && certainly_inside(g, segment.p1, circle);
}

/// A segment and an arc with a common end: whether they certainly do not meet again. The other root is that end moved
/// along the line by twice the way to the foot of the centre. Of smooth outlines on a grid the two are close together,
/// and hard to tell apart.
bool is_only_meeting(const Geometry& g, const Piece& segment, const Piece& arc, Index shared) {
  if (segment.half != 0 || arc.half == 0) return false;
  const auto coordinate = [&](Index point, bool x) {
    const exact::Point& p = g.points[point];
    return exact::Approx{x ? p.x : p.y, p.error};
  };
  const exact::SupportingCurve& circle = g.supporting_curves[arc.supporting_curve];
  const Index other = shared == segment.p0 ? segment.p1 : segment.p0;
  const exact::Approx x = coordinate(shared, true), y = coordinate(shared, false);
  const exact::Approx along = coordinate(other, true) - x, up = coordinate(other, false) - y;
  const int way = (along * (circle.x() - x) + up * (circle.y() - y)).sign();
  if (way < 0) return true;                                       // behind the end of the segment
  return way > 0 && along.sign() == (shared == arc.p0 ? -1 : 1);  // beside the arc
}

/// Whether one ends at the x at which the other begins, but not at the same point, so that they do not meet. Of nested
/// outlines with arcs at their corners most are such.
bool is_beside(const Geometry& g, const Piece& p, const Piece& q) {
  const auto upright = [&](const Piece& k) { return k.half == 0 && g.supporting_curves[k.supporting_curve].b == 0; };
  if (upright(p) || upright(q)) return false;
  const auto ends_before = [&](Index end, Index begin) {
    const int x = compare_x(g, end, begin);
    return x < 0 || (x == 0 && compare_y(g, end, begin) != 0);
  };
  return ends_before(p.p1, q.p0) || ends_before(q.p1, p.p0);
}

/// The things that are used (not 0), numbered in their order.
std::vector<Index> numbered(std::vector<Index>& used) {
  std::vector<Index> all;
  for (Index k = 0; k < used.size(); ++k) {
    if (used[k] == 0) continue;
    used[k] = Index(all.size());
    all.push_back(k);
  }
  return all;
}

/// The pieces in some columns of a grid with a geometry of their own, to which their crossings are added. Cells keep
/// their order, so crossings keep their roots.
class Strip {
 public:
  Strip(const Geometry& whole, std::span<const Piece> pieces, const CellGrid& grid, IndexRange columns)
      : of_whole_(grid.pieces_in(columns)), place_(pieces.size(), kNone) {
    std::vector<Index> point(whole.points.size(), 0), curve(whole.supporting_curves.size(), 0);
    for (const Index i : of_whole_) {
      curve[pieces[i].supporting_curve] = 1;
      for (const Index end : {pieces[i].p0, pieces[i].p1}) {
        point[end] = 1;
        const exact::Point& p = whole.points[end];
        if (p.kind == exact::Point::Kind::kCross) curve[p.i] = curve[p.j] = 1;
      }
    }
    points_ = numbered(point);
    curves_ = numbered(curve);
    copy_geometry(whole, curve);
    pieces_.reserve(of_whole_.size());
    for (const Index i : of_whole_) {
      place_[i] = Index(pieces_.size());
      Piece& piece = pieces_.emplace_back(pieces[i]);
      piece.supporting_curve = curve[piece.supporting_curve];
      piece.p0 = point[piece.p0];
      piece.p1 = point[piece.p1];
    }
  }

  Geometry& geometry() { return geometry_; }
  std::span<const Piece> pieces() const { return pieces_; }
  /// Of a piece of the whole, the number here.
  Index place(Index of_whole) const { return place_[of_whole]; }

  /// Keeps the crossings alone: there are many strips.
  void drop_copies() {
    crossings_.assign(geometry_.points.begin() + std::ptrdiff_t(points_.size()), geometry_.points.end());
    geometry_ = {};
    pieces_ = {};
    place_ = {};
  }

  std::size_t crossings() const { return crossings_.size(); }
  /// Sets the crossings found, which start at `first` there, and what is known of them.
  void put_into(Geometry& whole, Index first, const PieceMeetings& found, std::span<PieceMeetings::Split> splits,
                std::span<PieceMeetings::Tie> ties) const {
    const Index known = Index(points_.size());
    for (std::size_t k = 0; k < crossings_.size(); ++k) {
      exact::Point& p = whole.points[first + k] = crossings_[k];
      p.i = curves_[p.i];
      p.j = curves_[p.j];
    }
    const auto point = [&](Index k) { return k < known ? points_[k] : first + (k - known); };
    for (std::size_t k = 0; k < splits.size(); ++k)
      splits[k] = {of_whole_[found.splits[k].piece], point(found.splits[k].point)};
    for (std::size_t k = 0; k < ties.size(); ++k) ties[k] = {point(found.ties[k].p), point(found.ties[k].q)};
  }

 private:
  void copy_geometry(const Geometry& whole, const std::vector<Index>& curve) {
    geometry_.supporting_curves.reserve(curves_.size());
    for (const Index k : curves_) geometry_.supporting_curves.push_back(whole.supporting_curves[k]);
    geometry_.points.reserve(2 * points_.size());
    geometry_.reals.reserve(std::min(points_.size(), whole.reals.size()));
    for (const Index k : points_) {
      exact::Point& p = geometry_.points.emplace_back(whole.points[k]);
      if (p.kind == exact::Point::Kind::kCross) {
        p.i = curve[p.i];
        p.j = curve[p.j];
      }
      if (p.kind != exact::Point::Kind::kReal) continue;
      geometry_.reals.push_back(whole.reals[p.i]);
      p.i = Index(geometry_.reals.size() - 1);
    }
  }

  std::vector<Index> of_whole_, points_, curves_;  // here -> of the whole
  std::vector<Index> place_;                       // piece of the whole -> here
  std::vector<Piece> pieces_;
  Geometry geometry_;
  std::vector<exact::Point> crossings_;
};

/// A strip and what was found there.
struct OfStrip {
  Strip strip;
  PieceMeetings meetings;
  Index point = 0;  // of the whole: the first of its crossings, of its splits and of its ties
  std::size_t split = 0, tie = 0;

  OfStrip(const Geometry& g, std::span<const Piece> pieces, const CellGrid& grid, IndexRange columns)
      : strip(g, pieces, grid, columns), meetings(strip.geometry(), strip.pieces(), kHeap) {}
};

/// Adds what was found in the strips, one after the other, and drops them.
void join(Geometry& g, PieceMeetings& all, std::span<std::unique_ptr<OfStrip>> found) {
  std::size_t points = g.points.size(), split = all.splits.size(), tie = all.ties.size();
  for (const std::unique_ptr<OfStrip>& f : found) {
    f->point = Index(points);
    f->split = split;
    f->tie = tie;
    points += f->strip.crossings();
    split += f->meetings.splits.size();
    tie += f->meetings.ties.size();
  }
  g.points.resize(points);
  all.splits.resize(split);
  all.ties.resize(tie);
  parallel_for(found.size(), [&](std::size_t k) {
    const OfStrip& f = *found[k];
    f.strip.put_into(g, f.point, f.meetings, std::span(all.splits).subspan(f.split, f.meetings.splits.size()),
                     std::span(all.ties).subspan(f.tie, f.meetings.ties.size()));
    found[k].reset();
  });
}

}  // namespace

exact::Approx approx_y_at(const Geometry& g, const Piece& p, Index point) {
  const exact::SupportingCurve& k = g.supporting_curves[p.supporting_curve];
  exact::Approx x{g.points[point].x, g.points[point].error};
  if (!k.circle) return (k.z() - k.x() * x) / k.y();
  exact::Approx dx = x - k.x(), root = sqrt((k.z() - dx) * (k.z() + dx));
  return p.half > 0 ? k.y() + root : k.y() - root;
}

int compare_heights(const Geometry& g, const Piece& p, const Piece& q, Index point) {
  const int s = (approx_y_at(g, p, point) - approx_y_at(g, q, point)).sign();
  return s != 0 ? s : compare(exact_y_at(g, p, point), exact_y_at(g, q, point));
}

int compare_along(const Geometry& g, const Piece& piece, Index p, Index q) {
  if (piece.half != 0) return compare_x(g, p, q);
  // Along the longer axis the filter decides more often. A line of slope -a/b (a >= 0) rises for b <= 0.
  const exact::SupportingCurve& k = g.supporting_curves[piece.supporting_curve];
  if (k.a <= std::abs(k.b)) return compare_x(g, p, q);
  return k.b > 0 ? compare_y(g, q, p) : compare_y(g, p, q);
}

Within within(const Geometry& g, const Piece& piece, Index point) {
  if (point == piece.p0) return Within::kAtStart;
  if (point == piece.p1) return Within::kAtEnd;
  int from = compare_along(g, piece, point, piece.p0);
  if (from < 0) return Within::kOutside;
  int to = compare_along(g, piece, point, piece.p1);
  if (to > 0) return Within::kOutside;
  if (piece.half != 0) {
    int up = above_center(g, point, piece.supporting_curve);
    if (up != 0 && up != piece.half) return Within::kOutside;
  }
  return from == 0 ? Within::kAtStart : to == 0 ? Within::kAtEnd : Within::kInside;
}

int height(const Geometry& g, const Piece& piece, Index point) {
  int s = side(g, point, piece.supporting_curve);
  if (piece.half == 0) return g.supporting_curves[piece.supporting_curve].b > 0 ? s : -s;
  if (s < 0) return -piece.half;  // inside the circle: below the upper half, above the lower one
  int up = above_center(g, point, piece.supporting_curve);
  if (s > 0) return up != 0 ? up : piece.half;
  return up == 0 || up == piece.half ? 0 : up;
}

void PieceMeetings::add_pair(Index i, Index j) {
  const Piece &p = pieces_[i], &q = pieces_[j];
  if (p.group == q.group && p.group != kNone) return;
  if (p.half == 0 && q.half == 0) return lines(i, j);
  if ((p.supporting_curve == q.supporting_curve ||
       same_supporting_curve(g_.supporting_curves[p.supporting_curve], g_.supporting_curves[q.supporting_curve])) &&
      p.half != 0 && q.half != 0)
    return overlap(i, j);
  curves(i, j);
}

void PieceMeetings::add_pairs(const CellGrid& grid) {
  const auto of_first = [&](const Piece& p) { return p.group == pieces_[0].group; };
  if (!pieces_.empty() && pieces_[0].group != kNone && std::all_of(pieces_.begin(), pieces_.end(), of_first)) return;
  const std::size_t ranges = range_count(pieces_.size(), kManyToMeet);
  const auto group = [&](Index i) { return pieces_[i].group; };
  if (ranges == 1) return grid.pairs(grid.columns(), group, [&](Index i, Index j) { add_pair(i, j); });
  const std::vector<IndexRange> strips = grid.strips(ranges);
  std::vector<std::unique_ptr<OfStrip>> found(strips.size());
  parallel_for(strips.size(), [&](std::size_t k) {
    found[k] = std::make_unique<OfStrip>(g_, pieces_, grid, strips[k]);
    const Strip& strip = found[k]->strip;
    grid.pairs(strips[k], group,
               [&](Index i, Index j) { found[k]->meetings.add_pair(strip.place(i), strip.place(j)); });
    found[k]->strip.drop_copies();
  });
  join(g_, *this, found);
}

void PieceMeetings::add_point(Index point, Index piece) {
  const Piece& p = pieces_[piece];
  if (!lies_on(g_, point, p.supporting_curve)) return;
  place(piece, point, within(g_, p, point));
}

void PieceMeetings::place(Index piece, Index point, Within where) {
  const Piece& p = pieces_[piece];
  if (where == Within::kInside) splits.push_back({piece, point});
  if (where == Within::kAtStart && p.p0 != point) ties.push_back({p.p0, point});
  if (where == Within::kAtEnd && p.p1 != point) ties.push_back({p.p1, point});
}

void PieceMeetings::lines(Index i, Index j) {
  const Piece &p = pieces_[i], &q = pieces_[j];
  const exact::SupportingCurve &k = g_.supporting_curves[p.supporting_curve],
                               &l = g_.supporting_curves[q.supporting_curve];
  if (k.a == l.a && k.b == l.b) {  // primitive normals: parallel
    if (p.supporting_curve == q.supporting_curve || same_supporting_curve(k, l)) overlap(i, j);
    return;
  }
  if (shared_end(p, q) != kNone) return;  // the one common point
  int s0 = side(g_, q.p0, p.supporting_curve), s1 = side(g_, q.p1, p.supporting_curve);
  if (s0 * s1 > 0) return;
  int t0 = side(g_, p.p0, q.supporting_curve), t1 = side(g_, p.p1, q.supporting_curve);
  if (t0 * t1 > 0) return;
  if (s0 != 0 && s1 != 0 && t0 != 0 && t1 != 0) {
    Index point = g_.add_crossing(p.supporting_curve, q.supporting_curve, 0);
    splits.push_back({i, point});
    splits.push_back({j, point});
    return;
  }
  // The one common point is an end of at least one of the two.
  Index end = s0 == 0 ? q.p0 : s1 == 0 ? q.p1 : t0 == 0 ? p.p0 : p.p1;
  place(i, end, t0 == 0 ? Within::kAtStart : t1 == 0 ? Within::kAtEnd : Within::kInside);
  place(j, end, s0 == 0 ? Within::kAtStart : s1 == 0 ? Within::kAtEnd : Within::kInside);
}

void PieceMeetings::overlap(Index i, Index j) {
  const Piece &p = pieces_[i], &q = pieces_[j];
  for (Index end : {q.p0, q.p1}) place(i, end, within(g_, p, end));
  for (Index end : {p.p0, p.p1}) place(j, end, within(g_, q, end));
}

Index PieceMeetings::shared_end(const Piece& p, const Piece& q) const {
  if (p.p0 == q.p0 || p.p0 == q.p1) return p.p0;
  if (p.p1 == q.p0 || p.p1 == q.p1) return p.p1;
  return kNone;
}

/// Of two different roots, is `end` (known to be one of them) the first?
bool PieceMeetings::is_root(Index end, Index root_point, Index other_root_point) const {
  const exact::Point &e = g_.points[end], &r = g_.points[root_point], &o = g_.points[other_root_point];
  auto apart = [](const exact::Point& a, const exact::Point& b) {
    double tolerance = (a.error + b.error) * exact::Approx::kGrow;
    return std::abs(a.x - b.x) > tolerance || std::abs(a.y - b.y) > tolerance;
  };
  if (apart(e, r)) return false;
  if (apart(e, o)) return true;
  return compare_xy(g_, end, root_point) == 0;
}

void PieceMeetings::meet_at(Index i, Index j, Index point) {
  const Piece &p = pieces_[i], &q = pieces_[j];
  Within wp = within(g_, p, point);
  if (wp == Within::kOutside) return;
  Within wq = within(g_, q, point);
  if (wq == Within::kOutside) return;
  // Prefer the id of an end, so that known points keep one id.
  Index id = wp == Within::kAtStart   ? p.p0
             : wp == Within::kAtEnd   ? p.p1
             : wq == Within::kAtStart ? q.p0
             : wq == Within::kAtEnd   ? q.p1
                                      : point;
  place(i, id, wp);
  place(j, id, wq);
}

void PieceMeetings::curves(Index i, Index j) {
  const Piece &p = pieces_[i], &q = pieces_[j];
  if (is_chord_inside(g_, p, q) || is_chord_inside(g_, q, p)) return;
  Index shared = shared_end(p, q);
  if (shared != kNone) {
    bool smooth_p = shared == p.p0 ? p.smooth0 : p.smooth1, smooth_q = shared == q.p0 ? q.smooth0 : q.smooth1;
    if (smooth_p && smooth_q) return;  // tangent there: a double root, no further meeting
    if (is_only_meeting(g_, p, q, shared) || is_only_meeting(g_, q, p, shared)) return;
  } else if (is_beside(g_, p, q)) {
    return;
  }
  for (Index end : {p.p0, p.p1, q.p0, q.p1})
    if (touch_at(g_, end, p.supporting_curve, q.supporting_curve)) return end == shared ? void() : meet_at(i, j, end);
  auto m = meet(g_, p.supporting_curve, q.supporting_curve);
  if (m.count == 0 || (m.count == 1 && shared != kNone)) return;
  std::size_t before = g_.points.size();
  Index roots[2] = {kNone, kNone};
  for (int k = 0; k < m.count; ++k) roots[k] = g_.add_crossing(p.supporting_curve, q.supporting_curve, m.root[k]);
  int skip = shared == kNone ? -1 : is_root(shared, roots[0], roots[1]) ? 0 : 1;
  std::size_t known = splits.size();
  for (int k = 0; k < m.count; ++k)
    if (k != skip) meet_at(i, j, roots[k]);
  drop_unused(before, known);
}

/// Of two roots mostly one lies on both pieces: a point that none of the splits from `first` on names goes.
void PieceMeetings::drop_unused(std::size_t first_point, std::size_t first) {
  const std::span<Split> found = std::span(splits).subspan(first);
  const auto is_used = [&](std::size_t point) {
    return std::any_of(found.begin(), found.end(), [&](const Split& s) { return s.point == point; });
  };
  if (g_.points.size() == first_point + 2 && !is_used(first_point)) {
    for (Split& s : found)
      if (s.point == first_point + 1) s.point = Index(first_point);
    g_.points[first_point] = g_.points[first_point + 1];
    g_.points.pop_back();
  }
  if (!is_used(g_.points.size() - 1)) g_.points.pop_back();
}

}  // namespace findspace::plane
