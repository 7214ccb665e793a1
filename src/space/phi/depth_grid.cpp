// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/depth_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/margins/space.h"
#include "space/phi/plane_scan.h"

namespace findspace::space {

struct DepthGrid::Box {
  std::array<int, 3> corner{};  // in cells
  int side = 1;                 // in cells
  Vector centre, half;
};

DepthGrid::DepthGrid(const PhiFunction& phi, int levels) : phi_(phi), levels_(levels) {
  const int n = phi.surface().facet_count();
  if (levels_ == 0) levels_ = n <= 64 ? 3 : n <= 512 ? 4 : 5;
  side_ = 1 << levels_;
  Vector low = phi.vertex(0), high = low;
  for (int v = 1; v < phi.surface().vertex_count(); ++v) {
    const Vector& p = phi.vertex(v);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  low_ = low;
  scale_ = {side_ / (high.x - low.x), side_ / (high.y - low.y), side_ / (high.z - low.z)};
  margin_ = 4 * std::max(phi.error_bound(low), phi.error_bound(high));
  cells_.resize(static_cast<std::size_t>(side_) * side_ * side_);
  all_facets_.resize((static_cast<std::size_t>(n) + 7) / 8 * 8);
  std::iota(all_facets_.begin(), all_facets_.end(), 0);
  everywhere_ = {phi.blocks().data(), phi.blocks().size(), all_facets_.data()};
  Box box;
  box.side = side_;
  box.half = {(high.x - low.x) / 2, (high.y - low.y) / 2, (high.z - low.z) / 2};
  box.centre = {low.x + box.half.x, low.y + box.half.y, low.z + box.half.z};
  divide(box, {all_facets_.begin(), all_facets_.begin() + n}, levels_);
}

/// A facet stays if for none of the reference planes (the highest at the centre and at the corners) it is lower in the
/// whole box. The difference of two planes is linear: its maximum over the box is its value at the centre plus
/// |difference of normals| . half sides. Boxes are taken a little larger than they are, for the rounding of cell
/// indices.
std::vector<int> DepthGrid::candidates(const Box& box, const std::vector<int>& facets) const {
  std::vector<int> references;
  for (int corner = -1; corner < 8; ++corner) {
    Vector u = box.centre;
    if (corner >= 0) {
      u.x += corner & 1 ? box.half.x : -box.half.x;
      u.y += corner & 2 ? box.half.y : -box.half.y;
      u.z += corner & 4 ? box.half.z : -box.half.z;
    }
    int best = facets[0];
    double most = -std::numeric_limits<double>::infinity();
    for (const int f : facets) {
      const double v = phi_.plane_value(f, u);
      if (v > most) {
        most = v;
        best = f;
      }
    }
    if (std::find(references.begin(), references.end(), best) == references.end()) references.push_back(best);
  }
  std::vector<int> kept;
  const double grown = 1 + margin::kLargerGain;
  for (const int f : facets) {
    const Vector& n = phi_.unit_normal(f);
    const double at_centre = phi_.plane_value(f, box.centre);
    const bool beaten = std::any_of(references.begin(), references.end(), [&](int r) {
      const Vector& m = phi_.unit_normal(r);
      const double gain =
          std::fabs(n.x - m.x) * box.half.x + std::fabs(n.y - m.y) * box.half.y + std::fabs(n.z - m.z) * box.half.z;
      return at_centre - phi_.plane_value(r, box.centre) + gain * grown < -margin_;
    });
    if (!beaten) kept.push_back(f);
  }
  return kept;
}

void DepthGrid::divide(const Box& box, const std::vector<int>& facets, int level) {
  const std::vector<int> kept = candidates(box, facets);
  if (level == 0) {
    store(box, kept);
    return;
  }
  for (int child = 0; child < 8; ++child) {
    Box part;
    part.side = box.side / 2;
    part.half = {box.half.x / 2, box.half.y / 2, box.half.z / 2};
    part.centre = {box.centre.x + (child & 1 ? part.half.x : -part.half.x),
                   box.centre.y + (child & 2 ? part.half.y : -part.half.y),
                   box.centre.z + (child & 4 ? part.half.z : -part.half.z)};
    for (int k = 0; k < 3; ++k) part.corner[k] = box.corner[k] + (child >> k & 1) * part.side;
    divide(part, kept, level - 1);
  }
}

void DepthGrid::store(const Box& box, const std::vector<int>& facets) {
  const auto [x, y, z] = box.corner;
  Cell& cell = cells_[(static_cast<std::size_t>(z) * side_ + y) * side_ + x];
  cell.first = static_cast<std::uint32_t>(blocks_.size());
  std::vector<Vector> normals;
  std::vector<double> offsets;
  for (const int f : facets) {
    normals.push_back(phi_.unit_normal(f));
    offsets.push_back(phi_.blocks()[static_cast<std::size_t>(f) / 8].d[f % 8]);
  }
  const std::vector<PlaneBlock> packed = pack_planes(normals, offsets);
  cell.count = static_cast<std::uint32_t>(packed.size());
  blocks_.insert(blocks_.end(), packed.begin(), packed.end());
  facets_.insert(facets_.end(), facets.begin(), facets.end());
  facets_.resize(blocks_.size() * 8, 0);
}

void DepthGrid::evaluate(std::span<const Vector> at, std::span<double> values, std::span<int> facets) const {
  scan_cells(*this, at, values, facets);
}

double DepthGrid::max_form(const Vector& u) const {
  const CellPlanes planes = cell(u);
  return scan_planes(planes.blocks, planes.count, u).value;
}

double DepthGrid::mean_planes() const {
  double sum = 0;
  for (const Cell& c : cells_) sum += 8.0 * c.count;
  return sum / static_cast<double>(cells_.size());
}

}  // namespace findspace::space
