// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/read_nesting.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "io/nesting/nesting_json.h"
#include "io/nesting/unread_keys.h"
#include "io/scene/scene_curves.h"
#include "io/scene/scene_shapes.h"
#include "io/text/drawing_rules.h"
#include "io/text/quantity.h"
#include "plane/build/build.h"
#include "plane/contour/alike.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using packing::Fraction;
using Kind = JsonValue::Kind;

constexpr int kUsualShapeDigits = 6, kMostShapeDigits = 9;  // of the grid of shapes

bool is_polygon(const JsonValue& shape) { return shape.is(Kind::kObject) && shape.find("type") != nullptr; }

/// Shapes of the scene language in a problem, by name or as they are, on a grid that holds the numbers of all of them.
class StatedShapes {
 public:
  StatedShapes(const NestingJson& problem, const NestingOptions& asked)
      : problem_(problem), step_(1, packing::power_of_ten(digits())), context_(asked.read) {
    context_.folder = asked.folder.empty() ? std::filesystem::path(problem.name()).parent_path() : asked.folder;
    context_.grid = Grid(exact::Real(1) / exact::Real(packing::power_of_ten(digits())));
    context_.quantities = true;
    if (const JsonValue* unit = problem.tree().find("unit"))
      context_.unit = json_.placed({}, *unit, [&] { return parse_unit(unit->text()); });
    context_.scene_rules = read_drawing_rules(json_, problem.tree(), {});
    json_.placed({}, problem.tree(), [&] { context_.use(context_.options.drawings.over(context_.scene_rules)); });
  }

  plane::ShapePtr read(const JsonValue& value, const Label& label) {
    plane::ShapePtr shape = shapes_.shape(value, label);
    if (shapes_.dimension() == 3)
      problem_.fail(value, fmt::format("this is a shape of space: {} needs one of the plane", label.text()));
    return shape;
  }

  UnscaledShape built(const plane::ShapePtr& shape, const JsonValue& value, const Label& label) {
    plane::BuildResult built = json_.placed(
        label, value, [&] { return plane::build(*shape, context_.grid.step_size(), context_.options.work_limit); });
    context_.rounding.points += built.rounding.points;
    context_.rounding.largest = std::max(context_.rounding.largest, built.rounding.largest);
    return {plane::closure(std::move(built.region)), step_};
  }

  /// The outlines of a drawing that are parts each, where that is asked for or their names say how many. A drawing of
  /// one outline is one part, called as the drawing.
  std::optional<std::vector<plane::ShapePtr>> parts_in(const plane::ShapePtr& shape, const JsonValue& value,
                                                       const Label& label) {
    if (!is_file(value)) return std::nullopt;
    const bool called = value.is(Kind::kString);  // so the shape's name is the problem's, not the drawing's
    if (called && !shape->collection) return std::nullopt;
    const std::vector<plane::ShapePtr> all = shape->collection ? shape->children : std::vector{shape};
    const auto counted = [](const plane::ShapePtr& one) { return quantity_in(one->name).has_value(); };
    const std::optional<PartRule> rule = part_rule(value, label);
    const bool any_counted = std::any_of(all.begin(), all.end(), counted);
    const bool apart = rule ? *rule == PartRule::kOutlines && (all.size() > 1 || any_counted) : any_counted;
    if (!rule && !apart && all.size() > 1)
      context_.notes.push_back(
          fmt::format("{}: its {} outlines side by side are one part (\"parts\": \"outlines\": each is one)",
                      label.text(), all.size()));
    return apart ? std::optional(all) : std::nullopt;
  }

  void add_notes(std::vector<std::string>& notes) const {
    for (std::string& note : context_.summary()) notes.push_back(std::move(note));
  }

