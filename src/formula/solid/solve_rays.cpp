// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/solve_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "distance/rays/ray_directional.h"
#include "distance/rays/ray_runs.h"
#include "distance/rays/ray_signs.h"
#include "formula/language/evaluate.h"
#include "formula/language/level_truth.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "formula/solid/container_parts.h"
#include "formula/solid/csg_shapes.h"
#include "formula/solid/faults.h"
#include "formula/solid/solid_rays.h"
#include "formula/solid/solve_space.h"
#include "plane/base/lazy.h"
#include "space/body/cell_parts.h"
#include "space/rays/oblique_line.h"
#include "space/rays/row_merge.h"
#include "space/shape/shape_rays.h"

namespace findspace::formula {
namespace {

using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::RayGrid;
using space::RayRow;
using space::RaySolid;
using space::RaySource;
using space::RealVector;

/// Denominators of positions that are tried.
constexpr std::array<std::int64_t, 10> kParts{1, 10, 100, 1000, 10000, 1000000, 3, 8, 64, 1024};

Refusal no_map(const SignMap& map, const std::string& why) {
  return Refusal(written(map.distance) + " has no ray map here: " + why);
}

/// All solids of the names; nothing where one of them is not a union of solids.
std::optional<std::vector<RaySolid>> solids(const RayWorld& world, const std::vector<std::string>& names) {
  std::vector<RaySolid> all;
  for (const std::string& name : names) {
    const auto* more = world.shapes.at(name).solids();
    if (!more) return std::nullopt;
    all.insert(all.end(), more->begin(), more->end());
  }
  return all;
}

Tried<space::Body> body(const RayWorld& world, const std::vector<std::string>& names) {
  std::vector<const space::Body*> bodies;
  for (const std::string& name : names) {
    const Tried<const space::Body*> one = throwing_faults(world.shapes.at(name).try_body());
    if (!one) return one.refusal();
    bodies.push_back(*one);
  }
  return try_united(bodies);
}

RealVector direction_of(const Distance& d) { return {d.vector.at(0), d.vector.at(1), d.vector.at(2)}; }

/// Of one scale.
Tried<KeptBodies::Pointer> bodies(const RayWorld& world, const std::vector<std::string>& moving_names,
                                  const std::vector<std::string>& fixed_names) {
  const Tried<space::Body> moving = body(world, moving_names);
  if (!moving) return moving.refusal();
  const Tried<space::Body> fixed = body(world, fixed_names);
  if (!fixed) return fixed.refusal();
  const std::int64_t scale = space::joint_scale(moving->scale, fixed->scale);
  space::Body b = space::at_scale(*moving, scale), a = space::at_scale(*fixed, scale);
  // B + p in A is A - p in B, or -A + p in -B.
  if (b.outside && !a.outside)
    return std::make_shared<const distance::BodiesOnLines>(mirrored(std::move(a)), mirrored(std::move(b)));
  return std::make_shared<const distance::BodiesOnLines>(std::move(b), std::move(a));
}

/// By the convex parts of the shapes.
Tried<space::RaySourcePointer> by_parts(const RayWorld& world, const SignMap& map, const Distance& d, bool second,
                                        const RayGrid& grid) {
  const std::vector<std::string>&moving = second ? d.second : d.first, &fixed = second ? d.first : d.second;
  const Tried<KeptBodies::Pointer> made = world.bodies.of(moving, fixed, [&] { return bodies(world, moving, fixed); });
  if (!made) return made.refusal();
  const distance::BodiesOnLines& pair = **made;
  if (pair.b().outside) return no_map(map, "of two complements");
  const bool back = std::any_of(moving.begin(), moving.end(),
                                [&](const std::string& name) { return world.shapes.at(name).outside(); });
  const distance::Which asked = which(d.kind, second), base = back ? distance::exchanged(asked) : asked;
  const Real level = map.level / world.step * Real(pair.b().scale);
  if (!is_directional(d)) return distance::ray_sign_map(base, level, pair.b(), pair.a(), grid);
  return distance::ray_directional_map(base, level, direction_of(d), d.mode == Mode::kAlong, pair, grid);
}

Tried<SurfaceRays> parts(const RayWorld& world, const SignMap& map, const RayGrid& grid);

/// Containment up to level 0 in a shape that has no convex parts, by those it is made of (container_parts.h); nothing
/// where it is made of one.
Tried<SurfaceRays> in_container(const RayWorld& world, const SignMap& map, const Distance& d, const RayGrid& grid) {
  SurfaceRays out;
  out.least = false;
  if ((d.kind != Kind::kEta1 && d.kind != Kind::kMu) || map.level.sign() > 0 || d.second.size() != 1) return out;
  const std::vector<ContainerPart> container = container_parts(world.shapes.at(d.second[0]).stated());
  if (container.size() < 2) return out;
  for (const ContainerPart& part : container) {
    RayWorld one = world;
    one.shapes.insert_or_assign(d.second[0], RayShape(part.shape));
    SignMap wanted{d, part.without ? -map.level : map.level, false};
    wanted.distance.kind = part.without ? Kind::kGamma1 : Kind::kEta1;
    Tried<SurfaceRays> rays = parts(one, wanted, grid);
    if (!rays) return rays;
    auto source = as_source(*std::move(rays));
    out.sources.push_back(part.without ? space::negated_rays(std::move(source)) : std::move(source));
  }
  return out;
}

/// To or from a shape that round ones are cut out of; null where neither is one.
Tried<space::RaySourcePointer> by_cut(const RayWorld& world, const SignMap& map, const Distance& d, bool second,
                                      const RayGrid& grid) {
  const auto forms = [&](const std::vector<std::string>& names) -> Tried<std::vector<SpaceShape>> {
    std::vector<SpaceShape> out;
    for (const std::string& name : names) {
      Tried<SpaceShape> shape = throwing_faults(try_space_shape(*world.shapes.at(name).stated()));
      if (!shape) return shape.refusal();
      out.push_back(*std::move(shape));
    }
    return out;
  };
  const Tried<std::vector<SpaceShape>> b = forms(second ? d.second : d.first);
  if (!b) return b.refusal();
  const Tried<std::vector<SpaceShape>> a = forms(second ? d.first : d.second);
  if (!a) return a.refusal();
  std::optional<distance::AlongWay> way;
  if (is_directional(d)) way = distance::AlongWay{direction_of(d), d.mode == Mode::kAlong};
  const Real level = map.level / world.step;
  if (const CsgShapes shapes = csg_shapes(*b, *a); shapes.cut) {
    auto rays = csg_map(which(d.kind, second), level * Real(shapes.scale), shapes, grid, way);
    if (!rays) return no_map(map, kNoMapAlong);
    return rays;
  }
  const auto cut = cut_between(*b, *a);
  if (!cut) return nullptr;
  auto rays = cut->of.map(cut->which(which(d.kind, second)), level * Real(cut->scale), way, grid);
  if (!rays) return no_map(map, rays.refusal().error.message());
  return rays;
}

bool is_protrusion(Kind kind) { return kind == Kind::kMu || kind == Kind::kH || kind == Kind::kHausdorff; }

/// Whether the direction is that of the lines, or the opposite one.
bool runs_along(const Distance& d, const RayGrid& grid) {
  const RealVector direction = direction_of(d);
  if (grid.oblique) return space::is_zero(space::cross(direction, grid.oblique->frame[2]));
  RealVector axis;
  axis[static_cast<std::size_t>(grid.axis)] = Real(1);
  return space::is_zero(space::cross(direction, axis));
}

/// Off the signs at level 0 on the same lines.
Tried<space::RaySourcePointer> along_lines(const RayWorld& world, const SignMap& map, const Distance& d,
                                           const RayGrid& grid) {
  SignMap zero{d, Real(), false};
  zero.distance.mode = Mode::kPlain;
  zero.distance.vector.clear();
  distance::RunQuery query;
  query.farthest = is_farthest(d.kind);
  zero.distance.kind = nearest_kind(d.kind);
  query.both_ways = d.mode == Mode::kAlong;
  const RealVector direction = direction_of(d);
  query.forward =
      (grid.oblique ? space::dot(direction, grid.oblique->frame[2]) : direction[static_cast<std::size_t>(grid.axis)])
          .sign() > 0;
  Tried<SurfaceRays> made = parts(world, zero, grid);
  if (!made) return made.refusal();
  auto rays = std::make_shared<SurfaceRays>(*std::move(made));
  return std::make_unique<distance::RayRuns>([rays](int j) { return rays->try_row(j); }, rays->searched(), query,
                                             map.level / world.step * Real(grid.parts), grid);
}

/// Whether the coordinates of surfaces, and those from the centres of balls, are within the limit of ray maps.
bool in_ray_range(const std::vector<RaySolid>& b, const std::vector<RaySolid>& a, const RayGrid& grid) {
  bool any = false, balls = false;
  space::Point low, high;
  for (const auto* solids : {&b, &a}) {
    space::extend_box(*solids, low, high, any);
    balls = balls || std::any_of(solids->begin(), solids->end(), [](const RaySolid& s) { return s.ball(); });
  }
  const std::int64_t parts = balls ? 2 * grid.parts : grid.parts;
  return space::in_ray_range(low, parts) && space::in_ray_range(high, parts);
}

/// By the surfaces of the solids, as they are; no sources where they do not answer.
Tried<SurfaceRays> by_surfaces(const RayWorld& world, const SignMap& map, const Distance& d, bool second,
                               const RayGrid& grid) {
  if (grid.oblique) return SurfaceRays();
  if (is_directional(d) && (map.level.sign() != 0 || nearest_kind(d.kind) != d.kind)) return SurfaceRays();
  const std::vector<std::string>&moving = second ? d.second : d.first, &fixed = second ? d.first : d.second;
  const auto b = solids(world, moving), a = solids(world, fixed);
  if (!b || !a || !in_ray_range(*b, *a, grid)) return SurfaceRays();
  return solid_rays(which(d.kind, second), {*b, [&] { return body(world, moving); }},
                    {*a, [&] { return body(world, fixed); }}, map.level / world.step, grid);
}

/// By the convex parts of the shapes, or else by what a shape without such is made of.
Tried<SurfaceRays> by_sets(const RayWorld& world, const SignMap& map, const Distance& d, bool second,
                           const RayGrid& grid) {
  Tried<space::RaySourcePointer> whole = by_parts(world, map, d, second, grid);
  if (whole) return SurfaceRays::of(*std::move(whole));
  if (!second && !is_directional(d)) {
    Tried<SurfaceRays> containers = in_container(world, map, d, grid);
    if (!containers || !containers->sources.empty()) return containers;
  }
  Tried<space::RaySourcePointer> cut = by_cut(world, map, d, second, grid);
  if (!cut) return cut.refusal();
  if (!*cut) return whole.refusal().within(written(map.distance));
  return SurfaceRays::of(*std::move(cut));
}

/// Whether each of the shapes has convex parts whose corners are where they belong.
bool has_parts(const RayWorld& world, const std::vector<std::string>& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const Tried<const space::Body*> body = world.shapes.at(name).try_body();
    return body && (*body)->moved == 0;  // no sign: said of exact ones
  });
}

