// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The model is read as it is unpacked. Kept are the numbers of its meshes, as they are written or as indices, and what
// is built of them: items may stand before their objects.
#include "io/mesh/mesh_3mf.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "exact/number/decimal.h"
#include "io/mesh/mesh_transform.h"
#include "io/mesh/read_mesh_ply.h"
#include "io/mesh/xml_stream.h"
#include "io/mesh/zip_archive.h"

namespace findspace::io {
namespace {

using exact::Real;

constexpr int kMostDepth = 64;

[[noreturn]] void bad_value(const std::string& what) { throw Error(ErrorCode::kBadValue, what); }

std::string_view text_of(XmlAttributes attributes, const char* name) {
  const char* const value = xml_attribute(attributes, name);
  return value ? value : "";
}

long whole(const char* element, XmlAttributes attributes, const char* name) {
  const std::string_view text = text_of(attributes, name);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0)
    bad_value(fmt::format("a <{}> has the {} '{}', which is not an index", element, name, text));
  return value;
}

MeshTransform transform(const std::string& text) {
  MeshTransform out;
  if (text.empty()) return out;
  std::istringstream words(text);
  std::string word;
  int count = 0;
  for (; words >> word; ++count) {
    if (count == 12) break;
    try {
      out.row[static_cast<std::size_t>(count / 3)][static_cast<std::size_t>(count % 3)] = Real::parse_decimal(word);
    } catch (const Error&) {
      bad_value(fmt::format("a transform has '{}', which is not a number", word));
    }
  }
  if (count != 12 || words >> word) bad_value("a transform has twelve numbers");
  return out;
}

/// An object that stands somewhere, by a transform as it is written: empty for none.
struct Use {
  long object = 0;
  std::string transform;
};

struct MeshPart {
  std::string coordinates;  // as they are written, each with a 0 behind it
  std::size_t vertices = 0;
  std::vector<std::array<int, 3>> triangles;
};

struct Object {
  std::unique_ptr<MeshPart> mesh;
  std::vector<Use> components;
};

/// What a model says, while it is read.
class ModelReader : public XmlListener {
 public:
  ModelReader(ReadContext& context, const MeshScale& scale) : context_(context), scale_(scale) {}

  void begin(const char* name, XmlAttributes attributes) override {
    Level& around = levels_.back();
    Part part = inner(around.part, name);
    if (is_single(part)) {
      const std::uint32_t bit = std::uint32_t{1} << static_cast<int>(part);
      if (around.seen & bit) part = Part::kOther;  // the first counts
      around.seen |= bit;
    }
    levels_.push_back({part, 0});
    enter(part, name, attributes);
  }
  void end() override { levels_.pop_back(); }

  /// After the whole model.
  MeshBuilder& builder() { return *builder_; }
  const std::map<long, Object>& objects() const { return objects_; }
  const std::vector<Use>& items() const { return items_; }

 private:
  enum class Part : std::uint8_t {
    kFile,
    kModel,
    kResources,
    kObject,
    kMesh,
    kVertices,
    kVertex,
    kTriangles,
    kTriangle,
    kComponents,
    kComponent,
    kBuild,
    kItem,
    kOther
  };
  struct Level {
    Part part;
    std::uint32_t seen;  // which single parts it has
  };

  static Part inner(Part around, const char* name) {
    struct Row {
      Part around;
      const char* name;
      Part part;
    };
    static constexpr Row kRows[] = {{Part::kVertices, "vertex", Part::kVertex},
                                    {Part::kTriangles, "triangle", Part::kTriangle},
                                    {Part::kBuild, "item", Part::kItem},
                                    {Part::kComponents, "component", Part::kComponent},
                                    {Part::kResources, "object", Part::kObject},
                                    {Part::kObject, "mesh", Part::kMesh},
                                    {Part::kMesh, "vertices", Part::kVertices},
                                    {Part::kMesh, "triangles", Part::kTriangles},
                                    {Part::kObject, "components", Part::kComponents},
                                    {Part::kModel, "resources", Part::kResources},
                                    {Part::kModel, "build", Part::kBuild},
                                    {Part::kFile, "model", Part::kModel}};
    for (const Row& row : kRows)
      if (row.around == around && std::strcmp(row.name, name) == 0) return row.part;
    return Part::kOther;
  }

  static bool is_single(Part part) {
    return part != Part::kObject && part != Part::kVertex && part != Part::kTriangle && part != Part::kComponent &&
           part != Part::kItem && part != Part::kOther;
  }

  void enter(Part part, const char* name, XmlAttributes attributes) {
    if (!builder_ && part != Part::kModel) throw Error(ErrorCode::kSyntax, "the model file has no <model>");
    switch (part) {
      case Part::kModel:
        return model(attributes);
      case Part::kObject:
        return object(attributes);
      case Part::kMesh:
        object_->mesh = std::make_unique<MeshPart>();
        return;
      case Part::kVertex:
        return vertex(attributes);
      case Part::kTriangle:
        return triangle(attributes);
      case Part::kComponent:
        return object_->components.push_back(use(name, attributes));
      case Part::kItem:
        return items_.push_back(use(name, attributes));
      default:
        return;
    }
  }

