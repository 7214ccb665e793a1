// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/explanation.h>

#include "api/query/world_data.h"
#include "formula/language/text.h"
#include "formula/planar/solve_rotation.h"
#include "io/api/public_scene.h"
#include "io/question/map_answer.h"
#include "io/question/position_answer.h"
#include "io/write/write_explanation.h"

namespace findspace {
namespace {

std::vector<double> position(const distance::Coordinates& p) {
  std::vector<double> out;
  for (const exact::Real& c : p) out.push_back(c.to_double());
  return out;
}

/// Puts the place into a public value.
template <class Value>
void put_place(const io::ExplanationReport& report, const formula::RemainingPlace& place, Value& out) {
  out.angle = place.degrees;
  out.time = place.time;
  if (!place.at) return;
  out.at = position(*place.at);
  if (!report.degrees.empty()) out.angle = report.degrees[place.pose];
}

LevelChange public_change(const io::ExplanationReport& report, const formula::LevelChange& change) {
  using Kind = LevelChange::Kind;
  static_assert(int(formula::LevelChange::Kind::kUnknown) == int(Kind::kUnknown));
  const io::SaidChange said = io::said(report, change);
  LevelChange out{Kind(int(change.kind)), said.text, said.becomes, 0, 0, false, 0, 0, change.reached, {}, {}, {},
                  change.refused};
  if (out.kind != Kind::kTo) return out;
  const distance::OutwardEnds ends = distance::outward(said.level.answer->bounds());
  out.to = said.level.value()->to_double();
  out.by = said.by.to_double();
  out.exact = said.level.proven();
  out.lower = ends.lower;
  out.upper = ends.upper;
  put_place(report, change.place, out);
  return out;
}

std::vector<std::string> written(const formula::Formula& f, const std::vector<std::size_t>& atoms) {
  std::vector<std::string> out;
  for (const std::size_t k : atoms) out.push_back(formula::written(f.atoms()[k]));
  return out;
}

Explanation public_explanation(const io::ExplanationReport& report) {
  const formula::Explanation& e = report.explanation;
  Explanation out;
  out.feasible = e.feasible;
  if (e.conflict) {
    out.conflict = written(report.formula, e.conflict->atoms);
    out.smallest = e.conflict->smallest;
  }
  for (const formula::LevelChange& c : e.relax) out.relax.push_back(public_change(report, c));
  for (const formula::LevelChange& c : e.slack) out.slack.push_back(public_change(report, c));
  if (e.together) {
    out.together = {e.together->lower.to_double(), {}, {}, {}, {}};
    if (e.together->upper) out.together->upper = e.together->upper->to_double();
    put_place(report, e.together->place, *out.together);
  }
  if (report.here != nullptr) {
    out.here = api::public_check(report.here->check);
    out.change = written(report.formula, report.here->change);
  }
  out.text = io::explanation_text(report);
  out.json = io::explanation_json(report);
  return out;
}

template <class Solver, class Place>
Explanation explained(const World::Data& world, const Solver& solver, const Formula& formula,
                      const std::optional<Place>& at) {
  const formula::Formula asked = world.formula(formula.text());
  return api::limited(world.options, [&] {
    const formula::Explanation found = formula::explain(solver, asked);
    std::optional<formula::PositionExplanation> here;
    if (at) here = formula::explain_at(solver, asked, *at);
    return public_explanation({asked, found, here ? &*here : nullptr,
                               at ? distance::coordinates(*at) : distance::Coordinates(), solver.world().step,
                               world.unit()});
  });
}

/// The world at some angles.
std::vector<formula::SharedSolver> poses_of(const World::Data& world, const std::vector<exact::Real>& degrees,
                                            const Point& about) {
  const formula::World& drawn = world.plane("an explanation over angles").world();
  if (world.motion) throw Error(ErrorCode::kUnsupported, "poses of shapes that move in time are not computed");
  if (degrees.empty()) throw Error(ErrorCode::kBadValue, "no angles");
  plane::RoundingLog moved;
  const plane::GridPoint pole = world.grid.nearest(api::real_of(about.x), api::real_of(about.y), moved);
  plane::Rounding rotated;
  return formula::solvers_at(drawn, {pole.x, pole.y}, degrees, rotated);
}

double within_a_turn(const exact::Real& degrees) {
  return (degrees - exact::Real(360) * exact::Real(exact::floor(degrees / exact::Real(360)))).to_double();
}

/// Its angles as the scene tells them.
void tell_angles(formula::Explanation& found, const io::Scene& scene) {
  const auto tell = [&](formula::RemainingPlace& place) {
    if (place.degrees) place.degrees = within_a_turn(scene.seen(exact::Real::from_double(*place.degrees)));
  };
  for (formula::LevelChange& c : found.relax) tell(c.place);
  for (formula::LevelChange& c : found.slack) tell(c.place);
  if (found.together) tell(found.together->place);
}

}  // namespace

namespace io {

Explanation explain_poses(const AskedScene& asked, const std::optional<exact::Real>& degrees,
                          const std::optional<exact::RealPoint>& at) {
  const Scene& scene = asked.scene();
  const formula::Formula formula = question_over_angles(asked);
  if (at && !degrees)
    throw Error(ErrorCode::kUnsupported, "over several angles there is no explanation at a position", scene.file);
  const std::vector<exact::Real> angles = degrees ? std::vector{scene.seen(*degrees)} : scene.free.angles;
  const exact::RealPoint about{scene.free.about[0], scene.free.about[1]};
  asked.stage("explaining");
  plane::Rounding rounding;
  const formula::SharedSolver drawn = asked.solver();
  const std::vector<formula::SharedSolver> poses = formula::solvers_at(drawn->world(), about, angles, rounding);
  asked.note_rotated(rounding);
  formula::Explanation found = formula::explain(poses, formula);
  std::optional<formula::PositionExplanation> here;
  if (at) {
    const formula::RotationSolver pose(*drawn, rotation_pose(asked, {*at, degrees}));
    here = formula::explain_at(pose, *poses[0], formula, *at);
    if (here->check.holds && !found.feasible) found = formula::feasible_off_the_grid(formula);
  }
  std::vector<double> told;
  for (const exact::Real& angle : angles) told.push_back(within_a_turn(scene.seen(angle)));
  return public_explanation({formula, found, here ? &*here : nullptr,
                             distance::coordinates(at.value_or(exact::RealPoint())), asked.step(), asked.unit(), told});
}

Explanation explain_angles(const AskedScene& asked, const exact::RealPoint& at) {
  const formula::Formula formula = question_over_angles(asked);
  const GridPosition& about = asked.scene().free.about;
  const exact::RealPoint pole{exact::Real(about[0]) * asked.step(), exact::Real(about[1]) * asked.step()};
  const std::shared_ptr<const formula::Solver> solver = asked.solver();
  asked.stage("explaining");
  const formula::RotationSolver rotated(*solver, {at, {}, pole});
  formula::Explanation found = formula::explain(rotated.maps(formula), formula);
  tell_angles(found, asked.scene());
  return public_explanation({formula, found, nullptr, {}, asked.step(), asked.unit(), {}, Sought::kAngle});
}

Explanation explain_instants(const AskedScene& asked, const exact::RealPoint& at) {
  asked.require_positions(true);
  if (asked.goal()) throw Error(ErrorCode::kUnsupported, "an objective in time is not computed", asked.scene().file);
  asked.require_question();
  const formula::Formula formula = asked.where();
  const std::shared_ptr<const formula::Solver> solver = asked.solver();
  asked.stage("explaining");
  const formula::Explanation found = formula::explain_instants(*solver, formula, at);
  return public_explanation({formula, found, nullptr, {}, asked.step(), asked.unit(), {}, Sought::kInstant});
}

}  // namespace io

Explanation World::explain_angles(const Formula& formula, const Point& at, const Point& about) const {
  const formula::Solver& solver = data_->plane("an explanation over angles");
  if (data_->motion) throw Error(ErrorCode::kUnsupported, "an angle of shapes that move in time is not computed");
  const distance::Coordinates place = api::place_of(*data_, at), centre = api::place_of(*data_, about);
  return api::limited(data_->options, [&] {
    const formula::Formula asked = data_->formula(formula.text());
    const formula::RotationSolver rotated(solver, {{place[0], place[1]}, {}, exact::RealPoint{centre[0], centre[1]}});
    const formula::Explanation found = formula::explain(rotated.maps(asked), asked);
    return public_explanation({asked, found, nullptr, {}, solver.world().step, data_->unit(), {}, io::Sought::kAngle});
  });
}

Explanation World::explain_instants(const Formula& formula, const Point& at) const {
  const formula::Solver& solver = data_->plane("an explanation over time");
  if (!data_->motion) throw Error(ErrorCode::kBadValue, "an explanation over time needs a motion");
  const distance::Coordinates place = api::place_of(*data_, at);
  return api::limited(data_->options, [&] {
    const formula::Formula asked = data_->formula(formula.text());
    const formula::Explanation found = formula::explain_instants(solver, asked, {place[0], place[1]});
    return public_explanation(
        {asked, found, nullptr, {}, solver.world().step, data_->unit(), {}, io::Sought::kInstant});
  });
}

Explanation World::explain_poses(const Formula& formula, const std::vector<Number>& degrees, const Point& about) const {
  return api::limited(data_->options, [&] {
    std::vector<exact::Real> angles;
    for (const Number& d : degrees) angles.push_back(api::real_of(d));
    const std::vector<formula::SharedSolver> poses = poses_of(*data_, angles, about);
    const formula::Formula asked = data_->formula(formula.text());
    const formula::Explanation found = formula::explain(poses, asked);
    std::vector<double> told;
    for (const exact::Real& angle : angles) told.push_back(within_a_turn(angle));
    return public_explanation({asked, found, nullptr, {}, poses.front()->world().step, data_->unit(), told});
  });
}

Explanation World::explain(const Formula& formula, const std::optional<Point>& at) const {
  if (!at && data_->solid) return explained(*data_, *data_->solid, formula, std::optional<space::RealVector>());
  std::optional<exact::RealPoint> p;
  if (at) p = exact::RealPoint{api::real_of(at->x), api::real_of(at->y)};
  return explained(*data_, data_->plane("an explanation at a position of two numbers"), formula, p);
}

Explanation World::explain(const Formula& formula, const Point3& at) const {
  const space::RealVector p{api::real_of(at.x), api::real_of(at.y), api::real_of(at.z)};
  return explained(*data_, data_->space("an explanation at a position of three numbers"), formula, std::optional(p));
}

}  // namespace findspace
