// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/question/scenery.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "io/question/motion_arrows.h"

namespace findspace::io {

namespace {

/// Whether a member of a list is called so: holes and tracks of a board have numbers only.
bool has_own_name(const Board* board, std::string_view member) {
  if (board == nullptr || board->find(member) != nullptr) return true;
  return std::any_of(board->keep_outs.begin(), board->keep_outs.end(), [&](const auto& k) { return k.name == member; });
}

}  // namespace

void add_scenery(const AskedScene& asked, Picture& picture, const formula::World& world,
                 const formula::Formula* formula) {
  picture.step = world.step;
  picture.unit = asked.unit();
  picture.y_down = asked.scene().y_down;
  const Board* const board = asked.scene().board.get();
  picture.small_names = board != nullptr;
  for (int c : {0, 1})
    picture.home[c] = static_cast<double>(asked.scene().drawn_at[c]) * asked.scene().grid.step_size();
  picture.arrows = motion_arrows(asked.scene(), world, formula);
  if (board != nullptr) picture.copper = copper_of(*board, world.moving, asked.scene().grid.step_size());
  const std::set<std::string> named = formula != nullptr ? formula->shapes() : std::set<std::string>();
  const bool named_only = asked.scene().named_only;
  const auto has_name = [](const std::string& part) { return !std::isdigit(static_cast<unsigned char>(part[0])); };
  const auto is_drawn_itself = [&](const std::string& part) {
    if (named_only) return named.count(part) > 0;
    return has_name(part) && (named.empty() || named.count(part) > 0) && world.shapes.count(part) > 0;
  };
  // The parts of a collection carry their own names; the first that has none carries the collection's.
  const auto all_of = [&](const std::string& name) {
    const auto parts = world.parts.find(name);
    const bool by_parts =
        parts != world.parts.end() &&
        std::any_of(parts->second.begin(), parts->second.end(), [&](const auto& part) { return has_name(part.first); });
    if (board != nullptr && name == "board") return picture.fixed.push_back({"", &*world.shapes.at(name)});
    if (parts == world.parts.end() || (!named_only && !by_parts))
      return picture.fixed.push_back({name, &*world.shapes.at(name)});
    std::string others = board != nullptr ? "" : name;
    for (const auto& [part, region] : parts->second) {
      if (is_drawn_itself(part)) continue;
      const bool shown = board != nullptr ? has_own_name(board, part) : has_name(part);
      picture.fixed.push_back({shown ? part : std::exchange(others, ""), &region, is_behind(board, part)});
    }
  };
  // The names of a board's pads are said where the formula speaks of them.
  const auto shown_name = [&](const std::string& name) {
    return named_only && name.find('.') != std::string::npos && named.count(name) == 0 ? std::string() : name;
  };
  for (const plane::ShapePtr& s : asked.scene().shapes) {
    const bool moves = std::find(world.moving.begin(), world.moving.end(), s->name) != world.moving.end();
    if (moves && asked.scene().groups.count(s->name) > 0) continue;  // its members are drawn
    if (moves)
      picture.moving.push_back({shown_name(s->name), &*world.shapes.at(s->name)});
    else if ((named.empty() || named.count(s->name) != 0) && world.shapes.count(s->name) != 0)
      all_of(s->name);
  }
}

}  // namespace findspace::io
