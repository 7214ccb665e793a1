// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/sweep_strips.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/build/moved_geometry.h"

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

/// The classes of half-edges around a vertex, counter-clockwise from the window's direction.
enum Class { kForward = 0, kUp = 1, kBackward = 2, kDown = 3 };

}  // namespace

SweepStrips::SweepStrips(const CellComplex& m, const Window& window)
    : m_(m), window_(window), rightward_(window.dx > 0 || (window.dx == 0 && window.dy > 0)) {
  copy_geometry();
  split_edges();
  upward_.assign(m.vertices.size(), kNone);
  for (Index v = 0; v < m.vertices.size(); ++v) look_around(v);
  lines_.assign(nodes.size(), kNone);
  add_curves();
}

void SweepStrips::copy_geometry() {
  const Index start = append_moved(curves.geometry, m_.geometry, -window_.from);
  end_supporting_curves_ = Index(curves.geometry.supporting_curves.size());
  const Index end = append_moved(curves.geometry, m_.geometry, -window_.to);
  for (const Vertex& v : m_.vertices) {
    nodes.push_back({true, v.mark, v.mark, v.mark});
    start_point.push_back(start + v.point);
    end_point.push_back(end + v.point);
  }
}

void SweepStrips::split_edges() {
  for (Index e = 0; e < m_.edges.size(); ++e) {
    part_start_.push_back(Index(parts.size()));
    if (m_.is_arc(e)) {
      split_arc(e);
    } else {
      parts.push_back({e, m_.edges[e].v0, m_.edges[e].v1, rise_of_line(m_.supporting_curve(e))});
    }
  }
  part_start_.push_back(Index(parts.size()));
}

int SweepStrips::rise_of_line(const SupportingCurve& k) const {
  // From the lexicographically smaller to the larger end: (b, -a) or its opposite.
  const bool flip = k.b <= 0;
  const int128 cross = int128(window_.dx) * (flip ? k.a : -k.a) - int128(window_.dy) * (flip ? -k.b : k.b);
  return (cross > 0) - (cross < 0);
}

/// Travelled to the right, the upper half of a circle turns from straight up to straight down, the lower half back.
void SweepStrips::split_arc(Index e) {
  const Edge& d = m_.edges[e];
  if (window_.dx == 0) {
    parts.push_back({e, d.v0, d.v1, window_.dy > 0 ? -1 : 1});
    return;
  }
  const SupportingCurve& k = m_.supporting_curve(e);
  const int to_right = window_.dx > 0 ? 1 : -1, before = d.half * to_right;
  const Real square(int128(window_.dx) * window_.dx + int128(window_.dy) * window_.dy);
  const Real scale = Real(d.half * to_right) * k.w() / sqrt(square);
  const RealVector at{k.center_x() - scale * Real(window_.dy), k.center_y() + scale * Real(window_.dx)};
  const RealVector in_start = at - window_.from;
  exact::Geometry& g = curves.geometry;
  const Index place = g.add_real_point(in_start.x, in_start.y);
  if (compare_x(g, place, start_point[d.v1]) >= 0) return parts.push_back({e, d.v0, d.v1, before});
  if (compare_x(g, place, start_point[d.v0]) <= 0) return parts.push_back({e, d.v0, d.v1, -before});
  const RealVector in_end = at - window_.to;
  const Index node = Index(nodes.size());
  // The window passes an arc on its outer side.
  const Mark beside = m_.faces[m_.face(d.half > 0 ? 2 * e : 2 * e + 1)].mark;
  nodes.push_back({true, d.mark, beside, beside});
  start_point.push_back(place);
  end_point.push_back(g.add_real_point(in_end.x, in_end.y));
  parts.push_back({e, d.v0, node, before});
  parts.push_back({e, node, d.v1, -before});
}

int SweepStrips::turn_class(Index h) const {
  const StripPart& part = parts[part_at(h)];
  const bool from_p = !(h & 1u);
  if (part.rise != 0) return (part.rise > 0) == from_p ? kUp : kDown;
  return from_p == rightward_ ? kForward : kBackward;
}

/// Of half-edges in counter-clockwise order whose keys rise cyclically: the first with the least key.
Index SweepStrips::first_after(const std::vector<Index>& around, const std::vector<int>& key) const {
  const std::size_t n = around.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (key[(i + n - 1) % n] > key[i]) return around[i];
  }
  // All on one side. The list begins straight down; where that is on the same side, the half-edges before it come
  // first.
  const bool wraps = (turn_class(around[0]) == kUp) != rightward_;
  for (Index h : around) {
    if (wraps && (h & 1u)) return h;
  }
  return around[0];
}

