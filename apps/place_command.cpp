// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "commands.h"
#include "findspace/error.h"
#include "io/board/write_board.h"
#include "io/text/read_text.h"
#include "io/write/write_drawing.h"
#include "io/write/write_json.h"
#include "io/write/write_placement.h"
#include "placement_problem.h"
#include "plane/query/moved.h"
#include "plane/query/summary.h"
#include "planning/planar/sequential.h"
#include "planning/planar/simultaneous.h"
#include "run_limits.h"
#include "session.h"
#include "space_commands.h"

namespace findspace::app {
namespace {

using planning::Body;
using planning::Problem;

struct Answer {
  io::PlacementResult result;
  planning::Poses poses;
  bool complete = true;  // every body has a position
};

/// Whether a body may turn: then results say its angle.
bool rotations(const Body& body) { return body.angles.size() > 1 || body.angles[0].sign() != 0; }

io::PlacedResult placed(const Body& body, const std::optional<planning::Pose>& pose) {
  io::PlacedResult out;
  out.shape = body.name;
  out.copy = body.copy;
  if (!pose) return out;
  out.at = {pose->at.x, pose->at.y};
  if (rotations(body)) out.angle = body.angles[pose->angle];
  return out;
}

/// Regions of bodies that are placed once; of copies they would be many and alike.
void add_regions(Answer& answer, const Problem& problem, const std::vector<std::vector<planning::AtAngle>>& regions) {
  const exact::Real& step = problem.world.step;
  for (std::size_t b = 0; b < regions.size(); ++b) {
    const Body& body = problem.bodies[b];
    if (body.copy > 0) continue;
    for (const planning::AtAngle& r : regions[b])
      answer.result.regions.push_back({body.name, rotations(body) ? std::optional(body.angles[r.angle]) : std::nullopt,
                                       io::region_json(r.region, plane::summarize(r.region, step), step, "")});
  }
}

Answer sequential(const planning::Relations& relations, const planning::Limit& limit) {
  const Problem& problem = relations.problem();
  planning::SequentialPlacement found = planning::place_sequentially(relations, limit);
  Answer answer;
  answer.result.method = "sequential";
  std::vector<std::vector<planning::AtAngle>> regions;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    answer.result.placed.push_back(placed(problem.bodies[b], found.poses[b]));
    answer.complete = answer.complete && found.poses[b];
    if (b >= found.steps.size()) continue;
    planning::Step& step = found.steps[b];
    io::PlacedResult& last = answer.result.placed.back();
    last.attained = step.chosen.attained;
    if (!last.attained) {
      last.infimum = step.chosen.values;
      answer.result.attained = false;
    }
    regions.push_back(std::move(step.positions));
  }
  if (found.limit_reached) answer.result.unproven = "the time limit came before all shapes were placed";
  answer.poses = std::move(found.poses);
  add_regions(answer, problem, regions);
  return answer;
}

Answer simultaneous(const planning::Relations& relations, const planning::Limit& limit) {
  const Problem& problem = relations.problem();
  planning::SimultaneousPlacement found = planning::place_simultaneously(relations, limit);
  Answer answer;
  answer.result.method = "simultaneous";
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    answer.result.placed.push_back(placed(problem.bodies[b], found.witness[b]));
  answer.complete =
      std::all_of(found.witness.begin(), found.witness.end(), [](const auto& p) { return p.has_value(); });
  answer.result.unproven = found.unproven;
  answer.poses = std::move(found.witness);
  add_regions(answer, problem, found.positions);
  return answer;
}

/// Shapes where they are placed, by name.
struct PlacedRegions {
  std::vector<plane::Region> regions;
  std::vector<std::string> names;

  std::vector<io::NamedRegion> named() const {
    std::vector<io::NamedRegion> all;
    for (std::size_t k = 0; k < regions.size(); ++k) all.push_back({names[k], &regions[k]});
    return all;
  }
};

PlacedRegions placed_regions(const Problem& problem, const Answer& answer) {
  PlacedRegions out;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    if (!answer.poses[b]) continue;
    const Body& body = problem.bodies[b];
    for (std::size_t k = 0; k < body.shapes.size(); ++k) {
      const std::string& variant = body.variants[answer.poses[b]->angle][k];
      out.regions.push_back(plane::moved(problem.world.shapes.at(variant), answer.poses[b]->at));
      out.names.push_back(body.shapes[k]);
    }
  }
  return out;
}

