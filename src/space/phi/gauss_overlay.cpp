// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/gauss_overlay.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace findspace::space {
namespace {

/// The sign of e . f for two edge vectors of at most 2^41: two int128 sums, no filter needed.
int sign_edges(const Grid3& e, const Grid3& f) {
  return exact::sign(int128(e.x) * f.x + int128(e.y) * f.y + int128(e.z) * f.z);
}

/// The circuit of facet f, into a buffer that is used again.
void copy_circuit(const Polytope& p, int f, std::pmr::vector<int>& ring) {
  ring.clear();
  for (int h = p.first_half_edge(f); h < p.first_half_edge(f + 1); ++h) ring.push_back(p.half_edges()[h].origin);
}

}  // namespace

GaussOverlay::GaussOverlay(const Polytope& a, const Polytope& b, ContactSurface& out) : a_(a), b_(b), out_(out) {
  place_.assign(a.facet_count(), -1);
  walked_.assign(a.half_edges().size(), 0);
  const auto expected = static_cast<std::uint64_t>(a.facet_count() + b.facet_count()) * 2 + 16;
  const int bits = std::bit_width(expected) + 1;
  slots_.resize(std::size_t{1} << bits);
  queue_.reserve(std::max(a.facet_count(), b.facet_count()));
  for (auto* buffer : {&tied_, &ring_a_, &ring_b_}) buffer->reserve(16);
  for (auto* buffer : {&flat_p_, &flat_q_}) buffer->reserve(16);
  shift_ = 64 - bits;
  const auto facets = static_cast<std::size_t>(a.facet_count() + b.facet_count()) * 2;
  out_.planes_.reserve(facets);
  out_.contacts_.reserve(facets);
  out_.features_.reserve(facets);
  out_.first_.reserve(facets + 1);
  out_.first_.push_back(0);
  out_.corners_.reserve(facets * 4);
  out_.vertices_.reserve(facets);
  out_.pairs_.reserve(facets);
}

void GaussOverlay::run() {
  locate_first();
  walk_all();
  add_facets_of_b();
}

/// The id of the vertex A[i] - B[j], made when it is met first.
int GaussOverlay::vertex(int i, int j) {
  const std::uint64_t key = (static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j)) + 1;
  std::size_t slot = key * 0x9E3779B97F4A7C15u >> shift_;
  while (slots_[slot].key != 0) {
    if (slots_[slot].key == key) return slots_[slot].id;
    slot = (slot + 1) & (slots_.size() - 1);
  }
  const int id = out_.vertex_count();
  slots_[slot] = {key, id};
  out_.vertices_.push_back(a_.vertices()[i] - b_.vertices()[j]);
  out_.pairs_.push_back({i, j});
  if (2 * out_.vertices_.size() > slots_.size()) grow();
  return id;
}

void GaussOverlay::grow() {
  --shift_;
  slots_.assign(slots_.size() * 2, {});
  for (int id = 0; id < out_.vertex_count(); ++id) {
    const auto [i, j] = out_.pairs_[id];
    const std::uint64_t key = (static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint32_t>(j)) + 1;
    std::size_t slot = key * 0x9E3779B97F4A7C15u >> shift_;
    while (slots_[slot].key != 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = {key, id};
  }
}

void GaussOverlay::finish(Contact contact, int feature_a, int feature_b, const Plane& plane) {
  out_.first_.push_back(static_cast<int>(out_.corners_.size()));
  out_.contacts_.push_back(contact);
  out_.features_.push_back({feature_a, feature_b});
  out_.planes_.push_back(plane);
}

void GaussOverlay::locate_first() {
  int at = 0;
  for (bool better = true; better;) {
    better = false;
    const int begin = b_.outgoing(at);
    int h = begin;
    do {
      if (sign_along(a_, 0, b_, h) < 0) {
        at = b_.target(h);
        better = true;
        break;
      }
      h = b_.turn(h);
    } while (h != begin);
  }
  place_[0] = at;
  queue_.assign(1, 0);
}

void GaussOverlay::walk_all() {
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const int facet = queue_[i];
    add_facet_of_a(facet);
    // add_facet_of_a leaves in `tied_` the vertices of B that are lowest along the normal of the facet.
    for (int h = a_.first_half_edge(facet); h < a_.first_half_edge(facet + 1); ++h) {
      if (walked_[h]) continue;
      const int twin = a_.half_edges()[h].twin;
      walked_[h] = walked_[twin] = 1;
      const int end = walk(h, start_of_walk(h, tied_));
      const int right = a_.half_edges()[h].right;
      if (place_[right] >= 0) continue;
      place_[right] = end;
      queue_.push_back(right);
    }
  }
}

