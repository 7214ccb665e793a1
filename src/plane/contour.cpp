// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Checking and normalising rings. Pairs of edges whose boxes meet are found by a tree of boxes over all edges (median
// splits, the tree descended against itself); each pair is then decided exactly in contour_meet.cpp.
#include "plane/contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "findspace/error.h"
#include "plane/contour_boxes.h"
#include "plane/contour_meet.h"

namespace findspace::plane {
namespace {

/// A ring without its repeated points, and where its edges stood in the input.
struct Ring {
  Contour edges;
  std::vector<std::size_t> source;  // empty where nothing was dropped
  std::string label;

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

Ring clean(Contour input, std::string label, std::int64_t& repeated, double step) {
  const GridPoint first = input.empty() ? GridPoint{} : input[0].start;
  Ring ring{std::move(input), {}, std::move(label)};
  std::int64_t same = 0;
  bool arcs = false;
  for (std::size_t i = 0; i < ring.edges.size(); ++i) {
    if (ring.edges[i].start == ring.end(i)) {
      ++same;
    } else {
      arcs |= bool(ring.edges[i].arc);
    }
  }
  if (same > 0) drop_repeated(ring);
  repeated += same;
  if (ring.edges.size() < (arcs ? 2u : 3u)) {
    fail(fmt::format("{} has no area: fewer than three different points", ring.label), double(first.x), double(first.y),
         step);
  }
  return ring;
}

/// A ring of segments that all lie on one line: told apart from self-intersection for the sake of the message.
bool flat(const Ring& ring) {
  GridPoint o = ring.edges[0].start, a = ring.end(0);
  return straight(ring.edges) && std::all_of(ring.edges.begin(), ring.edges.end(),
                                             [&](const ContourEdge& e) { return cross(o, a, e.start) == 0; });
}

std::string edge_label(const Ring& ring, std::size_t i, double step) {
  GridPoint p = ring.edges[i].start, q = ring.end(i);
  return fmt::format("{} {} from {} to {}", ring.edges[i].arc ? "arc" : "edge", ring.given(i),
                     show(double(p.x), double(p.y), step), show(double(q.x), double(q.y), step));
}

struct EdgeId {
  std::uint32_t ring, edge;
};

[[noreturn]] void fail_meeting(const Ring& a, std::size_t i, const Ring& b, std::size_t j, const Meeting& m,
                               double step) {
  const char* how = m.along ? "run along each other" : "meet";
  std::string what = &a == &b ? fmt::format("{} touches or crosses itself", a.label)
                              : fmt::format("{} touches or crosses {}", b.label, a.label);
  std::string first = edge_label(a, i, step), second = edge_label(b, j, step);
  if (&a != &b) {
    first = a.label + ", " + first;
    second = b.label + ", " + second;
  }
  fail(fmt::format("{}: {} and {} {} at {}", what, first, second, how, show(m.x, m.y, step)), m.x, m.y, step);
}

void check_pair(const std::vector<Ring>& rings, EdgeId f, EdgeId g, double step) {
  if (f.ring > g.ring || (f.ring == g.ring && f.edge > g.edge)) std::swap(f, g);
  const Ring &a = rings[f.ring], &b = rings[g.ring];
  Span s = a.span(f.edge), t = b.span(g.edge);
  bool same = f.ring == g.ring;
  bool next = same && f.edge + 1 == g.edge;
  bool wrap = same && f.edge == 0 && g.edge + 1 == a.edges.size();
  const GridPoint* joined = next ? &s.to : wrap ? &s.from : nullptr;
  if (auto m = meet(s, t, joined, next && wrap)) fail_meeting(a, f.edge, b, g.edge, *m, step);
}

Box box_of(const ContourEdge& edge, GridPoint to) {
  const GridPoint from = edge.start;
  Box box{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x), std::max(from.y, to.y)};
  if (!edge.arc) return box;
  // Near a half circle the apothem is the root of a difference of rounded squares: off by up to sqrt(2^-51) * r.
  constexpr double kSlack = 0x1p-24;
  auto reach = std::int64_t(sagitta(edge, to) + edge.arc->r.to_double() * kSlack) + 2;
  return {box.x0 - reach, box.y0 - reach, box.x1 + reach, box.y1 + reach};
}

void check_edges(const std::vector<Ring>& rings, double step) {
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.edges.size();
  std::vector<Box> boxes;
  boxes.reserve(count);
  std::vector<std::size_t> first;  // of each ring
  for (const Ring& ring : rings) {
    first.push_back(boxes.size());
    for (std::size_t e = 0; e < ring.edges.size(); ++e) boxes.push_back(box_of(ring.edges[e], ring.end(e)));
  }
  auto edge = [&](std::size_t i) -> EdgeId {
    const std::size_t r = std::size_t(std::upper_bound(first.begin(), first.end(), i) - first.begin()) - 1;
    return {std::uint32_t(r), std::uint32_t(i - first[r])};
  };
  for_meeting_boxes(boxes, [&](std::size_t i, std::size_t j) { check_pair(rings, edge(i), edge(j), step); });
}

Box box_of(const Ring& ring) {
  Box all = box_of(ring.edges[0], ring.end(0));
  for (std::size_t i = 1; i < ring.edges.size(); ++i) all = all.joined(box_of(ring.edges[i], ring.end(i)));
  return all;
}

std::vector<Ring> clean_and_check(std::vector<Contour> rings, const std::vector<std::string>& labels,
                                  std::int64_t& repeated, double step) {
  std::vector<Ring> clean_rings;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    clean_rings.push_back(clean(std::move(rings[i]), labels[i], repeated, step));
    const Ring& ring = clean_rings.back();
    GridPoint p = ring.edges[0].start;
    if (flat(ring)) {
      fail(fmt::format("{} has no area: all its points are on one line", ring.label), double(p.x), double(p.y), step);
    }
  }
  check_edges(clean_rings, step);
  return clean_rings;
}

Contour directed(Contour ring, int wanted, std::int64_t& turned) {
  if (orientation(ring) == wanted) return ring;
  ++turned;
  return reversed(ring);
}

void check_holes(const std::vector<Ring>& rings, double step) {
  if (rings.size() == 1) return;
  std::vector<Box> boxes;
  for (const Ring& ring : rings) boxes.push_back(box_of(ring));
  for (std::size_t i = 1; i < rings.size(); ++i) {
    GridPoint p = rings[i].edges[0].start;
    if (!encloses(rings[0].edges, p)) {
      fail(fmt::format("{} is not inside {}: its vertex {} is outside", rings[i].label, rings[0].label,
                       show(double(p.x), double(p.y), step)),
           double(p.x), double(p.y), step);
    }
    for (std::size_t j = 1; j < rings.size(); ++j) {
      if (i == j || !boxes[j].holds(p.x, p.y) || !encloses(rings[j].edges, p)) continue;
      fail(fmt::format("{} is inside {}", rings[i].label, rings[j].label), double(p.x), double(p.y), step);
    }
  }
}

}  // namespace

