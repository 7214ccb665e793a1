// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/stated_conditions.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "packing/problem/pair_formula.h"

namespace findspace::io {
namespace {

using packing::Fraction;
using Kind = JsonValue::Kind;

class ConditionReader {
 public:
  ConditionReader(const NestingJson& json, const std::vector<std::string>& names, int dimension)
      : json_(json), dimension_(dimension) {
    for (const std::string& name : names) parts_.push_back({name});
  }

  void read(StatedConditions& out) const {
    const JsonValue &tree = json_.tree(), *gaps = tree.find("gaps"), *where = tree.find("where"),
                    *pairs = tree.find("pairs"), *groups = tree.find("groups");
    if (gaps != nullptr)
      for (const JsonValue& value : json_.list(*gaps).items()) {
        const auto [first, second] = between(value, "a gap");
        out.gaps.push_back({first, second, not_below_0(json_.need(value, "gap"), value, "a gap")});
      }
    if (where != nullptr) out.where = condition(*where);
    if (pairs != nullptr)
      for (const JsonValue& value : json_.list(*pairs).items()) {
        const auto [first, second] = between(value, "a condition");
        out.conditions.push_back({first, second, condition(json_.need(value, "where"))});
      }
    if (groups != nullptr)
      for (const JsonValue& value : json_.list(*groups).items()) {
        StatedGroup& group = out.groups.emplace_back();
        for (const JsonValue& name : json_.list(json_.need(value, "parts")).items()) group.parts.push_back(part(name));
        if (const JsonValue* within = value.find("within")) group.within = not_below_0(*within, value, "a distance");
      }
  }

 private:
  struct Named {
    std::string name;
  };

  std::size_t part(const JsonValue& name) const { return json_.index_of(name, parts_, "part"); }

  std::array<std::size_t, 2> between(const JsonValue& value, const char* what) const {
    const JsonValue& names = json_.list(json_.need(value, "between"));
    if (names.size() != 2) json_.fail(names, fmt::format("{} is between two parts", what));
    return {part(names.items()[0]), part(names.items()[1])};
  }

  Fraction not_below_0(const JsonValue& number, const JsonValue& at, const char* what) const {
    const Fraction result = json_.number(number);
    if (result < 0) json_.fail(at, fmt::format("{} below 0", what));
    return result;
  }

  std::string condition(const JsonValue& value) const {
    if (!value.is(Kind::kString)) json_.fail(value, fmt::format("a formula is meant, not {}", value.kind_name()));
    const std::string text(value.text());
    try {
      packing::parse_condition(text, dimension_);
    } catch (const Error& e) {
      throw e.within(fmt::format("{}:{}:{}: 'where'", json_.name(), value.line, value.column));
    }
    return text;
  }

  const NestingJson& json_;
  int dimension_;
  std::vector<Named> parts_;
};

}  // namespace

std::vector<packing::PairCondition> conditions_of(const StatedConditions& stated, std::size_t parts,
                                                  const std::optional<Fraction>& farthest, const std::string& place) {
  std::vector<packing::PairCondition> result = stated.conditions;
  std::vector<std::size_t> all(parts);
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (!stated.where.empty()) packing::add_conditions(result, all, stated.where);
  for (const StatedGroup& group : stated.groups) {
    const std::optional<Fraction> within = group.within ? group.within : farthest;
    if (!within)
      throw Error(
          ErrorCode::kBadValue,
          "a group needs 'within' here: its parts may stay on one sheet, or in one container, and there is none",
          place);
    packing::add_conditions(result, group.parts, fmt::format("gap(self, other) <= {}", within->text()));
  }
  return result;
}

void read_conditions(const NestingJson& json, const std::vector<std::string>& names, int dimension,
                     StatedConditions& out) {
  ConditionReader(json, names, dimension).read(out);
}

}  // namespace findspace::io
