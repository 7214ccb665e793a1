// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/solid_containment.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "packing/solid_proof/solid_pair_proof.h"
#include "space/surface/surface_side.h"

namespace findspace::packing {
namespace {

std::int64_t scale_of_surface(const SolidForm& form) {
  return form.surface.empty() ? form.body.scale : form.surface_scale;
}

space::RealVector place_in_steps(const std::array<Fraction, 3>& at, int128 steps) {
  return {in_steps(at[0], steps), in_steps(at[1], steps), in_steps(at[2], steps)};
}

class InSurface : public SolidContainment {
 public:
  InSurface(const SolidProblem& problem, const SolidContainer& container, const SolidForm& form)
      : steps_(bounded_product(problem.steps(), scale_of_surface(form))),
        container_(surfaces_of(*container.inside, scale_of_surface(form))),
        form_(surfaces_of(form, scale_of_surface(form))),
        gaps_(container_, form_) {}

  bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    const space::RealVector p = place_in_steps(at, steps_);
    if (gaps_.relation(p) != space::SurfaceGaps::Relation::kInside) return false;
    return edge == 0 || !(gaps_.gap(p, gaps_.near(p)).value < in_steps(edge, steps_));
  }

  double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    const space::RealVector p = place_in_steps(at, steps_);
    const double steps = double(steps_);
    if (gaps_.relation(p) == space::SurfaceGaps::Relation::kInside)
      return edge.to_double() - gaps_.gap(p, gaps_.near(p)).value.to_double() / steps;
    const space::SurfaceSet::Sheet& walls = *container_->sheets()[0];
    double most = 0;
    const auto look_at = [&](const space::Point& q, double radius) {
      const space::RealVector x = space::plus(space::real(q), p);
      const double far = space::length(space::rounded(space::way_to(walls, x)));
      const bool held = space::side_of(walls.body, walls.tree, x, space::rounded(x)) == space::SurfaceSide::kInside;
      most = std::max(most, (held ? radius - far : radius + far) / steps);
    };
    for (const auto& sheet : form_->sheets())
      for (const space::Point& q : sheet->body.points) look_at(q, 0);
    for (const space::SurfaceSet::Ball& ball : form_->balls()) look_at(ball.center, ball.radius.to_double());
    return most > 0 ? most : depth_of_walls(p) / steps;
  }

 private:
  /// How deep a corner of the walls lies in the form at p, as that of a hollow that it covers; of balls look_at()
  /// tells.
  double depth_of_walls(const space::RealVector& p) const {
    double most = 0;
    for (const space::Point& q : container_->sheets()[0]->body.points) {
      const space::RealVector x = space::minus(space::real(q), p);
      for (const auto& sheet : form_->sheets())
        if (space::side_of(sheet->body, sheet->tree, x, space::rounded(x)) == space::SurfaceSide::kInside)
          most = std::max(most, space::length(space::rounded(space::way_to(*sheet, x))));
    }
    return most;
  }

  int128 steps_;  // in a unit
  std::shared_ptr<const space::SurfaceSet> container_, form_;
  space::SurfaceGaps gaps_;
};

/// A ball is convex: the corners of the form decide, and its balls.
class InBall : public SolidContainment {
 public:
  /// The ball's coordinates are in steps / scale.
  InBall(const SolidProblem& problem, const space::BodyPart& ball, std::int64_t ball_scale, const SolidForm& form)
      : steps_(problem.steps()),
        center_(on_grid(ball.center, ball_scale)),
        radius_(ball.radius / exact::Real(ball_scale)) {
    const auto add = [&](const space::Point& p, std::int64_t scale, const exact::Real& radius) {
      corners_.push_back({on_grid(p, scale), radius / exact::Real(scale)});
    };
    if (form.is_exact())
      for (const space::BodyPart& part : form.body.parts)
        for (const space::Point& p : part.vertices()) add(p, form.body.scale, part.radius);
    else
      for (const space::RaySolid& solid : form.surface)
        for (const space::Point& p : solid.surface.points) add(p, form.surface_scale, {});
  }

  bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    const space::RealVector from_center = space::minus(place_in_steps(at, steps_), center_);
    const exact::Real most = radius_ - in_steps(edge, steps_);
    return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& corner) {
      const space::RealVector way = space::plus(corner.at, from_center);
      const exact::Real room = most - corner.radius;
      return room.sign() >= 0 && !(room * room < space::dot(way, way));
    });
  }

  double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    const space::RealVector from_center = space::minus(place_in_steps(at, steps_), center_);
    double most = 0;
    for (const Corner& corner : corners_)
      most = std::max(most, space::length(space::rounded(space::plus(corner.at, from_center))) +
                                (corner.radius - radius_).to_double());
    return most / double(steps_) + edge.to_double();
  }

 private:
  struct Corner {
    space::RealVector at;
    exact::Real radius;
  };

  static space::RealVector on_grid(const space::Point& p, std::int64_t scale) {
    return space::scaled(exact::Real::ratio(1, scale), space::real(p));
  }

  int128 steps_;  // in a unit
  space::RealVector center_;
  exact::Real radius_;
  std::vector<Corner> corners_;
};

/// It keeps out of the cells of the box that the container lacks.
class OutOfCells : public SolidContainment {
 public:
  OutOfCells(const SolidProblem& problem, const SolidContainer& container, const SolidForm& form)
      : cells_(problem, *container.lacks, form) {}

  bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    return !cells_.interiors_meet(at) && (edge == 0 || !cells_.is_nearer(at, edge));
  }

  double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    return cells_.interiors_meet(at) ? cells_.depth(at) + edge.to_double() : 0;
  }

 private:
  SolidPairProof cells_;
};

class InAll : public SolidContainment {
 public:
  explicit InAll(std::vector<std::unique_ptr<const SolidContainment>> ways) : ways_(std::move(ways)) {}

  bool holds(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    return std::all_of(ways_.begin(), ways_.end(), [&](const auto& way) { return way->holds(at, edge); });
  }

  double excess(const std::array<Fraction, 3>& at, const Fraction& edge) const override {
    double most = 0;
    for (const auto& way : ways_) most = std::max(most, way->holds(at, edge) ? 0 : way->excess(at, edge));
    return most;
  }

 private:
  std::vector<std::unique_ptr<const SolidContainment>> ways_;
};

}  // namespace

std::unique_ptr<const SolidContainment> containment_of(const SolidProblem& problem, const SolidContainer& container,
                                                       const SolidForm& form) {
  std::vector<std::unique_ptr<const SolidContainment>> ways;
  const space::Body& inside = container.inside->body;
  if (container.inside->has_balls())
    for (const space::BodyPart& ball : inside.parts)
      ways.push_back(std::make_unique<const InBall>(problem, ball, inside.scale, form));
  if (container.lacks) ways.push_back(std::make_unique<const OutOfCells>(problem, container, form));
  if (ways.empty()) return std::make_unique<const InSurface>(problem, container, form);
  return std::make_unique<const InAll>(std::move(ways));
}

}  // namespace findspace::packing
