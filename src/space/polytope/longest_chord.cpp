// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/longest_chord.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>

#include "exact/margins/space.h"
#include "space/polytope/near_features.h"

namespace findspace::space {

using exact::Real;

namespace {

struct Chord {
  Real from, to;
};

/// Of the line through x, which meets the region.
Chord chord_through(const ConvexRegion& region, const RealVector& x, const RealVector& u) {
  std::optional<Real> from, to;
  for (const HalfSpace& h : region.planes()) {
    const Real slope = dot(h.normal, u);
    const int way = slope.sign();
    if (way == 0) continue;
    const Real at = -h.value(x) / slope;
    if (way > 0 && (!to || at < *to)) to = at;
    if (way < 0 && (!from || *from < at)) from = at;
  }
  return {*from, *to};
}

/// The place on the first edge that lies over or under one of the other, if it is in both and there is one such.
std::optional<RealVector> crossing(const RealVector& a, const RealVector& b, const RealVector& c, const RealVector& d,
                                   const RealVector& u) {
  const RealVector e = minus(b, a), f = minus(d, c), between = minus(c, a);
  Real all = dot(cross(e, f), u);
  if (all.sign() == 0) return std::nullopt;
  Real first = dot(cross(between, f), u), other = dot(cross(between, e), u);
  if (all.sign() < 0) {
    all = -all;
    first = -first;
    other = -other;
  }
  if (first.sign() <= 0 || other.sign() <= 0 || !(first < all) || !(other < all)) return std::nullopt;
  return along(a, first / all, e);
}

[[noreturn]] void refuse_pairs() {
  throw Error(ErrorCode::kUnsupported, "least values along a direction of shapes with so many edges are not computed");
}

std::vector<RealVector> candidates(const ConvexRegion& region, const RealVector& u) {
  const auto edges = region.edges();
  if (edges.size() * edges.size() / 2 > kMostPairs) refuse_pairs();
  std::vector<RealVector> out;
  const auto at = [&](int v) -> const RealVector& { return region.vertices()[static_cast<std::size_t>(v)].at; };
  for (const ConvexRegion::Vertex& v : region.vertices()) out.push_back(v.at);
  for (std::size_t j = 0; j < edges.size(); ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      auto x = crossing(at(edges[j].first), at(edges[j].second), at(edges[k].first), at(edges[k].second), u);
      if (x) out.push_back(std::move(*x));
    }
  }
  return out;
}

}  // namespace

LongestChord longest_chord(const ConvexRegion& region, const RealVector& direction) {
  LongestChord out;
  int count = 0;
  for (const RealVector& x : candidates(region, direction)) {
    const Chord chord = chord_through(region, x, direction);
    const Real length = chord.to - chord.from;
    const int order = count == 0 ? 1 : compare(length, out.length);
    if (order < 0) continue;
    if (order > 0) {
      out.length = length;
      out.middle = {};
      count = 0;
    }
    out.middle = plus(out.middle, along(x, (chord.from + chord.to) / Real(2), direction));
    ++count;
  }
  // Between all the longest at once: if any is, this one is inside.
  out.middle = scaled(Real::ratio(1, count), out.middle);
  const Vector near = rounded(out.middle);
  out.inside = std::all_of(region.planes().begin(), region.planes().end(),
                           [&](const HalfSpace& h) { return h.sign(out.middle, near) < 0; });
  return out;
}

