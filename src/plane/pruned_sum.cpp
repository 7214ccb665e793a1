// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/pruned_sum.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "plane/point_winding.h"

namespace findspace::plane {
namespace {

using exact::Carrier;
using exact::Geometry;

struct Extents {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300, length = 0;
};

Extents extents(const ConvolutionBuilder& c) {
  Extents e;
  const auto& points = c.curves.geometry.points;
  for (const Piece& p : c.curves.pieces) {
    const exact::Point &a = points[p.p0], &b = points[p.p1];
    e.x0 = std::min(e.x0, a.x), e.x1 = std::max(e.x1, b.x);
    e.y0 = std::min({e.y0, a.y, b.y}), e.y1 = std::max({e.y1, a.y, b.y});
    e.length += std::hypot(b.x - a.x, b.y - a.y);
  }
  return e;
}

/// Crossings of randomly placed segments (Buffon): squared total length over pi times the area.
double estimated_crossings(const Extents& e) {
  double area = std::max((e.x1 - e.x0) * (e.y1 - e.y0), 1.0);
  return e.length * e.length / (3.14 * area);
}

constexpr std::size_t kFewPieces = 300;
constexpr double kManyCrossings = 3;  // a piece

/// Cuts away what lies in masked cells. A piece is followed along its longer axis; it is cut where it passes from a
/// line of cells that are all masked to one that is not, on the border between them, which is a grid line.
class Cutter {
 public:
  Cutter(Geometry& g, const InnerMask& mask) : g_(g), mask_(mask) {}

  void cut(const Piece& piece, std::vector<Piece>& out) {
    const exact::Point a = g_.points[piece.p0], b = g_.points[piece.p1];
    bool steep = std::abs(b.y - a.y) > b.x - a.x;
    double u0 = steep ? a.y : a.x, v0 = steep ? a.x : a.y, u1 = steep ? b.y : b.x, v1 = steep ? b.x : b.y;
    bool turned = u1 < u0;
    if (turned) std::swap(u0, u1), std::swap(v0, v1);
    Index from = turned ? piece.p1 : piece.p0, to = turned ? piece.p0 : piece.p1;
    std::int64_t first = mask_.line_of(u0), last = mask_.line_of(u1);
    Index open = kNone;  // start of the part that is kept at present
    for (std::int64_t line = first; line <= last; ++line) {
      bool masked = covered(line, u0, v0, u1, v1, steep);
      if (!masked && open == kNone) open = line == first ? from : border(piece, line, steep);
      if (masked && open != kNone) keep(piece, open, border(piece, line, steep), turned, out), open = kNone;
    }
    if (open != kNone) keep(piece, open, to, turned, out);
  }

 private:
  /// Is the part of the piece over this line of cells in masked cells only?
  bool covered(std::int64_t line, double u0, double v0, double u1, double v1, bool steep) const {
    double low = std::max(u0, double(mask_.border(line))), high = std::min(u1, double(mask_.border(line + 1)));
    double slope = u1 > u0 ? (v1 - v0) / (u1 - u0) : 0, va = v0 + slope * (low - u0), vb = v0 + slope * (high - u0);
    // Two grid steps are far more than the rounding of these doubles (2^43 steps at most).
    std::int64_t c0 = mask_.line_of(std::min(va, vb) - 2), c1 = mask_.line_of(std::max(va, vb) + 2);
    for (std::int64_t c = c0; c <= c1; ++c)
      if (!(steep ? mask_.covers(c, line) : mask_.covers(line, c))) return false;
    return true;
  }

  Index border(const Piece& piece, std::int64_t line, bool steep) {
    auto [at, fresh] = lines_.try_emplace(2 * line + steep, 0);
    if (fresh) at->second = g_.add(Carrier::line(steep ? 0 : 1, steep ? 1 : 0, exact::int128(mask_.border(line))));
    return g_.add_crossing(piece.carrier, at->second, 0);
  }

  void keep(const Piece& piece, Index from, Index to, bool turned, std::vector<Piece>& out) const {
    if (g_.compare_xy(from, to) == 0) return;
    Piece part = piece;
    part.p0 = turned ? to : from;
    part.p1 = turned ? from : to;
    out.push_back(part);
  }

