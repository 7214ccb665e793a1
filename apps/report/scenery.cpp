// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "report/scenery.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "io/board/read_part.h"
#include "plane/base/parallel.h"
#include "plane/build/build.h"
#include "report/motion_arrows.h"

namespace findspace::app {

namespace {

/// The layers of a picture, from below.
enum Layer { kBack, kInner, kFront, kThrough, kHole };

Layer layer_of(const io::Sides& sides) {
  return sides.front && sides.back ? kThrough : sides.back ? kBack : sides.front ? kFront : kInner;
}

}  // namespace

std::vector<io::CopperLayer> copper_of(const io::Board& board, const std::vector<std::string>& moving, double step) {
  std::vector<io::CopperLayer> out{{"copper-back", "copper: back", {}},
                                   {"copper-inner", "inner", {}},
                                   {"copper-front", "front", {}},
                                   {"copper-through", "through", {}},
                                   {"hole", "", {}}};
  std::vector<std::pair<Layer, plane::ShapePtr>> shapes;
  for (const io::Part& part : board.parts) {
    if (std::find(moving.begin(), moving.end(), part.name) != moving.end()) continue;
    for (const io::Pad& pad : part.pads) shapes.emplace_back(layer_of(pad.sides), pad.copper);
  }
  for (const io::Copper& c : board.tracks) shapes.emplace_back(layer_of(io::sides_of(c.layers)), c.shape);
  for (const io::Copper& c : board.vias) shapes.emplace_back(kThrough, c.shape);
  for (const io::Hole& hole : board.holes)
    if (std::find(moving.begin(), moving.end(), hole.part) == moving.end()) shapes.emplace_back(kHole, hole.shape);
  std::vector<plane::Region> built(shapes.size());
  plane::parallel_for(shapes.size(), [&](std::size_t k) { built[k] = plane::build(*shapes[k].second, step).region; });
  for (std::size_t k = 0; k < built.size(); ++k) out[shapes[k].first].regions.push_back(std::move(built[k]));
  std::erase_if(out, [](const io::CopperLayer& layer) { return layer.regions.empty(); });
  return out;
}

bool is_behind(const io::Board* board, std::string_view part) {
  const io::Part* found = board == nullptr ? nullptr : board->find(part);
  return found != nullptr && found->courtyard.back && !found->courtyard.front;
}

namespace {

/// Whether a member of a list is called so: holes and tracks of a board have numbers only.
bool has_own_name(const io::Board* board, std::string_view member) {
  if (board == nullptr || board->find(member) != nullptr) return true;
  return std::any_of(board->keep_outs.begin(), board->keep_outs.end(), [&](const auto& k) { return k.name == member; });
}

}  // namespace

void add_scenery(const Session& session, io::Picture& picture, const formula::World& world,
                 const formula::Formula* formula) {
  picture.step = world.step;
  picture.unit = session.unit();
  picture.y_down = session.scene().y_down;
  const io::Board* const board = session.scene().board.get();
  picture.small_names = board != nullptr;
  for (int c : {0, 1})
    picture.home[c] = static_cast<double>(session.scene().drawn_at[c]) * session.scene().grid.step_size();
  picture.arrows = motion_arrows(session.scene(), world, formula);
  if (board != nullptr) picture.copper = copper_of(*board, world.moving, session.scene().grid.step_size());
  const std::set<std::string> named = formula != nullptr ? formula->shapes() : std::set<std::string>();
  const bool named_only = session.scene().named_only;
  // The parts of a collection carry their own names; one whose parts have none carries its own.
  const auto all_of = [&](const std::string& name) {
    const auto parts = world.parts.find(name);
    const auto has_name = [](const auto& part) { return !std::isdigit(static_cast<unsigned char>(part.first[0])); };
    const bool by_parts =
        parts != world.parts.end() && std::all_of(parts->second.begin(), parts->second.end(), has_name);
    if (board != nullptr && name == "board") return picture.fixed.push_back({"", &*world.shapes.at(name)});
    if (parts == world.parts.end() || (!named_only && !by_parts))
      return picture.fixed.push_back({name, &*world.shapes.at(name)});
    for (const auto& [part, region] : parts->second) {
      if (named_only && named.count(part) > 0) continue;  // it is drawn itself
      picture.fixed.push_back({has_own_name(board, part) ? part : "", &region, is_behind(board, part)});
    }
  };
  // The names of a board's pads are said where the formula speaks of them.
  const auto shown_name = [&](const std::string& name) {
    return named_only && name.find('.') != std::string::npos && named.count(name) == 0 ? std::string() : name;
  };
  for (const plane::ShapePtr& s : session.scene().shapes) {
    const bool moves = std::find(world.moving.begin(), world.moving.end(), s->name) != world.moving.end();
    if (moves && session.scene().groups.count(s->name) > 0) continue;  // its members are drawn
    if (moves)
      picture.moving.push_back({shown_name(s->name), &*world.shapes.at(s->name)});
    else if ((named.empty() || named.count(s->name) != 0) && world.shapes.count(s->name) != 0)
      all_of(s->name);
  }
}

}  // namespace findspace::app
