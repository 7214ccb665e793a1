// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "common/asked_numbers.h"
#include "in_plane/rotation_command.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_explanation.h"
#include "io/write/write_panels.h"
#include "io/write/write_poses.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"
#include "report/scenery.h"

namespace findspace::app {
namespace {

using planning::PoseSector;
using planning::PoseSlice;
using planning::PoseStack;

/// The stack with its angles as they are counted where y runs downwards: counter-clockwise as it is seen.
PoseStack as_seen(PoseStack stack) {
  const auto seen = [](const exact::Real& a) { return a.sign() == 0 ? a : exact::Real(360) - a; };
  for (PoseSlice& s : stack.slices) s.degrees = seen(s.degrees);
  for (PoseSector& s : stack.sectors) {
    const exact::Real from = seen(s.to), width = s.to - s.from;  // s.to may be beyond 360
    s.from = from.sign() < 0 ? from + exact::Real(360) : from;
    s.to = s.from + width;
  }
  const auto zero_first = [](auto& all, auto angle) {
    std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  };
  zero_first(stack.slices, [](const PoseSlice& s) { return s.degrees; });
  zero_first(stack.sectors, [](const PoseSector& s) { return s.from; });
  return stack;
}

std::string area_text(const plane::Region& r, const exact::Real& step) {
  const plane::Summary s = plane::summarize(r, step);
  if (s.empty) return "empty";
  return s.area ? fmt::format("area {}, {} component{}", io::shown(*s.area), s.components.size(),
                              s.components.size() == 1 ? "" : "s")
                : "unbounded";
}

/// A region of positions, another faintly around it, and what stands there. `panel`: of several in one.
io::Picture picture(const Session& session, const formula::World& world, const formula::Formula& formula,
                    const std::string& title, std::string panel, const plane::Summary& summary,
                    const plane::Region& region, const plane::Region* around) {
  io::Picture p;
  p.title = title + (summary.empty ? ": none" : "");
  p.panel = std::move(panel);
  p.region = &region;
  p.summary = &summary;
  p.around = around;
  p.around_text = "positions not excluded";
  add_scenery(session, p, world, &formula);
  return p;
}

io::Page page(const Session& session, const formula::World& world, const formula::Formula& formula, std::string title,
              const plane::Region& region, const plane::Region* around) {
  const plane::Summary summary = plane::summarize(region, session.step());
  std::string svg = io::picture_svg(picture(session, world, formula, title, "", summary, region, around));
  return {std::move(title), std::move(svg)};
}

/// A panel for each of the given angles, and one for all positions that some angle allows.
std::string panels(const Session& session, const PoseStack& stack, const formula::World& world,
                   const formula::Formula& formula, const plane::GridPoint& about, bool down) {
  std::vector<io::SvgDrawing> out;
  std::vector<const plane::Region*> regions;
  plane::Rounding drawn;
  for (const PoseSlice& s : stack.slices) {
    const formula::World rotated =
        formula::rotated_world(world, {about.x, about.y}, down ? -s.degrees : s.degrees, drawn);
    const plane::Summary summary = plane::summarize(s.region, session.step());
    out.push_back(
        io::picture_drawing(picture(session, rotated, formula, fmt::format("At {}°", io::shown(s.degrees.to_double())),
                                    std::to_string(out.size()), summary, s.region, s.outer ? &*s.outer : nullptr)));
    regions.push_back(&s.region);
  }
  const plane::Region all = plane::unite(regions);
  const plane::Summary summary = plane::summarize(all, session.step());
  io::Picture last =
      picture(session, world, formula, "At one of these angles", std::to_string(out.size()), summary, all, nullptr);
  last.moving.clear();  // at which angle it may stand there differs
  out.push_back(io::picture_drawing(last));
  return io::panels_svg(fmt::format("Positions of {}", session.scene().moving_text()), out);
}

std::string pages(const Session& session, const PoseStack& stack, const formula::World& world,
                  const formula::Formula& formula, const plane::GridPoint& about, bool down) {
  std::vector<io::Page> out;
  const exact::RealPoint centre{about.x, about.y};
  plane::Rounding drawn;
  for (const PoseSlice& s : stack.slices) {
    const formula::World rotated = formula::rotated_world(world, centre, down ? -s.degrees : s.degrees, drawn);
    out.push_back(page(session, rotated, formula, fmt::format("At {}°", io::shown(s.degrees.to_double())), s.region,
                       s.outer ? &*s.outer : nullptr));
    for (const PoseSector& t : stack.sectors) {
      if (!(t.from == s.degrees)) continue;
      out.push_back(page(session, rotated, formula,
                         fmt::format("Certain from {}° to {}°; faintly, where it may be possible at some angle between",
                                     io::shown(t.from.to_double()), io::shown(t.to.to_double())),
                         t.inner, &t.outer));
    }
  }
  return io::pages_html(session.scene().where.text, out);
}

std::string stack_text(const Session& session, const PoseStack& stack) {
  std::string out = fmt::format("Positions of {}, angle by angle\n", session.scene().moving_text());
  for (const PoseSlice& s : stack.slices)
    out += fmt::format("  at {}°: {}{}\n", io::shown(s.degrees.to_double()), area_text(s.region, session.step()),
                       s.outer ? ", possible within " + area_text(*s.outer, session.step()) : "");
  if (session.scene().board != nullptr) {  // at these angles alone
    std::vector<const plane::Region*> regions;
    for (const PoseSlice& s : stack.slices) regions.push_back(&s.region);
    return out + fmt::format("  at one of them: {}\n", area_text(plane::unite(regions), session.step()));
  }
  for (const PoseSector& s : stack.sectors) {
    out += fmt::format("  {}° to {}°: at all angles {}; at some within {} (bound {} {})\n",
                       io::shown(s.from.to_double()), io::shown(s.to.to_double()), area_text(s.inner, session.step()),
                       area_text(s.outer, session.step()), io::shown(s.bound), session.unit());
  }
  return out;
}

void say_rotated(const Session& session, const plane::Rounding& all, std::string_view sectors = "") {
  if (all.points == 0) return;
  session.reporter().note(fmt::format("{} rotated vertices were put on the grid, moved by at most {:.2g} {}{}",
                                      all.points, all.largest * session.scene().grid.step_size(), session.unit(),
                                      sectors));
}

plane::Rounding rounding_of(const PoseStack& stack) {
  plane::Rounding all;
  for (const PoseSlice& s : stack.slices) {
    all.points += s.rounding.points;
    all.largest = std::max(all.largest, s.rounding.largest);
  }
  return all;
}

/// As they are counted where they are seen.
std::vector<double> seen(const std::vector<exact::Real>& degrees, bool down) {
  std::vector<double> out;
  for (const exact::Real& d : degrees) {
    const exact::Real turned = down ? -d : d;
    out.push_back((turned - exact::Real(360) * exact::Real(exact::floor(turned / exact::Real(360)))).to_double());
  }
  return out;
}

}  // namespace

Outcome explain_poses(const Session& session) {
  const io::Scene& scene = session.scene();
  const formula::Formula formula = question_over_angles(session);
  const bool one = session.options().angle.has_value();
  const std::vector<exact::Real> angles = one ? std::vector{asked_angle(session)} : scene.free.angles;
  if (session.options().at && !one)
    throw Error(ErrorCode::kUsage, "--at is for one angle: --angle says which", scene.file);
  const exact::RealPoint about{scene.free.about[0], scene.free.about[1]};
  session.reporter().stage("explaining");
  plane::Rounding rounding;
  const std::vector<formula::SharedSolver> poses = formula::solvers_at(session.world(), about, angles, rounding);
  say_rotated(session, rounding);
  const formula::Explanation found = formula::explain(poses, formula);
  std::optional<formula::PositionExplanation> here;
  exact::RealPoint at;
  if (session.options().at) here = formula::explain_at(*poses[0], formula, at = asked_position(session));
  const io::ExplanationReport report{formula,
                                     found,
                                     here ? &*here : nullptr,
                                     distance::coordinates(at),
                                     session.step(),
                                     session.unit(),
                                     seen(angles, scene.board != nullptr && !one)};
  write_outputs(session.options(), {{".json", [&] { return io::explanation_json(report); }}});
  const bool holds = here ? here->check.holds : found.feasible;
  return {session.options().json ? io::explanation_json(report) : io::explanation_text(report), holds ? kDone : kEmpty};
}

Outcome map_of_poses(const Session& session) {
  check_outputs(session.options(), {".json", ".html", ".svg"});
  const formula::Formula formula = question_over_angles(session);
  const io::Free& free = session.scene().free;
  const plane::GridPoint about{free.about[0], free.about[1]};
  formula::World world = session.world();
  for (auto& [name, region] : world.shapes) region = plane::closure(std::move(region));
  session.reporter().stage("solving");
  PoseStack stack = planning::pose_stack(world, formula, about, free.angles);
  const bool down = session.scene().board != nullptr;
  if (down) stack = as_seen(std::move(stack));
  say_rotated(session, rounding_of(stack), "; the sectors allow for it");
  const auto json = [&] { return io::poses_json(stack, session.step(), session.unit()); };
  const auto html = [&] { return pages(session, stack, world, formula, about, down); };
  const auto svg = [&] { return panels(session, stack, world, formula, about, down); };
  write_outputs(session.options(), {{".json", json}, {".html", html}, {".svg", svg}});
  bool empty = true, impossible = true;
  for (const PoseSlice& s : stack.slices) {
    empty = empty && plane::is_empty(s.region);
    impossible = impossible && plane::is_empty(s.outer ? *s.outer : s.region);
  }
  return {session.options().json ? json() : stack_text(session, stack), !empty ? kDone : impossible ? kEmpty : kLimit};
}

}  // namespace findspace::app
