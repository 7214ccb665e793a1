// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/swept.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "findspace/error.h"
#include "plane/complex/face_walk.h"
#include "plane/complex/overlay.h"
#include "plane/query/in_batches.h"
#include "plane/query/moved.h"

namespace findspace::plane {
namespace {

using exact::Real;
using Role = SweepStrips::Source::Role;

/// The marks on every cell of an arrangement.
struct Layer {
  std::vector<Mark> faces, edges, vertices;
};

/// What the windows of all cells see.
class Sights {
 public:
  Sights(const CellComplex& m, const SweepStrips& strips, const Arrangement& a) : m_(m), strips_(strips), a_(a) {
    at_start_ = labels(Role::kStart);
    at_end_ = labels(Role::kEnd);
    inside_ = at_start_;  // a window begins where its start is ...
    step_off_start();     // ... or next to it
    pass_marked_pieces();
    cross_chains();
  }

  Marks marks(const std::function<Mark(const Sight&)>& rule) const {
    auto apply = [&](const std::vector<Mark>& start, const std::vector<Mark>& end, const std::vector<Mark>& inside) {
      std::vector<Mark> out(start.size());
      for (std::size_t k = 0; k < start.size(); ++k) out[k] = rule({start[k], end[k], inside[k]});
      return out;
    };
    return {apply(at_start_.faces, at_end_.faces, inside_.faces), apply(at_start_.edges, at_end_.edges, inside_.edges),
            apply(at_start_.vertices, at_end_.vertices, inside_.vertices)};
  }

 private:
  Index edge_of(Index piece) const { return strips_.parts[strips_.sources[piece].part].edge; }

  template <class Visit>
  void inner_vertices(Index piece, Visit&& visit) const {
    for (Index k = a_.chain_start[piece] + 1; k < a_.chain_start[piece + 1]; ++k) visit(a_.edges[a_.chain[k]].v0);
  }

  /// M moved, on every cell.
  Layer labels(Role role) const {
    Layer out;
    out.faces.assign(a_.face_count, m_.faces[0].mark);
    walk_faces(a_, [&](Index h) {
      Mark mark = out.faces[a_.face[h]];
      for (Index k = a_.cover_start[h / 2]; k < a_.cover_start[h / 2 + 1]; ++k) {
        if (strips_.sources[a_.cover[k]].role != role) continue;
        mark = m_.faces[m_.face(2 * edge_of(a_.cover[k]) + (h & 1u ? 0 : 1))].mark;
      }
      out.faces[a_.face[h ^ 1u]] = mark;
    });
    for (Index e = 0; e < a_.edge_count(); ++e) out.edges.push_back(out.faces[a_.face[2 * e]]);
    for (Index v = 0; v < a_.vertex_count(); ++v) out.vertices.push_back(out.faces[a_.some_face(v)]);
    for (Index i = 0; i < a_.pieces.size(); ++i) {
      if (strips_.sources[i].role != role) continue;
      const Mark mark = m_.edges[edge_of(i)].mark;
      for (Index k = a_.chain_start[i]; k < a_.chain_start[i + 1]; ++k) out.edges[a_.chain[k]] = mark;
      inner_vertices(i, [&](Index v) { out.vertices[v] = mark; });
    }
    const std::vector<Index>& point = role == Role::kStart ? strips_.start_point : strips_.end_point;
    for (Index n = 0; n < strips_.nodes.size(); ++n) out.vertices[a_.point_vertex[point[n]]] = strips_.nodes[n].mark;
    return out;
  }

  /// Where a window starts on a curve or a point of M it goes on beside it.
  void step_off_start() {
    for (Index i = 0; i < a_.pieces.size(); ++i) {
      if (strips_.sources[i].role != Role::kStart) continue;
      const StripPart& part = strips_.parts[strips_.sources[i].part];
      const Index e = part.edge;
      // The window's direction is to the right of an edge that rises.
      const Mark mark = part.rise == 0 ? m_.edges[e].mark : m_.faces[m_.face(part.rise > 0 ? 2 * e + 1 : 2 * e)].mark;
      for (Index k = a_.chain_start[i]; k < a_.chain_start[i + 1]; ++k) inside_.edges[a_.chain[k]] = mark;
      inner_vertices(i, [&](Index v) { inside_.vertices[v] = mark; });
    }
    for (Index n = 0; n < strips_.nodes.size(); ++n)
      inside_.vertices[a_.point_vertex[strips_.start_point[n]]] = strips_.nodes[n].ahead;
  }

  void pass_marked_pieces() {
    for (Index i = 0; i < a_.pieces.size(); ++i) {
      if (strips_.sources[i].role != Role::kPassing) continue;
      const Mark mark = strips_.sources[i].mark;
      for (Index k = a_.chain_start[i]; k < a_.chain_start[i + 1]; ++k) lower(inside_.edges[a_.chain[k]], mark);
      inner_vertices(i, [&](Index v) { lower(inside_.vertices[v], mark); });
    }
  }

