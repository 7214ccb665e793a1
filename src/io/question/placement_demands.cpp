// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/placement_demands.h"

#include <fmt/format.h>

namespace findspace::io {
namespace {

std::string place_of(const FormulaText& text) { return fmt::format("{}:{}:{}", text.file, text.line, text.column); }

planning::Unread<formula::Formula> unread(const AskedScene& asked, const FormulaText& text) {
  if (text.empty()) return {};
  return {[&](const formula::Context& context) { return asked.formula(text, context); }, place_of(text)};
}

planning::Wanted wanted_of(const AskedScene& asked, const Placement::Near& near, const planning::Demands& demands) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorCode::kBadValue, fmt::format("near: {}", what), asked.scene().file);
  };
  const std::string called = near.copy > 0 ? fmt::format("{} {}", near.name, near.copy) : near.name;
  planning::Wanted out;
  while (out.body < demands.bodies.size() &&
         !(demands.bodies[out.body].name == near.name && demands.bodies[out.body].copy == near.copy))
    ++out.body;
  if (out.body == demands.bodies.size()) refuse(fmt::format("'{}' is not placed", called));
  if (near.at.size() != std::size_t(asked.scene().dimension))
    refuse(fmt::format("a position of this scene has {} numbers", asked.scene().dimension));
  for (const exact::Real& c : near.at) {
    asked.scene().grid.steps(c);  // refuses what is out of reach
    out.at.push_back(c / asked.step());
  }
  if (!near.degrees) return out;
  const auto& angles = demands.bodies[out.body].angles;
  const exact::Real wanted = asked.scene().seen(*near.degrees);
  for (std::size_t a = 0; a < angles.size(); ++a)
    if (!angles[a].rotation && ((angles[a].degrees - wanted) / exact::Real(360)).integer()) out.angle = a;
  if (!out.angle) refuse(fmt::format("'{}' is not placed at {} degrees", called, near.degrees->text()));
  return out;
}

}  // namespace

planning::AskedDemands placement_demands(const AskedScene& asked) {
  const Scene& scene = asked.scene();
  auto refuse = [&](const std::string& what) { throw Error(ErrorCode::kUnsupported, what, scene.file); };
  if (!scene.place.given())
    throw Error(ErrorCode::kBadValue, "the scene has no \"place\": nothing says what to place", scene.file);
  if (scene.motion.given()) refuse("a placement over a \"motion\" is not computed");
  if (scene.free.kind != Free::Kind::kPosition)
    refuse("a placement ranges over positions: \"free\" has no meaning with it");
  planning::Asked demanded;
  for (const PlacedBody& b : scene.place.bodies) demanded.bodies.push_back({b.name, b.shapes, b.angles, b.count});
  demanded.each = unread(asked, scene.place.each);
  demanded.pairs = unread(asked, scene.place.pairs);
  for (const FormulaText& text : scene.place.constraints) demanded.constraints.push_back(unread(asked, text));
  for (const FormulaText& text : scene.place.minimize)
    demanded.minimize.push_back(
        {[&](const formula::Context& context) { return asked.goal(text, context); }, place_of(text)});
  planning::AskedDemands out = planning::demands_of(demanded, asked.context());
  std::vector<planning::Wanted> wanted;
  for (const Placement::Near& near : scene.place.near) wanted.push_back(wanted_of(asked, near, out.demands));
  planning::put_first(out.demands, wanted);
  return out;
}

}  // namespace findspace::io
