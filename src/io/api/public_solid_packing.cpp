// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing of solids as the public header shows it: problems and layouts as values with names, put on one grid and back.

#include <findspace/error.h>
#include <findspace/solid_packing.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <utility>

#include "api/values/shape_data.h"
#include "io/api/last_verdict.h"
#include "io/api/public_packing.h"
#include "io/api/public_search.h"
#include "io/nesting/read_solids.h"
#include "io/nesting/write_solids.h"
#include "packing/solid_problem/container_shape.h"
#include "packing/solid_problem/solid_pair_formula.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_search/make_solid_room.h"
#include "packing/solid_search/proved_search.h"
#include "space/shape/rotation.h"

namespace findspace {
namespace {

using packing::Fraction;
using packing::SolidLayout;
using packing::SolidProblem;
using packing::SolidRotation;

Orientation shown(const SolidRotation& rotation) {
  Orientation result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result.rows[r][c] = rotation[r][c].text();
  return result;
}

SolidRotation rotation_of(const Orientation& orientation) {
  SolidRotation result;
  space::Rotation::Matrix rows;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      result[r][c] = io::fraction(orientation.rows[r][c]);
      rows[r][c] = packing::in_steps(result[r][c], 1);
    }
  space::Rotation::of_matrix(rows, {});  // refuses what is no rotation
  return result;
}

std::vector<Orientation> all_shown(const std::vector<SolidRotation>& rotations) {
  std::vector<Orientation> result;
  for (const SolidRotation& rotation : rotations) result.push_back(shown(rotation));
  return result;
}

plane::Grid decimal_grid(int digits) {
  return plane::Grid(exact::Real(1) / exact::Real(packing::power_of_ten(digits)));
}

/// The digits of a decimal grid that holds the shapes.
int digits_of(const SolidPackProblem& problem) {
  constexpr int kMost = 9;
  int digits = 0;
  const auto look_at = [&](const Shape& shape, const std::string& place) {
    while (!(shape.data().grid.step() * exact::Real(packing::power_of_ten(digits))).integer())
      if (++digits > kMost) throw Error(ErrorCode::kUnsupported, "its grid has no decimal step of nine digits", place);
  };
  for (const PackSolid& part : problem.parts) look_at(part.shape, "part '" + part.name + "'");
  for (const PackContainer& container : problem.containers)
    if (container.shape) look_at(*container.shape, "container '" + container.name + "'");
  return digits;
}

packing::SolidPart part_of(const PackSolid& part, const plane::Grid& grid) try {
  packing::SolidPart result{part.name, io::count_of(part.count), {}, true, io::amount_of(part.value)};
  if (part.shape.dimension() != 3) throw Error(ErrorCode::kUnsupported, "parts are shapes of space");
  std::vector<SolidRotation> rotations;
  for (const Orientation& orientation : part.orientations) rotations.push_back(rotation_of(orientation));
  if (rotations.empty()) rotations.push_back(packing::as_given());
  packing::set_forms(result, *api::tree_on(part.shape, grid), rotations);
  return result;
} catch (const Error& e) {
  throw e.within("part '" + part.name + "'");
}

void set_shape(packing::SolidContainer& result, const PackContainer& container, int digits) try {
  if (result.width != 0 || result.depth != 0 || result.height != 0)
    throw Error(ErrorCode::kBadValue, "it has either sizes or a shape of its own");
  if (container.shape->dimension() != 3) throw Error(ErrorCode::kUnsupported, "containers are shapes of space");
  packing::set_shape(result, *api::tree_on(*container.shape, decimal_grid(digits)), packing::power_of_ten(digits));
} catch (const Error& e) {
  throw e.within("container '" + container.name + "'");
}

packing::SolidContainer container_of(const PackContainer& container, bool costs, int digits) {
  packing::SolidContainer result{container.name,
                                 io::count_of(container.count),
                                 io::amount_of(container.cost),
                                 io::fraction(container.width),
                                 io::fraction(container.depth),
                                 io::fraction(container.height)};
  if (container.shape) set_shape(result, container, digits);
  if (result.width <= 0 || result.depth <= 0 || result.height <= 0)
    throw Error(ErrorCode::kBadValue, "a container has sizes above 0", "container '" + container.name + "'");
  if (result.cost.has_value() != costs)
    throw Error(ErrorCode::kBadValue, "some containers have a cost and others none");
  return result;
}

std::array<Fraction, 3> exact_place(const Point3& at) {
  return {io::fraction(at.x), io::fraction(at.y), io::fraction(at.z)};
}

/// A copy of a part in a form of it.
packing::SolidPlaced standing(const SolidProblem& problem, const std::string& part, const Orientation& orientation,
                              const Point3& at) {
  packing::SolidPlaced result;
  result.part = io::index_of(part, problem.parts, "part");
  result.at = exact_place(at);
  const SolidRotation rotation = rotation_of(orientation);
  const std::vector<packing::SolidForm>& forms = problem.parts[result.part].forms;
  const auto same = [&](const packing::SolidForm& form) { return form.rotation == rotation; };
  result.form = std::size_t(std::find_if(forms.begin(), forms.end(), same) - forms.begin());
  if (result.form == forms.size())
    throw Error(ErrorCode::kBadValue, "'" + part + "' stands in an orientation that is not allowed");
  return result;
}

packing::SolidPlaced placed_of(const SolidProblem& problem, const PlacedSolid& item) {
  packing::SolidPlaced result = standing(problem, item.part, item.orientation, item.at);
  result.copy = item.copy;
  result.container = item.container;
  return result;
}

packing::FixedSolid fixed_of(const SolidProblem& problem, const FixedSolid& fixed) {
  packing::FixedSolid result{standing(problem, fixed.part, fixed.orientation, fixed.at)};
  if (!problem.in_containers()) {
    if (!fixed.container.empty() || fixed.number != 1)
      throw Error(ErrorCode::kBadValue, "a container is said, but there is only a floor",
                  "fixed solid '" + fixed.part + "'");
    return result;
  }
  result.kind = io::index_of(fixed.container, problem.containers, "container");
  if (fixed.number < 1 || fixed.number > problem.containers[result.kind].count)
    throw Error(ErrorCode::kBadValue, fmt::format("there is no container {} number {}", fixed.container, fixed.number));
  result.placed.container = std::size_t(fixed.number - 1);
  return result;
}

SolidProblem on_grid(const SolidPackProblem& problem) {
  SolidProblem result;
  result.name = problem.name;
  result.width = io::fraction(problem.width, "width");
  result.depth = io::fraction(problem.depth, "depth");
  result.gap = io::fraction(problem.gap, "gap");
  result.edge = io::fraction(problem.edge, "edge");
  if (result.gap < 0 || result.edge < 0) throw Error(ErrorCode::kBadValue, "a gap or an edge below 0");
  if (!problem.containers.empty() && (result.width != 0 || result.depth != 0))
    throw Error(ErrorCode::kBadValue, "a problem has either a floor or containers");
  result.digits = digits_of(problem);
  for (const PackContainer& container : problem.containers)
    result.containers.push_back(container_of(container, problem.containers[0].cost.has_value(), result.digits));
  io::check_names(result.containers, "containers");
  const plane::Grid grid = decimal_grid(result.digits);
  for (const PackSolid& part : problem.parts) result.parts.push_back(part_of(part, grid));
  io::check_names(result.parts, "parts");
  const io::StatedConditions stated = io::stated_of(problem, result.parts);
  result.pair_gaps = stated.gaps;
  result.conditions = io::conditions_of(stated, result.parts.size(), io::farthest_gap(result), "pack");
  packing::check_conditions(result, "pack");
  packing::check(result, "pack");
  for (const FixedSolid& fixed : problem.fixed) result.fixed.push_back(fixed_of(result, fixed));
  io::check_fixed(result, "pack");
  return result;
}

SolidPackLayout public_layout(const SolidProblem& problem, const SolidLayout& layout) {
  SolidPackLayout result;
  result.height = layout.height.text();
  for (const packing::SolidPlaced& item : layout.items)
    result.items.push_back({problem.parts[item.part].name,
                            item.copy,
                            item.container,
                            shown(packing::form_of(problem, item).rotation),
                            {item.at[0].text(), item.at[1].text(), item.at[2].text()}});
  for (const packing::LeftOut& out : layout.left_out)
    result.left_out.push_back({problem.parts[out.part].name, out.copies, out.why});
  for (const std::size_t kind : layout.containers) result.containers.push_back(problem.containers[kind].name);
  const double room = packing::container_volume(problem, layout);
  result.density = room > 0 ? packing::volume(problem, layout) / room : 0;
  return result;
}

SolidLayout layout_of(const SolidProblem& problem, const SolidPackLayout& layout) {
  SolidLayout result;
  result.height = io::fraction(layout.height);
  for (const PlacedSolid& item : layout.items) result.items.push_back(placed_of(problem, item));
  for (const LeftOutPart& out : layout.left_out)
    result.left_out.push_back({io::index_of(out.part, problem.parts, "part"), io::count_of(out.copies), out.why});
  for (const std::string& name : layout.containers)
    result.containers.push_back(io::index_of(name, problem.containers, "container"));
  for (const packing::SolidPlaced& item : result.items)
    if (problem.in_containers() ? item.container >= result.containers.size() : item.container > 0)
      throw Error(ErrorCode::kBadValue, fmt::format("the layout has no container {}", item.container));
  return result;
}

PackFault::Kind kind_of(packing::SolidFault::Kind kind) {
  using From = packing::SolidFault::Kind;
  using To = PackFault::Kind;
  switch (kind) {
    case From::kOverlap:
      return To::kOverlap;
    case From::kGap:
      return To::kGap;
    case From::kOutside:
      return To::kOutside;
    case From::kCount:
      return To::kCount;
    case From::kContainers:
      return To::kContainers;
    case From::kFixed:
      return To::kFixed;
    case From::kCondition:
      break;
  }
  return To::kCondition;
}

PackFault public_fault(const SolidProblem& problem, const SolidLayout& layout, const packing::SolidFault& fault) {
  using Kind = packing::SolidFault::Kind;
  PackFault result{kind_of(fault.kind),
                   {},
                   fault.depth,
                   {fault.at[0], fault.at[1], fault.at[2]},
                   io::fault_text(problem, layout, fault)};
  const bool of_part = fault.kind == Kind::kCount || fault.kind == Kind::kFixed;
  result.of.push_back(of_part                           ? problem.parts[fault.first].name
                      : fault.kind == Kind::kContainers ? problem.containers[fault.first].name
                                                        : io::item_name(problem, layout, fault.first));
  if (fault.kind <= Kind::kGap || fault.kind == Kind::kCondition)
    result.of.push_back(io::item_name(problem, layout, fault.second));
  return result;
}

PackContainer public_container(const packing::SolidContainer& c, const plane::ShapePtr& shape,
                               const plane::Grid& grid) {
  PackContainer result{c.name, 0, 0, 0, c.count, io::public_amount(c.cost)};
  if (shape != nullptr) {
    result.shape = api::make_shape(shape, grid, 3);
    return result;
  }
  result.width = c.width.text();
  result.depth = c.depth.text();
  result.height = c.height.text();
  return result;
}

SolidPackProblem public_problem(const io::SolidProblemRead& read) {
  const SolidProblem& inner = read.problem;
  SolidPackProblem result;
  result.name = inner.name;
  result.width = inner.width.text();
  result.depth = inner.depth.text();
  result.gap = inner.gap.text();
  result.edge = inner.edge.text();
  const plane::Grid grid = decimal_grid(inner.digits);
  for (std::size_t k = 0; k < inner.containers.size(); ++k)
    result.containers.push_back(public_container(inner.containers[k], read.container_shapes[k], grid));
  for (std::size_t k = 0; k < inner.parts.size(); ++k) {
    const packing::SolidPart& part = inner.parts[k];
    PackSolid& out = result.parts.emplace_back(
        PackSolid{part.name, api::make_shape(read.shapes[k], grid, 3), part.demand, {}, io::public_amount(part.value)});
    for (const packing::SolidForm& form : part.forms) out.orientations.push_back(shown(form.rotation));
  }
  io::show_stated(read.stated, io::names_of(inner.parts), result);
  for (const packing::FixedSolid& f : inner.fixed)
    result.fixed.push_back({inner.parts[f.placed.part].name,
                            {f.placed.at[0].text(), f.placed.at[1].text(), f.placed.at[2].text()},
                            shown(packing::form_of(inner, f.placed).rotation),
                            inner.in_containers() ? inner.containers[f.kind].name : "",
                            int(f.placed.container) + 1});
  return result;
}

}  // namespace