  Geometry& g_;
  const InnerMask& mask_;
  std::unordered_map<std::int64_t, Index> lines_;
};

/// A piece that is left, or a part of one.
struct KeptPiece {
  bool inner_left = false;  // its inner side is to the left of p0 -> p1
  /// Whether the displaced curve passes between its end and the directions on its inner side. Not at a corner that
  /// turns round the other way, nor twice at one that turns left into another kept piece.
  bool hides_at_p0 = true, hides_at_p1 = true;
};

std::vector<KeptPiece> describe(const ConvolutionBuilder& c) {
  std::vector<KeptPiece> out(c.strands.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k].inner_left = c.strands[k].forward;
  for (const Corner& k : c.corners) {
    bool in = c.strands[k.in].displaced_left, next = c.strands[k.out].displaced_left;
    bool start_hides = k.rotation < 0, end_hides = start_hides || (in && next);
    (c.strands[k.in].forward ? out[k.in].hides_at_p1 : out[k.in].hides_at_p0) = end_hides;
    (c.strands[k.out].forward ? out[k.out].hides_at_p0 : out[k.out].hides_at_p1) = start_hides;
  }
  return out;
}

/// Labels the arrangement of what is left.
class Labels {
 public:
  Labels(Arrangement a, const std::vector<KeptPiece>& kept, const PointWinding& winding, std::int32_t base)
      : a_(std::move(a)), kept_(kept), winding_(winding) {
    face_in_.assign(a_.face_count, 0);
    face_in_[0] = base > 0;
    mark_sides();
    decide_faces();
    decide_edges();
    decide_vertices();
  }

  SignMap result() {
    Marks m;
    for (char in : face_in_) m.faces.push_back(in ? -1 : 1);
    for (Index e = 0; e < a_.edge_count(); ++e) m.edges.push_back(edge_in_[e] ? -1 : beside(e) ? 0 : 1);
    for (Index v = 0; v < a_.vertex_count(); ++v) {
      bool near = face_in_[a_.some_face(v)];
      for (Index k = a_.out_start[v]; !near && k < a_.out_start[v + 1]; ++k) near = face_in_[a_.face[a_.out[k]]];
      m.vertices.push_back(vertex_in_[v] ? -1 : near ? 0 : 1);
    }
    return extract(a_, m);
  }

 private:
  static constexpr char kThrough = 1, kEnd = 2;

  bool beside(Index e) const { return face_in_[a_.face[2 * e]] || face_in_[a_.face[2 * e + 1]]; }

  /// side_[h]: the left side of half-edge h is the inner side of a curve.
  void mark_sides() {
    side_.assign(2 * std::size_t(a_.edge_count()), 0);
    hides_.assign(4 * std::size_t(a_.edge_count()), 0);
    for (Index e = 0; e < a_.edge_count(); ++e)
      for (Index k = a_.cover_start[e]; k < a_.cover_start[e + 1]; ++k) {
        const KeptPiece& s = kept_[a_.cover[k]];
        side_[2 * e + (s.inner_left ? 0 : 1)] = 1;
        const Piece& p = a_.pieces[a_.cover[k]];
        // Half-edge 2e has the inner side on its left if the piece has; 2e + 1 the other way round.
        bool starts = a_.point_vertex[p.p0] == a_.edges[e].v0, ends = a_.point_vertex[p.p1] == a_.edges[e].v1;
        hides_[4 * e + (s.inner_left ? 0 : 1)] |= !starts ? kThrough : s.hides_at_p0 ? kEnd : 0;
        hides_[4 * e + (s.inner_left ? 3 : 2)] |= !ends ? kThrough : s.hides_at_p1 ? kEnd : 0;
      }
    for (Index h = 0; h < side_.size(); ++h)
      if (side_[h]) face_in_[a_.face[h]] = 1;
  }

  /// A face all of whose sides are outer sides has the number of any of its edges, displaced away from it.
  void decide_faces() {
    std::vector<char> known(a_.face_count, 0);
    known[0] = 1;
    for (Index h = 0; h < side_.size(); ++h) {
      Index f = a_.face[h];
      if (face_in_[f] || known[f]) continue;
      known[f] = 1;
      if (number_of_edge(h / 2) > 0) face_in_[f] = 1;
    }
  }

  void decide_edges() {
    edge_in_.assign(a_.edge_count(), 0);
    for (Index e = 0; e < a_.edge_count(); ++e) {
      bool both = face_in_[a_.face[2 * e]] && face_in_[a_.face[2 * e + 1]];
      // With curves of one side only, the edge goes with the face on their outer side.
      edge_in_[e] = both && (!(side_[2 * e] && side_[2 * e + 1]) || number_of_edge(e) > 0);
    }
  }

  void decide_vertices() {
    vertex_in_.assign(a_.vertex_count(), 0);
    for (Index v = 0; v < a_.vertex_count(); ++v) {
      bool inside = face_in_[a_.some_face(v)];
      for (Index k = a_.out_start[v]; inside && k < a_.out_start[v + 1]; ++k)
        inside = face_in_[a_.face[a_.out[k]]] && edge_in_[a_.out[k] / 2];
      vertex_in_[v] = inside && (!surrounded(v) || winding_.at(a_.geometry, a_.vertex_point[v]) > 0);
    }
  }

