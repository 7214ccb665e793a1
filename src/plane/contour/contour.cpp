// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Checking and normalising rings. A single ring that is seen whole from the mean of its corners is simple. Else pairs
// of edges whose boxes meet are found by a tree of boxes over all edges (contour_boxes.h); each pair is then decided
// exactly in contour_meet.cpp.
#include "plane/contour/contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "exact/margins/plane.h"
#include "findspace/error.h"
#include "plane/base/arena.h"
#include "plane/contour/contour_boxes.h"
#include "plane/contour/contour_meet.h"
#include "plane/contour/nesting_depths.h"
#include "plane/contour/star_shaped.h"

namespace findspace::plane {
namespace {

/// How messages call a ring by its number.
using Label = std::string (*)(std::size_t);

std::string outer_or_hole(std::size_t i) { return i == 0 ? "the ring" : fmt::format("hole {}", i - 1); }
std::string any_ring(std::size_t i) { return fmt::format("ring {}", i); }

/// A ring, whose repeated points are dropped, and where its edges stood in the input.
struct Ring {
  Contour& edges;
  std::size_t number;
  Label name;
  std::vector<std::size_t> source{};  // empty where nothing was dropped
  bool straight = true;               // it has no arcs
  int way = 0;                        // its orientation where the check has shown it

  std::string label() const { return name(number); }
  GridPoint end(std::size_t i) const { return edges[i + 1 == edges.size() ? 0 : i + 1].start; }
  Span span(std::size_t i) const { return span_of(edges, i); }
  std::size_t given(std::size_t i) const { return source.empty() ? i : source[i]; }
};

[[noreturn]] void fail(const std::string& message, double x, double y, double step) {
  throw Error(ErrorCode::kGeometry, message).at(x * step, y * step);
}

std::string show(double x, double y, double step) { return fmt::format("({:.10g}, {:.10g})", x * step, y * step); }

void drop_repeated(Ring& ring) {
  Contour kept;
  kept.reserve(ring.edges.size());
  for (std::size_t i = 0; i < ring.edges.size(); ++i) {
    if (ring.edges[i].start == ring.end(i)) continue;
    kept.push_back(ring.edges[i]);
    ring.source.push_back(i);
  }
  ring.edges = std::move(kept);
}

Ring clean(Contour& edges, std::size_t number, Label name, std::int64_t& repeated, double step) {
  const GridPoint first = edges.empty() ? GridPoint{} : edges[0].start;
  Ring ring{edges, number, name};
  std::int64_t same = 0;
  bool arcs = false;
  for (std::size_t k = 0, before = edges.size() - 1; k < edges.size(); before = k++) {
    const bool moves = edges[before].start != edges[k].start;
    same += !moves;
    arcs |= moves && edges[before].arc;
  }
  ring.straight = !arcs;
  if (same > 0) drop_repeated(ring);
  repeated += same;
  if (edges.size() < (arcs ? 2u : 3u)) {
    fail(fmt::format("{} has no area: fewer than three different points", ring.label()), double(first.x),
         double(first.y), step);
  }
  return ring;
}

/// A ring of segments that all lie on one line: decided apart from self-intersection for the sake of the message.
bool flat(const Ring& ring) {
  GridPoint o = ring.edges[0].start, a = ring.end(0);
  return std::all_of(ring.edges.begin(), ring.edges.end(),
                     [&](const ContourEdge& e) { return !e.arc && cross(o, a, e.start) == 0; });
}

std::string edge_label(const Ring& ring, std::size_t i, double step) {
  GridPoint p = ring.edges[i].start, q = ring.end(i);
  return fmt::format("{} {} from {} to {}", ring.edges[i].arc ? "arc" : "edge", ring.given(i),
                     show(double(p.x), double(p.y), step), show(double(q.x), double(q.y), step));
}

struct EdgeId {
  std::uint32_t ring, edge;
};

[[noreturn]] void fail_meeting(const Ring& a, std::size_t i, const Ring& b, std::size_t j, const CommonPoint& m,
                               double step) {
  const char* how = m.along ? "run along each other" : "meet";
  std::string what = &a == &b ? fmt::format("{} touches or crosses itself", a.label())
                              : fmt::format("{} touches or crosses {}", b.label(), a.label());
  std::string first = edge_label(a, i, step), second = edge_label(b, j, step);
  if (&a != &b) {
    first = a.label() + ", " + first;
    second = b.label() + ", " + second;
  }
  fail(fmt::format("{}: {} and {} {} at {}", what, first, second, how, show(m.x, m.y, step)), m.x, m.y, step);
}

void check_pair(std::span<const Ring> rings, EdgeId f, EdgeId g, double step) {
  if (f.ring > g.ring || (f.ring == g.ring && f.edge > g.edge)) std::swap(f, g);
  const Ring &a = rings[f.ring], &b = rings[g.ring];
  Span s = a.span(f.edge), t = b.span(g.edge);
  bool same = f.ring == g.ring;
  bool next = same && f.edge + 1 == g.edge;
  bool wrap = same && f.edge == 0 && g.edge + 1 == a.edges.size();
  const GridPoint* joined = next ? &s.to : wrap ? &s.from : nullptr;
  if (auto m = meet(s, t, joined, next && wrap)) fail_meeting(a, f.edge, b, g.edge, *m, step);
}

[[gnu::noinline]] Box box_of_arc(const ContourEdge& edge, GridPoint to, const Box& chord) {
  auto reach = std::int64_t(sagitta(edge, to) + edge.arc->r.to_double() * margin::kApothemSlack) + 2;
  return {chord.x0 - reach, chord.y0 - reach, chord.x1 + reach, chord.y1 + reach};
}

inline Box box_of(const ContourEdge& edge, GridPoint to) {
  const GridPoint from = edge.start;
  const Box box{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x), std::max(from.y, to.y)};
  return edge.arc ? box_of_arc(edge, to, box) : box;
}

/// +1 of a segment to the right, or straight up, -1 of one to the left, 0 of an arc.
int way_of(const ContourEdge& edge, const GridPoint& to) {
  if (edge.arc) return 0;
  return edge.start.x < to.x || (edge.start.x == to.x && edge.start.y < to.y) ? 1 : -1;
}

/// Edges of a ring that follow each other share a vertex: of segments only folding back onto each other is a fault.
void check_neighbours(std::span<const Ring> rings, std::uint32_t r, std::size_t before, std::size_t k, double step) {
  const Contour& edges = rings[r].edges;
  const bool segments = !edges[before].arc && !edges[k].arc;
  if (segments && cross(edges[before].start, edges[k].start, rings[r].end(k)) != 0) return;
  check_pair(rings, {r, std::uint32_t(before)}, {r, std::uint32_t(k)}, step);
}

/// The edges of all rings, one after the other.
struct EdgeBoxes {
  EdgeBoxes(std::size_t count, Memory memory) : boxes(memory), chains(memory), first(memory) {
    boxes.reserve(count);
    chains.reserve(count);
  }

