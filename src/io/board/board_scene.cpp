// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/board_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "findspace/error.h"
#include "io/text/outline_shapes.h"
#include "io/text/scene_reader.h"

namespace findspace::io {
namespace {

using plane::Shape;
using plane::ShapePtr;

ShapePtr named(const ShapePtr& shape, const std::string& name) {
  Shape copy = *shape;
  copy.name = name;
  return std::make_shared<const Shape>(std::move(copy));
}

ShapePtr list_of(std::vector<ShapePtr> parts, const std::string& name) {
  Shape shape;
  shape.kind = Shape::Kind::kUnion;
  shape.collection = true;
  shape.name = name;
  shape.children = std::move(parts);
  return std::make_shared<const Shape>(std::move(shape));
}

/// The shape with the anchor at the origin.
ShapePtr at_origin(const ShapePtr& shape, plane::GridPoint anchor) {
  Shape moved;
  moved.kind = Shape::Kind::kTranslate;
  moved.points = {plane::GridPoint{-anchor.x, -anchor.y}};
  moved.place = shape->place;
  moved.children = {shape};
  return std::make_shared<const Shape>(std::move(moved));
}

class SceneMaker {
 public:
  SceneMaker(std::shared_ptr<const Board> board, const BoardQuestion& question) : board_(*board), question_(question) {
    scene_.board = std::move(board);
  }

  Scene run() {
    scene_.file = board_.file;
    scene_.unit = Unit::kMillimetre;
    scene_.notes = board_.notes;
    scene_.y_down = scene_.named_only = true;
    name_groups();
    find_fixed();
    find_movers();
    add("board", board_.outline);
    for (const Part& part : board_.parts) add_part(part);
    add_lists();
    add_copper();
    add_groups();
    if (question_.place) {
      add_placement();
      return std::move(scene_);
    }
    scene_.where = formula(question_.where, "--where");
    scene_.minimize = formula(question_.minimize, "--minimize");
    scene_.maximize = formula(question_.maximize, "--maximize");
    if (!question_.angles.empty()) {
      scene_.free.kind = Free::Kind::kPose;
      for (const exact::Real& a : question_.angles) scene_.free.angles.push_back(scene_.seen(a));
    }
    return std::move(scene_);
  }

 private:
  static FormulaText formula(const std::string& text, const char* option) {
    return text.empty() ? FormulaText{} : FormulaText{text, option, 1, 1};
  }

  /// Those of the board under names that nothing else has, and those of the question.
  void name_groups() {
    std::set<std::string> taken{"board", "self", "other", "others", "parts", "smd",    "tht",
                                "front", "back", "fixed", "holes",  "vias",  "tracks", "keepouts"};
    for (const Part& part : board_.parts) {
      taken.insert(part.name);
      for (const Pad& pad : part.pads) taken.insert(pad.name);
    }
    const auto is_taken = [&](const std::string& name) {
      return taken.count(name) > 0 || name.rfind("net ", 0) == 0 || name.rfind("zone ", 0) == 0 ||
             name.ends_with(".Cu");
    };
    for (PartGroup group : board_.groups) {
      while (is_taken(group.name))
        group.name = group.name.ends_with(".Cu") ? group.name + " group" : "group " + group.name;
      groups_.push_back(std::move(group));
      taken.insert(groups_.back().name);
    }
    for (const PartGroup& group : question_.groups) {
      if (is_taken(group.name) || !taken.insert(group.name).second)
        throw Error(ErrorCode::kBadValue, fmt::format("the group '{}' needs a name of its own", group.name),
                    board_.file);
      PartGroup members{group.name, {}};
      for (const std::string& name : group.parts)
        for (const Part* part : named_parts(name))
          if (std::find(members.parts.begin(), members.parts.end(), part->name) == members.parts.end())
            members.parts.push_back(part->name);
      groups_.push_back(std::move(members));
    }
  }

  const PartGroup* find_group(const std::string& name) const {
    const auto found = std::find_if(groups_.begin(), groups_.end(), [&](const PartGroup& g) { return g.name == name; });
    return found == groups_.end() ? nullptr : &*found;
  }

  /// The part of that name, or the parts of the group.
  std::vector<const Part*> named_parts(const std::string& name) const {
    if (const Part* part = board_.find(name); part != nullptr && part->body) return {part};
    if (const PartGroup* group = find_group(name)) {
      std::vector<const Part*> out;
      for (const std::string& member : group->parts) out.push_back(board_.find(member));
      return out;
    }
    std::vector<std::string> names;
    for (const Part& part : board_.parts)
      if (part.body) names.push_back(part.name);
    for (const PartGroup& group : groups_) names.push_back(group.name);
    throw Error(ErrorCode::kUnknownName,
                fmt::format("there is no part or group '{}'{}", name, choice("parts", name, names)), board_.file);
  }

