// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/mesh_glb.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "io/mesh/mesh_transform.h"
#include "io/text/json_tree.h"

namespace findspace::io {
namespace {

using exact::Real;
using Kind = JsonValue::Kind;

constexpr std::size_t kHeader = 12, kChunkHeader = 8, kPlace = 3 * sizeof(float);
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::kBadValue, what); }

/// A part of the file.
struct Part {
  std::size_t at = 0, length = 0;
};

std::size_t whole_number(const JsonValue& v, std::string_view what) {
  std::size_t value = 0;
  const std::string_view text = v.text();
  const char* end = text.data() + text.size();
  if (!v.is(Kind::kNumber) || std::from_chars(text.data(), end, value).ptr != end)
    refuse(fmt::format("{} is a whole number from 0 on", what));
  return value;
}

std::size_t whole_at(const JsonValue& of, std::string_view key, std::optional<std::size_t> otherwise = {}) {
  const JsonValue* v = of.find(key);
  if (v != nullptr) return whole_number(*v, fmt::format("\"{}\"", key));
  if (!otherwise) refuse(fmt::format("\"{}\" is missing", key));
  return *otherwise;
}

/// The list under the key; empty where there is none.
std::span<const JsonValue> list(const JsonValue& of, std::string_view key) {
  const JsonValue* v = of.find(key);
  if (v == nullptr) return {};
  if (!v->is(Kind::kArray)) refuse(fmt::format("\"{}\" is a list", key));
  return v->items();
}

const JsonValue& item(const JsonValue& root, std::string_view key, std::size_t index) {
  const std::span<const JsonValue> items = list(root, key);
  if (index >= items.size()) refuse(fmt::format("there is no number {} in \"{}\"", index, key));
  return items[index];
}

std::optional<std::vector<Real>> numbers(const JsonValue& node, std::string_view key, std::size_t count) {
  if (node.find(key) == nullptr) return std::nullopt;
  std::vector<Real> out;
  for (const JsonValue& v : list(node, key)) {
    if (!v.is(Kind::kNumber)) break;
    out.push_back(Real::parse_decimal(v.text()));
  }
  if (out.size() != count || list(node, key).size() != count)
    refuse(fmt::format("\"{}\" of a node has {} numbers", key, count));
  return out;
}

/// A matrix, column by column.
MeshTransform of_matrix(const std::vector<Real>& m) {
  MeshTransform out;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t k = 0; k < 3; ++k) out.row[j][k] = m[4 * j + k];
    if (compare(m[4 * j + 3], Real(j == 3 ? 1 : 0)) != 0) refuse("the last row of a \"matrix\" is 0, 0, 0, 1");
  }
  return out;
}

/// By the direction of the quaternion (x, y, z, w).
void rotate(MeshTransform& out, const std::vector<Real>& q) {
  const auto& [x, y, z, w] = std::tie(q[0], q[1], q[2], q[3]);
  const Real norm = x * x + y * y + z * z + w * w;
  if (norm.sign() == 0) refuse("the \"rotation\" of a node is not 0");
  const Real two = Real(2) / norm;
  const std::array<std::array<Real, 3>, 3> columns{
      {{Real(1) - two * (y * y + z * z), two * (x * y + z * w), two * (x * z - y * w)},
       {two * (x * y - z * w), Real(1) - two * (x * x + z * z), two * (y * z + x * w)},
       {two * (x * z + y * w), two * (y * z - x * w), Real(1) - two * (x * x + y * y)}}};
  std::copy(columns.begin(), columns.end(), out.row.begin());
}

MeshTransform transform(const JsonValue& node) {
  if (const auto matrix = numbers(node, "matrix", 16)) return of_matrix(*matrix);
  MeshTransform out;
  if (const auto rotation = numbers(node, "rotation", 4)) rotate(out, *rotation);
  if (const auto scale = numbers(node, "scale", 3))
    for (std::size_t j = 0; j < 3; ++j)
      for (Real& factor : out.row[j]) factor = factor * (*scale)[j];
  if (const auto shift = numbers(node, "translation", 3)) std::copy(shift->begin(), shift->end(), out.row[3].begin());
  return out;
}

