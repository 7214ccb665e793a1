// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/scene_extras.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "exact/number/decimal.h"
#include "io/scene/scene_placement.h"
#include "io/scene/scene_rotation.h"

namespace findspace::io {
namespace {

using exact::Real;
using Kind = JsonValue::Kind;

std::vector<std::string> read_names(const JsonValue& value, ShapeReader& shapes, const Label& label) {
  const SceneReader& json = shapes.json();
  std::vector<std::string> names = json.texts(value, fmt::format("\"{}\"", label.what), label);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const JsonValue& at = value.is(Kind::kArray) ? value.items()[i] : value;
    shapes.named(names[i], at, label);
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      json.fail(ErrorCode::kBadValue, fmt::format("'{}' stands here twice", names[i]), label, at);
    }
  }
  return names;
}

/// Decimals as integers in the same proportion, without a common factor.
GridPosition read_direction(const JsonValue& value, int dimension, const SceneReader& json, const Label& label) {
  json.expect(value, Kind::kArray, "a direction", label);
  if (value.size() != static_cast<std::size_t>(dimension)) {
    json.fail(ErrorCode::kBadValue, fmt::format("a direction needs {} numbers, not {}", dimension, value.size()), label,
              value);
  }
  std::vector<exact::Decimal> numbers;
  std::int64_t low = 0;
  for (const JsonValue& item : value.items()) {
    json.expect(item, Kind::kNumber, "a direction's coordinate", label);
    numbers.push_back(json.placed(label, item, [&] { return exact::Decimal::parse(item.text()); }));
    low = std::min(low, numbers.back().exponent);
  }
  constexpr std::int64_t kMostDigits = 17;
  GridPosition result{};
  std::int64_t common = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].digits.empty()) continue;
    std::int64_t zeros = numbers[i].exponent - low;
    if (zeros + static_cast<std::int64_t>(numbers[i].digits.size()) > kMostDigits) {
      json.fail(ErrorCode::kOutOfRange, "a direction with more than 17 digits from the first to the last", label,
                value);
    }
    result[i] = std::stoll(numbers[i].digits + std::string(static_cast<std::size_t>(zeros), '0'));
    if (numbers[i].negative) result[i] = -result[i];
    common = std::gcd(common, result[i]);
  }
  if (common == 0) json.fail(ErrorCode::kBadValue, "a direction must not be zero", label, value);
  for (std::int64_t& x : result) {
    x /= common;
    if (std::abs(x) > Grid::kLimit)
      json.fail(ErrorCode::kOutOfRange, "a direction must be a ratio of integers up to 2^40", label, value);
  }
  return result;
}

/// N angles evenly over the full turn, or the list itself.
std::vector<Real> read_angles(const JsonValue& value, const SceneReader& json, const Label& label) {
  std::vector<Real> angles;
  if (value.is(Kind::kArray)) {
    for (std::size_t i = 0; i < value.size(); ++i)
      angles.push_back(json.number(value.items()[i], label.part("angle", i)));
    if (angles.empty()) json.fail(ErrorCode::kBadValue, "\"angles\" is an empty list", label, value);
    return angles;
  }
  auto count = json.number(value, label).integer();
  if (!count || *count < 1 || *count > 100000) {
    json.fail(ErrorCode::kBadValue, "\"angles\" must be a list or a whole number from 1 to 100000", label, value);
  }
  for (exact::int128 i = 0; i < *count; ++i) angles.push_back(Real::ratio(360 * i, *count));
  return angles;
}

/// `free` is a word, or an object {word: {...}}; what belongs to the word may stand in it, beside it, or in the scene.
struct FreeValue {
  std::string word;
  const JsonValue* inner = nullptr;
  const JsonValue* outer = nullptr;
  const JsonValue* root = nullptr;

  const JsonValue* find(std::string_view key) const {
    for (const JsonValue* object : {inner, outer, root}) {
      const JsonValue* value = object && object->is(Kind::kObject) ? object->find(key) : nullptr;
      if (value) return value;
    }
    return nullptr;
  }
};

struct FreeKind {
  std::string_view word;
  Free::Kind kind;
  std::vector<std::string_view> keys;
};

const std::vector<FreeKind>& free_kinds() {
  static const std::vector<FreeKind> kinds{{"position", Free::Kind::kPosition, {}},
                                           {"line", Free::Kind::kLine, {"through", "direction"}},
                                           {"angle", Free::Kind::kAngle, {"about"}},
                                           {"time", Free::Kind::kTime, {}},
                                           {"pose", Free::Kind::kPose, {"about", "angles"}}};
  return kinds;
}

