// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/inner_disc.h"

#include <cmath>

#include "plane/base/subdivide.h"

namespace findspace::distance {
namespace {

constexpr int kMostCells = 200;
constexpr double kGoodEnough = 1.05;  // of the best found

struct DiscCell {
  double x, y, half;  // a square
  double depth, most;
  bool operator<(const DiscCell& o) const { return most < o.most; }  // the most promising on top
};

DiscCell cell(const FeatureTree& tree, double x, double y, double half) {
  double depth = depth_in(tree, x, y).value_or(0);
  return {x, y, half, depth, depth + half * std::sqrt(2.0)};
}

}  // namespace

std::optional<double> depth_in(const FeatureTree& tree, double x, double y) {
  auto near = tree.nearest(x, y);
  auto inside = tree.contains(x, y, near);
  if (!inside) return std::nullopt;
  return *inside ? near.distance : -near.distance;
}

InnerDisc inner_disc(const FeatureTree& tree) {
  InnerDisc best;
  if (tree.empty()) return best;
  const FeatureBox& box = tree.nodes()[0].box;
  plane::Subdivision<DiscCell> cells;
  cells.push(cell(tree, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, std::max(box.x1 - box.x0, box.y1 - box.y0) / 2));
  const auto settled = [&](const DiscCell& top) {
    if (top.depth > best.radius) best = {top.x, top.y, top.depth};
    return top.most <= best.radius * kGoodEnough;
  };
  cells.run(kMostCells, settled, [&](const DiscCell& top) {
    const double half = top.half / 2;
    for (double dx : {-half, half})
      for (double dy : {-half, half}) cells.push(cell(tree, top.x + dx, top.y + dy, half));
  });
  return best;
}

}  // namespace findspace::distance
