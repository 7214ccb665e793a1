// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The overlay of the Gauss maps of A and of -B behind ContactSurface. Write n for an outward normal of A - B: the facet
// there is (face of A highest along n) - (face of B lowest along n), so the map of B is read at -n.
//
// 1. Each facet h of A is located in the map of B: the vertices of B lowest along n(h) give FV, FE or FF.
// 2. The arc of each edge e of A, from n(left) to n(right), is walked through the cells of B's vertices. Where it
// crosses
//    the arc of an edge f of B there is an EE facet. The walk also locates the facet at its far end.
// 3. Each facet g of B is located in the map of A by climbing from its neighbour's place: VF or EF (FF is known).
//
// Degenerate arcs. On the walk of e a facet normal g of B with e . g = 0 (the arc meets a node of the map) counts as
// e . g > 0, which moves the arc's plane to e . m = -epsilon as seen from B; the ends of the arc move with it. The
// moved arc crosses every edge that the true one crosses in the interior of both, and perhaps others; those fail the
// strict test for EE (both signs at the ends of f, both at the ends of e) and are passed over.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "space/phi/contact_surface.h"

namespace findspace::space {

class GaussOverlay {
 public:
  GaussOverlay(const Polytope& a, const Polytope& b, ContactSurface& out);
  void run();

  /// A point in the plane of a facet, along two coordinates.
  struct Flat {
    std::int64_t x = 0, y = 0;
    friend auto operator<=>(const Flat&, const Flat&) = default;
  };

 private:
  void locate_first();
  void walk_all();
  void add_facet_of_a(int h);
  int start_of_walk(int edge, std::span<const int> tied) const;
  int walk(int edge, int at);
  bool leaves(int edge, int across) const;
  void add_edge_pair(int edge, int across);
  void add_facets_of_b();
  void add_facet_of_b(int g, int at);
  int climb(int g, int at) const;
  int vertex(int i, int j);
  void finish(Contact contact, int feature_a, int feature_b, const Plane& plane);
  void add_planar_sum(std::span<const int> p, std::span<const int> q, const Wide3& normal);
  void grow();

  const Polytope& a_;
  const Polytope& b_;
  ContactSurface& out_;
  // Arena comes from here: for small bodies nothing is allocated but the surface itself.
  std::array<std::byte, 8192> buffer_;
  std::pmr::monotonic_buffer_resource arena_{buffer_.data(), buffer_.size()};
  std::pmr::vector<int> place_{&arena_};  // of each facet of A: one lowest vertex of B, or -1
  std::pmr::vector<int> queue_{&arena_}, tied_{&arena_}, ring_a_{&arena_}, ring_b_{&arena_};
  std::pmr::vector<Flat> flat_p_{&arena_}, flat_q_{&arena_};  // of the planar sum in hand
  std::pmr::vector<char> walked_{&arena_};                    // half-edges of A whose arc is done
  struct Slot {
    std::uint64_t key = 0;  // (i, j) + 1
    int id = 0;
  };
  std::pmr::vector<Slot> slots_{&arena_};  // open addressing
  int shift_ = 0;
};

}  // namespace findspace::space
