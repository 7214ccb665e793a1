// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/unread_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/nesting/stated_conditions.h"
#include "io/text/scene_reader.h"

namespace findspace::io {
namespace {

using Key = std::string_view;
using Kind = JsonValue::Kind;

constexpr std::array<Key, 22> kProblemKeys{"findspace",  "layout", "name",    "items",     "strip_height", "sheets",
                                           "box",        "fixed",  "shapes",  "unit",      "gaps",         "pairs",
                                           "where",      "groups", "curves",  "tolerance", "join",         "mend",
                                           "open_lines", "parts",  "$schema", "comment"};
constexpr std::array<Key, 8> kPartKeys{"id",    "demand", "allowed_orientations", "mirrored", "tilt", "value",
                                       "shape", "dxf"};
constexpr std::array<Key, 7> kSheetKeys{"id", "count", "cost", "width", "height", "shape", "zones"};
constexpr std::array<Key, 4> kZoneKeys{"shape", "only", "keeps_out", "holds"};
constexpr std::array<Key, 2> kPolygonKeys{"type", "data"};
constexpr std::array<Key, 2> kDataKeys{"outer", "inner"};
constexpr std::array<Key, 7> kFixedKeys{"part", "copy", "angle", "mirrored", "at", "sheet", "number"};

/// The values of a list of the object; none where it has no such list.
std::span<const JsonValue> values_of(const JsonValue& object, Key list) {
  const JsonValue* values = object.is(Kind::kObject) ? object.find(std::string(list)) : nullptr;
  if (values == nullptr || !values->is(Kind::kArray)) return {};
  return values->items();
}

bool says_nothing(const JsonValue& value) {
  return value.is(Kind::kNull) || (value.is(Kind::kArray) && value.size() == 0);
}

}  // namespace

void UnreadKeys::look(const JsonValue& object, std::span<const Key> known, Key of) {
  if (!object.is(Kind::kObject)) return;
  for (std::size_t i = 0; i < object.size(); ++i) {
    const Key key = object.keys()[i];
    if (std::find(known.begin(), known.end(), key) != known.end() || says_nothing(object.items()[i])) continue;
    const std::string hint = suggestion(key, {known.begin(), known.end()});
    if (!hint.empty()) json_.fail(object.items()[i], fmt::format("unknown key '{}'{}", key, hint));
    const std::string unread = fmt::format("'{}'{}", key, of);
    if (std::find(unread_.begin(), unread_.end(), unread) == unread_.end()) unread_.push_back(unread);
  }
}

void UnreadKeys::look_through(const JsonValue& object, Key list, std::span<const Key> known) {
  for (const JsonValue& value : values_of(object, list)) look(value, known, fmt::format(" of {}", list));
}

void UnreadKeys::look_at_polygon(const JsonValue& object) {
  const JsonValue* shape = object.is(Kind::kObject) ? object.find("shape") : nullptr;
  if (shape == nullptr || !shape->is(Kind::kObject) || shape->find("type") == nullptr) return;
  look(*shape, kPolygonKeys, " of a shape");
  if (const JsonValue* data = shape->find("data")) look(*data, kDataKeys, " of a shape's data");
}

std::vector<std::string> UnreadKeys::notes() const {
  if (unread_.empty()) return {};
  return {fmt::format("{}: not read: {}", json_.name(), fmt::join(unread_, ", "))};
}

std::vector<std::string> unread_keys(const NestingJson& json) {
  UnreadKeys unread(json);
  unread.look(json.tree(), kProblemKeys, "");
  unread.look_through(json.tree(), "items", kPartKeys);
  unread.look_through(json.tree(), "sheets", kSheetKeys);
  for (const JsonValue& item : values_of(json.tree(), "items")) unread.look_at_polygon(item);
  for (const JsonValue& sheet : values_of(json.tree(), "sheets")) {
    unread.look_through(sheet, "zones", kZoneKeys);
    unread.look_at_polygon(sheet);
    for (const JsonValue& zone : values_of(sheet, "zones")) unread.look_at_polygon(zone);
  }
  unread.look_through(json.tree(), "fixed", kFixedKeys);
  unread.look_through(json.tree(), "gaps", kGapKeys);
  unread.look_through(json.tree(), "pairs", kPairKeys);
  unread.look_through(json.tree(), "groups", kGroupKeys);
  return unread.notes();
}

}  // namespace findspace::io
