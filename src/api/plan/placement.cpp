// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From public demands to a placement problem of the layer `planning`, and back to public values.

#include "findspace/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "api/plan/placement_data.h"
#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "plane/build/build.h"
#include "planning/order/demands.h"
#include "space/shape/rotated_shape.h"

namespace findspace {

using exact::Real;

namespace {

constexpr int kMostCopies = 10000;

Real within_a_turn(const Real& degrees) { return degrees - Real(360) * Real(exact::floor(degrees / Real(360))); }

planning::AskedBody asked_body(const Body& body, const formula::Context& all, std::set<std::string>& known) {
  planning::AskedBody out{fmt::format("{}", fmt::join(body.shapes, "+")), body.shapes, {}, body.count};
  if (body.shapes.empty()) throw Error(ErrorCode::kBadValue, "a body has at least one shape");
  const std::string place = fmt::format("body '{}'", out.name);
  for (const std::string& name : body.shapes) {
    if (std::find(all.shapes.begin(), all.shapes.end(), name) == all.shapes.end()) {
      try {
        api::unknown_shape(all, name);
      } catch (const Error& e) {
        throw e.within(place);
      }
    }
    if (!known.insert(name).second)
      throw Error(ErrorCode::kBadValue, fmt::format("'{}' stands here twice; several of a shape are a count", name),
                  place);
  }
  for (const Number& angle : body.angles) {
    Real degrees = within_a_turn(api::real_of(angle));
    const auto same = [&](const planning::Orientation& t) { return t.degrees == degrees; };
    if (std::none_of(out.angles.begin(), out.angles.end(), same)) out.angles.emplace_back(std::move(degrees));
  }
  if (out.angles.empty()) throw Error(ErrorCode::kBadValue, "no angles: nothing is allowed", place);
  if (body.count < 1 || body.count > kMostCopies)
    throw Error(ErrorCode::kBadValue, fmt::format("a count is a whole number from 1 to {}", kMostCopies), place);
  return out;
}

/// A formula that is read later; errors say which it is.
planning::Unread<formula::Formula> unread(const Formula& formula, std::string what) {
  return {[text = formula.text(), what](const formula::Context& context) {
            try {
              return formula::parse_formula(text, context);
            } catch (const Error& e) {
              throw e.within(what);
            }
          },
          std::move(what)};
}

planning::Asked asked_of(const Demands& demands, const formula::Context& all) {
  planning::Asked out;
  std::set<std::string> known;
  for (const Body& body : demands.bodies) out.bodies.push_back(asked_body(body, all, known));
  if (out.bodies.empty()) throw Error(ErrorCode::kBadValue, "nothing is to be placed");
  if (demands.each) out.each = unread(*demands.each, "each");
  if (demands.pairs) out.pairs = unread(*demands.pairs, "pairs");
  for (std::size_t k = 0; k < demands.constraints.size(); ++k)
    out.constraints.push_back(unread(demands.constraints[k], fmt::format("constraint {}", k)));
  for (const std::string& text : demands.minimize)
    out.minimize.push_back({[text](const formula::Context& c) { return formula::parse_goal(text, c); }, text});
  return out;
}

formula::Context context_of(const std::map<std::string, Shape>& shapes, const std::string& unit) {
  if (shapes.empty()) throw Error(ErrorCode::kBadValue, "there are no shapes");
  for (const char* word : {"self", "other"})
    if (shapes.count(word) > 0)
      throw Error(ErrorCode::kBadValue, fmt::format("in a placement no shape may be called '{}'", word));
  formula::Context out = api::context_of(shapes, unit);
  out.moving.clear();
  return out;
}

planning::Problem planar_problem(const std::map<std::string, Shape>& shapes, const plane::Grid& grid,
                                 planning::AskedDemands asked) {
  planning::Problem out{std::move(asked.demands), {}};
  for (const auto& [name, shape] : shapes) out.world.shapes.emplace(name, api::region_on(shape, grid, name));
  for (const planning::RotatedShape& t : asked.rotated) {
    plane::Shape turn;
    turn.kind = plane::Shape::Kind::kRotate;
    turn.points = {plane::GridPoint{0, 0}};
    turn.degrees = t.turn.degrees;
    turn.children = {api::tree_on(shapes.at(t.shape), grid)};
    out.world.shapes.emplace(t.name, plane::build(turn, grid.step_size()).region);
  }
  std::set<std::string> moving;
  for (const planning::Body& body : out.bodies)
    for (const auto& names : body.variants) moving.insert(names.begin(), names.end());
  out.world.moving.assign(moving.begin(), moving.end());
  out.world.step = grid.step();
  return out;
}

planning::SpaceProblem solid_problem(const std::map<std::string, Shape>& shapes, const plane::Grid& grid,
                                     planning::AskedDemands asked, int lines) {
  planning::SpaceProblem out;
  static_cast<planning::Demands&>(out) = std::move(asked.demands);
  for (const auto& [name, shape] : shapes) out.shapes.emplace(name, api::tree_on(shape, grid));
  for (const planning::RotatedShape& t : asked.rotated) {
    plane::Rounding rounding;
    out.shapes.emplace(t.name, space::rotated(*out.shapes.at(t.shape), t.turn.in_space(), rounding));
  }
  for (const auto& [name, tree] : out.shapes) out.built.emplace(name, api::solid_on(*tree));
  out.step = grid.step();
  out.lines = lines;
  return out;
}

void place_planar(const Demands& demands, const plane::Grid& grid, const planning::Limit& limit,
                  Placement::Data& data) {
  const planning::Relations relations(data.planar);
  const auto add = [&](std::size_t b, const std::vector<planning::AtAngle>& all) {
    api::tell_positions(data.planar.bodies[b], b, all, grid, data.unit, data.told);
  };
  if (demands.together) {
    const auto& found = std::get<1>(data.in_plane.emplace(planning::place_simultaneously(relations, limit)));
    data.told = api::told(outcome(data.planar, found), grid.step());
    for (std::size_t b = 0; b < found.positions.size(); ++b) add(b, found.positions[b]);
  } else {
    const auto& found = std::get<0>(data.in_plane.emplace(planning::place_sequentially(relations, limit)));
    data.told = api::told(outcome(data.planar, found), grid.step());
    for (std::size_t b = 0; b < found.steps.size(); ++b) add(b, found.steps[b].positions);
  }
}

void place_solid(const Demands& demands, const planning::Limit& limit, Placement::Data& data) {
  const planning::SpaceProblem& problem = data.solid;
  if (demands.together) {
    const auto& found = std::get<1>(data.in_space.emplace(planning::place_together_in_space(problem, limit)));
    data.told = api::told(outcome(problem, found), problem.step);
  } else {
    const auto& found = std::get<0>(data.in_space.emplace(planning::place_in_space(problem, limit)));
    data.told = api::told(outcome(problem, found), problem.step);
  }
}

}  // namespace

namespace api {

Placement::Told told(const planning::Outcome& outcome, const Real& step) {
  Placement::Told out;
  out.complete = outcome.complete();
  out.unproven = outcome.unproven.value_or("");
  for (const planning::BodyOutcome& b : outcome.placed) {
    Placement::Placed& placed = out.placed.emplace_back();
    placed.body = b.shape;
    placed.copy = b.copy;
    placed.attained = b.attained;
    if (b.angle) placed.degrees = b.angle->degrees.to_double();
    if (b.at.empty()) continue;
    placed.at.emplace();
    for (const Real& c : b.at) {
      placed.at->push_back((c * step).to_double());
      placed.exact_at.push_back(Exact(std::make_shared<const Exact::Data>(Exact::Data{c * step})));
    }
  }
  return out;
}

void tell_positions(const planning::Body& body, std::size_t index, const std::vector<planning::AtAngle>& all,
                    const plane::Grid& grid, const std::string& unit, Placement::Told& out) {
  for (const planning::AtAngle& at : all)
    out.positions.push_back({index, body.angles[at.angle].degrees.to_double(), make_region(at.region, grid, unit)});
}

}  // namespace api

Placement place(const std::map<std::string, Shape>& shapes, const Demands& demands, const WorldOptions& world,
                const Options& options) {
  const planning::Limit limit(options.seconds);
  Options others = options;
  others.seconds = 0;  // what was found by then is given
  return api::limited(others, [&] {
    const formula::Context all = context_of(shapes, world.unit);
    const plane::Grid grid = api::grid_of(shapes);
    planning::AskedDemands asked = planning::demands_of(asked_of(demands, all), all);
    auto data = std::make_shared<Placement::Data>(Placement::Data{world.unit, all.shapes});
    if (all.dimension == 2) {
      data->planar = planar_problem(shapes, grid, std::move(asked));
      place_planar(demands, grid, limit, *data);
    } else {
      data->solid = solid_problem(shapes, grid, std::move(asked), demands.lines);
      place_solid(demands, limit, *data);
    }
    return Placement(std::move(data));
  });
}

Placement::Told Placement::told() const {
  Told out = data_->told;
  out.json = json();
  out.svg = svg();
  return out;
}

Placement::Placement(Told told) {
  auto data = std::make_shared<Data>();
  data->told = std::move(told);
  data_ = std::move(data);
}

const std::vector<Placement::Placed>& Placement::placed() const { return data_->told.placed; }
bool Placement::complete() const { return data_->told.complete; }
const std::string& Placement::unproven() const { return data_->told.unproven; }
const std::vector<Placement::Positions>& Placement::positions() const { return data_->told.positions; }

}  // namespace findspace
