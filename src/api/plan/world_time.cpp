// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Worlds in motion, and the poses of a shape that may turn.

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/planar/solve_region.h"
#include "plane/query/locate_line.h"
#include "planning/pose/pose_stack.h"

namespace findspace {

using exact::Real;

World World::with(const Motion& motion) const {
  data_->plane("a motion");
  auto data = std::make_shared<Data>(*data_);
  data->motion = motion;
  data->time.reset();
  data->context.motion = true;
  api::make_solver(*data);
  return World(std::move(data));
}

World World::at_time(const Number& time) const {
  if (!data_->motion) throw Error(ErrorCode::kBadValue, "the world has no motion");
  const Real t = api::real_of(time);
  const formula::Motion motion = api::motion_of(*data_, *data_->motion);
  if (t < motion.start || motion.end < t)
    throw Error(ErrorCode::kBadValue, "the time is outside that of the motion, " + data_->motion->start.text() +
                                          " to " + data_->motion->end.text());
  auto data = std::make_shared<Data>(*data_);
  data->time = time;
  api::make_solver(*data);
  return World(std::move(data));
}

RegionBounds World::solve_bounds(const Formula& formula) const {
  const formula::Solver& solver = data_->plane("the region of a formula");
  return api::limited(data_->options, [&] {
    const formula::Formula asked = data_->formula(formula.text());
    formula::SolvedRegion found = formula::solve_region(solver, asked);
    const Region inner = data_->region(std::move(found.region));
    return RegionBounds{inner, found.outer ? data_->region(*std::move(found.outer)) : inner};
  });
}

namespace {

std::vector<Interval> in_time(const plane::Section& line) {
  const auto end = [](const std::optional<Real>& t) { return t ? std::optional(t->to_double()) : std::nullopt; };
  std::vector<Interval> out;
  for (const plane::LineInterval& i : plane::intervals(line, Real(1)))
    out.push_back({end(i.from), end(i.to), i.from_in, i.to_in});
  return out;
}

std::vector<PoseMap::Slice> slices_of(const World::Data& world, std::vector<planning::PoseSlice> found) {
  std::vector<PoseMap::Slice> out;
  for (planning::PoseSlice& s : found) {
    PoseMap::Slice& slice =
        out.emplace_back(PoseMap::Slice{s.degrees.to_double(), world.region(std::move(s.region)), std::nullopt});
    if (s.outer) slice.outer = world.region(*std::move(s.outer));
  }
  return out;
}

PoseMap poses_of(const World::Data& world, const Formula& formula, std::vector<Real> degrees, const Point& about) {
  const formula::Solver& solver = world.plane("a map of poses");
  if (world.motion) throw Error(ErrorCode::kUnsupported, "poses of shapes that move in time are not computed");
  if (degrees.empty()) throw Error(ErrorCode::kBadValue, "no angles");
  return api::limited(world.options, [&] {
    plane::RoundingLog rounding;
    const plane::GridPoint pole = world.grid.nearest(api::real_of(about.x), api::real_of(about.y), rounding);
    planning::PoseStack found =
        planning::pose_stack(solver.world(), world.formula(formula.text()), pole, std::move(degrees));
    PoseMap out{slices_of(world, std::move(found.slices)), {}};
    for (planning::PoseSector& s : found.sectors)
      out.sectors.push_back({s.from.to_double(), s.to.to_double(), s.bound, world.region(std::move(s.inner)),
                             world.region(std::move(s.outer))});
    return out;
  });
}

}  // namespace

Instants World::instants(const Formula& formula, const Point& p) const {
  const formula::Solver& solver = data_->plane("instants");
  if (!data_->motion) throw Error(ErrorCode::kBadValue, "the world has no motion");
  const distance::Coordinates place = api::place_of(*data_, p);
  const exact::RealPoint at{place[0], place[1]};
  return api::limited(data_->options, [&] {
    const formula::Formula asked = data_->formula(formula.text());
    const formula::SolvedInstants found = solver.solve_instants(asked, at);
    const std::vector<Interval> certain = in_time(found.instants);
    return Instants{certain, found.outer ? in_time(*found.outer) : certain, !found.outer};
  });
}

PoseMap World::poses(const Formula& formula, const std::vector<Number>& degrees, const Point& about) const {
  std::vector<Real> angles;
  for (const Number& d : degrees) angles.push_back(api::real_of(d));
  return poses_of(*data_, formula, std::move(angles), about);
}

PoseMap World::poses(const Formula& formula, int count, const Point& about) const {
  constexpr int kMost = 10000;
  if (count < 1 || count > kMost) throw Error(ErrorCode::kBadValue, "a number of angles is from 1 to 10000");
  std::vector<Real> angles;
  for (int k = 0; k < count; ++k) angles.push_back(Real::ratio(exact::int128(360) * k, count));
  return poses_of(*data_, formula, std::move(angles), about);
}

}  // namespace findspace
