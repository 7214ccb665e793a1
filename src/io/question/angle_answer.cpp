// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/planar/rotation_bounds.h"
#include "formula/planar/solve_rotation.h"
#include "io/draw/draw_layout.h"
#include "io/question/map_answer.h"
#include "io/question/scenery.h"
#include "io/write/draw_rotations.h"
#include "io/write/write_json.h"
#include "io/write/write_rotations.h"
#include "io/write/write_summary.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {
namespace {

using Kind = Free::Kind;

exact::RealPoint about(const AskedScene& asked) {
  const GridPosition& p = asked.scene().free.about;
  return {exact::Real(p[0]) * asked.step(), exact::Real(p[1]) * asked.step()};
}

void require_plane(const AskedScene& asked) {
  const Scene& scene = asked.scene();
  if (scene.dimension != 2)
    throw Error(ErrorCode::kUnsupported, "rotations of shapes in space are not computed by this version", scene.file);
  if (scene.motion.given())
    throw Error(ErrorCode::kUnsupported, "an angle in a scene with \"motion\" is not computed", scene.file);
  asked.require_moving();
}

std::string angles_text(const std::vector<DegreeInterval>& angles) {
  std::string out;
  for (const DegreeInterval& i : angles) {
    if (i.single())
      out += fmt::format("  {} alone\n", shown(i.from));
    else if (i.whole())
      out += "  all\n";
    else
      out += fmt::format("  {}{}, {}{}\n", i.from_in ? "[" : "(", shown(i.from), shown(i.to), i.to_in ? "]" : ")");
  }
  return out;
}

/// `outer` may be null.
std::string rotations_text(const AskedScene& asked, const std::vector<DegreeInterval>& angles,
                           const plane::RotationMap* outer) {
  std::string out = fmt::format("Angles of {}, in degrees\n", asked.scene().moving_text());
  const std::string possible = outer != nullptr ? angles_text(degree_intervals(*outer)) : "";
  out += !angles.empty() ? angles_text(angles) : possible.empty() ? "  none: proven empty\n" : "  none certain\n";
  if (!possible.empty()) out += "possible\n" + possible;
  return out;
}

/// The moving shapes as they stand at the ends of the intervals, a few of them.
struct Station {
  double degrees;
  formula::World world;
};

std::vector<Station> stations(const AskedScene& asked, const formula::World& world,
                              const std::vector<DegreeInterval>& angles) {
  constexpr std::size_t kMost = 6;
  std::vector<double> ends;
  for (const DegreeInterval& i : angles) {
    ends.push_back(i.from);
    if (i.to != i.from && i.to - i.from < 360) ends.push_back(i.to);
  }
  std::erase(ends, 0.0);  // as it is drawn
  if (ends.size() > kMost) ends.resize(kMost);
  std::vector<Station> out;
  plane::Rounding rounding;
  const GridPosition& about = asked.scene().free.about;
  for (const double d : ends) {
    const exact::Real degrees = asked.scene().seen(exact::Real::from_double(d));
    out.push_back({d, formula::rotated_world(world, {about[0], about[1]}, degrees, rounding)});
  }
  return out;
}

std::string picture(const AskedScene& asked, const formula::World& world, const formula::Formula& formula,
                    const exact::RealPoint& at, const std::vector<DegreeInterval>& angles) {
  Picture p;
  p.title = fmt::format("Angles of {}{}", asked.scene().moving_text(), angles.empty() ? ": none" : "");
  p.subtitle = asked.scene().where.text;
  p.of_positions = false;
  p.position = {plane::Twofold(at.x).value(), plane::Twofold(at.y).value()};
  add_scenery(asked, p, world, &formula);
  const auto stood = stations(asked, world, angles);
  for (const Station& w : stood) {
    for (const std::string& name : world.moving) {
      if (asked.scene().groups.count(name) > 0) continue;  // its members are drawn
      p.rotated.push_back({fmt::format("{}°", shown(w.degrees)), &*w.world.shapes.at(name)});
    }
  }
  return rotations_svg(picture_svg(p), angles);
}

}  // namespace

