// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/scene_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>
#include <utility>

#include "io/scene/scene_curves.h"
#include "space/polytope/solid.h"

namespace findspace::io {
namespace {

constexpr std::size_t kMostLevels = 1000;  // of shapes made from shapes; keeps the stack bounded

using plane::Shape;
using plane::ShapePtr;

/// A kind, and its key with all that it may have beside it.
struct KnownKind {
  const ShapeKind* kind;
  std::vector<std::string_view> keys;
};

const std::vector<KnownKind>& all_kinds() {
  static const std::vector<KnownKind> kKinds = [] {
    std::vector<KnownKind> all;
    for (auto kinds : {primitive_kinds(), curve_kinds(), simplify_kinds(), node_kinds(), space_kinds()}) {
      for (const ShapeKind& kind : kinds) {
        KnownKind& known = all.emplace_back(KnownKind{&kind, {kind.key}});
        known.keys.insert(known.keys.end(), kind.beside.begin(), kind.beside.end());
      }
    }
    return all;
  }();
  return kKinds;
}

/// The first kind whose key the object has, or null.
const KnownKind* kind_of(const JsonValue& object) {
  static const std::unordered_map<std::string_view, const KnownKind*> kByKey = [] {
    std::unordered_map<std::string_view, const KnownKind*> all;
    for (const KnownKind& known : all_kinds()) all.emplace(known.kind->key, &known);
    return all;
  }();
  const KnownKind* first = nullptr;
  for (const std::string_view key : object.keys()) {
    const auto found = kByKey.find(key);
    if (found != kByKey.end() && (first == nullptr || found->second < first)) first = found->second;
  }
  return first;
}

}  // namespace

ShapePtr share(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

ShapeReader::ShapeReader(const SceneReader& json, const JsonValue& shapes)
    : json_(json), parts_work_(json.context().options.work_limit) {
  json_.expect(shapes, JsonValue::Kind::kObject, "\"shapes\"", {});
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string_view name = shapes.keys()[i];
    bool plain = !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
      return static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\x7f';
    });
    if (!plain)
      json_.fail(ErrorCode::kBadValue, "a shape needs a name without quotes and control characters", {},
                 shapes.items()[i]);
    entries_[names_.emplace_back(name)].value = &shapes.items()[i];
  }
}

std::vector<ShapePtr> ShapeReader::all() {
  std::vector<ShapePtr> shapes;
  for (const std::string& name : names_) shapes.push_back(named(name, *entries_.find(name)->second.value, {}));
  return shapes;
}

ShapePtr ShapeReader::named(std::string_view name, const JsonValue& at, const Label& label) {
  auto found = entries_.find(name);
  if (found == entries_.end()) {
    json_.fail(ErrorCode::kUnknownName, fmt::format("unknown shape '{}'{}", name, choice("shapes", name, names_)),
               label, at);
  }
  Entry& entry = found->second;
  if (entry.shape) {
    height_ = std::max(height_, entry.height);
    return entry.shape;
  }
  if (entry.open) fail_cycle(name, at, label);
  entry.open = true;
  trail_.emplace_back(name);
  Label own{nullptr, "shape", name};
  const std::size_t outside = std::exchange(height_, 0);
  Shape copy = *shape(*entry.value, own);
  entry.height = height_;
  height_ = std::max(outside, height_);
  copy.name = name;
  copy.place = json_.place(own, *entry.value);
  entry.shape = share(std::move(copy));
  trail_.pop_back();
  entry.open = false;
  return entry.shape;
}

ShapePtr ShapeReader::shape(const JsonValue& value, const Label& label) {
  const std::size_t beside = std::exchange(height_, 0);
  if (++depth_ > kMostLevels) fail_too_deep(value, label);
  ShapePtr made;
  switch (value.kind) {
    case JsonValue::Kind::kString:
      made = named(value.text(), value, label);
      json_.placed(label, value, [&] { charge_copy(*made); });
      break;
    case JsonValue::Kind::kArray:
      made = list(value, label);
      break;
    case JsonValue::Kind::kObject:
      made = object(value, label);
      break;
    default:
      json_.fail(ErrorCode::kBadValue, fmt::format("a shape is an object, a name or a list, not {}", value.kind_name()),
                 label, value);
  }
  --depth_;
  if (value.kind != JsonValue::Kind::kString && ++height_ > kMostLevels) fail_too_deep(value, label);
  height_ = std::max(beside, height_);
  return made;
}

ShapePtr ShapeReader::list(const JsonValue& value, const Label& label) {
  if (value.size() == 0) json_.fail(ErrorCode::kBadValue, "an empty list of shapes", label, value);
  Shape result = node(Shape::Kind::kUnion, label, value);
  result.collection = true;
  result.children.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i)
    result.children.push_back(shape(value.items()[i], label.part("part", i)));
  return share(std::move(result));
}

ShapePtr ShapeReader::object(const JsonValue& value, const Label& label) {
  const KnownKind* known = kind_of(value);
  if (known == nullptr) fail_unknown_kind(value, label);
  json_.check_keys(value, known->keys, label);
  return known->kind->build(*this, value, *value.find(known->kind->key), label);
}