/// FV, FE or FF, by the edges of B at the lowest vertex that are perpendicular to the normal: none, one or two.
void GaussOverlay::add_facet_of_a(int facet) {
  const int at = place_[facet];
  int flat = 0, level[2] = {-1, -1};
  const int begin = b_.outgoing(at);
  int h = begin;
  do {
    if (sign_along(a_, facet, b_, h) == 0) level[flat++] = h;
    h = b_.turn(h);
  } while (h != begin && flat < 2);
  const Plane& plane = a_.planes()[facet];
  tied_.assign(1, at);
  if (flat == 0) {
    for (int e = a_.first_half_edge(facet); e < a_.first_half_edge(facet + 1); ++e) {
      out_.corners_.push_back(vertex(a_.half_edges()[e].origin, at));
    }
    finish(Contact::kFV, facet, at, {plane.normal, plane.offset + exact::dot(plane.normal, b_.vertices()[at])});
    return;
  }
  int feature = level[0];
  if (flat == 1) {
    tied_.push_back(b_.target(feature));
  } else {
    // The two edges are neighbours; the parallel facet lies between them, on the left of the second in turning order.
    feature = b_.half_edges()[b_.turn(level[0]) == level[1] ? level[1] : level[0]].facet;
    copy_circuit(b_, feature, tied_);
    std::reverse(tied_.begin(), tied_.end());
  }
  copy_circuit(a_, facet, ring_a_);
  add_planar_sum(ring_a_, tied_, plane.normal);
  finish(flat == 1 ? Contact::kFE : Contact::kFF, facet, feature,
         {plane.normal, plane.offset + exact::dot(plane.normal, b_.vertices()[at])});
}

/// Of the vertices of B tied at the left end of the arc, the one whose cell holds the moved end: lowest along e, then
/// along the normal at the right end.
int GaussOverlay::start_of_walk(int edge, std::span<const int> tied) const {
  if (tied.size() == 1) return tied[0];
  const Grid3 e = a_.edge(edge);
  const int right = a_.half_edges()[edge].right;
  int best = tied[0];
  for (const int w : tied.subspan(1)) {
    int order = sign_edges(e, b_.vertices()[w] - b_.vertices()[best]);
    if (order == 0) order = sign_along(a_, right, b_, best, w);
    if (order < 0) best = w;
  }
  return best;
}

/// Does the moved arc of `edge` cross the arc of the half-edge `across` of B before it ends?
bool GaussOverlay::leaves(int edge, int across) const {
  if (const int s = sign_along(a_, a_.half_edges()[edge].right, b_, across); s != 0) return s < 0;
  if (const int s = sign_edges(a_.edge(edge), b_.edge(across)); s != 0) return s < 0;
  return sign_along(a_, a_.half_edges()[edge].facet, b_, across) < 0;
}