  void cross_chains() {
    std::set<Mark> values;
    for (Index i = 0; i < strips_.chains.size(); ++i)
      if (strips_.chains[i].weight != 0) values.insert(strips_.chain_mark[i]);
    for (Mark value : values) {
      std::vector<Chain> chains = strips_.chains;
      for (Index i = 0; i < chains.size(); ++i)
        if (strips_.chain_mark[i] != value) chains[i].weight = 0;
      std::vector<Corner> corners = strips_.corners;
      for (Corner& corner : corners) corner.weight = chains[corner.in].weight;
      const Windings w = windings(a_, chains, corners, 0, VertexScope::kAll);
      auto where = [value](const std::vector<std::int32_t>& number, std::vector<Mark>& marks) {
        for (std::size_t k = 0; k < number.size(); ++k)
          if (number[k] > 0) lower(marks[k], value);
      };
      where(w.faces, inside_.faces);
      where(w.edges, inside_.edges);
      where(w.vertices, inside_.vertices);
    }
  }

  static void lower(Mark& mark, Mark other) { mark = std::min(mark, other); }

  const CellComplex& m_;
  const SweepStrips& strips_;
  const Arrangement& a_;
  Layer at_start_, at_end_, inside_;
};

/// The greatest common measure of two numbers, not both 0, by Euclid's algorithm: both are integer multiples of it,
/// without a common factor. None where these integers are 2^53 or more, or the ratio is irrational: each step but the
/// last makes them at least the next Fibonacci number, and the 79th is above 2^53.
std::optional<Real> common_measure(Real x, Real y) {
  for (int steps = 80; y.sign() != 0; --steps) {
    if (steps == 0) return std::nullopt;
    Real rest = x - Real(exact::floor(x / y)) * y;
    x = std::exchange(y, rest);
  }
  return abs(x);
}

/// How far positions whose windows see something may be from it.
PieceBox reach_of(const Window& w) {
  const auto x = w.from.x.interval(), y = w.from.y.interval(), u = w.to.x.interval(), v = w.to.y.interval();
  return {-std::max(x.hi, u.hi), -std::max(y.hi, v.hi), -std::min(x.lo, u.lo), -std::min(y.lo, v.lo)};
}

}  // namespace

std::optional<GridPoint> primitive_direction(const RealVector& d) {
  const auto measure = common_measure(d.x, d.y);
  if (!measure) return std::nullopt;
  const auto dx = (d.x / *measure).integer(), dy = (d.y / *measure).integer();
  constexpr exact::int128 kMost = exact::int128(1) << 53;
  if (!dx || !dy || *dx >= kMost || *dx <= -kMost || *dy >= kMost || *dy <= -kMost) return std::nullopt;
  return GridPoint{std::int64_t(*dx), std::int64_t(*dy)};
}

Window window_between(const RealVector& from, const RealVector& to) {
  const auto d = primitive_direction(to - from);
  if (d) return {from, to, d->x, d->y};
  throw Error(ErrorCode::kOutOfRange,
              "a leg of a motion has a direction that is not a ratio of integers below 2^53: use fewer digits");
}

Window window_along(std::int64_t dx, std::int64_t dy, const Real& from, const Real& to) {
  const Real length = sqrt(Real(exact::int128(dx) * dx + exact::int128(dy) * dy));
  const RealVector d{Real(dx), Real(dy)};
  return {from / length * d, to / length * d, dx, dy};
}

CellComplex swept(const CellComplex& m, const Window& window, const std::function<Mark(const Sight&)>& rule) {
  if (m.vertices.empty() && m.edges.empty()) {
    const Mark mark = m.faces[0].mark;
    return CellComplex::uniform(rule({mark, mark, mark}));
  }
  const auto at_once = [&](const CellComplex& part) {
    SweepStrips strips(part, window);
    Arrangement a = arrange(std::move(strips.curves.geometry), std::move(strips.curves.pieces));
    return extract(std::move(a), Sights(part, strips, a).marks(rule));
  };
  if (auto map = made_in_batches(m, reach_of(window), at_once)) return *std::move(map);
  return at_once(m);
}

CellComplex least_along(const CellComplex& m, std::span<const RealVector> path) {
  auto least = [](const Sight& s) { return s.least(); };
  std::vector<CellComplex> legs;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (!(path[k] == path[k + 1])) legs.push_back(swept(m, window_between(path[k], path[k + 1]), least));
  }
  if (legs.empty()) return moved(m, -path[0]);
  if (legs.size() == 1) return std::move(legs[0]);
  std::vector<const CellComplex*> all;
  for (const CellComplex& leg : legs) all.push_back(&leg);
  return overlay(all, [](std::span<const Mark> marks) { return *std::min_element(marks.begin(), marks.end()); });
}

}  // namespace findspace::plane