 private:
  int digits() const {
    int most = kUsualShapeDigits;
    const auto see = [&](const JsonValue* value) {
      if (value != nullptr && !is_polygon(*value)) most = std::max(most, problem_.digits_in(*value, kMostShapeDigits));
    };
    see(problem_.tree().find("shapes"));
    for (const JsonValue& item : problem_.need(problem_.tree(), "items").items()) see(item.find("shape"));
    const JsonValue* sheets = problem_.tree().find("sheets");
    if (sheets == nullptr) return most;
    for (const JsonValue& sheet : sheets->items()) {
      see(sheet.find("shape"));
      if (const JsonValue* zones = sheet.find("zones"))
        for (const JsonValue& zone : zones->items()) see(zone.find("shape"));
    }
    return most;
  }

  /// Of a shape by its name.
  const JsonValue& stated(const JsonValue& value) const {
    const JsonValue* shapes = problem_.tree().find("shapes");
    const JsonValue* named = value.is(Kind::kString) && shapes != nullptr ? shapes->find(value.text()) : nullptr;
    return named != nullptr ? *named : value;
  }
  bool is_file(const JsonValue& value) const {
    return stated(value).is(Kind::kObject) && stated(value).find("file") != nullptr;
  }
  std::optional<PartRule> part_rule(const JsonValue& value, const Label& label) const {
    const DrawingRules own = read_drawing_rules(json_, stated(value), label);
    return context_.options.drawings.over(own.over(context_.scene_rules)).parts;
  }

  const NestingJson& problem_;
  Fraction step_;
  ReadContext context_;
  SceneReader json_{problem_.name(), context_};
  JsonValue none_{Kind::kObject};
  ShapeReader shapes_{json_, problem_.tree().find("shapes") != nullptr ? *problem_.tree().find("shapes") : none_};
};

class Reader : private NestingJson {
 public:
  using NestingJson::NestingJson;

  UnscaledProblem problem(const NestingOptions& asked) const {
    UnscaledProblem result;
    if (const JsonValue* named = tree().find("name")) result.name = named->text();
    if (tree().find("findspace") != nullptr && tree().find("items") == nullptr)
      fail(tree(),
           "this is a scene: pack takes a nesting problem, with 'items' and 'strip_height' or 'sheets' "
           "(docs/nesting.md); few shapes of a scene are placed by 'findspace place'");
    if (tree().find("item-types") != nullptr && tree().find("items") == nullptr)
      fail(tree(), tree().find("container") == nullptr && tree().find("containers") == nullptr
                       ? "a packing problem in space needs a 'container' or 'containers' (docs/nesting.md)"
                       : "this is a packing problem in space: only pack and verify take it (docs/nesting.md)");
    const JsonValue& items = list(need(tree(), "items"));
    result.notes = unread_keys(*this);
    StatedShapes shapes(*this, asked);
    for (const JsonValue& item : items.items()) {
      for (UnscaledPart& one : parts_of(item, shapes)) {
        result.parts.push_back(std::move(one));
        check_name(item, result.parts, "items");
      }
    }
    if (const JsonValue* sheets = tree().find("sheets"); sheets != nullptr && !asked.height)
      for (const JsonValue& value : list(*sheets).items()) {
        result.sheets.push_back(sheet(value, result.parts, shapes));
        check_name(value, result.sheets, "sheets");
      }
    if (!asked.height) check_container();
    shapes.add_notes(result.notes);
    check_costs(result);
    if (const JsonValue* box = tree().find("box")) result.box = truth(*box) && result.sheets.empty() && !asked.height;
    if (result.sheets.empty() && !result.box)
      result.height = asked.height ? *asked.height : number(need(tree(), "strip_height"));
    result.gap = asked.gap;
    result.edge = asked.edge;
    read_conditions(*this, names_of(result.parts), 2, result);
    if (const JsonValue* fixed = tree().find("fixed"))
      for (const JsonValue& item : list(*fixed).items()) result.fixed.push_back(fixed_part(item, result));
    return result;
  }

