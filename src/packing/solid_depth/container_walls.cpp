// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/container_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "space/body/outside_cells.h"

namespace findspace::packing {
namespace {

/// The axis of a plane across it, and whether it looks to its high end.
struct Across {
  std::size_t axis;
  bool high;
};

std::optional<Across> across_axis(const space::HalfSpace& h) {
  std::optional<Across> result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (h.normal[k].sign() == 0) continue;
    if (result) return std::nullopt;
    result = Across{k, h.normal[k].sign() > 0};
  }
  return result;
}

class Walls {
 public:
  Walls(const SolidProblem& problem, const SolidContainer& container)
      : container_(container), body_(container.inside->body) {
    const int128 steps = bounded_product(problem.steps(), body_.scale);
    const Fraction sides[] = {container.width, container.depth, container.height};
    for (std::size_t k = 0; k < 3; ++k) sides_[k] = in_steps(sides[k], steps);
    steps_ = double(steps);
  }

  ContainerWalls all() const {
    ContainerWalls result;
    if (container_.lacks) add_lacking(result);
    if (container_.inside->has_balls())
      add_balls(result);
    else if (!container_.lacks)
      add_outside(result);
    return result;
  }

 private:
  void add_outside(ContainerWalls& result) const {
    const std::vector<space::OutsideCell> cells = space::outside_cells(body_);
    const std::int64_t scale = scale_of(cells);
    for (const space::OutsideCell& cell : cells) {
      if (cell.bounded())
        add_cell(cell, scale, result);
      else if (!across_axis(cell.planes[0]))
        result.planes.push_back({cell.planes[0].unit, cell.planes[0].shift / steps_});
    }
  }

  void add_balls(ContainerWalls& walls) const {
    for (const space::BodyPart& ball : body_.parts)
      walls.balls.push_back({(1 / steps_) * exact::approx(ball.center), ball.radius.to_double() / steps_});
  }

  void add_lacking(ContainerWalls& walls) const {
    const space::Body& lacks = container_.lacks->body;
    for (const space::BodyPart& part : lacks.parts) {
      ContainerWalls::Cell& wall = walls.cells.emplace_back();
      wall.body.scale = lacks.scale;
      wall.body.parts.push_back(part);
      wall.open = open_sides(part.planes(), lacks.scale / body_.scale);
    }
  }

  /// That of the body where all corners lie on its grid, else as fine as coordinates allow.
  std::int64_t scale_of(const std::vector<space::OutsideCell>& cells) const {
    double farthest = 1;
    bool is_whole = true;
    for (const space::OutsideCell& cell : cells)
      for (const space::RealVector& v : cell.vertices)
        for (const exact::Real& c : v) {
          is_whole &= c.integer().has_value();
          farthest = std::max(farthest, std::abs(c.to_double()) / double(body_.scale));
        }
    return is_whole ? body_.scale : std::int64_t(double(space::kCoordinateLimit) / 4 / farthest);
  }

  void add_cell(const space::OutsideCell& cell, std::int64_t scale, ContainerWalls& walls) const {
    const double finer = double(scale) / double(body_.scale);
    const auto rounded = [&](const exact::Real& c) { return std::int64_t(std::llround(c.to_double() * finer)); };
    std::vector<space::Point> corners;
    for (const space::RealVector& v : cell.vertices) corners.push_back({rounded(v[0]), rounded(v[1]), rounded(v[2])});
    if (!space::Polytope::try_hull(corners)) return;  // thinner than the grid
    ContainerWalls::Cell& wall = walls.cells.emplace_back();
    wall.body.scale = scale;
    wall.body.parts.push_back(space::part_of(corners, {}));
    wall.open = open_sides(cell.planes, 1);
  }

  /// Of planes in steps that many times as fine.
  OpenSides open_sides(const std::vector<space::HalfSpace>& planes, std::int64_t finer) const {
    OpenSides open{};
    for (const space::HalfSpace& h : planes) {
      const std::optional<Across> across = across_axis(h);
      if (!across) continue;
      const std::size_t k = across->axis;
      const exact::Real end = across->high ? sides_[k] * exact::Real(finer) : exact::Real();
      if ((h.normal[k] * end + h.offset).sign() == 0) open[k][across->high ? 1 : 0] = true;
    }
    return open;
  }

  const SolidContainer& container_;
  const space::Body& body_;           // of its inside
  std::array<exact::Real, 3> sides_;  // in its steps
  double steps_;
};

}  // namespace

ContainerWalls container_walls(const SolidProblem& problem, const SolidContainer& container) {
  return Walls(problem, container).all();
}

}  // namespace findspace::packing
