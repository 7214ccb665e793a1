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
  SceneMaker(const Board& board, const BoardQuestion& question) : board_(board), question_(question) {}

  Scene run() {
    scene_.file = board_.file;
    scene_.unit = Unit::kMillimetre;
    scene_.notes = board_.notes;
    scene_.y_down = scene_.named_only = true;
    find_movers();
    add("board", board_.outline);
    for (const Part& part : board_.parts) add_part(part);
    add_lists();
    add_copper();
    if (question_.place) {
      add_placement();
      return std::move(scene_);
    }
    scene_.where = formula(question_.where, "--where");
    scene_.minimize = formula(question_.minimize, "--minimize");
    scene_.maximize = formula(question_.maximize, "--maximize");
    if (!question_.angles.empty()) {
      scene_.free.kind = Free::Kind::kPose;
      for (const exact::Real& a : question_.angles) scene_.free.angles.push_back(-a);
    }
    return std::move(scene_);
  }

 private:
  static FormulaText formula(const std::string& text, const char* option) {
    return text.empty() ? FormulaText{} : FormulaText{text, option, 1, 1};
  }

  void find_movers() {
    std::vector<std::string> names;
    for (const Part& part : board_.parts)
      if (part.body) names.push_back(part.name);
    for (const std::string& name : question_.move) {
      const Part* part = board_.find(name);
      if (part == nullptr || !part->body)
        throw Error(ErrorCode::kUnknownName, fmt::format("there is no part '{}'{}", name, choice("parts", name, names)),
                    board_.file);
      movers_.insert(part);
      if (scene_.moving_name.empty()) anchor_ = part->at;
      scene_.moving_name += (scene_.moving_name.empty() ? "" : ", ") + name;
      sides_.front = sides_.front || part->courtyard.front;
      sides_.back = sides_.back || part->courtyard.back;
      if (part->unlike)
        scene_.notes.push_back(
            fmt::format("{}: its courtyards on the two sides differ; their union is taken on both", name));
    }
    scene_.drawn_at = {anchor_.x, anchor_.y, 0};
  }

  /// One part after another, each at a point of the grid; pads move along where a formula names them.
  void add_placement() {
    Placement& place = scene_.place;
    for (const std::string& name : question_.move) {
      const Part& part = *board_.find(name);
      if (part.locked) throw Error(ErrorCode::kBadValue, fmt::format("the part '{}' is locked", name), board_.file);
      PlacedBody body{name, {name}, {}, 1};
      for (const std::string& pad : scene_.moving)
        if (pad.rfind(name + ".", 0) == 0 && is_mentioned(pad)) body.shapes.push_back(pad);
      for (const exact::Real& a : question_.angles) body.angles.push_back(-a);
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
    const bool moves = movers_.count(&part) > 0;
    const auto put = [&](const std::string& name, const ShapePtr& shape) {
      add(name, moves ? at_origin(shape, question_.place ? part.at : anchor_) : shape);
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
    std::vector<ShapePtr> keep_outs, here;
    for (const KeepOut& k : board_.keep_outs) {
      keep_outs.push_back(named(k.area, k.name));
      if (k.sides.meet(sides_)) here.push_back(keep_outs.back());
    }
    std::vector<ShapePtr> others = fixed([&](const Part& p) { return p.courtyard.meet(sides_); });
    for (const ShapePtr& part : others) scene_.all_shapes.push_back(part->name);
    others.insert(others.end(), here.begin(), here.end());
    add_list("others", std::move(others));
    add_parts("parts", [](const Part&) { return true; });
    add_parts("smd", [](const Part& p) { return p.smd; });
    add_parts("tht", [](const Part& p) { return p.through; });
    add_parts("front", [](const Part& p) { return p.mounted.front; });
    add_parts("back", [](const Part& p) { return p.mounted.back; });
    add_parts("locked", [](const Part& p) { return p.locked; });
    add_list("keepouts", std::move(keep_outs));
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

  const Board& board_;
  const BoardQuestion& question_;
  Scene scene_;
  std::set<const Part*> movers_;
  std::set<std::string> names_;
  plane::GridPoint anchor_;
  Sides sides_;
};

}  // namespace

Scene board_scene(std::shared_ptr<const Board> board, const BoardQuestion& question) {
  Scene scene = SceneMaker(*board, question).run();
  scene.board = std::move(board);
  return scene;
}

}  // namespace findspace::io