  packing::Layout layout(const packing::Problem& problem) const {
    const JsonValue& body = need(tree(), "layout");
    packing::Layout result;
    result.length = number(need(body, "length"));
    for (const JsonValue& item : list(need(body, "items")).items()) {
      result.items.push_back(placed(item, problem.parts));
      if (const JsonValue* sheet = item.find("sheet")) result.items.back().sheet = std::size_t(whole(*sheet));
    }
    if (problem.box) result.height = number(need(need(body, "container"), "box"));
    if (problem.on_sheets())
      for (const JsonValue& sheet : list(need(need(body, "container"), "sheets")).items())
        result.sheets.push_back(index_of(sheet, problem.sheets, "sheet"));
    if (const JsonValue* left = body.find("left_out")) result.left_out = left_out(*left, problem.parts);
    return result;
  }

 private:
  UnscaledRing ring(const JsonValue& points) const {
    UnscaledRing result;
    for (const JsonValue& p : list(points).items()) {
      if (list(p).size() != 2) fail(p, "a point is a list of two numbers");
      result.push_back({number(p.items()[0]), number(p.items()[1])});
    }
    return result;
  }

  std::vector<UnscaledRing> shape(const JsonValue& value) const {
    const JsonValue &type = need(value, "type"), &data = need(value, "data");
    std::vector<UnscaledRing> rings;
    if (type.text() == "simple_polygon") {
      rings.push_back(ring(data));
    } else if (type.text() == "polygon") {
      rings.push_back(ring(need(data, "outer")));
      if (const JsonValue* inner = data.find("inner"))
        for (const JsonValue& hole : list(*inner).items()) rings.push_back(ring(hole));
    } else {
      fail(type, "\"type\" is simple_polygon or polygon; other shapes are written as in a scene, without it");
    }
    return rings;
  }

  /// The parts of an item: one, or of a drawing those that it holds.
  std::vector<UnscaledPart> parts_of(const JsonValue& item, StatedShapes& shapes) const {
    const UnscaledPart whole = part(item);
    const JsonValue& outline = need(item, "shape");
    if (is_polygon(outline)) return {whole};
    const Label label{nullptr, "item", whole.name};
    const plane::ShapePtr shape = shapes.read(outline, label);
    if (const auto outlines = shapes.parts_in(shape, outline, label))
      return parts_of(item, whole, counted(item, whole, *outlines), shapes, label);
    std::vector<UnscaledPart> result{whole};
    result[0].shape = shapes.built(shape, outline, label);
    return result;
  }

  /// An outline, and how many of it are asked for.
  struct Counted {
    plane::ShapePtr outline;
    std::string name;
    std::int64_t demand;
  };

  std::vector<UnscaledPart> parts_of(const JsonValue& item, const UnscaledPart& whole,
                                     const std::vector<Counted>& outlines, StatedShapes& shapes,
                                     const Label& label) const {
    std::vector<UnscaledPart> result;
    for (const Counted& one : outlines) {
      UnscaledPart& part = result.emplace_back(whole);
      part.shape = shapes.built(one.outline, need(item, "shape"), label);
      part.name = one.name;
      part.demand = int(one.demand);
    }
    name_apart(whole.name, result);
    return result;
  }