const FreeKind& find_free_kind(const FreeValue& free, const JsonValue& at, const SceneReader& json,
                               const Label& label) {
  std::vector<std::string> words;
  for (const FreeKind& kind : free_kinds()) {
    if (kind.word == free.word) return kind;
    words.emplace_back(kind.word);
  }
  json.fail(
      ErrorCode::kUnknownName,
      fmt::format("\"free\" is one of {}, not '{}'{}", fmt::join(words, ", "), free.word, suggestion(free.word, words)),
      label, at);
}

FreeValue split_free(const JsonValue& value, const JsonValue& root, const SceneReader& json, const Label& label) {
  FreeValue free;
  free.root = &root;
  if (value.is(Kind::kString)) {
    free.word = value.text();
    return free;
  }
  json.expect(value, Kind::kObject, "\"free\" (if it is not a word)", label);
  if (value.size() == 0) json.fail(ErrorCode::kBadValue, "\"free\" is an empty object", label, value);
  free.outer = &value;
  free.word = value.keys()[0];
  free.inner = &value.items()[0];
  for (std::size_t i = 0; i < value.size(); ++i) {
    for (const FreeKind& kind : free_kinds()) {
      if (kind.word != value.keys()[i]) continue;
      free.word = value.keys()[i];
      free.inner = &value.items()[i];
    }
  }
  return free;
}

Free read_free(const JsonValue& value, const JsonValue& root, const ShapeReader& shapes) {
  const SceneReader& json = shapes.json();
  Label label{nullptr, "free"};
  FreeValue given = split_free(value, root, json, label);
  const FreeKind& kind = find_free_kind(given, value, json, label);
  if (given.outer) {
    std::vector<std::string_view> keys = kind.keys;
    json.expect(*given.inner, Kind::kObject, fmt::format("\"{}\" of \"free\"", kind.word), label);
    json.check_keys(*given.inner, keys, label);
    keys.push_back(kind.word);
    json.check_keys(*given.outer, keys, label);
  }
  Free free;
  free.kind = kind.kind;
  int dimension = shapes.dimension();
  if (free.kind == Free::Kind::kLine) {
    const JsonValue* through = given.find("through");
    const JsonValue* direction = given.find("direction");
    if (!through || !direction)
      json.fail(ErrorCode::kBadValue, "a line needs \"through\" and \"direction\"", label, value);
    free.through = json.position(*through, dimension, label.part("through"));
    free.direction = read_direction(*direction, dimension, json, label.part("direction"));
  }
  if (free.kind == Free::Kind::kAngle || free.kind == Free::Kind::kPose) {
    if (const JsonValue* about = given.find("about"))
      free.about = json.position(*about, dimension, label.part("about"));
  }
  if (free.kind == Free::Kind::kPose) {
    const JsonValue* angles = given.find("angles");
    if (!angles) json.fail(ErrorCode::kBadValue, "\"pose\" needs \"angles\"", label, value);
    if (dimension == 3)
      free.orientations = read_orientations(*angles, free.about, json, label.part("angles"));
    else
      free.angles = read_angles(*angles, json, label.part("angles"));
  }
  return free;
}

std::vector<Real> read_numbers(const JsonValue& value, std::size_t count, const SceneReader& json, const Label& label) {
  json.expect(value, Kind::kArray, "a list of numbers", label);
  if (value.size() != count) {
    json.fail(ErrorCode::kBadValue, fmt::format("{} numbers are needed here, not {}", count, value.size()), label,
              value);
  }
  std::vector<Real> numbers;
  for (const JsonValue& item : value.items()) numbers.push_back(json.number(item, label));
  return numbers;
}

void check_times(const Movement& movement, const Motion& motion, const JsonValue& at, const SceneReader& json,
                 const Label& label) {
  for (std::size_t i = 0; i < movement.times.size(); ++i) {
    const Real& t = movement.times[i];
    if (t < motion.start || motion.end < t) {
      json.fail(ErrorCode::kBadValue, "a way point's time is outside the time of the motion", label, at);
    }
    if (i > 0 && !(movement.times[i - 1] < t)) json.fail(ErrorCode::kBadValue, "times must ascend", label, at);
  }
}

