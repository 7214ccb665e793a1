// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/cut_to_window.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "plane/build/wound_loops.h"
#include "plane/grid/boundary_box.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kFewEdges = 1000;  // of a set that is not cut
// How many times fewer edges have to be left; more where some cross off the grid, as sums then take longer.
constexpr std::size_t kFewer = 2, kFewerOffGrid = 16;

/// The sides of a window beyond which a point lies, a bit each. What points beyond one side span misses the window.
unsigned beyond(const GridPoint& p, const PieceBox& w) {
  const auto x = double(p.x), y = double(p.y);  // grid coordinates are exact doubles
  return unsigned(x < w.x0) | unsigned(x > w.x1) << 1U | unsigned(y < w.y0) << 2U | unsigned(y > w.y1) << 3U;
}

/// A ring that winds as often around each point of the window. A corner is left out where the triangle with the one
/// kept before it and the one after it misses the window. The first one, which is kept, is in the window if any is.
Contour shortened(std::span<const GridCorner> ring, const PieceBox& window) {
  const auto inside =
      std::find_if(ring.begin(), ring.end(), [&](const GridCorner& c) { return !beyond(c.at, window); });
  const auto first = std::size_t(inside == ring.end() ? 0 : inside - ring.begin());
  const auto corner = [&](std::size_t k) { return ring[(first + k) % ring.size()].at; };
  Contour out{{.start = corner(0)}};
  unsigned last = beyond(corner(0), window), here = beyond(corner(1), window);
  for (std::size_t k = 1; k < ring.size(); ++k) {
    const unsigned next = beyond(corner(k + 1), window);
    if ((last & here & next) == 0) {
      out.push_back({.start = corner(k)});
      last = here;
    }
    here = next;
  }
  const auto same = [](const ContourEdge& a, const ContourEdge& b) { return a.start == b.start; };
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  while (out.size() > 1 && same(out.front(), out.back())) out.pop_back();
  return out;
}

/// Those that go around anything.
std::vector<Loop> shortened_rings(const GridFaces& faces, const PieceBox& window) {
  std::vector<Loop> out;
  for (const GridFace& face : faces) {
    const std::span<const GridCorner> corners(face.corners.data(), face.corners.size());
    for (std::size_t first = 0, end = 0; first < corners.size(); first = end) {
      end = corners[first].before + 1;
      Contour ring = shortened(corners.subspan(first, end - first), window);
      if (ring.size() < 3) continue;
      Loop& loop = out.emplace_back();
      loop.edges = std::move(ring);
      loop.area = 1;  // it stays as it runs: holes run clockwise
    }
  }
  return out;
}

bool has_its_boundary(const Region& a) {
  const auto is_marked = [](const auto& cell) { return is_in(cell.mark); };
  return std::all_of(a.edges.begin(), a.edges.end(), is_marked) &&
         std::all_of(a.vertices.begin(), a.vertices.end(), is_marked);
}

bool is_on_grid(const Region& a) {
  return std::all_of(a.vertices.begin(), a.vertices.end(),
                     [&](const Vertex& v) { return a.geometry.points[v.point].kind == exact::Point::Kind::kGrid; });
}

}  // namespace

std::optional<Region> cut_to_window(const Region& a, const PieceBox& window) {
  if (a.edges.size() < kFewEdges || !has_its_boundary(a)) return std::nullopt;
  std::vector<Loop> loops;
  {
    const auto faces = grid_faces(a, is_in, false);
    if (!faces || has_unbounded(*faces)) return std::nullopt;
    loops = shortened_rings(*faces, window);
  }
  std::size_t left = 0;
  for (const Loop& loop : loops) left += loop.edges.size();
  if (kFewer * left > a.edges.size()) return std::nullopt;
  std::vector<std::size_t> all(loops.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Region out = WoundLoops(loops, all).faces([](std::int32_t rounds) { return rounds > 0; });
  if (kFewerOffGrid * left > a.edges.size() && !is_on_grid(out)) return std::nullopt;
  return out;
}

}  // namespace findspace::plane