void SweepStrips::look_around(Index v) {
  StripNode& node = nodes[v];
  const Vertex& vertex = m_.vertices[v];
  if (vertex.out == kNone) {
    node.ahead = node.behind = m_.faces[vertex.face].mark;
    return;
  }
  std::vector<Index> around;
  Index h = vertex.out;
  do {
    around.push_back(h);
    h = m_.clockwise(h);
  } while (h != vertex.out);
  std::reverse(around.begin() + 1, around.end());  // counter-clockwise
  std::vector<int> ahead, behind, count(4, 0);
  Index up = kNone;
  for (Index k : around) {
    const int c = turn_class(k);
    ++count[std::size_t(c)];
    ahead.push_back(c);
    behind.push_back((c + 2) % 4);
    if (c == kUp) up = k;
  }
  const Index next = first_after(around, ahead), previous = first_after(around, behind);
  auto beside = [&](Index k, int on) {
    return turn_class(k) == on ? m_.edges[k / 2].mark : m_.faces[m_.face(CellComplex::twin(k))].mark;
  };
  node.ahead = beside(next, kForward);
  node.behind = beside(previous, kBackward);
  const bool through = around.size() == 2 && count[kUp] == 1 && count[kDown] == 1;
  node.event = !through || m_.edges[around[0] / 2].mark != vertex.mark || m_.edges[around[1] / 2].mark != vertex.mark;
  if (!node.event) upward_[v] = part_at(up);
}

Mark SweepStrips::least(Index part) const {
  const Index e = parts[part].edge;
  return std::min({m_.edges[e].mark, m_.faces[m_.face(2 * e)].mark, m_.faces[m_.face(2 * e + 1)].mark});
}

Index SweepStrips::next_in_chain(Index part) const {
  const Index end = high(part);
  return nodes[end].event ? kNone : upward_[end];
}

void SweepStrips::add_curves() {
  for (Index i = 0; i < parts.size(); ++i) {
    if (parts[i].rise != 0) {
      if (nodes[low(i)].event) add_chain(i);
      continue;
    }
    add_copy(Role::kStart, i, true, 0, 0);
    add_copy(Role::kEnd, i, true, 0, 0);
    // Seen from where its near end is at the window's end until its far end is at the window's start.
    const Index near = rightward_ ? parts[i].p : parts[i].q, far = rightward_ ? parts[i].q : parts[i].p;
    add_along(line_of(near), start_point[far], end_point[near], {Role::kPassing, i, m_.edges[parts[i].edge].mark}, 0,
              0);
  }
  for (Index n = 0; n < nodes.size(); ++n) {
    if (nodes[n].event)
      add_along(line_of(n), start_point[n], end_point[n], {Role::kPassing, 0, nodes[n].least()}, 0, 0);
  }
}

/// Counter-clockwise around the strip: up the copy seen at the start, back against the window's direction, down the
/// copy seen at the end, and forth.
void SweepStrips::add_chain(Index first) {
  const Mark mark = least(first);
  std::vector<Index> chain;
  for (Index i = first; i != kNone; i = next_in_chain(i)) chain.push_back(i);
  const Index begin = Index(curves.pieces.size());
  for (Index i : chain) add_copy(Role::kStart, i, true, 1, mark);
  const Index top = high(chain.back()), bottom = low(first);
  add_along(line_of(top), start_point[top], end_point[top], {Role::kSide, 0, 0}, 1, mark);
  for (std::size_t k = chain.size(); k-- > 0;) add_copy(Role::kEnd, chain[k], false, 1, mark);
  add_along(line_of(bottom), end_point[bottom], start_point[bottom], {Role::kSide, 0, 0}, 1, mark);
  const Index end = Index(curves.pieces.size());
  for (Index i = begin; i < end; ++i) corners.push_back({.in = i, .out = i + 1 < end ? i + 1 : begin});
}

Index SweepStrips::add_copy(Role role, Index part, bool upward, std::int32_t weight, Mark mark) {
  const StripPart& s = parts[part];
  const Edge& e = m_.edges[s.edge];
  const std::vector<Index>& point = role == Role::kStart ? start_point : end_point;
  const Index supporting_curve = e.supporting_curve + (role == Role::kStart ? 0 : end_supporting_curves_);
  curves.pieces.push_back({.supporting_curve = supporting_curve, .p0 = point[s.p], .p1 = point[s.q], .half = e.half});
  curves.forward.push_back((s.rise >= 0) == upward);
  sources.push_back({role, part, 0});
  chains.push_back({.forward = (s.rise >= 0) == upward, .displaced_left = true, .weight = weight});
  chain_mark.push_back(mark);
  return Index(curves.pieces.size() - 1);
}

/// A directed segment along the window; a copy seen at the end lies against its direction.
void SweepStrips::add_along(Index line, Index from, Index to, const Source& source, std::int32_t weight, Mark mark) {
  const bool right = compare_xy(curves.geometry, from, to) < 0;
  curves.segment(line, from, to, right);
  sources.push_back(source);
  chains.push_back({.forward = right, .displaced_left = true, .weight = weight});
  chain_mark.push_back(mark);
}

Index SweepStrips::line_of(Index node) {
  if (lines_[node] == kNone) {
    std::int64_t a = window_.dy, b = -window_.dx;
    exact::make_primitive(a, b);
    const RealVector at = curves.geometry.exact(start_point[node]);
    lines_[node] = curves.geometry.add(SupportingCurve::line(a, b, Real(a) * at.x + Real(b) * at.y));
  }
  return lines_[node];
}

}  // namespace findspace::plane
