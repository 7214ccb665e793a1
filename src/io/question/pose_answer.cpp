// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>

#include "api/values/region_data.h"
#include "formula/planar/solve_rotation.h"
#include "io/draw/draw_layout.h"
#include "io/question/map_answer.h"
#include "io/question/scenery.h"
#include "io/write/write_panels.h"
#include "io/write/write_poses.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace::io {
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
  return s.area ? fmt::format("area {}, {} component{}", shown(*s.area), s.components.size(),
                              s.components.size() == 1 ? "" : "s")
                : "unbounded";
}

/// A region of positions, another faintly around it, and what stands there. `panel`: of several in one.
Picture picture(const AskedScene& asked, const formula::World& world, const formula::Formula& formula,
                const std::string& title, std::string panel, const plane::Summary& summary, const plane::Region& region,
                const plane::Region* around) {
  Picture p;
  p.title = title + (summary.empty ? ": none" : "");
  p.panel = std::move(panel);
  p.region = &region;
  p.summary = &summary;
  p.around = around;
  p.around_text = "positions not excluded";
  add_scenery(asked, p, world, &formula);
  return p;
}

Page page(const AskedScene& asked, const formula::World& world, const formula::Formula& formula, std::string title,
          const plane::Region& region, const plane::Region* around) {
  const plane::Summary summary = plane::summarize(region, asked.step());
  std::string svg = picture_svg(picture(asked, world, formula, title, "", summary, region, around));
  return {std::move(title), std::move(svg)};
}

/// A panel for each of the given angles, and one for all positions that some angle allows.
std::string panels(const AskedScene& asked, const PoseStack& stack, const formula::World& world,
                   const formula::Formula& formula, const plane::GridPoint& about) {
  std::vector<SvgDrawing> out;
  std::vector<const plane::Region*> regions;
  plane::Rounding drawn;
  for (const PoseSlice& s : stack.slices) {
    const formula::World rotated =
        formula::rotated_world(world, {about.x, about.y}, asked.scene().seen(s.degrees), drawn);
    const plane::Summary summary = plane::summarize(s.region, asked.step());
    out.push_back(
        picture_drawing(picture(asked, rotated, formula, fmt::format("At {}°", shown(s.degrees.to_double())),
                                std::to_string(out.size()), summary, s.region, s.outer ? &*s.outer : nullptr)));
    regions.push_back(&s.region);
  }
  const plane::Region all = plane::unite(regions);
  const plane::Summary summary = plane::summarize(all, asked.step());
  Picture last =
      picture(asked, world, formula, "At one of these angles", std::to_string(out.size()), summary, all, nullptr);
  last.moving.clear();  // at which angle it may stand there differs
  out.push_back(picture_drawing(last));
  return panels_svg(fmt::format("Positions of {}", asked.scene().moving_text()), out);
}

std::string pages(const AskedScene& asked, const PoseStack& stack, const formula::World& world,
                  const formula::Formula& formula, const plane::GridPoint& about) {
  std::vector<Page> out;
  const exact::RealPoint centre{about.x, about.y};
  plane::Rounding drawn;
  for (const PoseSlice& s : stack.slices) {
    const formula::World rotated = formula::rotated_world(world, centre, asked.scene().seen(s.degrees), drawn);
    out.push_back(page(asked, rotated, formula, fmt::format("At {}°", shown(s.degrees.to_double())), s.region,
                       s.outer ? &*s.outer : nullptr));
    for (const PoseSector& t : stack.sectors) {
      if (!(t.from == s.degrees)) continue;
      out.push_back(page(asked, rotated, formula,
                         fmt::format("Certain from {}° to {}°; faintly, where it may be possible at some angle between",
                                     shown(t.from.to_double()), shown(t.to.to_double())),
                         t.inner, &t.outer));
    }
  }
  return pages_html(asked.scene().where.text, out);
}

std::string stack_text(const AskedScene& asked, const PoseStack& stack) {
  std::string out = fmt::format("Positions of {}, angle by angle\n", asked.scene().moving_text());
  for (const PoseSlice& s : stack.slices)
    out += fmt::format("  at {}°: {}{}\n", shown(s.degrees.to_double()), area_text(s.region, asked.step()),
                       s.outer ? ", possible within " + area_text(*s.outer, asked.step()) : "");
  if (asked.scene().board != nullptr) {  // at these angles alone
    std::vector<const plane::Region*> regions;
    for (const PoseSlice& s : stack.slices) regions.push_back(&s.region);
    return out + fmt::format("  at one of them: {}\n", area_text(plane::unite(regions), asked.step()));
  }
  for (const PoseSector& s : stack.sectors) {
    out += fmt::format("  {}° to {}°: at all angles {}; at some within {} (bound {} {})\n", shown(s.from.to_double()),
                       shown(s.to.to_double()), area_text(s.inner, asked.step()), area_text(s.outer, asked.step()),
                       shown(s.bound), asked.unit());
  }
  return out;
}

plane::Rounding rounding_of(const PoseStack& stack) {
  plane::Rounding all;
  for (const PoseSlice& s : stack.slices) {
    all.points += s.rounding.points;
    all.largest = std::max(all.largest, s.rounding.largest);
  }
  return all;
}

/// What a map of poses needs for its texts and pictures.
struct PoseQuestion {
  AskedScene asked;
  formula::Formula formula;
  plane::GridPoint about;
  formula::World world;
  PoseStack stack{};

  explicit PoseQuestion(AskedScene given)
      : asked(std::move(given)),
        formula(question_over_angles(asked)),
        about{asked.scene().free.about[0], asked.scene().free.about[1]},
        world(asked.world()) {
    for (auto& [name, region] : world.shapes) region = plane::closure(std::move(region));
  }

  PoseMap poses() const {
    const auto region = [&](const plane::Region& r) { return api::make_region(r, asked.scene().grid, asked.unit()); };
    PoseMap out;
    for (const PoseSlice& s : stack.slices) {
      PoseMap::Slice& slice = out.slices.emplace_back(PoseMap::Slice{s.degrees.to_double(), region(s.region), {}});
      if (s.outer) slice.outer = region(*s.outer);
    }
    for (const PoseSector& s : stack.sectors)
      out.sectors.push_back({s.from.to_double(), s.to.to_double(), s.bound, region(s.inner), region(s.outer)});
    return out;
  }
};

}  // namespace

Answer::Data map_of_poses(AskedScene given) {
  const auto q = std::make_shared<PoseQuestion>(std::move(given));
  q->asked.stage("solving");
  q->stack = planning::pose_stack(q->world, q->formula, q->about, q->asked.scene().free.angles);
  if (q->asked.scene().mirrors_angles()) q->stack = as_seen(std::move(q->stack));
  q->asked.note_rotated(rounding_of(q->stack), "; the sectors allow for it");
  bool empty = true, impossible = true;
  for (const PoseSlice& s : q->stack.slices) {
    empty = empty && plane::is_empty(s.region);
    impossible = impossible && plane::is_empty(s.outer ? *s.outer : s.region);
  }
  Answer::Data out;
  out.found = found_in(!empty, !impossible);
  out.json = [q](const Telling&) { return poses_json(q->stack, q->asked.step(), q->asked.unit()); };
  out.text = [q](const Telling&) { return stack_text(q->asked, q->stack); };
  out.files[".html"] = [q](const Telling&) {
    return Region::Drawn{pages(q->asked, q->stack, q->world, q->formula, q->about), {}};
  };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{panels(q->asked, q->stack, q->world, q->formula, q->about), {}};
  };
  out.poses = [q] { return q->poses(); };
  return out;
}

}  // namespace findspace::io