struct SolidPacking::Data {
  io::SolidProblemRead read;  // of values the problem alone
  Fraction bound;

  explicit Data(const SolidPackProblem& values) : given_(values) {
    read.problem = on_grid(values);
    find_bound();
  }
  explicit Data(io::SolidProblemRead stated) : read(std::move(stated)) { find_bound(); }

  const SolidProblem& problem() const { return read.problem; }
  const SolidPackProblem& values() const {
    std::call_once(made_, [&] {
      if (!given_) given_ = public_problem(read);
    });
    return *given_;
  }
  packing::SolidVerdict verdict(const SolidLayout& placed) const {
    return last_.of(placed, [&] { return packing::verify(problem(), placed); });
  }
  SolidPackLayout shown(const SolidLayout& layout) const {
    SolidPackLayout result = public_layout(problem(), layout);
    result.lower_bound = std::max(bound, layout.lower_bound).text();
    return result;
  }

 private:
  void find_bound() { bound = packing::lower_bound(problem()); }

  mutable std::once_flag made_{};
  mutable std::optional<SolidPackProblem> given_ = {};
  io::LastVerdict<SolidLayout, packing::SolidVerdict> last_{};
};

namespace {

io::LayoutFacts facts_of(const SolidPacking::Data& data, const SolidLayout& placed, const SolidPackLayout& layout) {
  io::LayoutFacts facts;
  const packing::SolidVerdict verdict = data.verdict(placed);
  facts.proven = verdict.is_feasible();
  facts.density = verdict.density;
  facts.lower_bound = std::max(data.bound, io::fraction(layout.lower_bound));
  facts.seconds = layout.seconds;
  facts.seed = layout.seed;
  facts.threads = layout.threads;
  return facts;
}

}  // namespace