double ShapeReader::parts_of(const Shape& shape) {
  if (shape.children.empty()) return 1;
  if (const auto known = parts_.find(&shape); known != parts_.end()) return known->second;
  double parts = parts_of(*shape.children[0]);
  for (std::size_t k = 1; k < shape.children.size(); ++k) {
    const double more = parts_of(*shape.children[k]);
    parts = shape.kind == Shape::Kind::kMinkowskiSum ? parts * more : parts + more;
  }
  return parts_[&shape] = shape.kind == Shape::Kind::kHull ? 1 : parts;
}

void ShapeReader::charge_copy(const Shape& named) {
  constexpr double kCopied = 150;
  if (dimension() != 3 || operands_.insert(&named).second) return;
  charge(kCopied * parts_of(named), "a shape of so many copied parts");
}

void ShapeReader::charge_pairs(const Shape& sum) {
  constexpr double kPair = 200;
  if (dimension() != 3) return;
  const double a = parts_of(*sum.children[0]), b = parts_of(*sum.children[1]);
  charge(kPair * (a * b - std::max(a, b)), "a Minkowski sum or difference of so many parts");
}

void ShapeReader::charge_rotated(const Shape& shape) {
  constexpr double kShape = 100, kCorner = 20;
  const space::Solid* const solid = space::solid_of(shape);
  if (solid == nullptr) {
    charge(kShape, "a rotated shape of so many shapes");
    for (const ShapePtr& child : shape.children) charge_rotated(*child);
  } else if (!rotated_.insert(shape.solid).second) {
    double corners = 1 + double(solid->mesh.vertices.size());
    for (const plane::Contour& contour : solid->contours) corners += 2 * double(contour.size());
    charge(kCorner * corners, "a rotated shape of so many copied corners");
  }
}

void ShapeReader::note_rotated(const Shape& made) {
  if (made.solid) rotated_.insert(made.solid);
  for (const ShapePtr& child : made.children) note_rotated(*child);
}

void ShapeReader::charge(double units, std::string_view what) {
  constexpr double kFarTooMuch = 1e18;
  parts_work_.charge(
      units < kFarTooMuch ? static_cast<std::uint64_t>(units) : std::numeric_limits<std::uint64_t>::max(), what);
}

namespace {

/// Words of other programs for kinds of shapes.
constexpr std::array<std::pair<std::string_view, std::string_view>, 29> kOtherKinds{{
    {"circle", "disc"},
    {"disk", "disc"},
    {"sphere", "ball"},
    {"rectangle", "box"},
    {"rect", "box"},
    {"square", "box"},
    {"cube", "box"},
    {"cuboid", "box"},
    {"cylinder", "prism"},
    {"extrude", "prism"},
    {"extrusion", "prism"},
    {"heightfield", "height_field"},
    {"heights", "height_field"},
    {"terrain", "height_field"},
    {"line", "polyline"},
    {"linestring", "polyline"},
    {"subtract", "difference"},
    {"intersect", "intersection"},
    {"merge", "union"},
    {"group", "union"},
    {"move", "translate"},
    {"translation", "translate"},
    {"rotation", "rotate"},
    {"buffer", "offset"},
    {"convex_hull", "hull"},
    {"nurbs", "spline"},
    {"svg", "file"},
    {"stl", "file"},
    {"import", "file"},
}};

}  // namespace

void ShapeReader::fail_unknown_kind(const JsonValue& value, const Label& label) const {
  std::vector<std::string> known;
  for (const KnownKind& one : all_kinds()) known.emplace_back(one.kind->key);
  for (const std::string_view key : value.keys()) {
    const auto other =
        std::find_if(kOtherKinds.begin(), kOtherKinds.end(), [&](const auto& w) { return w.first == key; });
    const std::string hint =
        other == kOtherKinds.end() ? suggestion(key, known) : fmt::format(", did you mean '{}'?", other->second);
    if (!hint.empty())
      json_.fail(ErrorCode::kUnknownName, fmt::format("unknown kind of shape '{}'{}", key, hint), label, value);
  }
  std::string what = value.keys().empty() ? "an empty object is not a shape"
                                          : fmt::format("unknown kind of shape '{}'", value.keys()[0]);
  json_.fail(ErrorCode::kUnknownName, fmt::format("{}; the kinds are {}", what, fmt::join(known, ", ")), label, value);
}

void ShapeReader::fail_cycle(std::string_view name, const JsonValue& at, const Label& label) const {
  auto first = std::find(trail_.begin(), trail_.end(), name);
  json_.fail(ErrorCode::kBadValue,
             fmt::format("'{}' is made from itself: {} -> {}", name, fmt::join(first, trail_.end(), " -> "), name),
             label, at);
}

void ShapeReader::fail_too_deep(const JsonValue& at, const Label& label) const {
  json_.fail(ErrorCode::kUnsupported, fmt::format("more than {} shapes that are each made from the next", kMostLevels),
             label, at);
}

Shape ShapeReader::node(Shape::Kind kind, const Label& label, const JsonValue& at) const {
  Shape shape;
  shape.kind = kind;
  shape.place = json_.place(label, at);
  return shape;
}

void ShapeReader::use_dimension(int dimension, const Label& label, const JsonValue& at) {
  if (dimension_ != 0 && dimension_ != dimension) {
    json_.fail(ErrorCode::kBadValue,
               fmt::format("a {}D shape in a scene whose other shapes are {}D", dimension, dimension_), label, at);
  }
  dimension_ = dimension;
}

}  // namespace findspace::io