/// The rows of a search through surfaces; where that has no answer, of the convex parts of both shapes, if these are
/// exact: of flat walls that face each other they may be few.
class SurfacesOrSets : public RaySource {
 public:
  using Sets = std::function<Tried<SurfaceRays>()>;
  SurfacesOrSets(SurfaceRays surfaces, Sets sets, const RayGrid& grid)
      : surfaces_(std::move(surfaces)), sets_(std::move(sets)), grid_(grid) {}
  const RayGrid& grid() const override { return grid_; }
  bool searched() const override { return true; }
  Tried<RayRow> try_row(int j) const override {
    Tried<RayRow> row = surfaces_.try_row(j);
    if (row) return row;
    const Tried<SurfaceRays>& sets = made_.of(sets_);
    if (!sets || sets->sources.empty()) return row;
    Tried<RayRow> other = sets->try_row(j);
    return other ? std::move(other) : std::move(row);
  }

 private:
  SurfaceRays surfaces_;
  Sets sets_;
  RayGrid grid_;
  plane::Lazy<Tried<SurfaceRays>> made_;
};

Tried<SurfaceRays> parts(const RayWorld& world, const SignMap& map, const RayGrid& grid) {
  Distance d = moving_first(map.distance, world.moving);
  if (d.mode == Mode::kRotation || d.prefix != Extremum::kNone) return no_map(map, "only translations are");
  const bool second = second_is_moving(d, world.moving);
  Tried<SurfaceRays> result = by_surfaces(world, map, d, second, grid);
  if (!result) return result;
  if (result->searched() && is_protrusion(d.kind) && !is_directional(d)) {
    const auto sets = [world, map, d, second, grid]() -> Tried<SurfaceRays> {
      if (!has_parts(world, d.first) || !has_parts(world, d.second)) return SurfaceRays();
      return by_sets(world, map, d, second, grid);
    };
    return SurfaceRays::of(std::make_unique<SurfacesOrSets>(*std::move(result), sets, grid));
  }
  if (!result->sources.empty()) return result;
  if (!is_directional(d) || !runs_along(d, grid)) return by_sets(world, map, d, second, grid);
  Tried<space::RaySourcePointer> along = along_lines(world, map, d, grid);
  if (!along) return along.refusal();
  return SurfaceRays::of(*std::move(along));
}

