// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/read_solids.h"

#include <findspace/error.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "io/cad/read_cad.h"
#include "io/mesh/read_mesh.h"
#include "io/nesting/nesting_json.h"
#include "io/nesting/stated_conditions.h"
#include "io/nesting/write_solids.h"
#include "io/scene/scene_rotation.h"
#include "io/scene/scene_shapes.h"
#include "io/text/file_kind.h"
#include "packing/solid_problem/container_shape.h"
#include "packing/solid_problem/solid_pair_formula.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace {

using packing::Fraction;
using Kind = JsonValue::Kind;

constexpr int kMostDigits = 9;
constexpr int kCadDigits = 6;  // as scenes have it: curved faces have no coordinates of their own

using Key = std::string_view;
constexpr std::array<Key, 12> kKeys{
    "name", "container", "containers", "item-types", "shapes", "allowed_orientations",
    "gaps", "pairs",     "where",      "groups",     "fixed",  "comment"};  // of data sets
constexpr std::array<Key, 6> kItemKeys{"id", "demand", "path", "shape", "allowed_orientations", "value"};
constexpr std::array<Key, 2> kFloorKeys{"size-x", "size-y"};
constexpr std::array<Key, 8> kContainerKeys{"id", "count", "cost", "size-x", "size-y", "size-z", "shape", "path"};
constexpr std::array<Key, 6> kFixedSolidKeys{"part", "copy", "at", "rotation", "container", "number"};
constexpr std::array<std::pair<Key, std::span<const Key>>, 6> kKeysOfLists{{{"item-types", kItemKeys},
                                                                            {"containers", kContainerKeys},
                                                                            {"fixed", kFixedSolidKeys},
                                                                            {"gaps", kGapKeys},
                                                                            {"pairs", kPairKeys},
                                                                            {"groups", kGroupKeys}}};

/// "Stoyan et al. 2005" as a folder of the data sets is named: "stoyan2005".
std::string short_folder(const std::string& words) {
  std::string first, year;
  for (std::size_t i = 0; i < words.size() && std::isalpha(static_cast<unsigned char>(words[i])) != 0; ++i)
    first += char(std::tolower(static_cast<unsigned char>(words[i])));
  for (const char c : words)
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) year += c;
  return first + year;
}

/// The file of an item: at its path from the folder of the problem; or, as the data sets have it, where the first
/// folder of the path is that of the problem, or one beside it or above, by its short name.
std::filesystem::path found_file(const std::filesystem::path& folder, const std::filesystem::path& path) {
  if (path.is_absolute() || std::filesystem::exists(folder / path) || path.begin() == path.end()) return folder / path;
  const std::string first = path.begin()->string();
  std::filesystem::path rest;
  for (auto part = std::next(path.begin()); part != path.end(); ++part) rest /= *part;
  if (rest.empty()) return folder / path;
  if (std::filesystem::exists(folder / rest)) return folder / rest;
  for (const char* above : {"..", "../.."}) {
    const std::filesystem::path other = folder / above / short_folder(first) / rest;
    if (std::filesystem::exists(other)) return other;
  }
  return folder / path;
}

class SolidReader : private NestingJson {
 public:
  SolidReader(const std::string& text, const std::string& name, const ReadOptions& options)
      : NestingJson(text, name), options_(options), size_(text.size()) {}

  SolidProblemRead problem(const NestingOptions& asked) {
    ReadContext context(options_);
    context.folder = std::filesystem::path(name()).parent_path();
    context.take_bytes(size_, name());
    check_keys(context);
    const int digits = digits_needed(context);
    context.grid = grid_of(digits);
    SolidProblemRead result = read(context, asked, digits);
    for (std::size_t k = 0; k < shapes_.size(); ++k) stand(result.problem.parts[k], k);
    read_conditions(*this, names_of(result.problem.parts), 3, result.stated);
    result.problem.pair_gaps = result.stated.gaps;
    result.problem.conditions =
        conditions_of(result.stated, result.problem.parts.size(), farthest_gap(result.problem), name());
    packing::check_conditions(result.problem, name());
    result.shapes = std::move(shapes_);
    packing::check(result.problem, name());
    if (const JsonValue* fixed = tree().find("fixed")) {
      for (const JsonValue& item : list(*fixed).items())
        result.problem.fixed.push_back(fixed_solid(item, result.problem));
      check_fixed(result.problem, place(*fixed));
    }
    return result;
  }