  void find_fixed() {
    for (const std::string& name : question_.fixed)
      for (const Part* part : named_parts(name)) fixed_.insert(part);
  }

  bool is_fixed(const Part& part) const { return part.locked || fixed_.count(&part) > 0; }

  void check_free(const Part& part) {
    if (fixed_.count(&part) > 0)
      throw Error(ErrorCode::kBadValue, fmt::format("the part '{}' is fixed, and it is to move", part.name),
                  board_.file);
    if (!part.locked) return;
    if (question_.place)
      throw Error(ErrorCode::kBadValue, fmt::format("the part '{}' is fixed: it is locked in the board", part.name),
                  board_.file);
    scene_.notes.push_back(fmt::format("{} is locked in the board: place does not move it", part.name));
  }

  void find_movers() {
    for (const std::string& name : question_.move) {
      const std::vector<const Part*> parts = named_parts(name);
      for (const Part* part : parts) {
        if (movers_.empty()) anchor_ = part->at;
        if (!movers_.emplace(part, parts.front()->at).second) {
          if (!question_.place) continue;
          throw Error(ErrorCode::kBadValue, fmt::format("the part '{}' is to be placed twice", part->name),
                      board_.file);
        }
        add_mover(*part);
      }
      scene_.moving_name += (scene_.moving_name.empty() ? "" : ", ") + name;
    }
    scene_.drawn_at = {anchor_.x, anchor_.y, 0};
  }

  void add_mover(const Part& part) {
    check_free(part);
    sides_.front = sides_.front || part.courtyard.front;
    sides_.back = sides_.back || part.courtyard.back;
    if (part.unlike)
      scene_.notes.push_back(
          fmt::format("{}: its courtyards on the two sides differ; their union is taken on both", part.name));
  }

  /// One part or group after another, each at a point of the grid; pads move along where a formula names them.
  void add_placement() {
    Placement& place = scene_.place;
    for (const std::string& name : question_.move) {
      PlacedBody body{name, {}, {}, 1};
      const std::vector<const Part*> parts = named_parts(name);
      for (const Part* part : parts) body.shapes.push_back(part->name);
      for (const Part* part : parts)
        for (const std::string& pad : scene_.moving)
          if (pad.rfind(part->name + ".", 0) == 0 && is_mentioned(pad)) body.shapes.push_back(pad);
      for (const exact::Real& a : question_.angles) body.angles.push_back(scene_.seen(a));
      if (body.angles.empty()) body.angles = {exact::Real(0)};
      place.bodies.push_back(std::move(body));
    }
    scene_.moving.clear();
    place.each = {"inside(self, board) and clear(self, others)", "the rules for parts", 1, 1};
    place.pairs = {"clear(self, other)", "the rules for parts", 1, 1};
    if (!question_.where.empty()) place.constraints.push_back(formula(question_.where, "--where"));
    if (!question_.minimize.empty()) place.minimize.push_back(formula(question_.minimize, "--minimize"));
    place.minimize.push_back({"grid", "the grid of the board", 1, 1});
  }

  bool is_mentioned(const std::string& pad) const {
    return question_.where.find(pad) != std::string::npos || question_.minimize.find(pad) != std::string::npos;
  }

  void add(const std::string& name, const ShapePtr& shape) {
    if (names_.insert(name).second) scene_.shapes.push_back(named(shape, name));
  }

  /// A part and its pads; pads of one name are one shape.
  void add_part(const Part& part) {
    if (!part.body) return;
    const auto mover = movers_.find(&part);
    const bool moves = mover != movers_.end();
    const auto put = [&](const std::string& name, const ShapePtr& shape) {
      add(name, moves ? at_origin(shape, question_.place ? mover->second : anchor_) : shape);
      if (moves) scene_.moving.push_back(name);
    };
    put(part.name, part.body);
    std::map<std::string, std::vector<ShapePtr>> pads;
    for (const Pad& pad : part.pads) pads[pad.name].push_back(pad.copper);
    for (auto& [name, shapes] : pads) put(name, united(std::move(shapes), part.place));
  }

  std::vector<ShapePtr> fixed(const std::function<bool(const Part&)>& wanted) const {
    std::vector<ShapePtr> out;
    for (const Part& part : board_.parts)
      if (part.body && movers_.count(&part) == 0 && wanted(part)) out.push_back(named(part.body, part.name));
    return out;
  }

