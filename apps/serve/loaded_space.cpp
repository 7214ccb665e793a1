// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/loaded_space.h"

#include <fmt/format.h>

#include "findspace/error.h"
#include "formula/explain/explain.h"
#include "io/mesh/space_surface.h"
#include "io/question/ray_map.h"
#include "io/question/space_line.h"
#include "io/question/space_map.h"
#include "io/question/space_shapes.h"
#include "io/write/write_explanation.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"

namespace findspace::app {
namespace {

using exact::Real;
using space::RealVector;

/// Lines each way where none are asked for: of a region, and of a shape that has no surface of flat faces.
constexpr int kLines = 64, kShapeLines = 48;

RealVector vector_of(const Spot& spot) { return {spot.at[0], spot.at[1], spot.at[2]}; }

}  // namespace

LoadedSpace::LoadedSpace(io::Scene given) : Loaded(std::move(given)) {
  read_formula();
  with_session([&](const Session& session) {
    if (!scene().moving.empty()) session.require_positions_in_space(true);
    solver_ = std::make_shared<const formula::SpaceSolver>(space_world(session));
  });
}

std::string LoadedSpace::drawing_of(const std::string& name) const {
  const plane::Shape& shape = *scene().shape(name);
  return with_session([&](const Session& session) {
    SpaceDrawing out;
    if (const auto boundary = formula::shape_boundary(shape))
      out.solid = io::surface_of(*boundary, session.step());
    else
      out.solid = io::surface_on_lines(shape, kShapeLines, session.step().to_double());
    return out.json();
  });
}

formula::SpaceRegion LoadedSpace::solved(const formula::Formula& formula, const std::string& apply) const {
  return with_session([&](const Session& session) {
    return io::space_map(session, *solver_, formula, {apply, {}}, true);
  });
}

std::string LoadedSpace::map_of_line(const RegionQuery& query, const formula::Formula& wanted) const {
  return with_session([&](const Session& session) {
    const io::SpaceLineMap map = io::space_line_map(session, *solver_, wanted);
    std::string out = space_line_json(session, map);
    if (!query.drawing) return out;
    SpacePlace through{}, direction{};
    for (std::size_t k = 0; k < 3; ++k) {
      through[k] = double(scene().free.through[k]) * step();
      direction[k] = double(scene().free.direction[k]);
    }
    std::vector<plane::LineInterval> lengths = map.intervals;
    for (plane::LineInterval& i : lengths) {
      if (i.from) i.from = *i.from * session.step();
      if (i.to) i.to = *i.to * session.step();
    }
    return with_member(std::move(out), "drawing", drawing_of_line(lengths, through, direction, window()).json());
  });
}

SpaceWindow LoadedSpace::window() const {
  if (!window_) {
    SpaceWindow all;
    with_session([&](const Session& session) {
      for (const plane::ShapePtr& shape : scene().shapes) {
        const auto boundary = formula::shape_boundary(*shape);
        if (boundary) all.include(io::surface_of(*boundary, session.step()));
      }
    });
    window_ = all.wider();
  }
  return *window_;
}

std::string LoadedSpace::map_json(const RegionQuery& asked) const {
  require_moving();
  RegionQuery query = asked;
  query.drawing = query.drawing || query.brief;
  if (query.angle) refuse("an angle in space");
  const formula::Formula other = query.where ? parsed(*query.where) : formula::Formula{};
  const formula::Formula& wanted = query.where ? other : formula();
  if (scene().free.kind == io::Free::Kind::kLine) return map_of_line(query, wanted);
  formula::SpaceRegion made;
  const formula::SpaceRegion* map = &made;
  if (query.where || !query.apply.empty())
    made = solved(wanted, query.apply);
  else
    map = &region();
  return with_session([&](const Session& session) {
    if (map->way == distance::Way::kLines) {
      if (!query.apply.empty()) refuse("an operation on a region that only lines give");
      io::LineChoice lines;
      lines.count = query.resolution > 0 ? query.resolution : kLines;
      lines.axes = true;
      io::RaysDrawn drawn = io::draw_rays(session, lines, wanted);
      if (!query.drawing) return drawn.json;
      return with_member(std::move(drawn.json), "drawing", SpaceDrawing{std::move(drawn.surface), {}, {}, {}}.json());
    }
    std::string out = space_map_json(session, *map);
    if (!query.drawing) return out;
    const SpaceDrawing drawing = map->way == distance::Way::kConvex
                                     ? drawing_of_convex(map->convex->set, map->convex->step)
                                     : drawing_of_boxes(map->boxes, session.step(), window());
    return with_member(std::move(out), "drawing", drawing.json());
  });
}

const formula::SpaceRegion& LoadedSpace::region() const {
  if (!region_) region_ = solved(formula(), "");
  return *region_;
}

formula::TriedNearest LoadedSpace::nearest(const RealVector& at) const {
  if (scene().free.kind == io::Free::Kind::kLine) return exact::Refusal("positions are free on a line only");
  return formula::nearest_feasible(*solver_, formula(), at);
}

std::string LoadedSpace::check_json(const Spot& spot, const CheckQuery& query) const {
  require_moving();
  if (spot.angle || spot.time) refuse("an angle or an instant in space");
  RealVector at = vector_of(spot);
  formula::Check check = solver_->check(formula(), at);
  formula::AskedNearest near;
  if (!check.holds && (query.nearest || query.snap.sign() > 0)) near = nearest(at);
  const formula::NearestFeasible* there = found(near);
  if (there != nullptr && there->attained && there->distance <= query.snap) {
    at = {there->at[0], there->at[1], there->at[2]};
    check = solver_->check(formula(), at);
    near.reset();
  }
  if (!query.nearest) near.reset();
  return io::check_json(check, distance::coordinates(at), unit(), std::nullopt, near);
}

formula::TriedNearest LoadedSpace::nearest(const Spot& spot) const { return nearest(vector_of(spot)); }

std::string LoadedSpace::measure_json(const Spot& spot) const {
  require_moving();
  const RealVector at = vector_of(spot);
  return io::measure_json(solver_->measure(at), distance::coordinates(at), unit());
}

std::string LoadedSpace::explain_json(const std::optional<Spot>& spot) const {
  require_moving();
  if (spot && (spot->angle || spot->time)) refuse("an angle or an instant in space");
  if (scene().free.kind == io::Free::Kind::kLine) refuse("an explanation on a line");
  const formula::Explanation explanation = formula::explain(*solver_, formula());
  std::optional<formula::PositionExplanation> here;
  distance::Coordinates at;
  if (spot && !spot->at.empty()) {
    here = formula::explain_at(*solver_, formula(), vector_of(*spot));
    at = spot->at;
  }
  return io::explanation_json({formula(), explanation, here ? &*here : nullptr, at, solver_->world().step, unit()});
}
std::string LoadedSpace::angles_json(const Spot&) const { refuse("a map of angles in space"); }
std::string LoadedSpace::instants_json(const Spot&) const { refuse("a motion in space"); }
std::string LoadedSpace::between_json(const Spot&, const std::array<exact::RealPoint, 2>&) const {
  refuse("the distance between features in space");
}

}  // namespace findspace::app
