// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "scenery.h"

#include <algorithm>
#include <set>

#include "motion_arrows.h"

namespace findspace::app {

void add_scenery(const Session& session, io::Picture& picture, const formula::World& world,
                 const formula::Formula* formula) {
  picture.step = world.step;
  picture.unit = session.unit();
  picture.y_down = session.scene().y_down;
  for (int c : {0, 1})
    picture.home[c] = static_cast<double>(session.scene().drawn_at[c]) * session.scene().grid.step_size();
  picture.arrows = motion_arrows(session.scene(), world, formula);
  std::set<std::string> named;
  if (formula != nullptr) {
    for (const formula::Atom& a : formula->atoms()) {
      named.insert(a.distance.first.begin(), a.distance.first.end());
      named.insert(a.distance.second.begin(), a.distance.second.end());
    }
  }
  const bool named_only = session.scene().named_only;
  const auto all_of = [&](const std::string& name) {
    const auto parts = world.parts.find(name);
    if (!named_only || parts == world.parts.end()) return picture.fixed.push_back({name, &world.shapes.at(name)});
    for (const auto& [part, region] : parts->second) picture.fixed.push_back({part, &region});
  };
  // The names of a board's pads are said where the formula speaks of them.
  const auto shown_name = [&](const std::string& name) {
    return named_only && name.find('.') != std::string::npos && named.count(name) == 0 ? std::string() : name;
  };
  for (const plane::ShapePtr& s : session.scene().shapes) {
    const bool moves = std::find(world.moving.begin(), world.moving.end(), s->name) != world.moving.end();
    if (moves)
      picture.moving.push_back({shown_name(s->name), &world.shapes.at(s->name)});
    else if ((named.empty() || named.count(s->name) != 0) && world.shapes.count(s->name) != 0)
      all_of(s->name);
  }
}

}  // namespace findspace::app
