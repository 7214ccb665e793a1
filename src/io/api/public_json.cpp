// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// JSON of the public headers: the trees of the readers.

#include <findspace/json.h>

#include <algorithm>
#include <utility>

#include "io/text/json_tree.h"

namespace findspace {
namespace {

JsonValue public_json(const io::JsonValue& from) {
  static_assert(int(io::JsonValue::Kind::kObject) == int(JsonValue::Kind::kObject));
  JsonValue out{JsonValue::Kind(from.kind),
                from.boolean,
                from.line,
                from.column,
                std::string(from.text()),
                {from.keys().begin(), from.keys().end()},
                {}};
  out.items.reserve(from.size());
  for (const io::JsonValue& item : from.items()) out.items.push_back(public_json(item));
  return out;
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[std::size_t(found - keys.begin())];
}

const char* JsonValue::kind_name() const { return io::JsonValue(io::JsonValue::Kind(kind)).kind_name(); }

JsonValue read_json(std::string_view text, const std::string& name, std::uint64_t work_limit) {
  plane::WorkBudget work(work_limit);
  return public_json(io::parse_json(text, name, work).root());
}

}  // namespace findspace
