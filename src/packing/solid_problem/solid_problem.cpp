// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/solid_problem.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "packing/solid_problem/container_shape.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::packing {
namespace {

/// A part of a body takes in a ball of this radius about each of its corners.
void extend(SolidBox& box, bool first, const space::Point& p, int128 steps, const Fraction& radius = 0) {
  const std::int64_t coordinates[] = {p.x, p.y, p.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const Fraction c(coordinates[k], steps);
    box.low[k] = first ? c - radius : std::min(box.low[k], c - radius);
    box.high[k] = first ? c + radius : std::max(box.high[k], c + radius);
  }
}

/// In units; radii are rational.
Fraction radius_of(const space::BodyPart& part, int128 steps) {
  const auto radius = part.radius.fraction();
  return Fraction((*radius)[0], bounded_product((*radius)[1], steps));
}

/// Where points go in steps that many times as fine.
class Turn {
 public:
  explicit Turn(const SolidRotation& rotation) {
    for (const auto& row : rotation)
      for (const Fraction& entry : row) finer_ = common_multiple(finer_, entry.denominator());
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) rows_[r][c] = rotation[r][c].over(finer_);
  }
  /// How many times.
  int128 finer() const { return finer_; }

  std::array<int128, 3> operator()(const space::Point& p) const {
    std::array<int128, 3> q{};
    for (std::size_t k = 0; k < 3; ++k)
      q[k] = bounded_product(rows_[k][0], p.x) + bounded_product(rows_[k][1], p.y) + bounded_product(rows_[k][2], p.z);
    return q;
  }

 private:
  int128 finer_ = 1;
  std::array<std::array<int128, 3>, 3> rows_{};
};

/// Turned points with the largest steps on which all of them are.
class TurnedPoints {
 public:
  explicit TurnedPoints(const Turn& turn) : turn_(turn), common_(turn.finer()) {}

  void look_at(const space::Point& p) {
    for (const int128 c : turn_(p)) {
      int128 a = common_, b = c < 0 ? -c : c;
      while (b != 0) {
        const int128 rest = a % b;
        a = b;
        b = rest;
      }
      common_ = a;
    }
  }
  /// How much finer their steps are than those of the points given; throws Error(kOutOfRange).
  std::int64_t finer(std::int64_t scale) const {
    return std::int64_t(in_range(turn_.finer() / common_ * scale) / scale);
  }
  space::Point at(const space::Point& p) const {
    const auto [x, y, z] = turn_(p);
    return {in_range(x / common_), in_range(y / common_), in_range(z / common_)};
  }

 private:
  static std::int64_t in_range(int128 c) {
    if (c > space::kCoordinateLimit || c < -space::kCoordinateLimit)
      throw Error(ErrorCode::kOutOfRange,
                  "its corners have too many digits in an orientation; one with smaller numbers, as of the quaternion "
                  "(5, 1, 0, 0), is in range");
    return std::int64_t(c);
  }

  const Turn& turn_;
  int128 common_;
};

/// Of its polytopes together, in cubic grid steps.
exact::Real flat_volume_of(const space::Body& body) {
  std::vector<space::Polytope> polytopes;
  for (const space::BodyPart& part : body.parts)
    if (part.core) polytopes.push_back(*part.core);
  const exact::Real scale(body.scale);
  return space::six_volumes_of_union(polytopes) / (exact::Real(6) * scale * scale * scale);
}

/// Unions of more facets count what their parts share twice: to tell it apart would take too long.
constexpr int kMostFacets = 1000;

int facets_of(const space::Body& body) {
  int sum = 0;
  for (const space::BodyPart& part : body.parts)
    if (part.core) sum += part.core->facet_count();
  return sum;
}

}  // namespace

std::size_t SolidProblem::items() const {
  std::size_t count = 0;
  for (const SolidPart& part : parts) count += std::size_t(part.demand);
  return count;
}

int SolidProblem::free_copies(std::size_t part) const {
  const auto of_part = [&](const FixedSolid& f) { return f.placed.part == part; };
  return parts[part].demand - int(std::count_if(fixed.begin(), fixed.end(), of_part));
}

std::size_t containers_with_fixed(const SolidProblem& problem, std::size_t kind) {
  std::size_t count = 0;
  for (const FixedSolid& f : problem.fixed)
    if (f.kind == kind) count = std::max(count, f.placed.container + 1);
  return problem.in_containers() ? count : 0;
}

bool is_fixed_solid(const SolidLayout& layout, const SolidPlaced& item, const FixedSolid& fixed) {
  const SolidPlaced& p = fixed.placed;
  if (item.part != p.part || item.form != p.form || item.at != p.at) return false;
  if (layout.containers.empty()) return item.container == 0;
  if (item.container >= layout.containers.size() || layout.containers[item.container] != fixed.kind) return false;
  const auto here = layout.containers.begin() + std::ptrdiff_t(item.container);
  return std::size_t(std::count(layout.containers.begin(), here, fixed.kind)) == p.container;
}