  std::uint32_t ring_of(std::size_t i) const {
    if (first.size() == 1) return 0;
    return std::uint32_t(std::upper_bound(first.begin(), first.end(), i) - first.begin() - 1);
  }

  ArenaVector<Box> boxes;
  ArenaVector<std::uint32_t> chains;  // where begin the segments that all run to the right, or left, up to each
  ArenaVector<std::size_t> first;     // of each ring
};

/// Checks neighbours as well: those that both run to the right, or left, cannot fold back.
void add_edges(std::span<const Ring> rings, std::uint32_t r, EdgeBoxes& to, double step) {
  const Contour& edges = rings[r].edges;
  const std::size_t n = edges.size();
  to.first.push_back(to.boxes.size());
  int before = way_of(edges[n - 1], edges[0].start);
  for (std::size_t k = 0; k < n; ++k) {
    const GridPoint& end = edges[k + 1 == n ? 0 : k + 1].start;
    const int way = way_of(edges[k], end);
    const bool runs_on = way != 0 && way == before;
    if (!runs_on) check_neighbours(rings, r, k == 0 ? n - 1 : k - 1, k, step);
    to.chains.push_back(runs_on && k > 0 ? to.chains.back() : std::uint32_t(to.boxes.size()));
    to.boxes.push_back(box_of(edges[k], end));
    before = way;
  }
}

/// Its orientation, if it is seen whole from the mean of its corners.
int star_orientation(const Ring& ring) {
  if (!ring.straight) return 0;
  return star_shaped(ring.edges.size(), [at = ring.edges.data()](std::size_t k) { return at[k].start; });
}

void check_edges(std::span<const Ring> rings, double step, Memory memory) {
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.edges.size();
  EdgeBoxes edges(count, memory);
  for (std::uint32_t r = 0; r < rings.size(); ++r) add_edges(rings, r, edges, step);
  for_meeting_boxes(edges.boxes, edges.chains, [&](std::size_t i, std::size_t j) {
    const std::uint32_t r = edges.ring_of(i), s = edges.ring_of(j);
    const std::size_t apart = i < j ? j - i : i - j;
    if (r == s && (apart == 1 || apart + 1 == rings[r].edges.size())) return;  // neighbours
    check_pair(rings, {r, std::uint32_t(i - edges.first[r])}, {s, std::uint32_t(j - edges.first[s])}, step);
  });
}

Box box_of(const Contour& ring) {
  Box all = box_of(ring[0], end_of(ring, 0));
  for (std::size_t i = 1; i < ring.size(); ++i) all = all.joined(box_of(ring[i], end_of(ring, i)));
  return all;
}

using Rings = ArenaVector<Ring>;

/// Of the contours, which stay where they are.
Rings clean_and_check(std::span<Contour> contours, Label name, std::int64_t& repeated, double step, Memory memory) {
  Rings rings(memory);
  rings.reserve(contours.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    rings.push_back(clean(contours[i], i, name, repeated, step));
    Ring& ring = rings.back();
    if (contours.size() == 1) ring.way = star_orientation(ring);
    if (ring.way == 0 && flat(ring)) {
      const GridPoint p = ring.edges[0].start;
      fail(fmt::format("{} has no area: all its points are on one line", ring.label()), double(p.x), double(p.y), step);
    }
  }
  if (rings.size() != 1 || rings[0].way == 0) check_edges(rings, step, memory);
  return rings;
}

void direct(Ring& ring, int wanted, std::int64_t& reversed_so_far) {
  if ((ring.way != 0 ? ring.way : orientation(ring.edges)) == wanted) return;
  ++reversed_so_far;
  ring.edges = reversed(ring.edges);
}

std::size_t edge_count(std::span<const Contour> rings) {
  std::size_t count = 0;
  for (const Contour& ring : rings) count += ring.size();
  return count;
}

std::vector<Box> boxes_of(const Rings& rings) {
  std::vector<Box> boxes;
  boxes.reserve(rings.size());
  for (const Ring& ring : rings) boxes.push_back(box_of(ring.edges));
  return boxes;
}

void check_holes(const Rings& rings, double step) {
  if (rings.size() == 1) return;
  const std::vector<Box> boxes = boxes_of(rings);
  const auto corner = [&](std::size_t i) { return rings[i].edges[0].start; };
  std::size_t outside = 1;  // the first that is not inside the outer ring
  while (outside < rings.size() && encloses(rings[0].edges, corner(outside))) ++outside;
  std::size_t last = outside - 1;  // no later one can be the first that lies in another
  const auto around = meeting_others(boxes, [&](std::size_t i, std::size_t j) {
    const GridPoint p = corner(i);
    if (i == 0 || j == 0 || i > last || !boxes[j].holds(p.x, p.y) || !encloses(rings[j].edges, p)) return false;
    last = i;
    return true;
  });
  const auto refuse = [&](std::size_t i, const std::string& message) {
    fail(message, double(corner(i).x), double(corner(i).y), step);
  };
  for (std::size_t i = 1; i < outside; ++i)
    if (!around[i].empty()) refuse(i, fmt::format("{} is inside {}", rings[i].label(), rings[around[i][0]].label()));
  if (outside == rings.size()) return;
  const GridPoint p = corner(outside);
  refuse(outside, fmt::format("{} is not inside {}: its vertex {} is outside", rings[outside].label(), rings[0].label(),
                              show(double(p.x), double(p.y), step)));
}

}  // namespace

