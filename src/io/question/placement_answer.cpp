// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/placement_answer.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

#include "api/plan/placement_data.h"
#include "io/board/write_board.h"
#include "io/export/write_drawing.h"
#include "io/question/placement_problem.h"
#include "io/question/scenery.h"
#include "io/write/write_placement.h"
#include "planning/planar/sequential.h"
#include "planning/planar/simultaneous.h"

namespace findspace::io {
namespace {

using planning::Problem;

struct PlacedBodies {
  PlacementResult result;
  planning::Poses poses;
  std::size_t shortened = 0;  // positions on the grid, as exact ones have too long numbers
  std::vector<std::vector<planning::AtAngle>> positions{};  // by body
};

PlacedBodies answered(const planning::Relations& relations, bool one_by_one, const planning::Limit& limit) {
  const Problem& problem = relations.problem();
  if (one_by_one) {
    const planning::SequentialPlacement found = planning::place_sequentially(relations, limit);
    const auto shortened = std::count_if(found.steps.begin(), found.steps.end(),
                                         [](const planning::Step& s) { return s.chosen.shortened; });
    PlacedBodies out{placement_result(problem, found), found.poses, std::size_t(shortened)};
    for (const planning::Step& step : found.steps) out.positions.push_back(step.positions);
    return out;
  }
  const planning::SimultaneousPlacement found = planning::place_simultaneously(relations, limit);
  return {placement_result(problem, found), found.witness, 0, found.positions};
}

/// The placed shapes as a file to cut, a layer a shape.
Region::Drawn cut_file(const AskedScene& asked, const Problem& problem, const PlacedBodies& answer,
                       DxfVersion version) {
  const PlacedRegions placed = placed_regions(problem, answer.poses);
  DrawingText text = shapes_dxf(placed.named(), asked.step(), asked.scene().unit, version);
  return {std::move(text.text), std::move(text.lost)};
}

std::string placement_picture(const AskedScene& asked, const Problem& problem, const PlacedBodies& answer) {
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : asked.scene().shapes) names.push_back(s->name);
  PlacementPicture out{"Placement, " + answer.result.method,
                       asked.scene().place.pairs.text,
                       {},
                       asked.unit(),
                       standing_still(problem, names),
                       asked.scene().y_down};
  std::vector<plane::Region> parts;
  if (const Board* board = asked.scene().board.get()) {
    std::vector<std::string> moved;
    for (const auto& body : problem.bodies) moved.insert(moved.end(), body.shapes.begin(), body.shapes.end());
    std::vector<plane::ShapePtr> shapes;
    for (const Part& part : board->parts)
      if (part.body && std::find(moved.begin(), moved.end(), part.name) == moved.end())
        shapes.push_back(asked.scene().shape(part.name));
    parts = asked.regions(shapes);
    for (std::size_t k = 0; k < parts.size(); ++k)
      out.parts.push_back({shapes[k]->name, &parts[k], is_behind(board, shapes[k]->name)});
    std::erase_if(out.fixed, [&](const std::string& name) { return name != "board" && name.find('.') == name.npos; });
    out.is_board = true;
    out.copper = copper_of(*board, moved, asked.scene().grid.step_size());
    const Placement& place = asked.scene().place;
    out.subtitle = place.each.text;
    for (const auto* texts : {&place.constraints, &place.minimize})
      for (const FormulaText& f : *texts)
        if (f.text != "grid") out.subtitle += (texts == &place.constraints ? " and " : "; least ") + f.text;
  }
  return placement_svg(problem, answer.poses, out);
}

/// Angles as the scene tells them.
void count_as_seen(const Scene& scene, PlacedBodies& answer) {
  for (planning::BodyOutcome& r : answer.result.placed)
    if (r.angle) r.angle = scene.seen(r.angle->degrees);
  for (auto& r : answer.result.regions)
    if (r.angle) r.angle = scene.seen(r.angle->degrees);
}

/// The board's file with the parts at their new positions; those of a group keep theirs to each other.
std::string board_text(const AskedScene& asked, const Problem& problem, const PlacedBodies& answer,
                       const std::string& source) {
  const Board& board = *asked.scene().board;
  std::map<std::string, NewPlace> places;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto& pose = answer.poses[b];
    const planning::Body& body = problem.bodies[b];
    if (!pose) throw Error(ErrorCode::kGeometry, fmt::format("'{}' fits nowhere: no board is written", body.name));
    const auto x = pose->at.x.integer(), y = pose->at.y.integer();
    if (!x || !y)
      throw Error(ErrorCode::kGeometry,
                  fmt::format("'{}' fits at no point of the board's grid: no board is written", body.name));
    const NewPlace place{{static_cast<std::int64_t>(*x), static_cast<std::int64_t>(*y)},
                         asked.scene().seen(body.angles[pose->angle].degrees)};
    for (const std::string& name : body.shapes)
      if (const Part* part = board.find(name)) places[name] = place_beside(*part, *board.find(body.shapes[0]), place);
  }
  return moved_board(source, asked.scene().file, places);
}

