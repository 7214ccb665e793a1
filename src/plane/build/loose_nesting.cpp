// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/loose_nesting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "plane/build/ring_sketch.h"
#include "plane/contour/contour.h"
#include "plane/contour/contour_boxes.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kVoters = 15;  // corners of a loop that say where it lies

/// Adds the loops of a ring, cut where it comes back to a corner, without edges that have no length.
void add_loops(const Contour& ring, std::size_t number, std::vector<Loop>& loops) {
  Contour path;
  std::map<GridPoint, std::size_t> place;  // of a corner in the path
  auto cut = [&](std::size_t from) {
    const auto first = path.begin() + std::ptrdiff_t(from);
    Contour edges(std::make_move_iterator(first), std::make_move_iterator(path.end()));
    path.erase(first, path.end());
    for (const ContourEdge& e : edges) place.erase(e.start);
    loops.push_back({.edges = std::move(edges), .ring = number});
  };
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (ring[k].start == end_of(ring, k)) continue;
    if (const auto back = place.find(ring[k].start); back != place.end()) cut(back->second);
    place[ring[k].start] = path.size();
    path.push_back(ring[k]);
  }
  if (!path.empty()) cut(0);
}

/// Whether a loop goes round a corner, if all points beside the corner agree.
std::optional<bool> goes_round(const RingSketch& loop, GridPoint p) {
  constexpr double kBeside = 4;  // grid steps
  const double x = double(p.x), y = double(p.y);
  const bool answer = loop.goes_round(x + kBeside, y + kBeside);
  for (const auto& [dx, dy] : {std::pair{-kBeside, kBeside}, {-kBeside, -kBeside}, {kBeside, -kBeside}})
    if (loop.goes_round(x + dx, y + dy) != answer) return std::nullopt;
  return answer;
}

bool goes_round(const RingSketch& outer, const Contour& inner) {
  const std::size_t step = (inner.size() + kVoters - 1) / kVoters;
  int votes = 0;
  for (std::size_t k = 0; k < inner.size(); k += step)
    if (const auto vote = goes_round(outer, inner[k].start)) votes += *vote ? 1 : -1;
  return votes > 0;
}

Box box_around(const PieceBox& b) {
  const auto below = [](double v) { return std::int64_t(std::floor(v)); };
  return {below(b.x0), below(b.y0), -below(-b.x1), -below(-b.y1)};
}

}  // namespace

std::vector<Loop> loosely_nested(std::span<const Contour> rings) {
  std::vector<Loop> loops;
  for (std::size_t r = 0; r < rings.size(); ++r) add_loops(rings[r], r, loops);
  std::vector<RingSketch> sketches;
  for (Loop& loop : loops) {
    sketches.emplace_back(loop.edges);
    loop.area = sketches.back().area();
  }
  std::vector<Box> boxes;
  for (const RingSketch& s : sketches) boxes.push_back(box_around(s.box()));
  const auto around = meeting_others(boxes, [&](std::size_t i, std::size_t j) {
    return std::abs(loops[j].area) > std::abs(loops[i].area) && sketches[i].box().meets(sketches[j].box()) &&
           goes_round(sketches[j], loops[i].edges);
  });
  for (std::size_t i = 0; i < loops.size(); ++i) {
    loops[i].within = i;
    loops[i].depth = around[i].size();
    double least = INFINITY;
    for (const std::size_t j : around[i]) {
      const double size = std::abs(loops[j].area);
      if (size >= least) continue;
      least = size;
      loops[i].within = j;
    }
  }
  return loops;
}

}  // namespace findspace::plane