bool is_fixed_solid(const SolidProblem& problem, const SolidLayout& layout, const SolidPlaced& item) {
  return std::any_of(problem.fixed.begin(), problem.fixed.end(),
                     [&](const FixedSolid& fixed) { return is_fixed_solid(layout, item, fixed); });
}

SolidLayout layout_of_fixed(const SolidProblem& problem) {
  SolidLayout layout;
  std::vector<std::size_t> first_of_kind;
  for (std::size_t kind = 0; kind < problem.containers.size(); ++kind) {
    first_of_kind.push_back(layout.containers.size());
    layout.containers.insert(layout.containers.end(), containers_with_fixed(problem, kind), kind);
  }
  std::vector<int> copies(problem.parts.size());
  for (const FixedSolid& f : problem.fixed) {
    SolidPlaced& item = layout.items.emplace_back(f.placed);
    item.copy = ++copies[item.part];
    if (problem.in_containers()) item.container += first_of_kind[f.kind];
    if (item.container + 1 >= layout.containers.size())
      layout.height =
          std::max(layout.height, item.at[2] + box_of(problem, form_of(problem, item)).high[2] + problem.edge);
  }
  for (std::size_t part = 0; part < problem.parts.size(); ++part)
    layout.left_out.push_back({part, problem.free_copies(part), ""});
  return layout;
}

Fraction SolidProblem::widest_gap_of_all() const {
  Fraction widest = gap;
  for (const PairGap& pair : pair_gaps) widest = std::max(widest, pair.gap);
  return widest;
}

std::optional<std::int64_t> common_scale(const space::Body& a, const space::Body& b) {
  const int128 common = int128(a.scale) / std::gcd(a.scale, b.scale) * b.scale;
  for (const space::Body* body : {&a, &b})
    for (const space::BodyPart& part : body->parts)
      for (const space::Point& p : part.vertices())
        for (const std::int64_t c : {p.x, p.y, p.z})
          if ((c < 0 ? -int128(c) : int128(c)) > space::kCoordinateLimit / (common / body->scale)) return std::nullopt;
  return std::int64_t(common);
}

exact::Real in_steps(const Fraction& value, int128 steps) {
  return exact::Real(value.numerator()) * exact::Real(steps) / exact::Real(value.denominator());
}

SolidRotation as_given() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