  /// Only where every direction is the inner side of some curve at the vertex can it be a single point outside the open
  /// sum.
  bool surrounded(Index v) {
    Index d = a_.degree(v);
    const Index* out = a_.out.data() + a_.out_start[v];
    // Each curve covers less than half a turn; two cannot cover a whole one. A curve passing through is seen on both
    // its edges.
    int twice = 0;
    for (Index r = 0; r < d; ++r)
      for (char hides : {hides_[2 * out[r]], hides_[2 * out[r] + 1]})
        twice += (hides & kThrough ? 1 : 0) + (hides & kEnd ? 2 : 0);
    if (twice < 6) return false;
    covered_.assign(d, 0);
    for (Index r = 0; r < d; ++r) {
      if (hides_[2 * out[r]])  // sectors counter-clockwise from out[r], through half a turn
        for (Index s = 0; s < d && (s == 0 || left_of(v, out[r], out[(r + s) % d])); ++s) covered_[(r + s) % d] = 1;
      if (hides_[2 * out[r] + 1])  // sectors clockwise
        for (Index s = 1; s <= d && (s == 1 || left_of(v, out[(r + d - s + 1) % d], out[r])); ++s)
          covered_[(r + d - s) % d] = 1;
    }
    return std::all_of(covered_.begin(), covered_.end(), [](char c) { return c != 0; });
  }

  bool left_of(Index v, Index h, Index k) const {
    auto heading = [&](Index half_edge) {
      Index carrier = a_.edges[half_edge / 2].carrier;
      return Geometry::Heading{carrier, (a_.geometry.carriers[carrier].b > 0) == !(half_edge & 1u)};
    };
    return a_.geometry.turn(a_.vertex_point[v], heading(h), heading(k)) > 0;
  }

  std::int32_t number_of_edge(Index e) {
    const Arrangement::Edge& d = a_.edges[e];
    return winding_.at(a_.geometry, point_between(d.carrier, a_.vertex_point[d.v0], a_.vertex_point[d.v1]));
  }

  /// A point of the carrier strictly between two of its points.
  Index point_between(Index carrier, Index p, Index q) {
    Geometry& g = a_.geometry;
    const exact::Point s = g.points[p], t = g.points[q];
    for (bool steep : {false, true}) {
      double u = steep ? s.y : s.x, w = steep ? t.y : t.x, low = std::min(u, w) + std::max(s.error, t.error) + 1,
             high = std::max(u, w) - std::max(s.error, t.error) - 1, middle = std::floor((low + high) / 2);
      if (!(low < middle && middle < high)) continue;
      Index line = g.add(Carrier::line(steep ? 0 : 1, steep ? 1 : 0, exact::int128(middle)));
      return g.add_crossing(carrier, line, 0);
    }
    exact::RealPoint a = g.exact(p), b = g.exact(q);
    return g.add_real_point((a.x + b.x) / exact::Real(2), (a.y + b.y) / exact::Real(2));
  }

  Arrangement a_;
  const std::vector<KeptPiece>& kept_;
  const PointWinding& winding_;
  std::vector<char> face_in_, edge_in_, vertex_in_, side_;
  std::vector<char> hides_;    // per half-edge: at its origin, directions to its left / right may lie behind its curve
  std::vector<char> covered_;  // scratch
};

}  // namespace

bool pruning_pays(const ConvolutionBuilder& c) {
  if (c.curves.pieces.size() < kFewPieces) return false;
  for (const Piece& p : c.curves.pieces)
    if (p.half != 0 || !c.curves.geometry.carriers[p.carrier].grid) return false;
  return estimated_crossings(extents(c)) > kManyCrossings * double(c.curves.pieces.size());
}

SignMap pruned_open_sum(ConvolutionBuilder c, std::int32_t base, std::span<const InnerMask::Pair> pairs) {
  Extents e = extents(c);
  // As many cells as there are curves, so that a cell holds a few of them.
  double lines = std::clamp(std::sqrt(double(c.curves.pieces.size())) * 2, 64.0, 600.0);
  std::int64_t side = 2 * std::max<std::int64_t>(std::int64_t(std::max(e.x1 - e.x0, e.y1 - e.y0) / lines / 2), 8);
  InnerMask mask(pairs, side);
  PointWinding winding(c, base);
  std::vector<Piece> pieces;
  std::vector<KeptPiece> kept, all = describe(c);
  Cutter cutter(c.curves.geometry, mask);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!c.strands[k].displaced_left) continue;  // arises at a reflex vertex
    std::size_t first = pieces.size();
    cutter.cut(c.curves.pieces[k], pieces);
    for (std::size_t i = first; i < pieces.size(); ++i) {
      kept.push_back(all[k]);  // ends made by cutting lie inside the sum anyway
      kept.back().hides_at_p0 |= pieces[i].p0 != c.curves.pieces[k].p0;
      kept.back().hides_at_p1 |= pieces[i].p1 != c.curves.pieces[k].p1;
    }
  }
  Arrangement a = arrange(std::move(c.curves.geometry), std::move(pieces));
  return Labels(std::move(a), kept, winding, base).result();
}

}  // namespace findspace::plane
