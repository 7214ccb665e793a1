// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/read_nesting.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

#include "io/nesting/nesting_json.h"
#include "io/nesting/unread_keys.h"
#include "io/scene/scene_curves.h"
#include "io/scene/scene_shapes.h"
#include "plane/build/build.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using packing::Fraction;
using Kind = JsonValue::Kind;

constexpr int kUsualShapeDigits = 6, kMostShapeDigits = 9;  // of the grid of shapes

class Reader : private NestingJson {
 public:
  using NestingJson::NestingJson;

  UnscaledProblem problem(const NestingOptions& asked) const {
    UnscaledProblem result;
    if (const JsonValue* named = tree().find("name")) result.name = named->text;
    if (tree().find("findspace") != nullptr && tree().find("items") == nullptr)
      fail(tree(),
           "this is a scene: pack takes a nesting problem, with 'items' and 'strip_height' or 'sheets' "
           "(docs/nesting.md); few shapes of a scene are placed by 'findspace place'");
    if (tree().find("item-types") != nullptr && tree().find("items") == nullptr)
      fail(tree(), "this is a packing problem in space: only pack and verify take it (docs/nesting.md)");
    const JsonValue& items = list(need(tree(), "items"));
    result.notes = unread_keys(*this);
    for (const JsonValue& item : items.items) {
      result.parts.push_back(part(item));
      check_name(item, result.parts, "items");
    }
    if (const JsonValue* sheets = tree().find("sheets"); sheets != nullptr && !asked.height)
      for (const JsonValue& value : list(*sheets).items) {
        result.sheets.push_back(sheet(value, result.parts));
        check_name(value, result.sheets, "sheets");
      }
    if (!asked.height) check_container();
    read_shapes(asked, result);
    check_costs(result);
    if (const JsonValue* box = tree().find("box")) result.box = truth(*box) && result.sheets.empty() && !asked.height;
    if (result.sheets.empty() && !result.box)
      result.height = asked.height ? *asked.height : number(need(tree(), "strip_height"));
    result.gap = asked.gap;
    result.edge = asked.edge;
    read_conditions(*this, names_of(result.parts), 2, result);
    if (const JsonValue* fixed = tree().find("fixed"))
      for (const JsonValue& item : list(*fixed).items) result.fixed.push_back(fixed_part(item, result));
    return result;
  }

  packing::Layout layout(const packing::Problem& problem) const {
    const JsonValue& body = need(tree(), "layout");
    packing::Layout result;
    result.length = number(need(body, "length"));
    for (const JsonValue& item : list(need(body, "items")).items) {
      result.items.push_back(placed(item, problem.parts));
      if (const JsonValue* sheet = item.find("sheet")) result.items.back().sheet = std::size_t(whole(*sheet));
    }
    if (problem.box) result.height = number(need(need(body, "container"), "box"));
    if (problem.on_sheets())
      for (const JsonValue& sheet : list(need(need(body, "container"), "sheets")).items)
        result.sheets.push_back(index_of(sheet, problem.sheets, "sheet"));
    if (const JsonValue* left = body.find("left_out")) result.left_out = left_out(*left, problem.parts);
    return result;
  }

 private:
  UnscaledRing ring(const JsonValue& points) const {
    UnscaledRing result;
    for (const JsonValue& p : list(points).items) {
      if (list(p).size() != 2) fail(p, "a point is a list of two numbers");
      result.push_back({number(p.items[0]), number(p.items[1])});
    }
    return result;
  }

  std::vector<UnscaledRing> shape(const JsonValue& value) const {
    const JsonValue &type = need(value, "type"), &data = need(value, "data");
    std::vector<UnscaledRing> rings;
    if (type.text == "simple_polygon") {
      rings.push_back(ring(data));
    } else if (type.text == "polygon") {
      rings.push_back(ring(need(data, "outer")));
      if (const JsonValue* inner = data.find("inner"))
        for (const JsonValue& hole : list(*inner).items) rings.push_back(ring(hole));
    } else {
      fail(type, "\"type\" is simple_polygon or polygon; other shapes are written as in a scene, without it");
    }
    return rings;
  }

  static bool is_polygon(const JsonValue& shape) { return shape.is(Kind::kObject) && shape.find("type") != nullptr; }

  /// A shape of the scene language, and whose it is.
  struct Stated {
    const JsonValue* value;
    Label label;
    std::optional<UnscaledShape>* to;
  };

  std::vector<Stated> stated_shapes(UnscaledProblem& problem) const {
    std::vector<Stated> result;
    const auto see = [&](const JsonValue& owner, const char* kind, const std::string& name, auto& to) {
      const JsonValue* value = owner.find("shape");
      if (value != nullptr && !is_polygon(*value)) result.push_back({value, Label{nullptr, kind, name}, &to.shape});
    };
    const JsonValue &items = need(tree(), "items"), *sheets = tree().find("sheets");
    for (std::size_t k = 0; k < problem.parts.size(); ++k)
      see(items.items[k], "item", problem.parts[k].name, problem.parts[k]);
    for (std::size_t k = 0; k < problem.sheets.size(); ++k) {
      UnscaledSheet& sheet = problem.sheets[k];
      see(sheets->items[k], "sheet", sheet.name, sheet);
      for (std::size_t z = 0; z < sheet.zones.size(); ++z)
        see(sheets->items[k].find("zones")->items[z], "zone of sheet", sheet.name, sheet.zones[z]);
    }
    return result;
  }

