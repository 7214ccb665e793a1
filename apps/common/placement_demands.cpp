// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/placement_demands.h"

#include <fmt/format.h>

namespace findspace::app {
namespace {

std::string place_of(const io::FormulaText& text) { return fmt::format("{}:{}:{}", text.file, text.line, text.column); }

planning::Unread<formula::Formula> unread(const Session& session, const io::FormulaText& text) {
  if (text.empty()) return {};
  return {[&](const formula::Context& context) { return session.formula(text, context); }, place_of(text)};
}

}  // namespace

planning::AskedDemands placement_demands(const Session& session) {
  const io::Scene& scene = session.scene();
  auto refuse = [&](const std::string& what) { throw Error(ErrorCode::kUnsupported, what, scene.file); };
  if (!scene.place.given())
    throw Error(ErrorCode::kBadValue, "the scene has no \"place\": nothing says what to place", scene.file);
  if (scene.motion.given()) refuse("a placement over a \"motion\" is not computed");
  if (scene.free.kind != io::Free::Kind::kPosition)
    refuse("a placement ranges over positions: \"free\" has no meaning with it");
  planning::Asked asked;
  for (const io::PlacedBody& b : scene.place.bodies) asked.bodies.push_back({b.name, b.shapes, b.angles, b.count});
  asked.each = unread(session, scene.place.each);
  asked.pairs = unread(session, scene.place.pairs);
  for (const io::FormulaText& text : scene.place.constraints) asked.constraints.push_back(unread(session, text));
  for (const io::FormulaText& text : scene.place.minimize)
    asked.minimize.push_back(
        {[&](const formula::Context& context) { return session.goal(text, context); }, place_of(text)});
  return planning::demands_of(asked, session.context());
}

}  // namespace findspace::app
