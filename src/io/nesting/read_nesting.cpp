// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/read_nesting.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>

#include "io/nesting/unscaled_problem.h"
#include "io/text/json_tree.h"
#include "plane/base/work_budget.h"

namespace findspace::io {
namespace {

using packing::Fraction;
using Kind = JsonValue::Kind;

class Reader {
 public:
  Reader(const std::string& text, std::string name) : name_(std::move(name)), tree_(parse_json(text, name_, work_)) {}

  packing::Problem problem(const NestingWishes& wishes) const {
    UnscaledProblem result;
    if (const JsonValue* named = tree_.find("name")) result.name = named->text;
    result.height = wishes.height ? *wishes.height : number(need(tree_, "strip_height"));
    result.gap = wishes.gap;
    result.edge = wishes.edge;
    const JsonValue& items = list(need(tree_, "items"));
    for (const JsonValue& item : items.items) result.parts.push_back(part(item));
    return std::move(result).on_grid(name_);
  }

  packing::Layout layout(const packing::Problem& problem) const {
    const JsonValue& body = need(tree_, "layout");
    packing::Layout result;
    result.length = number(need(body, "length"));
    for (const JsonValue& item : list(need(body, "items")).items) result.items.push_back(placed(item, problem));
    const JsonValue* left = body.find("left_out");
    if (left == nullptr) return result;
    for (const JsonValue& out : list(*left).items)
      result.left_out.push_back(
          {part_index(need(out, "part"), problem), whole(need(out, "copies")), need(out, "why").text});
    return result;
  }

 private:
  [[noreturn]] void fail(const JsonValue& at, const std::string& what) const {
    throw Error(ErrorCode::kSyntax, what, fmt::format("{}:{}:{}", name_, at.line, at.column));
  }
  const JsonValue& need(const JsonValue& object, const char* key) const {
    if (!object.is(Kind::kObject)) fail(object, fmt::format("an object with '{}' is meant", key));
    const JsonValue* value = object.find(key);
    if (value == nullptr) fail(object, fmt::format("'{}' is missing", key));
    return *value;
  }
  const JsonValue& list(const JsonValue& value) const {
    if (!value.is(Kind::kArray)) fail(value, fmt::format("a list is meant, not {}", value.kind_name()));
    return value;
  }
  Fraction number(const JsonValue& value) const {
    if (!value.is(Kind::kNumber) && !value.is(Kind::kString))
      fail(value, fmt::format("a number is meant, not {}", value.kind_name()));
    return Fraction::parse(value.text);
  }
  int whole(const JsonValue& value) const {
    const Fraction n = number(value);
    if (n.denominator() != 1 || n < 0 || n > 1000000) fail(value, "a whole number from 0 to 1000000 is meant");
    return int(n.numerator());
  }

  UnscaledRing ring(const JsonValue& points) const {
    UnscaledRing result;
    for (const JsonValue& p : list(points).items) {
      if (list(p).size() != 2) fail(p, "a point is a list of two numbers");
      result.push_back({number(p.items[0]), number(p.items[1])});
    }
    return result;
  }

  UnscaledPart part(const JsonValue& item) const {
    UnscaledPart result;
    result.name = need(item, "id").text;
    result.demand = whole(need(item, "demand"));
    if (const JsonValue* angles = item.find("allowed_orientations"); angles != nullptr && angles->is(Kind::kArray))
      for (const JsonValue& angle : angles->items) result.angles.push_back(number(angle));
    if (result.angles.empty()) result.angles.push_back(0);
    const JsonValue &shape = need(item, "shape"), &type = need(shape, "type"), &data = need(shape, "data");
    if (type.text == "simple_polygon") {
      result.rings.push_back(ring(data));
    } else if (type.text == "polygon") {
      result.rings.push_back(ring(need(data, "outer")));
      if (const JsonValue* inner = data.find("inner"))
        for (const JsonValue& hole : list(*inner).items) result.rings.push_back(ring(hole));
    } else {
      fail(type, "a shape is a simple_polygon or a polygon");
    }
    return result;
  }

  std::size_t part_index(const JsonValue& name, const packing::Problem& problem) const {
    const auto same = [&](const packing::Part& part) { return part.name == name.text; };
    const auto found = std::find_if(problem.parts.begin(), problem.parts.end(), same);
    if (found == problem.parts.end()) fail(name, fmt::format("there is no part '{}'", name.text));
    return std::size_t(found - problem.parts.begin());
  }

  packing::Placed placed(const JsonValue& item, const packing::Problem& problem) const {
    packing::Placed result;
    result.part = part_index(need(item, "part"), problem);
    if (const JsonValue* copy = item.find("copy")) result.copy = whole(*copy);
    if (const JsonValue* angle = item.find("angle")) result.angle = number(*angle);
    if (const JsonValue* mirrored = item.find("mirrored")) result.mirrored = mirrored->boolean;
    const JsonValue& at = list(need(item, "at"));
    if (at.size() != 2) fail(at, "a position is a list of two numbers");
    result.x = number(at.items[0]);
    result.y = number(at.items[1]);
    return result;
  }

  std::string name_;
  plane::WorkBudget work_;
  JsonValue tree_;
};

}  // namespace

packing::Problem read_nesting(const std::string& text, const std::string& name, const NestingWishes& wishes) {
  return Reader(text, name).problem(wishes);
}

packing::Layout read_layout(const std::string& text, const std::string& name, const packing::Problem& problem) {
  return Reader(text, name).layout(problem);
}

}  // namespace findspace::io