  void model(XmlAttributes attributes) {
    const std::string_view required = text_of(attributes, "requiredextensions");
    if (!required.empty()) bad_value(fmt::format("the model requires the extension '{}', which is not read", required));
    builder_.emplace(context_, scale_(millimetres(text_of(attributes, "unit"))));
  }

  void object(XmlAttributes attributes) {
    builder_->charge(kKept, "a model of so many objects");
    const auto [place, is_new] = objects_.try_emplace(whole("object", attributes, "id"));
    if (!is_new) bad_value(fmt::format("two objects have the id {}", text_of(attributes, "id")));
    object_ = &place->second;
  }

  Use use(const char* name, XmlAttributes attributes) {
    builder_->charge(kKept, "a model of so many objects");
    const char* const placed = xml_attribute(attributes, "transform");
    if (placed && !*placed) bad_value("a transform has twelve numbers");
    return {whole(name, attributes, "objectid"), placed ? placed : ""};
  }

  void vertex(XmlAttributes attributes) {
    MeshPart& mesh = *object_->mesh;
    std::array<const char*, 3> values{};
    for (; *attributes; attributes += 2) {
      const char* const name = attributes[0];
      if (name[0] >= 'x' && name[0] <= 'z' && name[1] == 0)
        values[static_cast<std::size_t>(name[0] - 'x')] = attributes[1];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (!values[k]) bad_value(fmt::format("a <vertex> has no {}", "xyz"[k]));
      mesh.coordinates.append(values[k], std::strlen(values[k]) + 1);
    }
    ++mesh.vertices;
  }

  void triangle(XmlAttributes attributes) {
    constexpr long kMost = std::numeric_limits<int>::max();
    const auto corner = [&](const char* name) {
      return static_cast<int>(std::min(whole("triangle", attributes, name), kMost));
    };
    object_->mesh->triangles.push_back({corner("v1"), corner("v2"), corner("v3")});
  }

  static Real millimetres(std::string_view unit);

  static constexpr std::uint64_t kKept = 5;  // units for an object, a component or an item
  ReadContext& context_;
  const MeshScale& scale_;
  std::optional<MeshBuilder> builder_;
  std::vector<Level> levels_{{Part::kFile, 0}};
  std::map<long, Object> objects_;
  Object* object_ = nullptr;  // the one that is read
  std::vector<Use> items_;
};

Real ModelReader::millimetres(std::string_view unit) {
  static const std::map<std::string_view, Real> kUnits{{"", Real(1)},
                                                       {"millimeter", Real(1)},
                                                       {"micron", Real::ratio(1, 1000)},
                                                       {"centimeter", Real(10)},
                                                       {"inch", Real::ratio(254, 10)},
                                                       {"foot", Real::ratio(3048, 10)},
                                                       {"meter", Real(1000)}};
  const auto found = kUnits.find(unit);
  if (found == kUnits.end()) bad_value(fmt::format("the model has the unknown unit '{}'", unit));
  return found->second;
}

/// A transform that takes vertices on the grid to others: its factors are whole numbers, and it moves by whole steps.
class StepTransform {
 public:
  /// `step`: of the grid, in the file's unit; 0 where there is none.
  static std::optional<StepTransform> of(const MeshTransform& transform, const Real& step) {
    if (step.sign() == 0) return std::nullopt;
    StepTransform out;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Real& number = transform.row[i][k];
        const auto steps = (i < 3 ? number : number / step).integer();
        if (!steps || *steps > kMost[i] || *steps < -kMost[i]) return std::nullopt;
        out.row_[i][k] = static_cast<std::int64_t>(*steps);
      }
    }
    return out;
  }
  /// Nothing for what lies beyond the grid.
  std::optional<space::Point> apply(const std::array<std::int64_t, 3>& p) const {
    std::array<std::int64_t, 3> out = row_[3];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) out[k] += p[i] * row_[i][k];
      if (out[k] > plane::Grid::kLimit || out[k] < -plane::Grid::kLimit) return std::nullopt;
    }
    return space::Point{out[0], out[1], out[2]};
  }

 private:
  // With coordinates up to 2^40 no sum leaves 64 bits.
  static constexpr std::int64_t kMostFactor = std::int64_t{1} << 20,
                                kMost[4] = {kMostFactor, kMostFactor, kMostFactor, plane::Grid::kLimit};
  std::array<std::array<std::int64_t, 3>, 4> row_{};
};

/// The vertices of a mesh, one after the other.
class Vertices {
 public:
  explicit Vertices(const MeshPart& mesh) : at_(mesh.coordinates.data()) {}
  std::array<std::string_view, 3> next() {
    std::array<std::string_view, 3> out;
    for (std::string_view& text : out) {
      text = at_;
      at_ += text.size() + 1;
    }
    return out;
  }

 private:
  const char* at_;
};

/// Builds what the items say.
class Build {
 public:
  Build(const std::map<long, Object>& objects, MeshBuilder& out) : objects_(objects), out_(out) {}