RingSet make_rings(std::vector<Contour> input, double step) {
  RingSet set;
  Arena arena(edge_count(input));
  Rings rings = clean_and_check(input, outer_or_hole, set.repeated_points, step, arena.memory());
  check_holes(rings, step);
  for (Ring& ring : rings) {
    std::int64_t ignored = 0;  // either direction of a hole is usual
    direct(ring, ring.number == 0 ? 1 : -1, ring.number == 0 ? set.reversed_rings : ignored);
  }
  set.contours = std::move(input);
  return set;
}

std::vector<RingSet> nest_rings(std::vector<Contour> input, double step) {
  std::int64_t repeated = 0, ignored = 0;
  Arena arena(edge_count(input));
  Rings rings = clean_and_check(input, any_ring, repeated, step, arena.memory());
  const std::vector<Box> boxes = boxes_of(rings);
  const auto around = meeting_others(boxes, [&](std::size_t i, std::size_t j) {
    const GridPoint p = rings[i].edges[0].start;
    return boxes[j].holds(p.x, p.y) && encloses(rings[j].edges, p);
  });
  std::vector<std::vector<std::size_t>> holes(rings.size());
  for (std::size_t h = 0; h < rings.size(); ++h) {
    if (around[h].size() % 2 == 0) continue;
    for (const std::size_t i : around[h])
      if (around[i].size() + 1 == around[h].size()) holes[i].push_back(h);
  }
  std::vector<RingSet> sets;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 != 0) continue;
    RingSet& set = sets.emplace_back();
    direct(rings[i], 1, ignored);
    set.contours.push_back(std::move(input[i]));
    for (const std::size_t h : holes[i]) {
      direct(rings[h], -1, ignored);
      set.contours.push_back(std::move(input[h]));
    }
  }
  if (!sets.empty()) sets[0].repeated_points = repeated;
  return sets;
}