int GaussOverlay::walk(int edge, int at) {
  const Approx3 e = a_.edge_approx(edge);
  const auto side = [&](int g) {
    const int fast = exact::filtered_sign_dot(b_.normal_approx(g), e);
    return fast != 2 ? fast : exact::sign(exact::dot(b_.planes()[g].normal, a_.edge(edge)));
  };
  // A cell is left over the half-edge whose left facet has a sign >= 0 and whose right facet has one < 0.
  int h = b_.outgoing(at);
  int left = side(b_.half_edges()[h].facet);
  while (left < 0) {
    h = b_.turn(h);
    left = side(b_.half_edges()[h].facet);
  }
  for (;;) {
    int right = side(b_.half_edges()[h].right);
    while (right >= 0) {
      h = b_.turn(h);
      left = right;
      right = side(b_.half_edges()[h].right);
    }
    if (!leaves(edge, h)) return at;
    if (left > 0) add_edge_pair(edge, h);
    at = b_.target(h);
    h = b_.half_edges()[h].next;
    // The new cell is entered over twin(h); the next edge about it has the same left facet, of sign `left`.
  }
}

/// An EE facet, if the crossing is strictly inside both arcs. The two signs of the ends of `across` are known.
void GaussOverlay::add_edge_pair(int edge, int across) {
  const HalfEdge &e = a_.half_edges()[edge], &f = b_.half_edges()[across];
  if (sign_along(a_, e.facet, b_, across) <= 0 || sign_along(a_, e.right, b_, across) >= 0) return;
  // The common factor stays in: to find it costs as much as all the rest, and signs do not need it gone.
  const Wide3 normal = exact::cross(a_.edge(edge), b_.edge(across));
  const int first = vertex(e.origin, f.origin);
  const int ring[4] = {first, vertex(e.origin, f.target), vertex(e.target, f.target), vertex(e.target, f.origin)};
  out_.corners_.insert(out_.corners_.end(), ring, ring + 4);
  finish(Contact::kEE, edge, across, {normal, -exact::dot(normal, out_.vertices_[first])});
}

/// The vertex of A lowest along the normal of facet g of B.
int GaussOverlay::climb(int g, int at) const {
  int h = a_.outgoing(at);
  for (int begin = h;;) {
    if (sign_along(b_, g, a_, h) < 0) {
      at = a_.target(h);
      // Go on behind the edge that led here; it leads upward and is tried last.
      h = begin = a_.turn(a_.half_edges()[h].twin);
      continue;
    }
    h = a_.turn(h);
    if (h == begin) return at;
  }
}

void GaussOverlay::add_facets_of_b() {
  std::pmr::vector<int>& place = place_;
  place.assign(b_.facet_count(), -1);
  place[0] = climb(0, 0);
  queue_.assign(1, 0);
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const int g = queue_[i];
    add_facet_of_b(g, place[g]);
    for (int h = b_.first_half_edge(g); h < b_.first_half_edge(g + 1); ++h) {
      const int next = b_.half_edges()[h].right;
      if (place[next] >= 0) continue;
      place[next] = climb(next, place[g]);
      queue_.push_back(next);
    }
  }
}

/// VF or EF; two level edges of A mean a parallel facet, and then A's turn has made the FF facet.
void GaussOverlay::add_facet_of_b(int g, int at) {
  int flat = 0, level = -1;
  const int begin = a_.outgoing(at);
  int h = begin;
  do {
    if (sign_along(b_, g, a_, h) == 0) {
      level = h;
      ++flat;
    }
    h = a_.turn(h);
  } while (h != begin && flat < 2);
  if (flat == 2) return;
  const Plane& facet = b_.planes()[g];
  const Plane plane{-facet.normal, facet.offset + exact::dot(facet.normal, a_.vertices()[at])};
  if (flat == 0) {
    for (int e = b_.first_half_edge(g + 1) - 1; e >= b_.first_half_edge(g); --e) {
      out_.corners_.push_back(vertex(at, b_.half_edges()[e].origin));
    }
    finish(Contact::kVF, at, g, plane);
    return;
  }
  ring_a_ = {at, a_.target(level)};
  copy_circuit(b_, g, ring_b_);
  std::reverse(ring_b_.begin(), ring_b_.end());
  add_planar_sum(ring_a_, ring_b_, plane.normal);
  finish(Contact::kEF, level, g, plane);
}

}  // namespace findspace::space