  void add_lists() {
    std::vector<ShapePtr> here;
    for (const KeepOut& k : board_.keep_outs) {
      if (!k.part.empty() && movers_.count(board_.find(k.part)) > 0) continue;
      keep_outs_.push_back(named(k.area, k.name));
      if (k.sides.meet(sides_)) here.push_back(keep_outs_.back());
    }
    std::vector<ShapePtr> others = fixed([&](const Part& p) { return p.courtyard.meet(sides_); });
    scene_.all_shapes.emplace();
    for (const ShapePtr& part : others) scene_.all_shapes->push_back(part->name);
    others.insert(others.end(), here.begin(), here.end());
    add_list("others", std::move(others));
    add_parts("parts", [](const Part&) { return true; });
    add_parts("smd", [](const Part& p) { return p.smd; });
    add_parts("tht", [](const Part& p) { return p.through; });
    add_parts("front", [](const Part& p) { return p.mounted.front; });
    add_parts("back", [](const Part& p) { return p.mounted.back; });
    add_parts("fixed", [&](const Part& p) { return is_fixed(p); });
    add_list("keepouts", movers_.empty() ? keep_outs_ : std::move(here));
    std::vector<ShapePtr> holes;
    for (const Hole& hole : board_.holes)
      if (hole.part.empty() || movers_.count(board_.find(hole.part)) == 0) holes.push_back(hole.shape);
    add_list("holes", std::move(holes));
  }

  void add_parts(const std::string& name, const std::function<bool(const Part&)>& wanted) {
    if (names_.count(name) > 0) return;
    std::vector<std::string>& members = scene_.groups[name];
    for (const Part& part : board_.parts)
      if (part.body && wanted(part)) members.push_back(part.name);
    add_list(name, fixed(wanted));
  }

  void add_list(const std::string& name, std::vector<ShapePtr> shapes) {
    if (names_.count(name) > 0) return;
    scene_.groups[name];  // a list, and no shape beside the others
    if (shapes.empty()) {
      scene_.empty_lists.push_back(name);
      return;
    }
    add(name, list_of(std::move(shapes), name));
  }

  void add_copper() {
    std::map<std::string, std::vector<ShapePtr>> by_name;
    for (const auto* kind : {&board_.tracks, &board_.vias}) {
      for (const Copper& c : *kind) {
        for (const std::string& layer : c.layers) by_name[layer].push_back(c.shape);
        by_name["net " + c.net].push_back(c.shape);
        by_name[kind == &board_.vias ? "vias" : "tracks"].push_back(c.shape);
      }
    }
    for (const Copper& zone : board_.zones) by_name["zone " + zone.net].push_back(zone.shape);
    for (auto& [name, shapes] : by_name) add_list(name, std::move(shapes));
  }

  /// A group as the list of its parts that stand still, or the union that moves; then the keep-outs by their names.
  void add_groups() {
    for (const PartGroup& group : groups_) {
      const bool is_body = std::find(question_.move.begin(), question_.move.end(), group.name) != question_.move.end();
      if (question_.place && is_body) continue;  // its name is that of a body
      const auto among = [&](const Part& p) {
        return std::find(group.parts.begin(), group.parts.end(), p.name) != group.parts.end();
      };
      const bool whole = std::all_of(group.parts.begin(), group.parts.end(),
                                     [&](const std::string& p) { return movers_.count(board_.find(p)) > 0; });
      if (question_.place || !whole)
        add_parts(group.name, among);
      else
        add_moving(group);
    }
    for (const ShapePtr& k : keep_outs_) add_list(k->name, {k});
  }

  void add_moving(const PartGroup& group) {
    if (names_.count(group.name) > 0) return;
    std::vector<ShapePtr> shapes;
    for (const std::string& name : group.parts)
      shapes.push_back(named(at_origin(board_.find(name)->body, anchor_), name));
    scene_.groups[group.name] = group.parts;
    add(group.name, list_of(std::move(shapes), group.name));
    scene_.moving.push_back(group.name);
  }

  const Board& board_;
  const BoardQuestion& question_;
  Scene scene_;
  std::vector<PartGroup> groups_;
  std::vector<ShapePtr> keep_outs_;
  std::set<const Part*> fixed_;
  std::map<const Part*, plane::GridPoint> movers_;  // and where what moves with them has its anchor
  std::set<std::string> names_;
  plane::GridPoint anchor_;
  Sides sides_;
};

}  // namespace

Scene board_scene(std::shared_ptr<const Board> board, const BoardQuestion& question) {
  return SceneMaker(std::move(board), question).run();
}

}  // namespace findspace::io