struct PlacementInPlane {
  AskedScene asked;
  Problem problem;
  PlacedBodies placed{};

  explicit PlacementInPlane(AskedScene given) : asked(std::move(given)), problem(placement_problem(asked)) {}
};

}  // namespace

Answer::Data place_in_plane(AskedScene given, const PlacementQuestion& question) {
  const auto q = std::make_shared<PlacementInPlane>(std::move(given));
  const AskedScene& asked = q->asked;
  asked.stage("placing");
  const planning::Relations relations(q->problem);
  const bool one_by_one = asked.scene().place.method == Placement::Method::kSequential;
  q->placed = answered(relations, one_by_one, question.limit);
  PlacedBodies& placed = q->placed;
  const bool board = asked.scene().board != nullptr;
  if (asked.scene().mirrors_angles()) count_as_seen(asked.scene(), placed);
  if (placed.shortened > 0)
    asked.note(
        fmt::format("{} position{} put on the grid, a few steps at most from the best one, whose exact numbers "
                    "are too long; say \"grid\" to have all of them there",
                    placed.shortened, placed.shortened == 1 ? " was" : "s were"));
  Answer::Data out;
  const bool proven = !one_by_one || !placed.result.unproven;
  out.found = placed.result.complete() && proven ? Answer::Found::kYes
              : placed.result.unproven           ? Answer::Found::kUndecided
                                                 : Answer::Found::kNo;
  out.json = [q](const Telling&) { return placement_json(q->placed.result, q->asked.step(), q->asked.unit()); };
  out.text = [q](const Telling&) { return placement_text(q->placed.result, q->asked.step(), q->asked.unit()); };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{placement_picture(q->asked, q->problem, q->placed), {}};
  };
  if (board)
    out.files[".kicad_pcb"] = [q, source = question.source](const Telling&) {
      return Region::Drawn{board_text(q->asked, q->problem, q->placed, source), {}};
    };
  else
    out.files[".dxf"] = [q](const Telling& telling) { return cut_file(q->asked, q->problem, q->placed, telling.dxf); };
  out.placement = [q, json = out.json] {
    findspace::Placement::Told told = api::told(q->placed.result, q->asked.step());
    for (std::size_t b = 0; b < q->placed.positions.size(); ++b)
      api::tell_positions(q->problem.bodies[b], b, q->placed.positions[b], q->asked.scene().grid, q->asked.unit(),
                          told);
    for (auto& positions : told.positions)
      positions.degrees = q->asked.scene().seen(exact::Real::from_double(positions.degrees)).to_double();
    told.json = json({});
    told.svg = placement_picture(q->asked, q->problem, q->placed);
    return findspace::Placement(std::move(told));
  };
  return out;
}

}  // namespace findspace::io
