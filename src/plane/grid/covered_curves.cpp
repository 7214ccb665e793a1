// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/covered_curves.h"

#include <algorithm>
#include <cmath>

#include "plane/grid/boundary_box.h"

namespace findspace::plane {
namespace {

constexpr double kCells = 512;             // along the longer side of a set
constexpr std::size_t kMostCorners = 256;  // that are known
constexpr std::size_t kMostTried = 128;    // of them: those that are near
constexpr std::size_t kBuckets = 16;       // along each side of the box of the corners
constexpr double kWider = 2;               // grid steps: far more than the rounding of sums below 2^43 steps

Outline outline(const GridFaces& faces) {
  Outline out;
  for (const GridFace& face : faces)
    for (const GridCorner& c : face.corners) {
      const GridPoint to = face.corners[c.next].at;
      out.push_back({double(c.at.x), double(c.at.y), double(to.x), double(to.y)});
    }
  return out;
}

}  // namespace

CoveredCurves::Corners::Corners(const GridFaces& faces) {
  std::size_t count = 0;
  for (const GridFace& f : faces) count += f.corners.size();
  const std::size_t step = count / kMostCorners + 1;
  std::vector<Spot> all;
  std::size_t k = 0;
  for (const GridFace& f : faces)
    for (const GridCorner& c : f.corners)
      if (k++ % step == 0) all.push_back({double(c.at.x), double(c.at.y)});
  const GridBox box = box_of(faces);
  x0_ = double(box.x0);
  y0_ = double(box.y0);
  columns_per_step_ = kBuckets / double(std::max<std::int64_t>(box.x1 - box.x0, 1));
  rows_per_step_ = kBuckets / double(std::max<std::int64_t>(box.y1 - box.y0, 1));
  each_ = std::min(all.size(), kMostTried);
  near_.reserve(kBuckets * kBuckets * each_);
  for (std::size_t bucket = 0; bucket < kBuckets * kBuckets; ++bucket) {
    const double x = x0_ + (double(bucket % kBuckets) + 0.5) / columns_per_step_;
    const auto row = bucket / kBuckets;
    const double y = y0_ + (double(row) + 0.5) / rows_per_step_;
    const auto away = [&](const Spot& s) { return (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y); };
    std::partial_sort(all.begin(), all.begin() + std::ptrdiff_t(each_), all.end(),
                      [&](const Spot& s, const Spot& t) { return away(s) < away(t); });
    near_.insert(near_.end(), all.begin(), all.begin() + std::ptrdiff_t(each_));
  }
}

std::span<const CoveredCurves::Spot> CoveredCurves::Corners::near(const Spot& place) const {
  const auto line = [](double at) { return std::size_t(std::clamp(at, 0.0, double(kBuckets - 1))); };
  const std::size_t bucket =
      line((place.y - y0_) * rows_per_step_) * kBuckets + line((place.x - x0_) * columns_per_step_);
  return std::span(near_).subspan(bucket * each_, each_);
}

CoveredCurves::Set::Set(const GridFaces& faces) : corners(faces) {
  const GridBox box = box_of(faces);
  side = std::max(std::ceil(double(std::max(box.x1 - box.x0, box.y1 - box.y0)) / kCells), 4.0);
  const std::vector<LatticeRun> runs = cell_runs(outline(faces), side);
  if (runs.empty()) return;
  Bitmap cells(LatticeBox::around(runs));
  for (const LatticeRun& r : runs) cells.add(r);
  depths = CellDepths(cells);
  const CellPlace cell = depths.deepest();
  deep = {(double(cell.column) + 0.5) * side, (double(cell.row) + 0.5) * side};
}

/// The square around (x, y) lies in cells inside the set.
bool CoveredCurves::Set::covers(double x, double y, double half) const {
  const double column = std::floor(x / side), row = std::floor(y / side);
  return double(depths.depth(std::int64_t(column), std::int64_t(row))) > std::ceil(half / side);
}

bool CoveredCurves::covers(const Set& cells, Set& moved, const CoveredBox& box) {
  const double x = box.x0 + (box.x1 - box.x0) / 2, y = box.y0 + (box.y1 - box.y0) / 2;
  const double half = std::max(box.x1 - box.x0, box.y1 - box.y0) / 2 + kWider;
  const auto serves = [&](const Spot& corner) { return cells.covers(x - corner.x, y - corner.y, half); };
  if (moved.last && serves(*moved.last)) return true;
  for (const Spot& corner : moved.corners.near({x - cells.deep.x, y - cells.deep.y}))
    if (serves(corner)) {
      moved.last = corner;
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