Orientation Orientation::quaternion(const Number& w, const Number& x, const Number& y, const Number& z) {
  return shown(packing::exact_rotation(
      space::Rotation::of_quaternion({api::real_of(w), api::real_of(x), api::real_of(y), api::real_of(z)}, {})));
}

Orientation Orientation::about(Shape::Axis axis, const Number& degrees) {
  return shown(packing::exact_rotation(space::Rotation::about_axis(int(axis), api::real_of(degrees), {})));
}

std::vector<Orientation> Orientation::right_angles() { return all_shown(packing::axis_rotations(false)); }
std::vector<Orientation> Orientation::upright() { return all_shown(packing::axis_rotations(true)); }

SolidPacking::SolidPacking(const SolidPackProblem& problem) : data_(std::make_shared<const Data>(problem)) {}

SolidPacking SolidPacking::json(std::string_view text, const PackReading& reading) {
  const std::string name =
      reading.folder ? (std::filesystem::path(*reading.folder) / reading.name).string() : reading.name;
  return SolidPacking(std::make_shared<const Data>(
      io::read_solids(std::string(text), name, io::nesting_options(reading), reading.read)));
}

bool SolidPacking::is_stated_in(std::string_view json, const std::string& name) {
  return io::is_solid_problem(std::string(json), name);
}