/// y upwards becomes z upwards.
MeshTransform upright() {
  MeshTransform out;
  out.row[1] = {Real(), Real(), Real(1)};
  out.row[2] = {Real(), Real(-1), Real()};
  return out;
}

bool equal(const MeshTransform& a, const MeshTransform& b) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      if (compare(a.row[j][k], b.row[j][k]) != 0) return false;
  return true;
}

/// Where numbers of the binary chunk lie.
struct Accessor {
  std::size_t at, count, stride, component;
};

class GlbReader {
 public:
  GlbReader(const std::string& bytes, const JsonValue& root, Part binary, MeshBuilder& out)
      : bytes_(bytes), root_(root), binary_(binary), out_(out) {}

  /// The scene that the file shows; where there is none, every node that is no child.
  void read() {
    for (const std::size_t top : roots()) pending_.push_back({top, upright(), 0});
    std::reverse(pending_.begin(), pending_.end());
    while (!pending_.empty()) {
      const Pending next = std::move(pending_.back());
      pending_.pop_back();
      node(next);
    }
    if (out_.mesh().faces.empty()) refuse("the scene shows no triangles");
  }

  /// Sets of points and lines that were passed over.
  std::size_t passed_over() const { return passed_over_; }

 private:
  struct Pending {
    std::size_t node;
    MeshTransform placed;  // by its parents
    int depth;
  };

  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> out;
    if (!list(root_, "scenes").empty()) {
      for (const JsonValue& top : list(item(root_, "scenes", whole_at(root_, "scene", 0)), "nodes"))
        out.push_back(whole_number(top, "a node"));
      return out;
    }
    std::set<std::size_t> children;
    for (const JsonValue& node : list(root_, "nodes"))
      for (const JsonValue& child : list(node, "children")) children.insert(whole_number(child, "a node"));
    for (std::size_t k = 0; k < list(root_, "nodes").size(); ++k)
      if (children.count(k) == 0) out.push_back(k);
    return out;
  }

  void node(const Pending& at) {
    const JsonValue& node = item(root_, "nodes", at.node);
    if (!visited_.insert(at.node).second) refuse(fmt::format("node {} stands in the scene twice", at.node));
    if (at.depth > kMostDepth) refuse(fmt::format("node {} stands more than {} nodes deep", at.node, kMostDepth));
    const MeshTransform placed = at.placed.after(transform(node));
    if (node.find("mesh") != nullptr) mesh(whole_at(node, "mesh"), placed);
    const std::span<const JsonValue> children = list(node, "children");
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      pending_.push_back({whole_number(*child, "a node"), placed, at.depth + 1});
  }

  void mesh(std::size_t index, const MeshTransform& placed) {
    const int sense = placed.sense();
    if (sense == 0) refuse("a transform flattens what it places");
    first_.clear();
    for (const JsonValue& primitive : list(item(root_, "meshes", index), "primitives")) {
      const std::size_t mode = whole_at(primitive, "mode", kTriangles);
      if (mode > kFan) refuse(fmt::format("a primitive has the unknown mode {}", mode));
      if (mode < kTriangles)
        ++passed_over_;
      else
        faces(primitive, mode, placed, sense < 0);
    }
  }

  /// What one file repeats is not bounded by its length: more numbers than its chunk has bytes are work.
  void charge(std::size_t numbers) {
    taken_ += numbers;
    if (taken_ > binary_.length)
      out_.charge(kAgain * std::min(numbers, taken_ - binary_.length), "placing the same vertices so often");
  }

  void faces(const JsonValue& primitive, std::size_t mode, const MeshTransform& placed, bool mirrored) {
    const JsonValue* attributes = primitive.find("attributes");
    if (attributes == nullptr || attributes->find("POSITION") == nullptr)
      refuse("a primitive of triangles has no \"POSITION\"");
    const std::size_t position = whole_at(*attributes, "POSITION");
    const Accessor places = accessor(position, "VEC3", {kFloat});
    const std::vector<std::size_t> corners = corners_of(primitive, places.count);
    charge(1 + corners.size());
    if (mode == kTriangles && corners.size() % 3 != 0) refuse("a primitive of triangles has a part of one");
    const auto [shared, fresh] = first_.emplace(position, out_.size());
    const std::size_t first = shared->second;
    if (fresh) {
      charge(places.count);
      vertices(places, placed);
    }
    for (std::size_t k = 0, end = corners.size(); k + 2 < end; k += mode == kTriangles ? 3 : 1) {
      const bool fan = mode == kFan, turned = mode == kStrip && k % 2 == 1;
      std::array<std::size_t, 3> at{corners[fan ? 0 : k], corners[k + 1], corners[k + 2]};
      if (turned != mirrored) std::swap(at[1], at[2]);
      if (mode != kTriangles && (at[0] == at[1] || at[1] == at[2] || at[2] == at[0])) continue;  // it joins strips
      out_.face({int(first + at[0]), int(first + at[1]), int(first + at[2])});
    }
  }

  void vertices(const Accessor& places, const MeshTransform& placed) {
    const bool as_drawn = equal(placed, upright());
    for (std::size_t k = 0; k < places.count; ++k) {
      const std::size_t at = places.at + k * places.stride;
      const double x = little<float>(bytes_, at), y = little<float>(bytes_, at + 4), z = little<float>(bytes_, at + 8);
      if (as_drawn) {
        out_.vertex(x, -z, y);
        continue;
      }
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) refuse("a coordinate is not finite");
      out_.vertex(placed.apply({Real::from_double(x), Real::from_double(y), Real::from_double(z)}));
    }
  }

  std::vector<std::size_t> corners_of(const JsonValue& primitive, std::size_t vertices) const {
    std::vector<std::size_t> out;
    if (primitive.find("indices") == nullptr) {
      for (std::size_t k = 0; k < vertices; ++k) out.push_back(k);
      return out;
    }
    const Accessor indices = accessor(whole_at(primitive, "indices"), "SCALAR", {kByte, kShort, kInteger});
    for (std::size_t k = 0; k < indices.count; ++k) {
      const std::size_t at = indices.at + k * indices.stride;
      out.push_back(indices.component == kByte    ? little<std::uint8_t>(bytes_, at)
                    : indices.component == kShort ? little<std::uint16_t>(bytes_, at)
                                                  : little<std::uint32_t>(bytes_, at));
      if (out.back() >= vertices) refuse("a triangle refers to a vertex that is not there");
    }
    return out;
  }

  Accessor accessor(std::size_t index, std::string_view type, std::initializer_list<std::size_t> components) const {
    const JsonValue& given = item(root_, "accessors", index);
    const JsonValue* type_given = given.find("type");
    const std::size_t component = whole_at(given, "componentType"), count = whole_at(given, "count");
    if (type_given == nullptr || type_given->text() != type ||
        std::find(components.begin(), components.end(), component) == components.end())
      throw Error(ErrorCode::kUnsupported,
                  fmt::format("accessor {} is not of floats (\"VEC3\") or whole numbers (\"SCALAR\")", index));
    if (given.find("sparse") != nullptr || given.find("bufferView") == nullptr)
      throw Error(ErrorCode::kUnsupported, fmt::format("accessor {} is sparse", index));
    const std::size_t size = component == kFloat ? kPlace : component == kInteger ? 4 : component == kShort ? 2 : 1;
    const JsonValue& view = item(root_, "bufferViews", whole_at(given, "bufferView"));
    const Part part = inside(binary_, whole_at(view, "byteOffset", 0), whole_at(view, "byteLength"));
    if (whole_at(view, "buffer") != 0) throw Error(ErrorCode::kUnsupported, "only the buffer within the file is read");
    const std::size_t stride = whole_at(view, "byteStride", size), offset = whole_at(given, "byteOffset", 0);
    if (stride < size || stride > kMostStride)
      refuse(fmt::format("\"byteStride\" is from {} to {}", size, kMostStride));
    if (count > part.length / stride + 1) cut_off();
    const std::size_t length = count == 0 ? 0 : (count - 1) * stride + size;
    return {inside(part, offset, length).at, count, stride, component};
  }

  static Part inside(Part whole, std::size_t offset, std::size_t length) {
    if (offset > whole.length || length > whole.length - offset) cut_off();
    return {whole.at + offset, length};
  }
  [[noreturn]] static void cut_off() {
    throw Error(ErrorCode::kFile, "the binary chunk is shorter than it is said to be");
  }

  static constexpr std::size_t kTriangles = 4, kStrip = 5, kFan = 6;
  static constexpr std::size_t kByte = 5121, kShort = 5123, kInteger = 5125, kFloat = 5126, kMostStride = 252;
  static constexpr std::uint64_t kAgain = 10;  // units for a vertex or a corner
  static constexpr int kMostDepth = 64;

  const std::string& bytes_;
  const JsonValue& root_;
  Part binary_;
  MeshBuilder& out_;
  std::vector<Pending> pending_;
  std::set<std::size_t> visited_;
  std::map<std::size_t, std::size_t> first_;  // vertex of each accessor that the mesh in hand has placed
  std::size_t taken_ = 0;                     // vertices and corners
  std::size_t passed_over_ = 0;
};