  packing::SolidLayout layout(const packing::SolidProblem& problem) const {
    const JsonValue& body = need(tree(), "layout");
    packing::SolidLayout result;
    result.height = number(need(body, "height"));
    for (const JsonValue& item : list(need(body, "items")).items()) {
      packing::SolidPlaced& placed = result.items.emplace_back(placed_solid(item, problem));
      if (const JsonValue* container = item.find("container")) placed.container = std::size_t(whole(*container));
    }
    if (problem.in_containers())
      for (const JsonValue& container : list(need(need(body, "container"), "containers")).items())
        result.containers.push_back(index_of(container, problem.containers, "container"));
    if (const JsonValue* left = body.find("left_out")) result.left_out = left_out(*left, problem.parts);
    return result;
  }

 private:
  /// Without its container.
  packing::SolidPlaced placed_solid(const JsonValue& item, const packing::SolidProblem& problem) const {
    packing::SolidPlaced placed;
    placed.part = index_of(need(item, "part"), problem.parts, "part");
    if (const JsonValue* copy = item.find("copy")) placed.copy = whole(*copy);
    const packing::SolidRotation stands =
        item.find("rotation") != nullptr ? rotation(*item.find("rotation")) : packing::as_given();
    const std::vector<packing::SolidForm>& forms = problem.parts[placed.part].forms;
    const auto same = [&](const packing::SolidForm& form) { return form.rotation == stands; };
    placed.form = std::size_t(std::find_if(forms.begin(), forms.end(), same) - forms.begin());
    if (placed.form == forms.size())
      fail(item, fmt::format("'{}' stands in an orientation that is not allowed", problem.parts[placed.part].name));
    const JsonValue& at = list(need(item, "at"));
    if (at.size() != 3) fail(at, "a position in space is a list of three numbers");
    for (std::size_t k = 0; k < 3; ++k) placed.at[k] = number(at.items()[k]);
    return placed;
  }

  /// "container" names a kind, "number" counts its containers from 1.
  packing::FixedSolid fixed_solid(const JsonValue& value, const packing::SolidProblem& problem) const {
    packing::FixedSolid result{placed_solid(value, problem), 0};
    if (!problem.in_containers()) {
      for (const char* key : {"container", "number"})
        if (const JsonValue* said = value.find(key)) fail(*said, "a container is said, but there is only a floor");
      return result;
    }
    result.kind = index_of(need(value, "container"), problem.containers, "container");
    const packing::SolidContainer& kind = problem.containers[result.kind];
    const JsonValue* counted = value.find("number");
    const int count = counted != nullptr ? whole(*counted) : 1;
    if (count < 1 || count > kind.count)
      fail(value, fmt::format("there is no container {} number {}", kind.name, count));
    result.placed.container = std::size_t(count - 1);
    return result;
  }

  /// Of all objects but shapes, which have their own reader.
  void check_keys(ReadContext& context) const {
    if (const JsonValue* unit = tree().find("unit"))
      fail(*unit, "a problem of solids has no unit: the numbers of meshes are taken as they are, STEP and IGES in mm");
    const SceneReader json(name(), context);
    json.check_keys(tree(), kKeys, {});
    for (const auto& [list, keys] : kKeysOfLists)
      if (const JsonValue* values = tree().find(list); values != nullptr && values->is(Kind::kArray))
        for (const JsonValue& value : values->items())
          if (value.is(Kind::kObject)) json.check_keys(value, keys, {});
    if (const JsonValue* floor = tree().find("container"); floor != nullptr && floor->is(Kind::kObject))
      json.check_keys(*floor, kFloorKeys, {});
  }

  static Grid grid_of(int digits) { return Grid(exact::Real(1) / exact::Real(packing::power_of_ten(digits))); }

  /// Of all numbers of shapes, and of all vertices in files, which are read on the way.
  int digits_needed(ReadContext& context) {
    int digits = 0;
    if (const JsonValue* named = tree().find("shapes")) digits = digits_in(*named, kMostDigits);
    const auto look_at = [&](const JsonValue& value) {
      if (const JsonValue* shape = value.find("shape")) digits = std::max(digits, digits_in(*shape, kMostDigits));
      if (const JsonValue* path = value.find("path")) digits = std::max(digits, digits_of_file(*path, context));
    };
    for (const JsonValue& item : list(need(tree(), "item-types")).items()) {
      need(item, "demand");  // an object
      look_at(item);
    }
    if (const JsonValue* containers = tree().find("containers"))
      for (const JsonValue& container : list(*containers).items()) {
        need(container, "id");
        look_at(container);
      }
    return digits;
  }

