// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/covered_curves.h"

#include <algorithm>
#include <cmath>

#include "plane/grid/boundary_box.h"

namespace findspace::plane {
namespace {

constexpr double kCells = 512;             // along the longer side of a set
constexpr std::size_t kMostCorners = 256;  // that are tried
constexpr double kWider = 2;               // grid steps: far more than the rounding of sums below 2^43 steps

Outline outline(const std::vector<GridFace>& faces) {
  Outline out;
  for (const GridFace& face : faces)
    for (const GridCorner& c : face.corners) {
      const GridPoint to = face.corners[c.next].at;
      out.push_back({double(c.at.x), double(c.at.y), double(to.x), double(to.y)});
    }
  return out;
}

}  // namespace

CoveredCurves::Set::Set(const std::vector<GridFace>& faces) {
  const GridBox box = box_of(faces);
  side = std::max(std::ceil(double(std::max(box.x1 - box.x0, box.y1 - box.y0)) / kCells), 4.0);
  const std::vector<LatticeRun> runs = cell_runs(outline(faces), side);
  if (!runs.empty()) {
    Bitmap cells(LatticeBox::around(runs));
    for (const LatticeRun& r : runs) cells.add(r);
    depths = CellDepths(cells);
  }
  std::size_t count = 0;
  for (const GridFace& f : faces) count += f.corners.size();
  const std::size_t step = count / kMostCorners + 1;
  std::size_t k = 0;
  for (const GridFace& f : faces)
    for (const GridCorner& c : f.corners)
      if (k++ % step == 0) corners.push_back({double(c.at.x), double(c.at.y)});
}

/// The square around (x, y) lies in cells inside the set.
bool CoveredCurves::Set::covers(double x, double y, double half) const {
  const double column = std::floor(x / side), row = std::floor(y / side);
  return double(depths.depth(std::int64_t(column), std::int64_t(row))) > std::ceil(half / side);
}

bool CoveredCurves::covers(const Set& cells, Set& moved, const CoveredBox& box) {
  const double x = box.x0 + (box.x1 - box.x0) / 2, y = box.y0 + (box.y1 - box.y0) / 2;
  const double half = std::max(box.x1 - box.x0, box.y1 - box.y0) / 2 + kWider;
  const auto serves = [&](std::size_t k) { return cells.covers(x - moved.corners[k].x, y - moved.corners[k].y, half); };
  if (serves(moved.last)) return true;
  for (std::size_t k = 0; k < moved.corners.size(); ++k)
    if (serves(k)) {
      moved.last = k;
      return true;
    }
  return false;
}

bool CoveredCurves::covers(const CoveredBox& box) {
  if (!sets_) sets_.emplace(std::array<Set, 2>{Set(*faces_[0]), Set(*faces_[1])});
  auto& [a, b] = *sets_;
  return covers(a, b, box) || covers(b, a, box);
}

}  // namespace findspace::plane