class RegionRays : public RaySource {
 public:
  RegionRays(std::vector<SurfaceRays> maps, const Formula& formula, const RayGrid& grid)
      : formula_(formula), grid_(grid), maps_(std::move(maps)) {}
  const RayGrid& grid() const override { return grid_; }
  Tried<RayRow> try_row(int j) const override {
    std::vector<RayRow> rows;
    for (std::size_t k = 0; k < maps_.size(); ++k) {
      Tried<RayRow> row = maps_[k].try_row(j);
      if (!row) return row.refusal().within(written(formula_.sign_maps()[k].distance));
      rows.push_back(*std::move(row));
    }
    return space::combined(rows, [&](std::span<const std::int8_t> signs) {
      return static_cast<std::int8_t>(evaluate(formula_, signs) ? -1 : 1);
    });
  }

 private:
  const Formula& formula_;
  RayGrid grid_;
  std::vector<SurfaceRays> maps_;
};

/// The same of a formula of one distance, from exact signs at the levels that tell something.
class LevelRays : public RaySource {
 public:
  LevelRays(std::vector<SurfaceRays> maps, plane::SignSum sum, const Distance& distance, const RayGrid& grid)
      : maps_(std::move(maps)), sum_(std::move(sum)), distance_(distance), grid_(grid) {}
  const RayGrid& grid() const override { return grid_; }
  Tried<RayRow> try_row(int j) const override {
    std::vector<RayRow> rows;
    for (const SurfaceRays& map : maps_) {
      Tried<RayRow> row = map.try_row(j);
      if (!row) return row.refusal().within(written(distance_));
      rows.push_back(*std::move(row));
    }
    return space::summed(rows, sum_);
  }