  void object(const Use& use, const MeshTransform& around, int depth) {
    const auto found = objects_.find(use.object);
    if (found == objects_.end()) bad_value(fmt::format("there is no object {}", use.object));
    if (depth > kMostDepth) bad_value(fmt::format("object {} is a component of itself, or of too many", use.object));
    const MeshTransform placed = around.after(transform(use.transform));
    if (const MeshPart* const mesh = found->second.mesh.get()) {
      if (!placed_.insert(use.object).second) charge_again(*mesh);
      return add(*mesh, placed);
    }
    for (const Use& part : found->second.components) {
      if (++components_ > kMostComponents) bad_value("there are more than 100,000 components");
      object(part, placed, depth + 1);
    }
  }

 private:
  /// What one file repeats is not bounded by its length.
  void charge_again(const MeshPart& mesh) {
    out_.charge(kAgain * (mesh.vertices + mesh.triangles.size()), "placing one mesh so often");
  }

  void add(const MeshPart& mesh, const MeshTransform& placed) {
    const int sense = placed.sense();
    if (sense == 0) bad_value("a transform flattens what it places");
    const auto first = static_cast<int>(out_.size()), count = static_cast<int>(mesh.vertices);
    add_vertices(mesh, placed);
    for (const std::array<int, 3>& corners : mesh.triangles) {
      if (*std::max_element(corners.begin(), corners.end()) >= count)
        bad_value("a triangle refers to a vertex that is not there");
      std::vector<int> face{first + corners[0], first + corners[1], first + corners[2]};
      if (sense < 0) std::reverse(face.begin(), face.end());
      out_.face(std::move(face));
    }
  }

  void add_vertices(const MeshPart& mesh, const MeshTransform& placed) {
    const auto by_steps = StepTransform::of(placed, out_.step());
    Vertices vertices(mesh);
    out_.expect(mesh.vertices);
    for (std::size_t i = 0; i < mesh.vertices; ++i) {
      const std::array<std::string_view, 3> written = vertices.next();
      if (const auto on_grid = by_steps ? in_steps(written, *by_steps) : std::nullopt)
        out_.vertex(*on_grid);
      else
        out_.vertex(placed.apply({decimal("x", written[0]), decimal("y", written[1]), decimal("z", written[2])}));
    }
  }

  std::optional<space::Point> in_steps(const std::array<std::string_view, 3>& written,
                                       const StepTransform& placed) const {
    std::array<std::int64_t, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto steps = exact::grid_integer(written[k], out_.step());
      if (!steps) return std::nullopt;
      at[k] = *steps;
    }
    return placed.apply(at);
  }

  static Real decimal(const char* name, std::string_view text) {
    try {
      return Real::parse_decimal(text);
    } catch (const Error&) {
      bad_value(fmt::format("a <vertex> has the {} '{}', which is not a number", name, text));
    }
  }

  static constexpr int kMostComponents = 100000;
  static constexpr std::uint64_t kAgain = 10;  // units for a vertex or a triangle
  const std::map<long, Object>& objects_;
  MeshBuilder& out_;
  std::set<long> placed_;
  int components_ = 0;
};

/// Finds the member that a package names as its model.
class ModelName : public XmlListener {
 public:
  void begin(const char* name, XmlAttributes attributes) override {
    const int depth = depth_++;
    if (depth == 0) named_ = std::strcmp(name, "Relationships") == 0;
    if (depth != 1 || !named_ || target_ || std::strcmp(name, "Relationship") != 0) return;
    if (text_of(attributes, "Type") == kModelType3mf) target_ = text_of(attributes, "Target");
  }
  void end() override { --depth_; }
  std::string name() const {
    if (!target_) return kModel3mf;
    return target_->starts_with('/') ? target_->substr(1) : *target_;
  }

 private:
  int depth_ = 0;
  bool named_ = false;
  std::optional<std::string> target_;
};

/// False where there is no such member.
bool read_xml(const ZipArchive& archive, const std::string& name, ReadContext& context, XmlListener& listener) {
  XmlStream stream(listener, name);
  if (!archive.read(name, context, [&](std::string_view piece) { stream.take(piece); })) return false;
  stream.finish();
  return true;
}

/// Where the relations of the package cannot be read, that of most packages.
std::string model_name(const ZipArchive& archive, ReadContext& context) {
  ModelName named;
  try {
    read_xml(archive, "_rels/.rels", context, named);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kSyntax && e.code() != ErrorCode::kUnsupported) throw;
    return kModel3mf;
  }
  return named.name();
}

}  // namespace

space::Mesh read_3mf(std::string_view bytes, ReadContext& context, const MeshScale& scale) {
  const ZipArchive archive(bytes);
  const std::string name = model_name(archive, context);
  ModelReader model(context, scale);
  if (!read_xml(archive, name, context, model)) throw Error(ErrorCode::kFile, "the package has no 3D model");
  Build build(model.objects(), model.builder());
  for (const Use& item : model.items()) build.object(item, {}, 0);
  if (model.builder().mesh().faces.empty()) bad_value("nothing with triangles is built");
  return std::move(model.builder().mesh());
}

}  // namespace findspace::io