const SolidPackProblem& SolidPacking::problem() const { return data_->values(); }
const std::vector<std::string>& SolidPacking::notes() const { return data_->read.notes; }
std::size_t SolidPacking::copies() const { return data_->problem().items(); }
Number SolidPacking::lower_bound() const { return data_->bound.text(); }

std::optional<SolidPackLayout> SolidPacking::search(const Options& options,
                                                    const PackSearch<SolidPackLayout>& how) const {
  const SolidProblem& inner = data_->problem();
  std::optional<SolidLayout> start;
  if (how.start) {
    start = layout_of(inner, *how.start);
    const packing::SolidVerdict verdict = data_->verdict(*start);
    if (!verdict.is_feasible())
      throw Error(ErrorCode::kBadValue,
                  "the layout to start with is not feasible: " + io::fault_text(inner, *start, verdict.faults[0]));
  }
  const auto shown = [&](const SolidLayout& layout) { return data_->shown(layout); };
  return io::searched<SolidLayout, SolidPackLayout>(
      options, how, start ? &*start : nullptr, shown,
      [&](const auto&... asked) { return packing::search_solids_to_proof(inner, asked...); });
}

PackVerdict SolidPacking::verdict(const SolidPackLayout& layout) const {
  const SolidLayout placed = layout_of(data_->problem(), layout);
  const packing::SolidVerdict found = data_->verdict(placed);
  PackVerdict result{{}, found.used.text(), found.density};
  for (const packing::SolidFault& fault : found.faults)
    result.faults.push_back(public_fault(data_->problem(), placed, fault));
  return result;
}