 private:
  std::vector<SurfaceRays> maps_;
  plane::SignSum sum_;
  Distance distance_;
  RayGrid grid_;
};

/// Null where the formula speaks of more than one distance, or a search tells signs: 0 is no place at a level then.
space::RaySourcePointer by_levels(const RayWorld& world, const Formula& formula, const RayGrid& grid) {
  std::optional<LevelTruth> truth = level_truth(formula);
  if (!truth) return nullptr;
  if (truth->sign_maps.empty()) return space::constant_rays(grid, truth->sum.first > 0 ? -1 : 1);
  std::vector<SurfaceRays> maps;
  for (const std::size_t k : truth->sign_maps) {
    Tried<SurfaceRays> one = parts(world, formula.sign_maps()[k], grid);
    if (!one || one->searched()) return nullptr;
    maps.push_back(*std::move(one));
  }
  return std::make_unique<LevelRays>(std::move(maps), std::move(truth->sum), formula.sign_maps()[0].distance, grid);
}

}  // namespace

KeptBodies& KeptBodies::operator=(const KeptBodies& other) {
  if (this != &other) made_.clear();
  return *this;
}

Tried<KeptBodies::Pointer> KeptBodies::of(const Names& moving, const Names& fixed,
                                          const std::function<Tried<Pointer>()>& make) const {
  const std::lock_guard lock(guard_);
  const auto known = made_.find({moving, fixed});
  if (known != made_.end()) return known->second;
  return made_.emplace(std::pair(moving, fixed), make()).first->second;
}