  int digits_of_file(const JsonValue& path, ReadContext& context) {
    if (!path.is(Kind::kString)) fail(path, fmt::format("a path is meant, not {}", path.kind_name()));
    const std::filesystem::path file = found_file(context.folder, path.text());
    auto known = files_.find(path.text());
    if (known == files_.end()) known = files_.emplace(path.text(), File{file, context.take_file(file)}).first;
    if (is_cad_ending(lower_ending(file.extension().string()))) return kCadDigits;
    int digits = 0;
    for (; digits < kMostDigits; ++digits) {
      ReadContext trial(options_);
      trial.grid = grid_of(digits);
      vertices_and_faces(known->second, trial);
      if (trial.rounding.points == 0) break;
    }
    return digits;
  }

  struct File {
    std::filesystem::path path;
    std::string bytes;
  };

  static space::Mesh vertices_and_faces(const File& file, ReadContext& context) {
    try {
      const std::string ending = lower_ending(file.path.extension().string());
      require_kind(file.bytes, ending, file.path.string());
      context.use(context.options.drawings);
      return parse_mesh(file.bytes, ending, context, [](const auto&) { return exact::Real(1); });
    } catch (const Error& e) {
      throw e.within(file.path.string());
    }
  }

  SolidProblemRead read(ReadContext& context, const NestingOptions& asked, int digits) {
    SolidProblemRead result;
    packing::SolidProblem& problem = result.problem;
    problem.digits = digits;
    if (const JsonValue* named = tree().find("name")) problem.name = named->text();
    problem.gap = asked.gap;
    problem.edge = asked.edge;
    if (problem.gap < 0 || problem.edge < 0) throw Error(ErrorCode::kBadValue, "a gap or an edge below 0", name());
    const SceneReader json(name(), context);
    const JsonValue none(Kind::kObject);
    const JsonValue* named = tree().find("shapes");
    ShapeReader shapes(json, named != nullptr ? *named : none);
    read_containers(result, shapes, context);
    for (const JsonValue& item : list(need(tree(), "item-types")).items()) {
      problem.parts.push_back(part(item, shapes, context));
      check_name(item, problem.parts, "items");
    }
    result.notes = context.summary();
    return result;
  }

  /// A floor on which the height is sought, or containers of given sizes.
  void read_containers(SolidProblemRead& read, ShapeReader& shapes, ReadContext& context) const {
    packing::SolidProblem& problem = read.problem;
    const JsonValue *floor = tree().find("container"), *containers = tree().find("containers");
    if (containers == nullptr) {
      problem.width = number(need(*floor, "size-x"));
      problem.depth = number(need(*floor, "size-y"));
      return;
    }
    if (floor != nullptr) fail(*containers, "a problem has either a 'container' or 'containers'");
    for (const JsonValue& value : list(*containers).items()) {
      packing::SolidContainer& container = problem.containers.emplace_back();
      container.name = need(value, "id").text();
      if (const JsonValue* count = value.find("count")) container.count = whole(*count);
      if (const JsonValue* cost = value.find("cost")) container.cost = not_below_0(*cost, "cost");
      read.container_shapes.push_back(container_shape(value, shapes, context));
      if (read.container_shapes.back() != nullptr)
        set_shape(value, *read.container_shapes.back(), problem);
      else
        set_sizes(value, container);
      check_name(value, problem.containers, "containers");
      if (container.cost.has_value() != problem.containers[0].cost.has_value())
        fail(value, "some containers have a cost and others none");
    }
    if (problem.containers.empty()) fail(*containers, "there are no containers");
  }

  void set_sizes(const JsonValue& value, packing::SolidContainer& container) const {
    container.width = number(need(value, "size-x"));
    container.depth = number(need(value, "size-y"));
    container.height = number(need(value, "size-z"));
    if (container.width <= 0 || container.depth <= 0 || container.height <= 0)
      fail(value, "a container has sizes above 0");
  }

  /// Null of a box that is given by its sizes.
  plane::ShapePtr container_shape(const JsonValue& value, ShapeReader& shapes, ReadContext& context) const {
    const JsonValue *path = value.find("path"), *shape = value.find("shape");
    if (path == nullptr && shape == nullptr) return nullptr;
    if (path != nullptr && shape != nullptr) fail(value, "a container has either a 'path' or a 'shape'");
    for (const char* key : {"size-x", "size-y", "size-z"})
      if (const JsonValue* size = value.find(key)) fail(*size, "a container has either sizes or a shape of its own");
    if (path != nullptr) return from_file(*path, context);
    return shapes.shape(*shape, Label{nullptr, "container", need(value, "id").text()});
  }