/// The placed shapes as a file to cut, a layer a shape.
std::string cut_file(const Session& session, const Problem& problem, const Answer& answer) {
  const PlacedRegions placed = placed_regions(problem, answer);
  io::DrawingText text = io::shapes_dxf(placed.named(), session.step(), session.scene().unit);
  if (!text.lost.empty()) session.reporter().note(text.lost);
  return std::move(text.text);
}

std::string picture(const Session& session, const Problem& problem, const Answer& answer) {
  io::Picture p;
  p.title = "Placement, " + answer.result.method;
  p.subtitle = session.scene().place.pairs.text;
  p.step = session.step();
  p.unit = session.unit();
  p.of_positions = false;
  p.y_down = session.scene().y_down;
  for (const plane::ShapePtr& s : session.scene().shapes) {
    const bool moves = problem.names.count(s->name) != 0 ||
                       std::any_of(problem.bodies.begin(), problem.bodies.end(), [&](const Body& b) {
                         return std::find(b.shapes.begin(), b.shapes.end(), s->name) != b.shapes.end();
                       });
    if (!moves && problem.world.shapes.count(s->name) > 0)
      p.fixed.push_back({s->name, &problem.world.shapes.at(s->name)});
  }
  const PlacedRegions placed = placed_regions(problem, answer);
  p.placed = placed.named();
  return io::picture_svg(p);
}

/// Angles as they are counted where y runs downwards: counter-clockwise as it is seen.
void count_as_seen(Answer& answer) {
  for (io::PlacedResult& r : answer.result.placed)
    if (r.angle) r.angle = -*r.angle;
  for (auto& r : answer.result.regions)
    if (r.angle) r.angle = -*r.angle;
}

/// The board's file with the parts at their new positions.
std::string board_text(const Session& session, const Problem& problem, const Answer& answer) {
  std::map<std::string, io::NewPlace> places;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto& pose = answer.poses[b];
    if (!pose)
      throw Error(ErrorCode::kGeometry,
                  fmt::format("'{}' fits nowhere: no board is written", problem.bodies[b].shapes[0]));
    const auto x = pose->at.x.integer(), y = pose->at.y.integer();
    if (!x || !y)
      throw Error(ErrorCode::kGeometry, fmt::format("'{}' fits at no point of the board's grid: no board is written",
                                                    problem.bodies[b].shapes[0]));
    places[problem.bodies[b].shapes[0]] = {{static_cast<std::int64_t>(*x), static_cast<std::int64_t>(*y)},
                                           -problem.bodies[b].angles[pose->angle]};
  }
  return io::moved_board(io::read_text(session.options().scene, session.options().input_limit), session.options().scene,
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
  const Session session(options, reporter);
  if (session.in_space()) return place_space(session, limit);
  const bool board = session.scene().board != nullptr;
  check_outputs(options, board ? std::vector<std::string>{".svg", ".json", ".kicad_pcb"}
                               : std::vector<std::string>{".svg", ".dxf", ".json"});
  if (options.resolution > 0) throw Error(ErrorCode::kUsage, "--resolution is for 3D scenes");
  const Problem problem = placement_problem(session);
  reporter.stage("placing");
  const planning::Relations relations(problem);
  const bool one_by_one = session.scene().place.method == io::Placement::Method::kSequential;
  Answer answer = one_by_one ? sequential(relations, limit) : simultaneous(relations, limit);
  if (board) count_as_seen(answer);
  const auto json = [&] { return io::placement_json(answer.result, session.step(), session.unit()); };
  const auto svg = [&] { return picture(session, problem, answer); };
  const auto dxf = [&] { return cut_file(session, problem, answer); };
  reporter.stage("writing");
  const auto copy = [&] { return board_text(session, problem, answer); };
  write_outputs(options, {{".json", json}, {".svg", svg}, {".kicad_pcb", copy}, {".dxf", dxf}});
  const ExitStatus status = answer.complete && (one_by_one ? !answer.result.unproven : true) ? kDone
                            : answer.result.unproven                                         ? kLimit
                                                                                             : kEmpty;
  return {options.json ? json() : io::placement_text(answer.result, session.step(), session.unit()), status};
}

}  // namespace findspace::app