  /// Outlines of one name that are alike are one part.
  std::vector<Counted> counted(const JsonValue& item, const UnscaledPart& whole,
                               const std::vector<plane::ShapePtr>& outlines) const {
    constexpr std::int64_t kMost = 1000000;
    const std::vector<std::size_t> first = plane::first_alike(outlines);
    std::map<std::pair<std::size_t, std::string>, std::size_t> known;
    std::vector<Counted> result;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      const Quantity quantity = quantity_in(outlines[k]->name).value_or(Quantity{outlines[k]->name, 1});
      const auto [at, is_new] = known.try_emplace({first[k], quantity.name}, result.size());
      if (is_new) result.push_back({outlines[k], quantity.name, 0});
      Counted& one = result[at->second];
      one.demand += std::int64_t{whole.demand} * quantity.count;
      if (one.demand > kMost) fail(item, fmt::format("its counts together are above {}", kMost));
    }
    return result;
  }

  /// Parts without a name are called as their drawing; of equal names each gets a number.
  static void name_apart(const std::string& drawing, std::vector<UnscaledPart>& parts) {
    std::map<std::string, int> all, seen;
    for (UnscaledPart& one : parts) {
      if (one.name.empty()) one.name = drawing;
      ++all[one.name];
    }
    for (UnscaledPart& one : parts)
      if (all[one.name] > 1) one.name = fmt::format("{} {}", one.name, ++seen[one.name]);
  }

  UnscaledSheet sheet(const JsonValue& value, const std::vector<UnscaledPart>& parts, StatedShapes& shapes) const {
    UnscaledSheet result;
    result.name = need(value, "id").text();
    if (const JsonValue* count = value.find("count")) result.count = whole(*count);
    if (const JsonValue* cost = value.find("cost")) {
      result.cost = number(*cost);
      if (*result.cost < 0) fail(*cost, "a cost below 0");
    }
    if (const JsonValue* outline = value.find("shape")) {
      read_outline(*outline, {nullptr, "sheet", result.name}, shapes, result);
    } else {
      const Fraction w = number(need(value, "width")), h = number(need(value, "height"));
      if (w <= 0 || h <= 0) fail(value, "a sheet has a width and a height above 0");
      result.rings = {{{0, 0}, {w, 0}, {w, h}, {0, h}}};
    }
    if (const JsonValue* zones = value.find("zones"))
      for (const JsonValue& item : list(*zones).items()) {
        result.zones.push_back(zone(item, parts));
        read_outline(need(item, "shape"), {nullptr, "zone of sheet", result.name}, shapes, result.zones.back());
      }
    return result;
  }

  /// A polygon, or any shape of the scene language.
  template <class Owner>
  void read_outline(const JsonValue& outline, const Label& label, StatedShapes& shapes, Owner& owner) const {
    if (is_polygon(outline)) {
      owner.rings = shape(outline);
    } else {
      owner.shape = shapes.built(shapes.read(outline, label), outline, label);
    }
  }

  /// Zones keep out the parts named, or all but those named; or they hold those named.
  UnscaledZone zone(const JsonValue& value, const std::vector<UnscaledPart>& parts) const {
    UnscaledZone result;
    const JsonValue *only = value.find("only"), *kept_out = value.find("keeps_out"), *held = value.find("holds");
    if ((only != nullptr) + (kept_out != nullptr) + (held != nullptr) != 1)
      fail(value, "a zone has one of 'keeps_out', 'only' and 'holds': names of parts");
    result.holds = held != nullptr;
    std::vector<std::size_t> named;
    for (const JsonValue& name : list(only != nullptr ? *only : kept_out != nullptr ? *kept_out : *held).items())
      named.push_back(index_of(name, parts, "part"));
    for (std::size_t part = 0; part < parts.size(); ++part)
      if ((std::count(named.begin(), named.end(), part) > 0) == (only == nullptr)) result.parts.push_back(part);
    return result;
  }

  /// "sheet" names a kind, "number" counts its sheets from 1.
  packing::FixedPart fixed_part(const JsonValue& value, const UnscaledProblem& problem) const {
    packing::FixedPart result{placed(value, problem.parts), 0};
    if (problem.sheets.empty()) {
      for (const char* key : {"sheet", "number"})
        if (const JsonValue* said = value.find(key)) fail(*said, "a sheet is said, but there are no sheets");
      return result;
    }
    result.kind = index_of(need(value, "sheet"), problem.sheets, "sheet");
    const JsonValue* counted = value.find("number");
    const int count = counted != nullptr ? whole(*counted) : 1;
    if (count < 1 || count > problem.sheets[result.kind].count)
      fail(value, fmt::format("there is no sheet {} number {}", problem.sheets[result.kind].name, count));
    result.placed.sheet = std::size_t(count - 1);
    return result;
  }

  /// What the parts are packed into is said once, and holds something.
  void check_container() const {
    const JsonValue *strip = tree().find("strip_height"), *sheets = tree().find("sheets"), *box = tree().find("box");
    const bool has_strip = strip != nullptr && !strip->is(Kind::kNull), has_box = box != nullptr && truth(*box);
    const bool has_sheets = sheets != nullptr && list(*sheets).size() > 0;
    if (has_strip + has_sheets + has_box > 1)
      fail(has_sheets ? *sheets : *box, "a problem has one of 'strip_height', 'sheets' and 'box'");
    const auto is_none = [&](const JsonValue& sheet) {
      const JsonValue* count = sheet.find("count");
      return count != nullptr && whole(*count) == 0;
    };
    if (has_sheets && std::all_of(sheets->items().begin(), sheets->items().end(), is_none))
      fail(*sheets, "every sheet has a count of 0");
  }

  void check_costs(const UnscaledProblem& problem) const {
    const auto has_cost = [](const UnscaledSheet& sheet) { return sheet.cost.has_value(); };
    const auto count = std::count_if(problem.sheets.begin(), problem.sheets.end(), has_cost);
    if (count != 0 && std::size_t(count) != problem.sheets.size())
      throw Error(ErrorCode::kBadValue, "some sheets have a cost and others none", name());
  }

  UnscaledPart part(const JsonValue& item) const {
    UnscaledPart result;
    result.name = need(item, "id").text();
    result.demand = whole(need(item, "demand"));
    if (const JsonValue* angles = item.find("allowed_orientations"); angles != nullptr && !angles->is(Kind::kNull))
      for (const JsonValue& angle : list(*angles).items()) result.angles.push_back(number(angle));
    if (result.angles.empty()) result.angles.push_back(0);
    if (const JsonValue* mirrored = item.find("mirrored")) result.mirrored = truth(*mirrored);
    if (const JsonValue* tilt = item.find("tilt")) {
      result.tilt = number(*tilt);
      if (result.tilt < 0 || result.tilt > 180) fail(*tilt, "a tilt is from 0 to 180 degrees");
    }
    if (const JsonValue* value = item.find("value")) {
      result.value = number(*value);
      if (*result.value < 0) fail(*value, "a value below 0");
    }
    if (const JsonValue& outline = need(item, "shape"); is_polygon(outline)) result.rings = shape(outline);
    return result;
  }

  /// Without the sheet.
  template <class Named>
  packing::Placed placed(const JsonValue& item, const std::vector<Named>& parts) const {
    packing::Placed result;
    result.part = index_of(need(item, "part"), parts, "part");
    if (const JsonValue* copy = item.find("copy")) result.copy = whole(*copy);
    if (const JsonValue* angle = item.find("angle")) result.angle = number(*angle);
    if (const JsonValue* mirrored = item.find("mirrored")) result.mirrored = truth(*mirrored);
    const JsonValue& at = list(need(item, "at"));
    if (at.size() != 2) fail(at, "a position is a list of two numbers");
    result.x = number(at.items()[0]);
    result.y = number(at.items()[1]);
    return result;
  }
};

}  // namespace

packing::Problem read_nesting(const std::string& text, const std::string& name, const NestingOptions& asked) {
  return read_unscaled(text, name, asked).on_grid(name);
}

UnscaledProblem read_unscaled(const std::string& text, const std::string& name, const NestingOptions& asked) {
  return Reader(text, name).problem(asked);
}

packing::Layout read_layout(const std::string& text, const std::string& name, const packing::Problem& problem) {
  return Reader(text, name).layout(problem);
}

}  // namespace findspace::io