  /// Of the last container.
  void set_shape(const JsonValue& value, const plane::Shape& shape, packing::SolidProblem& problem) const {
    packing::SolidContainer& container = problem.containers.back();
    try {
      packing::set_shape(container, shape, problem.steps());
    } catch (const Error& e) {
      throw e.within(fmt::format("container '{}' ({})", container.name, place(value)));
    }
  }

  Fraction not_below_0(const JsonValue& value, const char* what) const {
    const Fraction result = number(value);
    if (result < 0) fail(value, fmt::format("a {} below 0", what));
    return result;
  }

  packing::SolidPart part(const JsonValue& item, ShapeReader& shapes, ReadContext& context) {
    packing::SolidPart result;
    result.demand = whole(need(item, "demand"));
    if (const JsonValue* value = item.find("value")) result.value = not_below_0(*value, "value");
    const JsonValue *id = item.find("id"), *path = item.find("path"), *shape = item.find("shape");
    if ((path != nullptr) + (shape != nullptr) != 1) fail(item, "an item has either a 'path' or a 'shape'");
    if (path != nullptr) {
      result.name = std::filesystem::path(path->text()).stem().string();
      shapes_.push_back(from_file(*path, context));
    } else {
      const Label label{nullptr, "item", id != nullptr ? id->text() : std::string_view()};
      shapes_.push_back(shapes.shape(*shape, label));
      if (shapes.dimension() == 2)
        fail(*shape, fmt::format("this is a shape of the plane: {} needs one of space", label.text()));
      result.name = shape->is(Kind::kString) ? shape->text() : "";
    }
    if (id != nullptr) result.name = id->text();
    if (result.name.empty()) fail(item, "an item without a file needs an 'id'");
    places_.push_back(place(item));
    const JsonValue* allowed = item.find("allowed_orientations");
    if (allowed == nullptr) allowed = tree().find("allowed_orientations");
    rotations_.push_back(allowed != nullptr ? rotations(*allowed, context) : std::vector{packing::as_given()});
    return result;
  }

  /// "right-angles", "upright", or a list of orientations as scenes spell them, or of matrices row by row.
  std::vector<packing::SolidRotation> rotations(const JsonValue& value, ReadContext& context) const {
    if (value.is(Kind::kString) && value.text() == "right-angles") return packing::axis_rotations(false);
    if (value.is(Kind::kString) && value.text() == "upright") return packing::axis_rotations(true);
    if (!value.is(Kind::kArray) || value.size() == 0)
      fail(value, "orientations are \"right-angles\", \"upright\" or a list of them");
    const SceneReader json(name(), context);
    std::vector<packing::SolidRotation> result;
    for (const JsonValue& one : value.items())
      result.push_back(one.is(Kind::kArray) ? rotation(one) : orientation(one, json));
    return result;
  }

  packing::SolidRotation orientation(const JsonValue& value, const SceneReader& json) const {
    const Orientation read =
        read_orientation(value, nullptr, GridPosition{}, json, Label{nullptr, "orientation", std::string_view()});
    try {
      return packing::exact_rotation(read.rotation);
    } catch (const Error& e) {
      throw e.within(place(value));
    }
  }

  packing::SolidRotation rotation(const JsonValue& value) const {
    packing::SolidRotation result{};
    space::Rotation::Matrix rows;
    if (list(value).size() != 3) fail(value, "a rotation is a list of three rows");
    for (std::size_t r = 0; r < 3; ++r) {
      if (list(value.items()[r]).size() != 3) fail(value.items()[r], "a row of a rotation is a list of three numbers");
      for (std::size_t c = 0; c < 3; ++c) {
        result[r][c] = number(value.items()[r].items()[c]);
        rows[r][c] = packing::in_steps(result[r][c], 1);
      }
    }
    try {
      space::Rotation::of_matrix(rows, {});
    } catch (const Error& e) {
      throw e.within(place(value));
    }
    return result;
  }