RingSet make_rings(std::vector<Contour> input, double step) {
  std::vector<std::string> labels;
  labels.reserve(input.size());
  for (std::size_t i = 0; i < input.size(); ++i) labels.push_back(i == 0 ? "the ring" : fmt::format("hole {}", i - 1));
  RingSet set;
  std::vector<Ring> rings = clean_and_check(std::move(input), labels, set.repeated_points, step);
  check_holes(rings, step);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::int64_t ignored = 0;  // either direction of a hole is usual
    set.contours.push_back(directed(std::move(rings[i].edges), i == 0 ? 1 : -1, i == 0 ? set.turned_rings : ignored));
  }
  return set;
}

std::vector<RingSet> nest_rings(std::vector<Contour> input, double step) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < input.size(); ++i) labels.push_back(fmt::format("ring {}", i));
  std::int64_t repeated = 0, ignored = 0;
  std::vector<Ring> rings = clean_and_check(std::move(input), labels, repeated, step);
  std::vector<Box> boxes;
  for (const Ring& ring : rings) boxes.push_back(box_of(ring));
  std::vector<std::vector<std::size_t>> around(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    GridPoint p = rings[i].edges[0].start;
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (i != j && boxes[j].holds(p.x, p.y) && encloses(rings[j].edges, p)) around[i].push_back(j);
    }
  }
  std::vector<RingSet> sets;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 != 0) continue;
    RingSet& set = sets.emplace_back();
    set.contours.push_back(directed(rings[i].edges, 1, ignored));
    for (std::size_t h = 0; h < rings.size(); ++h) {
      bool mine = around[h].size() == around[i].size() + 1 &&
                  std::find(around[h].begin(), around[h].end(), i) != around[h].end();
      if (mine) set.contours.push_back(directed(rings[h].edges, -1, ignored));
    }
  }
  if (!sets.empty()) sets[0].repeated_points = repeated;
  return sets;
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