formula::Formula question_over_angles(const AskedScene& asked) {
  require_plane(asked);
  const Scene& scene = asked.scene();
  const auto goal = asked.goal();
  if (goal && (scene.free.kind == Kind::kPose || goal->objective.kind != formula::Objective::Kind::kDistance))
    throw Error(ErrorCode::kUnsupported, "over angles only a distance can be an objective, over poses none",
                scene.file);
  asked.require_question();
  return asked.where();
}

namespace {

struct AngleMap {
  formula::SolvedAngles set;
  std::optional<distance::OptimalValue> best;
};

/// The angles at which the formula holds, or the best of them, as the scene tells them.
AngleMap solve(const AskedScene& asked, const formula::RotationMaps& maps, const formula::Formula& formula) {
  AngleMap map{formula::solve_angles(maps, formula), std::nullopt};
  if (const auto goal = asked.goal()) {
    const bool negated = goal->objective.negated;
    const distance::Sense sense = negated ? opposite(goal->sense) : goal->sense;
    formula::BestAngles best = formula::best_angles(maps, goal->objective.distance, map.set, sense);
    if (negated) best.negate();
    map.best = best;
    map.set = std::move(best.at);
  }
  if (asked.scene().mirrors_angles()) {
    map.set.angles = plane::mirrored(map.set.angles);
    if (map.set.outer) map.set.outer = plane::mirrored(*map.set.outer);
  }
  if (map.set.outer)
    asked.note("rotations about two points: angles that certainly belong, and in \"outer\" the possible ones");
  return map;
}

/// What a map of angles needs for its texts and pictures.
struct AngleQuestion {
  AskedScene asked;
  formula::Formula formula;
  exact::RealPoint at;
  std::shared_ptr<const formula::Solver> solver;
  AngleMap map{};
  std::vector<DegreeInterval> angles{}, possible{};

  AngleQuestion(AskedScene given, const exact::RealPoint& place)
      : asked(std::move(given)), formula(question_over_angles(asked)), at(place), solver(asked.solver()) {}

  std::string json() const {
    std::string text = rotations_json(map.set.angles, map.best ? &*map.best : nullptr);
    return map.set.outer ? bounded_json(std::move(text), rotations_json(*map.set.outer)) : text;
  }
  std::string text() const {
    std::string out = rotations_text(asked, angles, map.set.outer ? &*map.set.outer : nullptr);
    return map.best ? out + optimum_text(*map.best, "") : out;
  }
};

std::vector<Interval> in_degrees(const std::vector<DegreeInterval>& angles) {
  std::vector<Interval> out;
  for (const DegreeInterval& i : angles) out.push_back({i.from, i.to, i.from_in, i.to_in});
  return out;
}

}  // namespace

Answer::Data map_of_angles(AskedScene given, const exact::RealPoint& at) {
  const auto q = std::make_shared<AngleQuestion>(std::move(given), at);
  q->asked.stage("solving");
  const formula::RotationSolver rotated(*q->solver, {at, {}, about(q->asked)});
  q->map = solve(q->asked, rotated.maps(q->formula), q->formula);
  q->angles = degree_intervals(q->map.set.angles);
  q->possible = q->map.set.outer ? degree_intervals(*q->map.set.outer) : q->angles;
  Answer::Data out;
  out.found = found_in(!q->angles.empty(), !q->possible.empty());
  out.json = [q](const Telling&) { return q->json(); };
  out.text = [q](const Telling&) { return q->text(); };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{picture(q->asked, q->solver->world(), q->formula, q->at, q->angles), {}};
  };
  out.intervals = [q] { return in_degrees(q->angles); };
  out.possible = [q] { return in_degrees(q->possible); };
  if (q->map.best)
    out.best = [q] {
      return api::public_optimum(*q->map.best, api::make_region(plane::Region::uniform(0), q->asked.scene().grid));
    };
  return out;
}

}  // namespace findspace::io