  plane::ShapePtr from_file(const JsonValue& path, ReadContext& context) const {
    const File& file = files_.find(path.text())->second;
    space::Solid solid;
    solid.form = space::Solid::Form::kMesh;
    solid.mesh = vertices_and_faces(file, context);
    const std::string name = file.path.filename().string();
    try {
      const space::Mesh raw = solid.mesh;
      std::vector<std::string> notes = space::clean(solid.mesh, context.grid.step_size(), repair_of(raw, context));
      if (auto taken = take_loose_vertices(raw, solid)) notes = {*std::move(taken)};
      for (const std::string& note : notes) context.notes.push_back(fmt::format("{}: {}", name, note));
      plane::Shape shape;
      shape.solid = std::make_shared<const space::Solid>(std::move(solid));
      return share(std::move(shape));
    } catch (const Error& e) {
      throw e.within(file.path.string());
    }
  }

  static space::MeshRepair repair_of(const space::Mesh& mesh, const ReadContext& context) {
    space::MeshRepair how = context.drawing.repair;
    how.width = std::max(how.width, slit_of(mesh));
    return how;
  }

  /// How wide slits can be that stem from rounded vertices: some steps, if the mesh has many.
  static std::int64_t slit_of(const space::Mesh& mesh) {
    constexpr std::int64_t kSteps = 16, kPartOfSize = std::int64_t{1} << 20;
    std::int64_t most = 0;
    for (const space::Point& p : mesh.vertices) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return std::min(kSteps, most / kPartOfSize);
  }

  /// A convex surface that leaves out some of its file's vertices stands for the hull of all of them; returns the note.
  static std::optional<std::string> take_loose_vertices(const space::Mesh& raw, space::Solid& solid) {
    std::vector<char> used(raw.vertices.size());
    for (const std::vector<int>& face : raw.faces)
      for (const int v : face) used[std::size_t(v)] = 1;
    const auto loose = std::count(used.begin(), used.end(), 0);
    if (loose == 0 || !space::is_convex(solid.mesh)) return std::nullopt;
    solid.form = space::Solid::Form::kPolytope;
    solid.mesh = raw;
    return fmt::format("{} no face; the convex hull of all vertices is taken",
                       loose == 1 ? "1 vertex belongs to" : fmt::format("{} vertices belong to", loose));
  }

  void stand(packing::SolidPart& part, std::size_t k) const {
    try {
      packing::set_forms(part, *shapes_[k], rotations_[k]);
    } catch (const Error& e) {
      const std::string item = fmt::format("item '{}'", part.name);
      if (e.place().starts_with(item)) throw;
      throw e.within(fmt::format("{} ({})", item, places_[k]));
    }
  }

  const ReadOptions& options_;
  std::size_t size_;
  std::map<std::string, File, std::less<>> files_;
  std::vector<plane::ShapePtr> shapes_;
  std::vector<std::string> places_;
  std::vector<std::vector<packing::SolidRotation>> rotations_;  // of each item
};

}  // namespace

std::optional<Fraction> farthest_gap(const packing::SolidProblem& problem) {
  std::optional<Fraction> result;
  for (const packing::SolidContainer& c : problem.containers)
    result = std::max(result.value_or(0), c.width + c.depth + c.height);
  return result;
}

void check_fixed(const packing::SolidProblem& problem, const std::string& place) {
  if (problem.fixed.empty()) return;
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    if (problem.free_copies(part) < 0)
      throw Error(ErrorCode::kBadValue,
                  fmt::format("more copies of '{}' are fixed than its demand", problem.parts[part].name), place);
  const packing::SolidLayout layout = layout_of_fixed(problem);
  for (std::size_t k = 0; k < layout.containers.size(); ++k)
    if (std::none_of(layout.items.begin(), layout.items.end(), [&](const auto& item) { return item.container == k; }))
      throw Error(ErrorCode::kBadValue,
                  fmt::format("containers '{}' with fixed solids are numbered from 1 on, without a gap",
                              problem.containers[layout.containers[k]].name),
                  place);
  const packing::SolidVerdict verdict = packing::verify(problem, layout);
  if (!verdict.is_feasible())
    throw Error(ErrorCode::kGeometry, "fixed: " + fault_text(problem, layout, verdict.faults[0]), place);
}

bool is_solid_problem(const std::string& text, const std::string& name) {
  const NestingJson json(text, name);
  return (json.tree().find("container") != nullptr || json.tree().find("containers") != nullptr) &&
         json.tree().find("item-types") != nullptr;
}

SolidProblemRead read_solids(const std::string& text, const std::string& name, const NestingOptions& asked,
                             const ReadOptions& options) {
  return SolidReader(text, name, options).problem(asked);
}

packing::SolidLayout read_solid_layout(const std::string& text, const std::string& name,
                                       const packing::SolidProblem& problem) {
  return SolidReader(text, name, {}).layout(problem);
}

}  // namespace findspace::io