Movement read_movement(std::string_view name, const JsonValue& value, const Motion& motion, ShapeReader& shapes) {
  const SceneReader& json = shapes.json();
  Label label{nullptr, "motion of", name};
  shapes.named(name, value, Label{nullptr, "motion"});
  static constexpr std::array<std::string_view, 3> kKeys{"path", "times", "angles"};
  json.expect(value, Kind::kObject, "a movement", label);
  json.check_keys(value, kKeys, label);
  Movement movement;
  movement.shape = name;
  const JsonValue& path = json.need(value, "path", label);
  json.expect(path, Kind::kArray, "\"path\"", label);
  if (path.size() == 0) json.fail(ErrorCode::kBadValue, "\"path\" needs at least one way point", label, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    movement.path.push_back(json.position(path.items()[i], shapes.dimension(), label.part("way point", i)));
  }
  std::size_t n = path.size();
  if (const JsonValue* times = value.find("times")) {
    movement.times = read_numbers(*times, n, json, label.part("times"));
    check_times(movement, motion, *times, json, label.part("times"));
  } else {
    Real leg = n > 1 ? (motion.end - motion.start) / Real(n - 1) : Real(0);
    for (std::size_t i = 0; i < n; ++i) movement.times.push_back(motion.start + leg * Real(i));
  }
  movement.angles.assign(n, Real(0));
  if (const JsonValue* angles = value.find("angles"))
    movement.angles = read_numbers(*angles, n, json, label.part("angles"));
  return movement;
}

Motion read_motion(const JsonValue& value, ShapeReader& shapes) {
  const SceneReader& json = shapes.json();
  Label label{nullptr, "motion"};
  json.expect(value, Kind::kObject, "\"motion\"", label);
  std::vector<Real> time = read_numbers(json.need(value, "time", label), 2, json, label.part("time"));
  Motion motion{time[0], time[1], {}};
  if (!(motion.start < motion.end))
    json.fail(ErrorCode::kBadValue, "\"time\" must be [start, end] with start < end", label, value);
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (value.keys()[i] == "time") continue;
    motion.movements.push_back(read_movement(value.keys()[i], value.items()[i], motion, shapes));
  }
  if (motion.movements.empty()) json.fail(ErrorCode::kBadValue, "\"motion\" moves no shape", label, value);
  return motion;
}

/// A group is the union of its shapes that stand still, a collection; the moving ones are its members all the same.
void read_groups(const JsonValue& value, ShapeReader& shapes, Scene& scene) {
  const SceneReader& json = shapes.json();
  json.expect(value, Kind::kObject, "\"groups\"", {});
  for (std::size_t g = 0; g < value.size(); ++g) {
    const std::string_view name = value.keys()[g];
    const Label label{nullptr, "group", name};
    if (scene.find(name))
      json.fail(ErrorCode::kBadValue, fmt::format("'{}' is a shape as well", name), label, value.items()[g]);
    json.expect(value.items()[g], Kind::kArray, "a group", label);
    std::vector<std::string>& members = scene.groups[std::string(name)];
    if (value.items()[g].size() > 0) members = read_names(value.items()[g], shapes, label);
    plane::Shape all;
    all.kind = plane::Shape::Kind::kUnion;
    all.collection = true;
    all.name = name;
    all.place = json.place(label, value.items()[g]);
    for (const std::string& member : members)
      if (std::find(scene.moving.begin(), scene.moving.end(), member) == scene.moving.end())
        all.children.push_back(scene.find(member));
    if (all.children.empty())
      scene.empty_lists.emplace_back(name);
    else
      scene.shapes.push_back(share(std::move(all)));
  }
}

}  // namespace

void read_question(const JsonValue& root, ShapeReader& shapes, Scene& scene) {
  const SceneReader& json = shapes.json();
  if (const JsonValue* moving = root.find("moving"))
    scene.moving = read_names(*moving, shapes, Label{nullptr, "moving"});
  if (const JsonValue* groups = root.find("groups")) read_groups(*groups, shapes, scene);
  if (const JsonValue* motion = root.find("motion")) scene.motion = read_motion(*motion, shapes);
  const JsonValue* free = root.find("free");
  if (free) scene.free = read_free(*free, root, shapes);
  if (free && scene.free.kind == Free::Kind::kTime && !scene.motion.given()) {
    json.fail(ErrorCode::kBadValue, "\"free\": \"time\" needs \"motion\"", {}, *free);
  }
  for (const char* key : {"about", "angles"}) {
    const JsonValue* value = root.find(key);
    bool used = scene.free.kind == Free::Kind::kPose ||
                (scene.free.kind == Free::Kind::kAngle && key == std::string_view("about"));
    if (value && !used)
      json.fail(ErrorCode::kBadValue, fmt::format("\"{}\" belongs to \"free\": \"angle\" or \"pose\"", key), {},
                *value);
  }
  if (const JsonValue* place = root.find("place")) scene.place = read_placement(*place, shapes);
}

}  // namespace findspace::io
