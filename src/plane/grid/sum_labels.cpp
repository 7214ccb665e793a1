// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/sum_labels.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/walk/point_between.h"

namespace findspace::plane {
namespace {

using exact::Geometry;
using exact::SupportingCurve;

/// Labels the arrangement of what is left.
class Labels {
 public:
  Labels(Arrangement a, const std::vector<InnerSide>& sides, bool unbounded_inside, const InsideTest& inside,
         Memory memory)
      : a_(std::move(a)),
        sides_(sides),
        inside_(inside),
        memory_(memory),
        face_in_(memory),
        edge_in_(memory),
        vertex_in_(memory),
        side_(memory),
        hides_(memory),
        covered_(memory) {
    face_in_.assign(a_.face_count, 0);
    face_in_[0] = unbounded_inside;
    mark_sides();
    decide_faces();
    decide_edges();
    decide_vertices();
  }

  SignMap result() {
    ArenaVector<Mark> faces(memory_), edges(memory_), vertices(memory_);
    faces.reserve(a_.face_count);
    edges.reserve(a_.edge_count());
    vertices.reserve(a_.vertex_count());
    for (char in : face_in_) faces.push_back(in ? -1 : 1);
    for (Index e = 0; e < a_.edge_count(); ++e) edges.push_back(edge_in_[e] ? -1 : beside(e) ? 0 : 1);
    for (Index v = 0; v < a_.vertex_count(); ++v) {
      bool near = face_in_[a_.some_face(v)];
      for (Index k = a_.out_start[v]; !near && k < a_.out_start[v + 1]; ++k) near = face_in_[a_.face[a_.out[k]]];
      vertices.push_back(vertex_in_[v] ? -1 : near ? 0 : 1);
    }
    return extract(std::move(a_), MarkViews(faces, edges, vertices));
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
        if (a_.cover[k] >= sides_.size()) continue;
        const InnerSide& s = sides_[a_.cover[k]];
        side_[2 * e + (s.left ? 0 : 1)] = 1;
        const Piece& p = a_.pieces[a_.cover[k]];
        // Half-edge 2e has the inner side on its left if the piece has; 2e + 1 the other way round.
        bool starts = a_.point_vertex[p.p0] == a_.edges[e].v0, ends = a_.point_vertex[p.p1] == a_.edges[e].v1;
        hides_[4 * e + (s.left ? 0 : 1)] |= !starts ? kThrough : s.hides_at_p0 ? kEnd : 0;
        hides_[4 * e + (s.left ? 3 : 2)] |= !ends ? kThrough : s.hides_at_p1 ? kEnd : 0;
      }
    for (Index h = 0; h < side_.size(); ++h)
      if (side_[h]) face_in_[a_.face[h]] = 1;
  }

  /// A face all of whose sides are outer sides has the number of any of its edges, displaced away from it.
  void decide_faces() {
    ArenaVector<char> known(a_.face_count, 0, memory_);
    known[0] = 1;
    for (Index h = 0; h < side_.size(); ++h) {
      Index f = a_.face[h];
      if (face_in_[f] || known[f]) continue;
      known[f] = 1;
      if (edge_inside(h / 2)) face_in_[f] = 1;
    }
  }

  void decide_edges() {
    edge_in_.assign(a_.edge_count(), 0);
    for (Index e = 0; e < a_.edge_count(); ++e) {
      bool both = face_in_[a_.face[2 * e]] && face_in_[a_.face[2 * e + 1]];
      // With curves of one side only, the edge goes with the face on their outer side.
      edge_in_[e] = both && (!(side_[2 * e] && side_[2 * e + 1]) || edge_inside(e));
    }
  }

  void decide_vertices() {
    vertex_in_.assign(a_.vertex_count(), 0);
    for (Index v = 0; v < a_.vertex_count(); ++v) {
      bool inside = face_in_[a_.some_face(v)];
      for (Index k = a_.out_start[v]; inside && k < a_.out_start[v + 1]; ++k)
        inside = face_in_[a_.face[a_.out[k]]] && edge_in_[a_.out[k] / 2];
      vertex_in_[v] = inside && (!surrounded(v) || inside_(a_.geometry, a_.vertex_point[v]));
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
      Index supporting_curve = a_.edges[half_edge / 2].supporting_curve;
      return exact::Heading{supporting_curve,
                            (a_.geometry.supporting_curves[supporting_curve].b > 0) == !(half_edge & 1u)};
    };
    return turn(a_.geometry, a_.vertex_point[v], heading(h), heading(k)) > 0;
  }

  bool edge_inside(Index e) {
    const Arrangement::Edge& d = a_.edges[e];
    return inside_(a_.geometry,
                   point_between(a_.geometry, d.supporting_curve, a_.vertex_point[d.v0], a_.vertex_point[d.v1]));
  }

  Arrangement a_;
  const std::vector<InnerSide>& sides_;
  const InsideTest& inside_;
  Memory memory_;
  ArenaVector<char> face_in_, edge_in_, vertex_in_, side_;
  ArenaVector<char> hides_;    // per half-edge: at its origin, directions to its left / right may lie behind its curve
  ArenaVector<char> covered_;  // arena
};

}  // namespace

SignMap labelled_sum(Arrangement a, const std::vector<InnerSide>& sides, bool unbounded_inside,
                     const InsideTest& inside) {
  Arena arena(a.edges.size());
  return Labels(std::move(a), sides, unbounded_inside, inside, arena.memory()).result();
}

}  // namespace findspace::plane