namespace {

using near::Triple;

/// Differences k - l of two points of a set, by its vertices: of k (or of points on the ways from it to others) and l
/// (likewise). At most two ways: a point, a segment, a parallelogram, or a triangle of two ways from one.
struct ChordEnds {
  int k, l;
  std::vector<int> from_k, from_l;
};

template <class T>
struct ChordExit {
  T at;                   // in lengths of the direction
  std::vector<T> shares;  // of the ways, to the nearest difference
};

template <class T>
Triple<T> cross_of(const Triple<T>& a, const Triple<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Where the direction leaves the differences grown by the reach, if it does so over themselves; `tolerance`: of the
/// shares, and of what is under the root. Nothing is said of ways that are parallel.
template <class T>
std::optional<ChordExit<T>> exit_of(const ChordEnds& ends, std::span<const Triple<T>> points, const T& reach,
                                    const Triple<T>& u, const T& tolerance) {
  const auto at = [&](int v) -> const Triple<T>& { return points[static_cast<std::size_t>(v)]; };
  const T zero(0), one(1);
  std::vector<Triple<T>> ways;
  for (const int v : ends.from_k) ways.push_back(near::minus(at(v), at(ends.k)));
  for (const int v : ends.from_l) ways.push_back(near::minus(at(ends.l), at(v)));
  const Triple<T> from = near::minus(at(ends.k), at(ends.l));
  Triple<T> across_u = u, across_from = from;  // what of them is square to the ways
  Triple<T> normal{};
  if (ways.size() == 1) {
    const T square = near::dot(ways[0], ways[0]);
    across_u = near::along<T>(u, zero - near::dot(u, ways[0]) / square, ways[0]);
    across_from = near::along<T>(from, zero - near::dot(from, ways[0]) / square, ways[0]);
  } else if (ways.size() == 2) {
    normal = cross_of(ways[0], ways[1]);
    const T square = near::dot(normal, normal);
    if (!(zero < square)) return std::nullopt;
    if constexpr (std::is_same_v<T, double>) {  // doubles do not tell
      if (square <= margin::kParallelEdges * near::dot(ways[0], ways[0]) * near::dot(ways[1], ways[1]))
        return ChordExit<T>{exact::kInfinity, {}};
    }
    const Triple<T> none{zero, zero, zero};
    across_u = near::along<T>(none, near::dot(u, normal) / square, normal);
    across_from = near::along<T>(none, near::dot(from, normal) / square, normal);
  }
  const T a = near::dot(across_u, across_u), b = near::dot(across_u, across_from);
  if (!(zero < a)) return std::nullopt;
  T rest = b * b - a * (near::dot(across_from, across_from) - reach * reach);
  if (rest < zero - tolerance * (b * b + a * reach * reach)) return std::nullopt;
  if (rest < zero) rest = zero;
  using std::sqrt;
  ChordExit<T> out{(b + sqrt(rest)) / a, {}};
  const Triple<T> off = near::minus(near::along<T>({zero, zero, zero}, out.at, u), from);
  if (ways.size() == 1) out.shares = {near::dot(off, ways[0]) / near::dot(ways[0], ways[0])};
  if (ways.size() == 2) {
    const T square = near::dot(normal, normal);
    out.shares = {near::dot(cross_of(off, ways[1]), normal) / square,
                  near::dot(cross_of(ways[0], off), normal) / square};
  }
  for (const T& share : out.shares) {
    if (share < zero - tolerance || one + tolerance < share) return std::nullopt;
  }
  if (ends.from_k.size() == 2 || ends.from_l.size() == 2) {
    if (one + tolerance < out.shares[0] + out.shares[1]) return std::nullopt;
  }
  return out;
}

/// Of vertices, edges and triangles of facets.
std::vector<ChordEnds> all_ends(const ConvexRegion& set) {
  const int count = static_cast<int>(set.vertices().size());
  const auto edges = set.edges();
  if (edges.size() * edges.size() / 2 > kMostPairs) refuse_pairs();
  std::vector<ChordEnds> out;
  for (int l = 0; l < count; ++l) {
    for (int k = 0; k < count; ++k) out.push_back({k, l, {}, {}});
    for (const auto& [v, w] : edges) {
      out.push_back({v, l, {w}, {}});
      out.push_back({l, v, {}, {w}});
    }
  }
  for (const auto& [v, w] : edges) {
    for (const auto& [x, y] : edges) out.push_back({v, x, {w}, {y}});
  }
  for (const std::vector<int>& ring : set.circuits()) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      for (int l = 0; l < count; ++l) {
        out.push_back({ring[0], l, {ring[i], ring[i + 1]}, {}});
        out.push_back({l, ring[0], {}, {ring[i], ring[i + 1]}});
      }
    }
  }
  return out;
}

}  // namespace

LongestChord longest_chord(const ConvexRegion& set, const Real& radius, const RealVector& direction) {
  std::vector<RealVector> points;
  std::vector<Triple<double>> near_points;
  for (const ConvexRegion::Vertex& v : set.vertices()) {
    points.push_back(v.at);
    near_points.push_back(near::triple(v.near));
  }
  const std::vector<ChordEnds> all = all_ends(set);
  const Real reach = Real(2) * radius;
  const Triple<double> near_u = near::triple(space::rounded(direction));
  struct Likely {
    double at;
    std::size_t which;
  };
  std::vector<Likely> likely;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto found = exit_of<double>(all[k], near_points, reach.to_double(), near_u, margin::kBeyondEnd);
    if (found) likely.push_back({found->at, k});
  }
  std::sort(likely.begin(), likely.end(), [](const Likely& a, const Likely& b) { return a.at > b.at; });
  LongestChord out;
  for (const Likely& next : likely) {
    if (out.inside && next.at < out.length.to_double() * (1 - margin::kBeyondEnd)) break;
    const ChordEnds& ends = all[next.which];
    const auto found = exit_of<Real>(ends, points, reach, direction, Real());
    if (!found || (out.inside && found->at <= out.length)) continue;
    RealVector sum = plus(points[static_cast<std::size_t>(ends.k)], points[static_cast<std::size_t>(ends.l)]);
    std::size_t share = 0;
    const auto add = [&](int base, const std::vector<int>& others) {
      for (const int v : others)
        sum = along(sum, found->shares[share++],
                    minus(points[static_cast<std::size_t>(v)], points[static_cast<std::size_t>(base)]));
    };
    add(ends.k, ends.from_k);
    add(ends.l, ends.from_l);
    out = {found->at, scaled(Real::ratio(1, 2), sum), true};
  }
  return out;
}

}  // namespace findspace::space