namespace {

Contour distinct(Contour edges) {
  Ring ring{edges, 0, any_ring};
  drop_repeated(ring);
  return edges;
}

/// Of two rings, the corners of one being all corners of the other: whether it goes inside.
bool goes_inside(const Contour& ring, const Contour& other) {
  if (ring.size() < 2 || other.size() < 2) return false;
  std::vector<std::pair<GridPoint, std::size_t>> corners;  // of the other, each with the edge that begins there
  for (std::size_t k = 0; k < other.size(); ++k) corners.emplace_back(other[k].start, k);
  std::sort(corners.begin(), corners.end());
  const int way = orientation(other);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto at = std::lower_bound(corners.begin(), corners.end(), std::pair(ring[k].start, std::size_t(0)));
    const int side = side_of_departure(other, way, at->second, span_of(ring, k));
    if (side != 0) return side > 0;
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> rings_around(const std::vector<Contour>& rings) {
  std::vector<Box> boxes;
  std::vector<std::vector<GridPoint>> corners;
  for (const Contour& ring : rings) {
    boxes.push_back(box_of(ring));
    std::vector<GridPoint>& own = corners.emplace_back();
    for (const ContourEdge& e : ring) own.push_back(e.start);
    std::sort(own.begin(), own.end());
  }
  return meeting_others(boxes, [&](std::size_t i, std::size_t j) {
    const auto apart = std::find_if(corners[i].begin(), corners[i].end(), [&](const GridPoint& p) {
      return !std::binary_search(corners[j].begin(), corners[j].end(), p);
    });
    if (apart == corners[i].end()) return goes_inside(distinct(rings[i]), distinct(rings[j]));
    // Boxes of arcs may be wider than the arcs.
    return boxes[j].holds(apart->x, apart->y) && encloses(rings[j], *apart);
  });
}

std::vector<std::size_t> nesting_depths(const std::vector<Contour>& rings) {
  std::vector<std::size_t> depths;
  for (const std::vector<std::size_t>& around : rings_around(rings)) depths.push_back(around.size());
  return depths;
}

Contour make_chain(Contour chain, std::int64_t& repeated) {
  Contour result;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i + 1 < chain.size() && chain[i].start == chain[i + 1].start) {
      ++repeated;
    } else {
      result.push_back(std::move(chain[i]));
    }
  }
  if (result.size() < 2) throw Error(ErrorCode::kGeometry, "a polyline needs two different points");
  return result;
}

}  // namespace findspace::plane
