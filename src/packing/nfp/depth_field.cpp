// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/depth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::packing {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

DepthField::DepthField(NoFitPolygon polygon) : polygon_(std::move(polygon)), cells_(std::size_t(kCells) * kCells) {
  const double width = polygon_.high.x - polygon_.low.x, height = polygon_.high.y - polygon_.low.y;
  inverse_x_ = width > 0 ? kCells / width : 0;
  inverse_y_ = height > 0 ? kCells / height : 0;
  for (std::size_t e = 0; e < polygon_.edges.size(); ++e) {
    const NoFitEdge& edge = polygon_.edges[e];
    const Vec way = edge.to - edge.from;
    const double square = dot(way, way);
    segments_.push_back({edge.from, edge.to, way, square > 0 ? 1 / square : 0, square > 0 ? 1 / std::sqrt(square) : 0,
                         int(e), edge.slit});
  }
  scratch_.resize(segments_.size());
  if (width <= 0 || height <= 0) return;
  for (int row = 0; row < kCells; ++row)
    for (int column = 0; column < kCells; ++column) fill(column, row);
}

/// The square of the distance to a segment and its foot.
static double square_to(const Vec from, const Vec to, const Vec way, double inverse_square, Vec t, Vec& foot) {
  const double along = dot(t - from, way) * inverse_square;
  foot = along <= 0 ? from : along >= 1 ? to : from + along * way;
  const Vec off = t - foot;
  return dot(off, off);
}

Nearest DepthField::nearest(const Cell& cell, Vec t) const {
  double best = kFar, side = 0;
  Nearest result;
  for (std::uint32_t k = cell.begin; k < cell.end; ++k) {
    const Segment& s = segments_[lists_[k]];
    Vec foot;
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, t, foot);
    if (square > best) continue;
    // Of two edges that share the nearest vertex, the one whose line is farther knows the side.
    const double height = s.slit ? 0 : cross(s.way, t - s.from) * s.inverse_length;
    if (square == best && std::abs(height) <= std::abs(side)) continue;
    best = square;
    side = height;
    result.edge = s.edge;
    result.foot = foot;
  }
  if (cell.kind == Kind::kMixed && side < 0) return {};
  result.depth = std::sqrt(best);
  return result;
}

void DepthField::fill(int column, int row) {
  Cell& cell = cells_[std::size_t(row * kCells + column)];
  const Vec half{0.5 / inverse_x_, 0.5 / inverse_y_};
  const Vec middle{polygon_.low.x + (2 * column + 1) * half.x, polygon_.low.y + (2 * row + 1) * half.y};
  const double radius = std::sqrt(dot(half, half));
  double nearest_square = kFar, side = 0;
  Vec foot;
  for (std::size_t e = 0; e < segments_.size(); ++e) {
    const Segment& s = segments_[e];
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, middle, foot);
    scratch_[e] = square;
    if (square > nearest_square) continue;
    const double height = s.slit ? 0 : cross(s.way, middle - s.from) * s.inverse_length;
    if (square == nearest_square && std::abs(height) <= std::abs(side)) continue;
    nearest_square = square;
    side = height;
  }
  const double distance = std::sqrt(nearest_square);
  if (distance > radius && side < 0) return;
  cell.kind = distance > radius ? Kind::kInside : Kind::kMixed;
  cell.least = float(std::max(0.0, 0.999 * (distance - radius)));
  const double reach = (distance + 2 * radius) * (distance + 2 * radius);
  // The greatest distance in the cell to the edge whose greatest is least: what is farther everywhere is never nearest.
  double least_greatest = kFar;
  const auto corners = {middle + half, middle - half, Vec{middle.x + half.x, middle.y - half.y},
                        Vec{middle.x - half.x, middle.y + half.y}};
  for (std::size_t e = 0; e < segments_.size(); ++e) {
    if (scratch_[e] > reach) continue;
    double greatest = 0;
    const Segment& s = segments_[e];
    for (const Vec c : corners)
      greatest = std::max(greatest, square_to(s.from, s.to, s.way, s.inverse_square, c, foot));
    least_greatest = std::min(least_greatest, greatest);
  }
  cell.begin = std::uint32_t(lists_.size());
  const double keep = std::sqrt(least_greatest) + radius;
  for (std::size_t e = 0; e < segments_.size(); ++e)
    if (scratch_[e] <= reach && scratch_[e] <= keep * keep) lists_.push_back(std::uint32_t(e));
  cell.end = std::uint32_t(lists_.size());
}

}  // namespace findspace::packing
