// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/height_field.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace findspace::space {

const FieldFrame& HeightField::checked(const FieldFrame& frame) {
  if (frame.columns < 2 || frame.rows < 2)
    throw Error(ErrorCode::kBadValue, fmt::format("a height field has 2 columns and 2 rows at least, not {} and {}",
                                                  frame.columns, frame.rows));
  if (frame.columns > kMostHeights / frame.rows)
    throw Error(ErrorCode::kLimit, fmt::format("a height field of {} columns and {} rows has more than {} heights",
                                               frame.columns, frame.rows, kMostHeights));
  for (const exact::Real& step : frame.step)
    if (step.sign() <= 0)
      throw Error(ErrorCode::kBadValue, "the step of a height field must be more than 0, in x and in y");
  return frame;
}

HeightField::Lines::Lines(const exact::Real& first, const exact::Real& step, std::size_t count, const plane::Grid& grid,
                          const char* what)
    : at(count), moved(count) {
  for (std::size_t k = 0; k < count; ++k) {
    at[k] = grid.nearest(first + exact::Real(std::int64_t(k)) * step, moved[k]);
    if (k > 0 && at[k] == at[k - 1])
      throw Error(ErrorCode::kGeometry, fmt::format("{} {} and {} of the height field fall together on the grid: the "
                                                    "step {} is finer than the grid step {}",
                                                    what, k - 1, k, step.text(), grid.step().text()));
  }
}

HeightField::HeightField(const FieldFrame& frame, const plane::Grid& grid)
    : x_(frame.at[0], frame.step[0], checked(frame).columns, grid, "columns"),
      y_(frame.at[1], frame.step[1], frame.rows, grid, "rows"),
      step_size_(grid.step_size()),
      floor_(grid.nearest(frame.floor, floor_moved_)),
      heights_(frame.columns * frame.rows, kNone) {}

void HeightField::put(std::size_t column, std::size_t row, std::int64_t height, double moved) {
  if (height <= floor_)
    throw Error(ErrorCode::kGeometry,
                fmt::format("the floor must lie below every height: it is {:g}, and this height is {:g}",
                            double(floor_) * step_size_, double(height) * step_size_));
  heights_[node(column, row)] = height;
  rounding_.add(std::hypot(x_.moved[column], y_.moved[row]), moved);
}

bool HeightField::stands(std::size_t column, std::size_t row) const {
  if (column >= x_.at.size() - 1 || row >= y_.at.size() - 1) return false;
  const std::size_t a = node(column, row), b = node(column, row + 1);
  return std::max({heights_[a] == kNone, heights_[a + 1] == kNone, heights_[b] == kNone, heights_[b + 1] == kNone}) ==
         false;
}

/// Triangles above, walls where a square has no neighbour, and below each row few triangles that meet the walls.
class FieldSurface {
 public:
  explicit FieldSurface(const HeightField& field)
      : field_(field), above_(field.heights_.size(), -1), below_(field.heights_.size(), -1) {}

  /// How many squares there are.
  std::size_t squares() {
    std::size_t count = 0;
    for (std::size_t row = 0; row < rows(); ++row)
      for (std::size_t column = 0; column < columns(); ++column)
        if (field_.stands(column, row)) count += square(column, row);
    for (std::size_t row = 0; row < rows(); ++row)
      for (std::size_t from = 0, to = 0; from < columns(); from = to + 1) {
        for (to = from; field_.stands(to, row);) ++to;
        if (to > from) strip(row, from, to);
      }
    return count;
  }
  std::size_t columns() const { return field_.x_.at.size() - 1; }
  std::size_t rows() const { return field_.y_.at.size() - 1; }
  Mesh take() { return std::move(mesh_); }

 private:
  using Node = std::array<std::size_t, 2>;     // column, row
  static constexpr std::size_t kLongest = 32;  // squares above a triangle below

  int vertex(const Node& n, std::vector<int>& known, std::int64_t z) {
    int& index = known[field_.node(n[0], n[1])];
    if (index < 0) {
      index = int(mesh_.vertices.size());
      mesh_.vertices.push_back({field_.x_.at[n[0]], field_.y_.at[n[1]], z});
    }
    return index;
  }
  int above(const Node& n) { return vertex(n, above_, field_.heights_[field_.node(n[0], n[1])]); }
  int below(const Node& n) { return vertex(n, below_, field_.floor_); }

  std::size_t square(std::size_t i, std::size_t j) {
    const std::array<Node, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    const int a = above(corners[0]), b = above(corners[1]), c = above(corners[2]), d = above(corners[3]);
    mesh_.faces.push_back({a, b, c});
    mesh_.faces.push_back({a, c, d});
    const bool beside[4] = {field_.stands(i, j - 1), field_.stands(i + 1, j), field_.stands(i, j + 1),
                            field_.stands(i - 1, j)};
    for (std::size_t k = 0; k < 4; ++k) {
      const Node &from = corners[k], &to = corners[(k + 1) % 4];
      if (!beside[k]) mesh_.faces.push_back({below(from), below(to), above(to), above(from)});
    }
    return 1;
  }

  /// Below the squares of a row from one column to another: triangles between the corners of walls on its two sides,
  /// and some others, as searches look at all that is near a long triangle.
  void strip(std::size_t row, std::size_t from, std::size_t to) {
    std::array<std::vector<int>, 2> side;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t i = from; i <= to; ++i)
        if (below_[field_.node(i, row + s)] >= 0 || i % kLongest == 0) side[s].push_back(below({i, row + s}));
    const auto x = [&](std::size_t s, std::size_t k) { return mesh_.vertices[std::size_t(side[s][k])].x; };
    for (std::size_t p = 0, q = 0; p + 1 < side[0].size() || q + 1 < side[1].size();) {
      const bool low = q + 1 == side[1].size() || (p + 1 < side[0].size() && x(0, p + 1) < x(1, q + 1));
      const int next = low ? side[0][p + 1] : side[1][q + 1];
      mesh_.faces.push_back({side[0][p], side[1][q], next});
      ++(low ? p : q);
    }
  }

  const HeightField& field_;
  std::vector<int> above_, below_;  // the vertex at each meeting of lines, or -1
  Mesh mesh_;
};

Solid HeightField::solid(plane::RoundingLog& log, std::vector<std::string>& notes) const {
  FieldSurface surface(*this);
  const std::size_t all = surface.columns() * surface.rows(), there = surface.squares();
  if (there == 0)
    throw Error(ErrorCode::kGeometry, "no square of the height field has a height at each of its corners");
  if (there < all)
    notes.push_back(
        fmt::format("{} of {} squares of the height field have a corner without a height: nothing stands "
                    "there",
                    all - there, all));
  log.add(floor_moved_, 0);
  log.points += rounding_.points;
  log.largest = std::max(log.largest, rounding_.largest);
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.simple = true;
  solid.mesh = surface.take();
  solid.step = step_size_;
  return solid;
}

}  // namespace findspace::space