/// The JSON chunk, then the binary one if there is one.
std::array<Part, 2> chunks(const std::string& bytes) {
  if (little<std::uint32_t>(bytes, 4) != 2)
    throw Error(ErrorCode::kUnsupported, fmt::format("this is glTF {}, not 2", little<std::uint32_t>(bytes, 4)));
  const std::size_t length = little<std::uint32_t>(bytes, 8);
  if (length > bytes.size()) throw Error(ErrorCode::kFile, "the file is truncated");
  std::array<Part, 2> out;
  for (std::size_t at = kHeader; at + kChunkHeader <= length;) {
    const std::size_t size = little<std::uint32_t>(bytes, at);
    const auto type = little<std::uint32_t>(bytes, at + 4);
    const Part part{at + kChunkHeader, size};
    if (size > length - part.at) throw Error(ErrorCode::kFile, "the file is truncated");
    if (type == kJsonChunk && out[0].at == 0) out[0] = part;
    if (type == kBinaryChunk && out[1].at == 0) out[1] = part;
    at = part.at + size;
  }
  if (out[0].at == 0) throw Error(ErrorCode::kFile, "the file has no JSON chunk");
  return out;
}

/// Of those that a file requires, only what does not change surfaces can be passed over.
void refuse_extensions(const JsonValue& root) {
  for (const JsonValue& name : list(root, "extensionsRequired")) {
    const std::string_view text = name.text();
    if (!text.starts_with("KHR_materials_") && !text.starts_with("KHR_texture_") && !text.starts_with("KHR_lights_"))
      throw Error(ErrorCode::kUnsupported,
                  fmt::format("it requires the extension {} of glTF, which is not read; export it without", text));
  }
  for (const JsonValue& buffer : list(root, "buffers"))
    if (buffer.find("uri") != nullptr)
      throw Error(ErrorCode::kUnsupported, "its numbers lie in a file of their own; export one binary file");
}

}  // namespace

void read_glb(const std::string& bytes, ReadContext& context, MeshBuilder& out) {
  const auto [json, binary] = chunks(bytes);
  const JsonTree tree = parse_json(std::string_view(bytes).substr(json.at, json.length), "glTF", context.work);
  refuse_extensions(tree.root());
  GlbReader reader(bytes, tree.root(), binary, out);
  reader.read();
  if (reader.passed_over() > 0)
    context.notes.push_back(fmt::format("{} sets of points or lines passed over", reader.passed_over()));
}

}  // namespace findspace::io
