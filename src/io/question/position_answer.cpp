// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/position_answer.h"

#include <findspace/error.h>
#include <findspace/vocabulary.h>
#include <fmt/format.h>

#include <algorithm>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/language/text.h"
#include "formula/planar/solve_rotation.h"
#include "io/question/planar_map.h"
#include "io/question/position_picture.h"
#include "io/report/feature_pair.h"
#include "io/report/position_report.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"

namespace findspace::io {
namespace {

using Found = Answer::Found;

formula::Kind kind_of(std::string_view word) {
  if (const formula::DistanceName* row = formula::find_distance(word)) return row->kind;
  std::vector<std::string> names;
  for (const formula::DistanceName& row : formula::distance_names()) names.emplace_back(row.name);
  const std::string near = formula::nearest(word, names);
  throw Error(ErrorCode::kUnknownName, fmt::format("there is no distance '{}'{}", word,
                                                   near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

/// What is told of all distances: where only usual ones are, those along directions of the formula as well.
formula::WantedText told_of(const WantedDistances& wanted) {
  if (wanted.kinds.empty()) return {};
  return [wanted](const std::string& text) {
    const std::string plain = formula::plain(text).text;
    if (!wanted.told && is_directional(plain)) return true;
    return std::find(wanted.kinds.begin(), wanted.kinds.end(), kind_of(distance_word(plain))) != wanted.kinds.end();
  };
}

std::vector<formula::DistanceAt> only(std::vector<formula::DistanceAt> distances, const formula::WantedText& wanted) {
  if (wanted) std::erase_if(distances, [&](const formula::DistanceAt& d) { return !wanted(d.text); });
  return distances;
}

bool ranges_over_angles(const Free& free) { return free.kind == Free::Kind::kAngle || free.kind == Free::Kind::kPose; }

/// Whether the moving shape turns: an angle is given, or the scene or its formula turns it.
bool turns(const AskedScene& asked, const PlanarPose& pose) {
  if (pose.degrees || ranges_over_angles(asked.scene().free)) return true;
  return !asked.scene().motion.given() && formula::has_rotations(asked.where());
}

void require_turning(const AskedScene& asked) {
  if (asked.scene().motion.given())
    throw Error(ErrorCode::kUnsupported, "an angle in a scene with \"motion\" is not computed", asked.scene().file);
  asked.require_moving();
}

}  // namespace

formula::Pose rotation_pose(const AskedScene& asked, const PlanarPose& pose) {
  formula::Pose out{pose.at, asked.scene().seen(pose.degrees.value_or(exact::Real())), std::nullopt};
  const GridPosition& about = asked.scene().free.about;
  if (ranges_over_angles(asked.scene().free))
    out.about = {exact::Real(about[0]) * asked.step(), exact::Real(about[1]) * asked.step()};
  return out;
}

namespace {

/// What a question about one position of the plane needs for its texts and pictures.
struct PlanarQuestion {
  AskedScene asked;
  formula::Formula formula{};
  exact::RealPoint at;
  std::shared_ptr<const formula::Solver> solver{};
  std::optional<formula::RotationSolver> rotated{};  // where the moving shape turns
  formula::Pose pose{};
  formula::AskedNearest nearest{};
  std::shared_ptr<const formula::Check> check{};
  std::shared_ptr<const std::vector<formula::DistanceAt>> distances{};

  PlanarQuestion(AskedScene given, const exact::RealPoint& place) : asked(std::move(given)), at(place) {}

  distance::Coordinates place() const { return distance::coordinates(at); }
  std::optional<double> degrees() const {
    if (!rotated && !asked.turned()) return std::nullopt;
    return (asked.turned().value_or(exact::Real()) + asked.scene().seen(pose.degrees)).to_double();
  }
  /// The shapes as they are drawn: of a shape that turns with its vertices rounded to the grid.
  template <class Draw>
  std::string drawn(const Draw& draw) const {
    if (!rotated) return draw(solver->world());
    plane::Rounding rounding;
    return draw(formula::rotated_world(solver->world(), rotated->about(), pose.degrees, rounding));
  }
};

/// All shapes, or those that the formula needs. It does not move any more.
std::shared_ptr<PlanarQuestion> planar_question(AskedScene given, const PlanarPose& pose, bool all) {
  auto out = std::make_shared<PlanarQuestion>(std::move(given), pose.at);
  const AskedScene& asked = out->asked;
  const bool turning = turns(asked, pose);
  if (turning)
    require_turning(asked);
  else
    asked.require_positions(true);
  out->formula = asked.where();
  out->solver = all || turning ? asked.solver() : asked.solver_of(out->formula);
  if (turning) {
    out->pose = rotation_pose(asked, pose);
    out->rotated.emplace(*out->solver, out->pose);
  }
  if (!asked.kept()) out->asked.forget_shapes();  // their sets stand
  return out;
}

}  // namespace

WantedDistances wanted_distances(const std::vector<std::string>& words) {
  WantedDistances out;
  for (const std::string& word : words) out.kinds.push_back(kind_of(word));
  out.told = !words.empty() && words != usual_distance_words();
  return out;
}

namespace {

/// In the scene's unit, of a position in it.
std::optional<formula::NearestFeasible> nearest_in(const Region& region, const exact::RealPoint& at,
                                                   const exact::Real& step) {
  const auto near = region.data().answers().nearest({at.x / step, at.y / step});
  if (!near) return std::nullopt;
  return formula::NearestFeasible{distance::coordinates(distance::times(step, near->at)), near->distance * step,
                                  near->attained};
}

/// From the region where that is kept or on a line, else from what is near.
formula::TriedNearest nearest_of(const PlanarQuestion& q) {
  const bool line = q.asked.scene().free.kind == Free::Kind::kLine;
  if (line || (q.asked.kept() && !q.asked.at_instant())) {
    const auto region = positions_of(q.asked, q.formula, q.solver);
    if (!region->outer) return nearest_in(region->region, q.at, q.asked.step());
    if (line || q.rotated) return exact::Refusal("the region is known between bounds only");
  }
  return q.solver->nearest_feasible(q.formula, q.at);
}

/// A corner or an edge of the region that is near, or the place itself.
exact::RealPoint snapped(const AskedScene& asked, const PlanarPose& pose, const exact::Real& within) {
  if (pose.degrees)
    throw Error(ErrorCode::kUnsupported, "nothing snaps at an angle; the scene may be rotated by it",
                asked.scene().file);
  asked.require_moving();
  const exact::Real& step = asked.step();
  const auto region = positions_of(asked.over_time(), asked.where());
  const auto near = region->region.data().answers().snapped({pose.at.x / step, pose.at.y / step}, within / step);
  return near ? distance::times(step, *near) : pose.at;
}

}  // namespace

Answer::Data check_in_plane(AskedScene given, const PlanarPose& asked_pose, const CheckWishes& wishes) {
  PlanarPose pose = asked_pose;
  if (wishes.snap.sign() > 0) pose.at = snapped(given, pose, wishes.snap);
  const auto q = planar_question(std::move(given), pose, false);
  q->asked.stage("checking");
  if (q->rotated) {
    q->check = std::make_shared<const formula::Check>(q->rotated->check(q->formula));
    q->asked.note_rotated(q->rotated->rounding());
  } else {
    q->check = std::make_shared<const formula::Check>(q->solver->check(q->formula, q->at));
  }
  if (!q->check->holds && wishes.nearest && (!q->rotated || (q->asked.kept() && !pose.degrees))) {
    q->asked.stage("looking for the nearest feasible position");
    q->nearest = nearest_of(*q);
  }
  Answer::Data out;
  out.found = q->check->holds ? Found::kYes : Found::kNo;
  out.json = [q](const Telling& telling) {
    return check_json(*q->check, q->place(), q->asked.unit(), q->degrees(), q->nearest, telling.explain);
  };
  out.text = [q](const Telling& telling) {
    return check_text(*q->check, shown_point(q->place()), q->place(), q->asked.unit(), q->nearest, telling.explain);
  };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{q->drawn([&](const formula::World& world) {
                           return check_picture(q->asked, world, q->formula, q->at, *q->check,
                                                formula::found(q->nearest));
                         }),
                         {}};
  };
  out.at = q->place();
  show_check(out, q->check, q->nearest);
  return out;
}

Answer::Data nearest_in_plane(AskedScene given, const exact::RealPoint& at) {
  const auto q = planar_question(std::move(given), {at}, false);
  q->asked.stage("looking for the nearest feasible position");
  if (q->rotated && !q->asked.kept())
    return nearest_answer(
        q->asked, exact::Refusal("the nearest feasible position of a shape that turns is not computed"), q->place());
  return nearest_answer(q->asked, nearest_of(*q), q->place());
}

Answer::Data nearest_answer(const AskedScene& asked, formula::TriedNearest near, const distance::Coordinates& from) {
  Answer::Data out;
  out.found = !near ? Found::kUndecided : *near ? Found::kYes : Found::kNo;
  out.at = from;
  const auto found = std::make_shared<const formula::AskedNearest>(std::move(near));
  out.json = [found](const Telling&) {
    if (**found) return "{" + nearest_member(***found) + "}";
    return fmt::format(R"({{"not_computed": {{"nearest_feasible": {}}}}})",
                       json_string((*found)->refusal().error.message()));
  };
  out.text = [found, unit = asked.unit()](const Telling&) { return nearest_words(*found, unit); };
  out.nearest = [found] { return nearest_place(*found); };
  return out;
}

Answer::Data between_in_plane(AskedScene given, const exact::RealPoint& at,
                              const std::array<exact::RealPoint, 2>& places) {
  given.stage("measuring");
  const auto asked = std::make_shared<const AskedScene>(std::move(given));
  const auto found = std::make_shared<const FeaturePair>(features_between(asked->solver()->world(), at, places));
  Answer::Data out;
  out.at = distance::coordinates(at);
  out.json = [asked, found](const Telling&) { return feature_pair_json(*found, asked->unit()); };
  out.text = [asked, found](const Telling&) { return feature_pair_text(*found, asked->unit()); };
  out.measured = [found] { return std::vector{Measured{"distance", api::public_value(found->distance), {}}}; };
  return out;
}

Answer::Data measure_in_plane(AskedScene given, const PlanarPose& pose, const WantedDistances& wanted) {
  const auto q = planar_question(std::move(given), pose, true);
  q->asked.stage("measuring");
  const formula::WantedText kinds = told_of(wanted);
  std::vector<formula::DistanceAt> all =
      q->rotated ? q->rotated->measure(q->formula, kinds) : q->solver->measure(q->at, q->formula, kinds);
  if (q->rotated) q->asked.note_rotated(q->rotated->rounding());
  q->distances = std::make_shared<const std::vector<formula::DistanceAt>>(only(std::move(all), kinds));
  Answer::Data out;
  out.json = [q](const Telling&) { return measure_json(*q->distances, q->place(), q->asked.unit(), q->degrees()); };
  out.text = [q, told = wanted.told](const Telling& telling) {
    return measure_text(*q->distances, shown_point(q->place()), q->place(), q->asked.unit(), telling.all || told);
  };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{
        q->drawn([&](const formula::World& world) { return measure_picture(q->asked, world, q->at, *q->distances); }),
        {}};
  };
  out.at = q->place();
  show_measured(out, q->distances);
  return out;
}

std::optional<NearestPlace> nearest_place(const formula::AskedNearest& nearest) {
  const formula::NearestFeasible* near = formula::found(nearest);
  if (near == nullptr) return std::nullopt;
  NearestPlace out{{}, near->distance.to_double(), near->attained};
  for (const exact::Real& c : near->at) out.at.push_back(c.to_double());
  return out;
}

void show_check(Answer::Data& answer, std::shared_ptr<const formula::Check> check, formula::AskedNearest nearest) {
  answer.check = [check = std::move(check)] { return api::public_check(*check); };
  answer.nearest = [nearest = std::move(nearest)] { return nearest_place(nearest); };
}

void show_measured(Answer::Data& answer, std::shared_ptr<const std::vector<formula::DistanceAt>> distances) {
  answer.measured = [distances = std::move(distances)] {
    std::vector<Measured> out;
    for (const formula::DistanceAt& d : *distances) {
      const formula::PlainText plain = formula::plain(d.text);
      Measured& one = out.emplace_back(Measured{plain.text, {}, d.refused});
      if (d.refused.empty()) one.value = api::public_value(plain.negated ? formula::minus(d) : d);
    }
    return out;
  };
}

}  // namespace findspace::io