  /// By name or as they are, on a grid that holds their numbers.
  void read_shapes(const NestingOptions& asked, UnscaledProblem& problem) const {
    const std::vector<Stated> stated = stated_shapes(problem);
    if (stated.empty()) return;
    const packing::int128 steps = packing::power_of_ten(digits_of_shapes(stated));
    ReadContext context(asked.read);
    context.folder = asked.folder.empty() ? std::filesystem::path(name()).parent_path() : asked.folder;
    context.grid = Grid(exact::Real(1) / exact::Real(steps));
    const SceneReader json(name(), context);
    read_rules(json);
    JsonValue none;
    none.kind = Kind::kObject;
    const JsonValue* named = tree().find("shapes");
    ShapeReader shapes(json, named != nullptr ? *named : none);
    for (const Stated& one : stated) {
      const plane::ShapePtr shape = shapes.shape(*one.value, one.label);
      if (shapes.dimension() == 3)
        fail(*one.value, fmt::format("this is a shape of space: {} needs one of the plane", one.label.text()));
      plane::BuildResult built = json.placed(
          one.label, *one.value, [&] { return plane::build(*shape, context.grid.step_size(), asked.read.work_limit); });
      *one.to = UnscaledShape{plane::closure(std::move(built.region)), Fraction(1, steps)};
      context.rounding.points += built.rounding.points;
      context.rounding.largest = std::max(context.rounding.largest, built.rounding.largest);
    }
    for (std::string& note : context.summary()) problem.notes.push_back(std::move(note));
  }

  int digits_of_shapes(const std::vector<Stated>& stated) const {
    const JsonValue* named = tree().find("shapes");
    int digits = std::max(kUsualShapeDigits, named != nullptr ? digits_in(*named, kMostShapeDigits) : 0);
    for (const Stated& one : stated) digits = std::max(digits, digits_in(*one.value, kMostShapeDigits));
    return digits;
  }

  /// The unit, and how drawings are read, as scenes say it.
  void read_rules(const SceneReader& json) const {
    ReadContext& context = json.context();
    if (const JsonValue* unit = tree().find("unit"))
      context.unit = json.placed({}, *unit, [&] { return parse_unit(unit->text); });
    context.scene_rules = read_drawing_rules(json, tree(), {});
    if (!context.scene_rules.one_part) context.scene_rules.one_part = true;  // a part is a drawing
    json.placed({}, tree(), [&] { context.use(context.options.drawings.over(context.scene_rules)); });
  }

  UnscaledSheet sheet(const JsonValue& value, const std::vector<UnscaledPart>& parts) const {
    UnscaledSheet result;
    result.name = need(value, "id").text;
    if (const JsonValue* count = value.find("count")) result.count = whole(*count);
    if (const JsonValue* cost = value.find("cost")) {
      result.cost = number(*cost);
      if (*result.cost < 0) fail(*cost, "a cost below 0");
    }
    if (const JsonValue* outline = value.find("shape")) {
      if (is_polygon(*outline)) result.rings = shape(*outline);
    } else {
      const Fraction w = number(need(value, "width")), h = number(need(value, "height"));
      if (w <= 0 || h <= 0) fail(value, "a sheet has a width and a height above 0");
      result.rings = {{{0, 0}, {w, 0}, {w, h}, {0, h}}};
    }
    if (const JsonValue* zones = value.find("zones"))
      for (const JsonValue& item : list(*zones).items) result.zones.push_back(zone(item, parts));
    return result;
  }

  /// Zones keep out the parts named, or all but those named; or they hold those named.
  UnscaledZone zone(const JsonValue& value, const std::vector<UnscaledPart>& parts) const {
    UnscaledZone result;
    if (const JsonValue& outline = need(value, "shape"); is_polygon(outline)) result.rings = shape(outline);
    const JsonValue *only = value.find("only"), *kept_out = value.find("keeps_out"), *held = value.find("holds");
    if ((only != nullptr) + (kept_out != nullptr) + (held != nullptr) != 1)
      fail(value, "a zone has one of 'keeps_out', 'only' and 'holds': names of parts");
    result.holds = held != nullptr;
    std::vector<std::size_t> named;
    for (const JsonValue& name : list(only != nullptr ? *only : kept_out != nullptr ? *kept_out : *held).items)
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
    if (has_sheets && std::all_of(sheets->items.begin(), sheets->items.end(), is_none))
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
    result.name = need(item, "id").text;
    result.demand = whole(need(item, "demand"));
    if (const JsonValue* angles = item.find("allowed_orientations"); angles != nullptr && !angles->is(Kind::kNull))
      for (const JsonValue& angle : list(*angles).items) result.angles.push_back(number(angle));
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
    result.x = number(at.items[0]);
    result.y = number(at.items[1]);
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
