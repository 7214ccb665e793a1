// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "common/commands.h"
#include "common/run_limits.h"
#include "common/session.h"
#include "findspace/error.h"
#include "findspace/text.h"
#include "in_space/space_commands.h"
#include "io/board/write_board.h"
#include "io/export/write_drawing.h"
#include "io/question/scenery.h"
#include "io/write/write_placement.h"
#include "placing/placement_problem.h"
#include "planning/planar/sequential.h"
#include "planning/planar/simultaneous.h"

namespace findspace::app {
namespace {

using planning::Problem;

struct Answer {
  io::PlacementResult result;
  planning::Poses poses;
  std::size_t shortened = 0;  // positions on the grid, as exact ones have too long numbers
};

Answer answered(const planning::Relations& relations, bool one_by_one, const planning::Limit& limit) {
  const Problem& problem = relations.problem();
  if (one_by_one) {
    const planning::SequentialPlacement found = planning::place_sequentially(relations, limit);
    const auto shortened = std::count_if(found.steps.begin(), found.steps.end(),
                                         [](const planning::Step& s) { return s.chosen.shortened; });
    return {io::placement_result(problem, found), found.poses, std::size_t(shortened)};
  }
  const planning::SimultaneousPlacement found = planning::place_simultaneously(relations, limit);
  return {io::placement_result(problem, found), found.witness};
}

/// The placed shapes as a file to cut, a layer a shape.
std::string cut_file(const Session& session, const Problem& problem, const Answer& answer) {
  const io::PlacedRegions placed = io::placed_regions(problem, answer.poses);
  io::DrawingText text = io::shapes_dxf(placed.named(), session.step(), session.scene().unit, session.options().dxf);
  if (!text.lost.empty()) session.reporter().note(text.lost);
  return std::move(text.text);
}

std::string picture(const Session& session, const Problem& problem, const Answer& answer) {
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : session.scene().shapes) names.push_back(s->name);
  io::PlacementPicture out{"Placement, " + answer.result.method,
                           session.scene().place.pairs.text,
                           {},
                           session.unit(),
                           io::standing_still(problem, names),
                           session.scene().y_down};
  std::vector<plane::Region> parts;
  if (const io::Board* board = session.scene().board.get()) {
    std::vector<std::string> moved;
    for (const auto& body : problem.bodies) moved.insert(moved.end(), body.shapes.begin(), body.shapes.end());
    std::vector<plane::ShapePtr> shapes;
    for (const io::Part& part : board->parts)
      if (part.body && std::find(moved.begin(), moved.end(), part.name) == moved.end())
        shapes.push_back(session.scene().shape(part.name));
    parts = session.regions(shapes);
    for (std::size_t k = 0; k < parts.size(); ++k)
      out.parts.push_back({shapes[k]->name, &parts[k], io::is_behind(board, shapes[k]->name)});
    std::erase_if(out.fixed, [&](const std::string& name) { return name != "board" && name.find('.') == name.npos; });
    out.is_board = true;
    out.copper = io::copper_of(*board, moved, session.scene().grid.step_size());
    const io::Placement& place = session.scene().place;
    out.subtitle = place.each.text;
    for (const auto* texts : {&place.constraints, &place.minimize})
      for (const io::FormulaText& f : *texts)
        if (f.text != "grid") out.subtitle += (texts == &place.constraints ? " and " : "; least ") + f.text;
  }
  return io::placement_svg(problem, answer.poses, out);
}

/// Angles as they are counted where y runs downwards: counter-clockwise as it is seen.
void count_as_seen(Answer& answer) {
  for (planning::BodyOutcome& r : answer.result.placed)
    if (r.angle) r.angle = -r.angle->degrees;
  for (auto& r : answer.result.regions)
    if (r.angle) r.angle = -r.angle->degrees;
}

/// The board's file with the parts at their new positions; those of a group keep theirs to each other.
std::string board_text(const Session& session, const Problem& problem, const Answer& answer) {
  const io::Board& board = *session.scene().board;
  std::map<std::string, io::NewPlace> places;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto& pose = answer.poses[b];
    const planning::Body& body = problem.bodies[b];
    if (!pose) throw Error(ErrorCode::kGeometry, fmt::format("'{}' fits nowhere: no board is written", body.name));
    const auto x = pose->at.x.integer(), y = pose->at.y.integer();
    if (!x || !y)
      throw Error(ErrorCode::kGeometry,
                  fmt::format("'{}' fits at no point of the board's grid: no board is written", body.name));
    const io::NewPlace place{{static_cast<std::int64_t>(*x), static_cast<std::int64_t>(*y)},
                             -body.angles[pose->angle].degrees};
    for (const std::string& name : body.shapes)
      if (const io::Part* part = board.find(name))
        places[name] = place_beside(*part, *board.find(body.shapes[0]), place);
  }
  return io::moved_board(read_text(session.options().scene, session.options().input_limit), session.options().scene,
                         places);
}

/// The verb for boards knows which of them it is.
Options as_placement(Options options) {
  options.place = true;
  return options;
}

}  // namespace

Outcome run_place(const Options& given, Reporter& reporter) {
  const planning::Limit limit(given.time_limit * kSearching);  // reading counts
  const Options options = as_placement(given);
  return place_scene(Session(options, reporter), limit);
}

Outcome place_scene(const Session& session, const planning::Limit& limit) {
  if (session.in_space()) return place_space(session, limit);
  const Options& options = session.options();
  Reporter& reporter = session.reporter();
  const bool board = session.scene().board != nullptr;
  check_outputs(options, board ? std::vector<std::string>{".svg", ".json", ".kicad_pcb"}
                               : std::vector<std::string>{".svg", ".dxf", ".json"});
  if (options.resolution > 0) throw Error(ErrorCode::kUsage, "--resolution is for 3D scenes");
  const Problem problem = placement_problem(session);
  reporter.stage("placing");
  const planning::Relations relations(problem);
  const bool one_by_one = session.scene().place.method == io::Placement::Method::kSequential;
  Answer answer = answered(relations, one_by_one, limit);
  if (board) count_as_seen(answer);
  if (answer.shortened > 0) {
    reporter.note(
        fmt::format("{} position{} put on the grid, a few steps at most from the best one, whose exact numbers "
                    "are too long; say \"grid\" to have all of them there",
                    answer.shortened, answer.shortened == 1 ? " was" : "s were"));
  }
  const auto json = [&] { return io::placement_json(answer.result, session.step(), session.unit()); };
  const auto svg = [&] { return picture(session, problem, answer); };
  const auto dxf = [&] { return cut_file(session, problem, answer); };
  reporter.stage("writing");
  const auto copy = [&] { return board_text(session, problem, answer); };
  write_outputs(options, {{".json", json}, {".svg", svg}, {".kicad_pcb", copy}, {".dxf", dxf}});
  const ExitStatus status = answer.result.complete() && (one_by_one ? !answer.result.unproven : true) ? kDone
                            : answer.result.unproven                                                  ? kLimit
                                                                                                      : kEmpty;
  return {options.json ? json() : io::placement_text(answer.result, session.step(), session.unit()), status};
}

}  // namespace findspace::app