std::optional<SolidPackLayout> SolidPacking::moved(const SolidPackLayout& layout, std::size_t item,
                                                   const Point3& at) const {
  io::check_item(item, layout.items.size());
  SolidLayout placed = layout_of(data_->problem(), layout);
  const auto made =
      packing::with_room(data_->problem(), placed, item, {io::fraction(at.x), io::fraction(at.y), io::fraction(at.z)});
  if (!made) return std::nullopt;
  SolidPackLayout result = data_->shown(*made);
  result.lower_bound = layout.lower_bound;
  return result;
}

SolidPackLayout SolidPacking::layout(std::string_view json, const std::string& name) const {
  return data_->shown(io::read_solid_layout(std::string(json), name, data_->problem()));
}

std::string SolidPacking::json(const SolidPackLayout& layout) const {
  const SolidLayout placed = layout_of(data_->problem(), layout);
  return io::layout_json(data_->problem(), placed, facts_of(*data_, placed, layout));
}

std::string SolidPacking::svg(const SolidPackLayout& layout) const {
  const SolidLayout placed = layout_of(data_->problem(), layout);
  return io::layout_svg(data_->problem(), placed, facts_of(*data_, placed, layout));
}

std::string SolidPacking::file(const SolidPackLayout& layout, std::string_view ending) const {
  const SolidProblem& inner = data_->problem();
  return io::assembly_text(io::layout_assembly(inner, layout_of(inner, layout)), inner.name, ending, "");
}

Surface SolidPacking::surface(const SolidPackLayout& layout) const {
  const SolidProblem& inner = data_->problem();
  io::Surface all = io::united(io::layout_assembly(inner, layout_of(inner, layout)));
  return {std::move(all.vertices), std::move(all.faces)};
}

Surface SolidPacking::outline(std::size_t part) const {
  if (part >= data_->problem().parts.size())
    throw Error(ErrorCode::kBadValue, fmt::format("there is no part {}", part));
  io::Surface turned = io::part_surface(data_->problem(), part);
  return {std::move(turned.vertices), std::move(turned.faces)};
}

Surface SolidPacking::inside(std::size_t container) const {
  if (container >= data_->problem().containers.size())
    throw Error(ErrorCode::kBadValue, fmt::format("there is no container {}", container));
  io::Surface surface = io::container_surface(data_->problem(), container);
  return {std::move(surface.vertices), std::move(surface.faces)};
}

std::optional<SolidPackLayout> pack(const SolidPackProblem& problem, const Options& options,
                                    const std::function<void(const SolidPackLayout&)>& better) {
  PackSearch<SolidPackLayout> how;
  if (better) how.better = [&](const SolidPackLayout& layout, const PackProgress&) { better(layout); };
  return SolidPacking(problem).search(options, how);
}

std::vector<std::string> layout_faults(const SolidPackProblem& problem, const SolidPackLayout& layout) {
  return io::texts_of(SolidPacking(problem).verdict(layout));
}

SolidPackProblem solid_pack_problem(std::string_view json, const std::string& folder) {
  PackReading reading;
  if (!folder.empty()) reading.folder = folder;
  return SolidPacking::json(json, reading).problem();
}

std::string layout_json(const SolidPackProblem& problem, const SolidPackLayout& layout) {
  return SolidPacking(problem).json(layout);
}
std::string layout_svg(const SolidPackProblem& problem, const SolidPackLayout& layout) {
  return SolidPacking(problem).svg(layout);
}
std::string layout_file(const SolidPackProblem& problem, const SolidPackLayout& layout, std::string_view ending) {
  return SolidPacking(problem).file(layout, ending);
}
Surface layout_surface(const SolidPackProblem& problem, const SolidPackLayout& layout) {
  return SolidPacking(problem).surface(layout);
}

}  // namespace findspace
