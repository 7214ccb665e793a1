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

/// The square of the distance to a segment and its projection.
double square_to(const Vec from, const Vec to, const Vec way, double inverse_square, Vec t, Vec& projection) {
  const double along = dot(t - from, way) * inverse_square;
  projection = along <= 0 ? from : along >= 1 ? to : from + along * way;
  const Vec off = t - projection;
  return dot(off, off);
}

}  // namespace

DepthField::DepthField(NoFitPolygon polygon) : polygon_(std::move(polygon)), cells_(std::size_t(kCells) * kCells) {
  const double width = polygon_.high.x - polygon_.low.x, height = polygon_.high.y - polygon_.low.y;
  inverse_x_ = width > 0 ? kCells / width : 0;
  inverse_y_ = height > 0 ? kCells / height : 0;
  polygon_.edges.shrink_to_fit();
  segments_.reserve(polygon_.edges.size());
  for (const NoFitEdge& edge : polygon_.edges) {
    const Vec way = edge.to - edge.from;
    const double square = dot(way, way);
    const double inverse = square > 0 ? 1 / square : 0;
    segments_.push_back({edge.from, edge.to, way, inverse, edge.slit ? 0 : std::sqrt(inverse)});
  }
  least_.assign(cells_.size(), 0);
  if (width <= 0 || height <= 0) return;
  std::vector<std::uint32_t> all(segments_.size());
  std::iota(all.begin(), all.end(), 0u);
  least_of_.assign(cells_.size(), -1);
  for (int row = 0; row < kCells; row += kBlock)
    for (int column = 0; column < kCells; column += kBlock) fill_block(column, row, kBlock, all, 0);
  keep_least();
  squares_ = least_of_ = std::vector<double>();
  choices_ = {};
  lists_.shrink_to_fit();
}

/// Rounded down to bytes.
void DepthField::keep_least() {
  constexpr double kMost = 254;
  least_step_ = std::max(0.0, *std::max_element(least_of_.begin(), least_of_.end())) / kMost;
  for (std::size_t k = 0; k < least_.size(); ++k)
    if (least_of_[k] >= 0)
      least_[k] = std::uint8_t(1 + (least_of_[k] > 0 ? std::max(0.0, std::floor(least_of_[k] / least_step_) - 1) : 0));
}

DepthGlance DepthField::glance(double sign, Vec shift) const {
  const Vec scale{sign * inverse_x_, sign * inverse_y_};
  const Vec from{(shift.x - polygon_.low.x) * inverse_x_, (shift.y - polygon_.low.y) * inverse_y_};
  return {scale, from, least_.data(), least_step_, cells_.data()};
}

Nearest DepthField::nearest(Vec t) const {
  const int index = cell_at(t);
  if (index == kNone) return {};
  const DepthCell& cell = cells_[std::size_t(index)];
  double best = kFar, side = 0;
  Nearest result;
  for (std::uint32_t k = cell.begin; k < cell.begin + cell.count; ++k) {
    const Segment& s = segments_[lists_[k]];
    Vec projection;
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, t, projection);
    if (square > best) continue;
    // Of two edges that share the nearest vertex, the one whose line is farther knows the side.
    const double height = cross(s.way, t - s.from) * s.inverse_length;
    if (square == best && std::abs(height) <= std::abs(side)) continue;
    best = square;
    side = height;
    result.edge = lists_[k];
    result.projection = projection;
  }
  if (cell.mixed && side < 0) return {};
  result.depth = std::sqrt(best);
  return result;
}

/// As nearest(), the depth alone.
double DepthField::depth(int index, Vec t) const {
  if (index == kNone) return 0;
  const DepthCell& cell = cells_[std::size_t(index)];
  double best = kFar, side = 0;
  const std::uint16_t* list = &lists_[cell.begin];
  for (std::uint32_t k = 0; k < cell.count; ++k) {
    const Segment& s = segments_[list[k]];
    Vec projection;
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, t, projection);
    if (square > best) continue;
    const double height = cross(s.way, t - s.from) * s.inverse_length;
    if (square == best && std::abs(height) <= std::abs(side)) continue;
    best = square;
    side = height;
  }
  return cell.mixed && side < 0 ? 0 : std::sqrt(best);
}

void DepthField::choose(Vec middle, Vec half, const std::vector<std::uint32_t>& from, Choice& choice) {
  squares_.clear();
  double least = kFar;
  std::uint32_t nearest = from.front();
  choice.side = 0;
  Vec projection;
  for (const std::uint32_t e : from) {
    const Segment& s = segments_[e];
    const double square = square_to(s.from, s.to, s.way, s.inverse_square, middle, projection);
    squares_.push_back(square);
    if (square > least) continue;
    const double height = cross(s.way, middle - s.from) * s.inverse_length;
    if (square == least && std::abs(height) <= std::abs(choice.side)) continue;
    least = square;
    nearest = e;
    choice.side = height;
  }
  choice.distance = std::sqrt(least);
  // What is farther everywhere than the nearest edge is at the farthest corner is never nearest.
  const double radius = std::sqrt(dot(half, half)), reach = choice.distance + 2 * radius;
  double greatest = 0;
  const Segment& s = segments_[nearest];
  for (const Vec c : {half, Vec{-half.x, half.y}, Vec{half.x, -half.y}, Vec{-half.x, -half.y}})
    greatest = std::max(greatest, square_to(s.from, s.to, s.way, s.inverse_square, middle + c, projection));
  const double keep = std::sqrt(std::min(greatest, reach * reach)) + radius;
  choice.edges.clear();
  for (std::size_t k = 0; k < from.size(); ++k)
    if (squares_[k] <= keep * keep) choice.edges.push_back(from[k]);
}

void DepthField::fill_block(int column, int row, int cells, const std::vector<std::uint32_t>& from, std::size_t level) {
  const Vec half{0.5 * cells / inverse_x_, 0.5 * cells / inverse_y_};
  const Vec middle{polygon_.low.x + (column + 0.5 * cells) / inverse_x_,
                   polygon_.low.y + (row + 0.5 * cells) / inverse_y_};
  Choice& choice = choices_[level];
  choose(middle, half, from, choice);
  const double radius = std::sqrt(dot(half, half));
  if (choice.distance > radius && choice.side < 0) return;  // all of it is outside
  if (cells == 1) return fill(std::size_t(row) * kCells + std::size_t(column), radius);
  const int quarter = cells / 2;
  for (const int r : {row, row + quarter})
    for (const int c : {column, column + quarter}) fill_block(c, r, quarter, choice.edges, level + 1);
}

void DepthField::fill(std::size_t index, double radius) {
  const Choice& choice = choices_[kLevels];
  DepthCell& cell = cells_[index];
  cell.mixed = choice.distance <= radius;
  least_of_[index] = std::max(0.0, choice.distance - radius);
  cell.begin = std::uint32_t(lists_.size());
  for (const std::uint32_t e : choice.edges) lists_.push_back(std::uint16_t(e));
  cell.count = std::uint16_t(choice.edges.size());
}

}  // namespace findspace::packing
