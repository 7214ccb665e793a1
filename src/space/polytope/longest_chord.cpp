// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/longest_chord.h"

#include <findspace/error.h>

#include <algorithm>
#include <optional>

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

std::vector<RealVector> candidates(const ConvexRegion& region, const RealVector& u) {
  const auto edges = region.edges();
  if (edges.size() * edges.size() / 2 > kMostPairs)
    throw Error(ErrorCode::kUnsupported,
                "least values along a direction of shapes with so many edges are not computed");
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

}  // namespace findspace::space