RayWindow window(const RayWorld& world, const Formula& formula) {
  RayWindow result;
  bool first = true;
  for (const SignMap& map : formula.sign_maps()) {
    Distance d = moving_first(map.distance, world.moving);
    if (second_is_moving(d, world.moving)) std::swap(d.first, d.second);
    space::Point b_low, b_high, a_low, a_high;
    bool any_b = false, any_a = false;
    for (const std::string& name : d.first) world.shapes.at(name).extend_box(b_low, b_high, any_b);
    for (const std::string& name : d.second) world.shapes.at(name).extend_box(a_low, a_high, any_a);
    const Real steps = abs(map.level / world.step);
    if (steps > Real(exact::kRayLimit))
      throw Error(ErrorCode::kOutOfRange, "a level exceeds 2^38 grid steps, the limit of ray maps");
    const auto r = static_cast<std::int64_t>(exact::floor(steps)) + 1;
    const space::Point low = a_low - b_high - space::Point{r, r, r}, high = a_high - b_low + space::Point{r, r, r};
    if (first) result = {low, high};
    first = false;
    result.low = {std::min(result.low.x, low.x), std::min(result.low.y, low.y), std::min(result.low.z, low.z)};
    result.high = {std::max(result.high.x, high.x), std::max(result.high.y, high.y), std::max(result.high.z, high.z)};
  }
  return result;
}

Tried<RegionOnLines> try_ray_region(const RayWorld& world, const Formula& formula, const RayGrid& grid) {
  if (formula.sign_maps().empty())
    return RegionOnLines{space::constant_rays(grid, evaluate(formula, {}) ? -1 : 1), Side::kExact};
  if (auto rays = by_levels(world, formula, grid)) return RegionOnLines{std::move(rays), Side::kExact};
  std::vector<SurfaceRays> maps;
  std::vector<bool> searched;
  for (const SignMap& map : formula.sign_maps()) {
    Tried<SurfaceRays> one = parts(world, map, grid);
    if (!one) return one.refusal();
    searched.push_back(one->searched());
    maps.push_back(*std::move(one));
  }
  return RegionOnLines{std::make_unique<RegionRays>(std::move(maps), formula, grid), side_of_search(formula, searched)};
}

RegionOnLines ray_region(const RayWorld& world, const Formula& formula, const RayGrid& grid) {
  return try_ray_region(world, formula, grid).or_throw();
}

namespace {

/// Line (0, 0) of one map, whose events may refer to the map's own memory.
struct FirstRow {
  SurfaceRays source;
  RayRow row;
};
Tried<FirstRow> first_row(const RayWorld& world, const SignMap& map, const RayGrid& grid) {
  Tried<SurfaceRays> source = parts(world, map, grid);
  if (!source) return source.refusal();
  Tried<RayRow> row = source->try_row(0);
  if (!row) return row.refusal();
  return FirstRow{*std::move(source), *std::move(row)};
}

}  // namespace

Tried<LineSigns> signs_on_line(const RayWorld& world, const SignMap& map, const RayGrid& grid) {
  const Tried<FirstRow> found = first_row(world, map, grid);
  if (!found) return found.refusal();
  const RayRow& row = found->row;
  LineSigns out{{row.before[0], {}}, found->source.searched()};
  for (int e = row.first[0]; e < row.first[1]; ++e) {
    const space::RayEvent& event = row.events[static_cast<std::size_t>(e)];
    out.section.stops.push_back({event.at.to_real(), event.here, event.after});
  }
  return out;
}

std::optional<RayGrid> grid_through(const space::RealVector& p, int axis) {
  const auto across = [&](int k) -> const Real& { return p[static_cast<std::size_t>((axis + k) % 3)]; };
  const auto* fits = std::find_if(kParts.begin(), kParts.end(), [&](std::int64_t parts) {
    return (across(1) * Real(parts)).integer() && (across(2) * Real(parts)).integer();
  });
  if (fits == kParts.end()) return std::nullopt;
  std::array<std::int64_t, 2> at{};
  for (int k = 0; k < 2; ++k) {
    const auto whole = *(across(k + 1) * Real(*fits)).integer();
    if (whole > exact::kRayLimit || whole < -exact::kRayLimit) return std::nullopt;
    at[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(whole);
  }
  return RayGrid{axis, *fits, at[0], at[1], 1, 1, 1, 1};
}

Tried<std::optional<int>> sign_at_position(const RayWorld& world, const SignMap& map, const space::RealVector& p) {
  const auto grid = grid_through(p, 2);
  if (!grid) return std::nullopt;
  const Tried<FirstRow> found = first_row(world, map, *grid);
  if (!found) return found.refusal();
  const int sign = space::sign_at(found->row, 0, p[2] * Real(grid->parts));
  if (sign == 0 && found->source.searched()) return std::nullopt;
  return sign;
}

}  // namespace findspace::formula
