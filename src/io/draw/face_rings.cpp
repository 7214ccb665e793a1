// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/face_rings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "exact/planar/geometry_signs.h"

namespace findspace::io {
namespace {

using plane::Index;
using plane::kNone;
using Curve = plane::CurveNet::Curve;
using Ring = plane::CurveNet::Ring;
using Side = plane::CurveNet::Side;

std::vector<Index> all_cycles(const plane::Face& f) {
  std::vector<Index> starts{f.outer};
  starts.insert(starts.end(), f.inner.begin(), f.inner.end());
  return starts;
}

}  // namespace

bool FaceRings::is_free(const Curve& curve) const {
  const Index h = curve.first;
  return curve.mark != 0 && !is_filled(h) && !is_filled(h ^ 1u);
}

Index FaceRings::next_on_boundary(Index h) const {
  Index next = s_.next(h);
  while (is_crack(next)) next = s_.clockwise(next);
  return next;
}

/// The boundary of a face without its cracks, cut into loops that pass no vertex twice.
std::vector<std::vector<Index>> FaceRings::simple_loops(const plane::Face& f) const {
  std::vector<std::vector<Index>> loops;
  std::set<Index> open;
  for (Index start : all_cycles(f)) {
    Index h = start;
    do {
      if (!is_crack(h)) open.insert(h);
      h = s_.next(h);
    } while (h != start);
  }
  while (!open.empty()) {
    std::vector<Index> path;
    std::map<Index, std::size_t> place;  // of a vertex: the half-edge of the path that starts there
    for (Index h = *open.begin(); open.erase(h) == 1; h = next_on_boundary(h)) {
      place[s_.origin(h)] = path.size();
      path.push_back(h);
      const auto back = place.find(s_.target(h));
      if (back == place.end()) continue;
      loops.emplace_back(path.begin() + std::ptrdiff_t(back->second), path.end());
      for (Index k : loops.back()) place.erase(s_.origin(k));
      path.resize(path.size() - loops.back().size());
    }
  }
  return loops;
}

Ring FaceRings::from_the_left(Ring ring) const {
  const auto start = [this](const Side& side) {
    const Curve& k = net_.curves()[side.curve];
    return s_.vertices[side.forward ? k.from : k.to].point;
  };
  const auto first = std::min_element(ring.begin(), ring.end(), [&](const Side& a, const Side& b) {
    return compare_xy(s_.geometry, start(a), start(b)) < 0;
  });
  std::rotate(ring.begin(), first, ring.end());
  return ring;
}

double FaceRings::size(const Ring& ring) const {
  std::optional<plane::Bounds> b;
  for (const Side& side : ring) {
    const plane::Bounds k = net_.bounds(net_.curves()[side.curve]);
    if (!b) b = k;
    for (int i : {0, 1}) {
      b->low[i] = std::min(b->low[i], k.low[i]);
      b->high[i] = std::max(b->high[i], k.high[i]);
    }
  }
  return b->high[0] - b->low[0] + b->high[1] - b->low[1];
}

std::vector<Ring> FaceRings::of(const plane::Face& face) const {
  std::vector<Ring> loops;
  for (const auto& loop : simple_loops(face)) loops.push_back(from_the_left(net_.ring(loop)));
  // The outer ring is the one that has all others in its box.
  const auto larger = [this](const Ring& a, const Ring& b) { return size(a) < size(b); };
  std::iter_swap(loops.begin(), std::max_element(loops.begin(), loops.end(), larger));
  return loops;
}

}  // namespace findspace::io
