// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/depth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace findspace::packing {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The square of the distance to a segment and its foot.
double square_to(const Vec from, const Vec to, const Vec way, double inverse_square, Vec t, Vec& foot) {
  const double along = dot(t - from, way) * inverse_square;
  foot = along <= 0 ? from : along >= 1 ? to : from + along * way;
  const Vec off = t - foot;
  return dot(off, off);
}

}  // namespace

DepthField::DepthField(NoFitPolygon polygon) : polygon_(std::move(polygon)), cells_(std::size_t(kCells) * kCells) {
  const double width = polygon_.high.x - polygon_.low.x, height = polygon_.high.y - polygon_.low.y;
  inverse_x_ = width > 0 ? kCells / width : 0;
  inverse_y_ = height > 0 ? kCells / height : 0;
  for (const NoFitEdge& edge : polygon_.edges) {
    const Vec way = edge.to - edge.from;
    const double square = dot(way, way);
    const double inverse = square > 0 ? 1 / square : 0;
    segments_.push_back({edge.from, edge.to, way, inverse, edge.slit ? 0 : std::sqrt(inverse)});
  }
  if (width <= 0 || height <= 0) return;
  std::vector<std::uint32_t> all(segments_.size());
  std::iota(all.begin(), all.end(), 0u);
  for (int row = 0; row < kCells; row += kBlock)
    for (int column = 0; column < kCells; column += kBlock) fill_block(column, row, all);
}

Nearest DepthField::nearest(const Cell& cell, Vec t) const {
  double best = kFar, side = 0;
  Nearest result;
  for (std::uint32_t k = cell.begin; k < cell.begin + cell.count; ++k) {
    const Segment& s = segments_[lists_[k]];
    Vec foot;
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, t, foot);
    if (square > best) continue;
    // Of two edges that share the nearest vertex, the one whose line is farther knows the side.
    const double height = cross(s.way, t - s.from) * s.inverse_length;
    if (square == best && std::abs(height) <= std::abs(side)) continue;
    best = square;
    side = height;
    result.edge = lists_[k];
    result.foot = foot;
  }
  if (cell.kind == Kind::kMixed && side < 0) return {};
  result.depth = std::sqrt(best);
  return result;
}

void DepthField::choose(Vec middle, Vec half, const std::vector<std::uint32_t>& from, Choice& choice) {
  squares_.clear();
  double least = kFar;
  choice.side = 0;
  Vec foot;
  for (const std::uint32_t e : from) {
    const Segment& s = segments_[e];
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, middle, foot);
    squares_.push_back(square);
    if (square > least) continue;
    const double height = cross(s.way, middle - s.from) * s.inverse_length;
    if (square == least && std::abs(height) <= std::abs(choice.side)) continue;
    least = square;
    choice.side = height;
  }
  choice.distance = std::sqrt(least);
  // What is farther everywhere than an edge is at the farthest corner is never nearest.
  const double radius = std::sqrt(dot(half, half)), reach = choice.distance + 2 * radius;
  double least_greatest = reach * reach;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (squares_[k] > least_greatest) continue;
    const Segment& s = segments_[from[k]];
    double greatest = 0;
    for (const Vec c : {half, Vec{-half.x, half.y}, Vec{half.x, -half.y}, Vec{-half.x, -half.y}})
      greatest = std::max(greatest, square_to(s.from, s.to, s.way, s.inverse_square, middle + c, foot));
    least_greatest = std::min(least_greatest, greatest);
  }
  const double keep = std::sqrt(least_greatest) + radius;
  choice.edges.clear();
  for (std::size_t k = 0; k < from.size(); ++k)
    if (squares_[k] <= keep * keep) choice.edges.push_back(from[k]);
}

void DepthField::fill_block(int column, int row, const std::vector<std::uint32_t>& all) {
  const Vec half{0.5 / inverse_x_, 0.5 / inverse_y_};
  const auto middle_of = [&](int c, int r, int cells) {
    return Vec{polygon_.low.x + (2 * c + cells) * half.x, polygon_.low.y + (2 * r + cells) * half.y};
  };
  choose(middle_of(column, row, kBlock), double(kBlock) * half, all, block_);
  for (int r = row; r < row + kBlock; ++r)
    for (int c = column; c < column + kBlock; ++c)
      fill(cells_[std::size_t(r * kCells + c)], middle_of(c, r, 1), half, block_.edges);
}

void DepthField::fill(Cell& cell, Vec middle, Vec half, const std::vector<std::uint32_t>& from) {
  choose(middle, half, from, cell_);
  const double radius = std::sqrt(dot(half, half));
  if (cell_.distance > radius && cell_.side < 0) return;
  cell.kind = cell_.distance > radius ? Kind::kInside : Kind::kMixed;
  cell.least = float(std::max(0.0, 0.999 * (cell_.distance - radius)));
  if (cell.kind == Kind::kMixed) cell.least = 0;
  cell.begin = std::uint32_t(lists_.size());
  for (const std::uint32_t e : cell_.edges) lists_.push_back(std::uint16_t(e));
  cell.count = std::uint16_t(cell_.edges.size());
}

}  // namespace findspace::packing