std::vector<SolidRotation> axis_rotations(bool upright) {
  std::vector<SolidRotation> result;
  std::array<std::size_t, 3> axes{0, 1, 2};
  do {
    const bool even = axes[1] == (axes[0] + 1) % 3;
    for (int signs = 0; signs < 8; ++signs) {
      SolidRotation rotation{};
      int sign = even ? 1 : -1;
      for (std::size_t k = 0; k < 3; ++k) {
        const int entry = (signs >> k & 1) != 0 ? -1 : 1;
        rotation[k][axes[k]] = entry;
        sign *= entry;
      }
      if (sign == 1 && (!upright || rotation[2][2] == 1)) result.push_back(rotation);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return result;
}

SolidForm turned(const SolidForm& form, const SolidRotation& rotation) {
  if (rotation == as_given()) return form;
  const Turn turn(rotation);
  TurnedPoints of_body(turn), of_surface(turn);
  for (const space::BodyPart& part : form.body.parts)
    for (const space::Point& p : part.vertices()) of_body.look_at(p);
  for (const space::RaySolid& solid : form.surface)
    for (const space::Point& p : solid.surface.points) of_surface.look_at(p);
  const std::int64_t finer = of_body.finer(form.body.scale);
  SolidForm result;
  result.rotation = rotation;
  result.body.scale = form.body.scale * finer;
  result.body.rounded = form.body.rounded;
  result.body.moved = form.body.moved;
  for (const space::BodyPart& part : form.body.parts) {
    std::vector<space::Point> corners;
    for (const space::Point& p : part.vertices()) corners.push_back(of_body.at(p));
    result.body.parts.push_back(space::part_of(corners, part.radius * exact::Real(finer)));
  }
  result.surface = form.surface;
  result.surface_scale = form.surface_scale * of_surface.finer(form.surface_scale);
  for (space::RaySolid& solid : result.surface) {
    for (space::Point& p : solid.surface.points) p = of_surface.at(p);
    solid.sheet = nullptr;
  }
  return result;
}

void set_forms(SolidPart& part, const plane::Shape& shape, const std::vector<SolidRotation>& rotations) {
  SolidForm form;
  form.body = space::body(shape);
  // Polytopes, and balls of rational radius.
  const auto is_solid = [](const space::BodyPart& piece) {
    return piece.core ? piece.radius.sign() == 0 : piece.flat.empty() && piece.radius.fraction().has_value();
  };
  if (form.body.outside || !std::all_of(form.body.parts.begin(), form.body.parts.end(), is_solid))
    throw Error(ErrorCode::kUnsupported, "pack takes bounded solids with flat faces, balls, and unions of such");
  part.disjoint = form.body.parts.size() == 1 || shape.solid != nullptr;
  if (shape.solid != nullptr && form.body.parts.size() > 1) form.surface = space::ray_solids(shape);
  if (!form.is_exact() && form.surface.empty())
    throw Error(ErrorCode::kOutOfRange, "its convex parts have corners with too many digits");
  if (!part.disjoint && facets_of(form.body) <= kMostFacets) part.flat_volume = flat_volume_of(form.body);
  for (const SolidRotation& rotation : rotations) part.forms.push_back(turned(form, rotation));
}

SolidRotation exact_rotation(const space::Rotation& rotation) {
  if (rotation.rounded)
    throw Error(ErrorCode::kBadValue,
                "this angle has no rational matrix; a quaternion near to it has one: {\"quaternion\": [w, x, y, z]}");
  SolidRotation result;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto entry = rotation.rows[r][c].fraction();
      if (!entry) throw Error(ErrorCode::kBadValue, "an orientation with too many digits");
      result[r][c] = Fraction((*entry)[0], (*entry)[1]);
    }
  return result;
}

SolidBox box_of(const SolidProblem& problem, const SolidForm& form) {
  SolidBox box;
  bool first = true;
  if (!form.is_exact()) {
    const int128 steps = bounded_product(problem.steps(), form.surface_scale);
    for (const space::RaySolid& solid : form.surface)
      for (const space::Point& p : solid.surface.points) {
        extend(box, first, p, steps);
        first = false;
      }
    return box;
  }
  const int128 steps = bounded_product(problem.steps(), form.body.scale);
  for (const space::BodyPart& piece : form.body.parts) {
    const Fraction radius = radius_of(piece, steps);
    for (const space::Point& p : piece.vertices()) {
      extend(box, first, p, steps, radius);
      first = false;
    }
  }
  return box;
}

bool fits(const SolidProblem& problem, const SolidBox& box) {
  const auto size = [&](std::size_t k) { return box.high[k] - box.low[k] + problem.edge + problem.edge; };
  if (!problem.in_containers()) return size(0) <= problem.width && size(1) <= problem.depth;
  return std::any_of(problem.containers.begin(), problem.containers.end(), [&](const SolidContainer& c) {
    return c.count > 0 && size(0) <= c.width && size(1) <= c.depth && size(2) <= c.height;
  });
}

double volume_of(const SolidProblem& problem, const SolidPart& part) {
  const space::Body& body = part.forms[0].body;
  const double unit = double(problem.steps()), steps = unit * double(body.scale);
  double sum = 0;
  for (const space::BodyPart& piece : body.parts)
    if (!piece.core)
      sum += 4 * std::numbers::pi / 3 * std::pow(piece.radius.to_double(), 3);
    else if (!part.flat_volume)
      sum += piece.core->volume();
  const double flat = part.flat_volume ? part.flat_volume->to_double() : 0;
  return sum / steps / steps / steps + flat / unit / unit / unit;
}

double volume(const SolidProblem& problem) {
  double sum = 0;
  for (const SolidPart& part : problem.parts) sum += part.demand * volume_of(problem, part);
  return sum;
}

double volume(const SolidProblem& problem, const SolidLayout& layout) {
  std::vector<double> volumes;
  for (const SolidPart& part : problem.parts) volumes.push_back(volume_of(problem, part));
  double sum = 0;
  for (const SolidPlaced& item : layout.items) sum += volumes[item.part];
  return sum;
}

double container_volume(const SolidProblem& problem, const SolidLayout& layout) {
  const double height = layout.height.to_double();
  if (!problem.in_containers()) return problem.width.to_double() * problem.depth.to_double() * height;
  double sum = 0;
  for (std::size_t k = 0; k < layout.containers.size(); ++k) {
    const SolidContainer& container = problem.containers[layout.containers[k]];
    sum += k + 1 == layout.containers.size() ? volume_below(problem, container, height) : volume_of(problem, container);
  }
  return sum;
}

void check(const SolidProblem& problem, const std::string& place) {
  if (problem.in_containers()) return;
  const Fraction width = problem.width - problem.edge - problem.edge,
                 depth = problem.depth - problem.edge - problem.edge;
  if (width <= 0 || depth <= 0) throw Error(ErrorCode::kBadValue, "the floor has no area within its edges", place);
  for (const SolidPart& part : problem.parts) {
    if (part.demand == 0) continue;
    const auto stands = [&](const SolidForm& form) { return fits(problem, box_of(problem, form)); };
    if (std::any_of(part.forms.begin(), part.forms.end(), stands)) continue;
    const SolidBox box = box_of(problem, part.forms[0]);
    throw Error(
        ErrorCode::kBadValue,
        fmt::format("'{}' is {} x {} wide: it does not stand on the floor of {} x {}", part.name,
                    (box.high[0] - box.low[0]).text(), (box.high[1] - box.low[1]).text(), width.text(), depth.text()),
        place);
  }
}

}  // namespace findspace::packing
