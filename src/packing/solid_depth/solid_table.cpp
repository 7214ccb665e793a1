// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/solid_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "exact/margins/packing.h"
#include "packing/problem/pair_formula.h"
#include "packing/solid_depth/ball_walls.h"

namespace findspace::packing {
namespace {

Vector in_doubles(const std::array<Fraction, 3>& v) { return {v[0].to_double(), v[1].to_double(), v[2].to_double()}; }

/// Sorted, with a radius about each.
using Corners = std::vector<std::array<double, 4>>;
/// Of each convex part, sorted, for unions that differ may have all corners in common; then of the surface, where parts
/// were rounded. Equal where two forms are, moved.
using Look = std::vector<Corners>;

void take_least(space::Point& low, std::span<const space::Point> points) {
  for (const space::Point& p : points) low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
}

Corners corners_from(const space::Point& low, std::span<const space::Point> points, double scale, double radius) {
  Corners corners;
  for (const space::Point& p : points)
    corners.push_back({double(p.x - low.x) / scale, double(p.y - low.y) / scale, double(p.z - low.z) / scale, radius});
  std::sort(corners.begin(), corners.end());
  return corners;
}

Look look_of(const SolidForm& form) {
  constexpr space::Point kFar{space::kCoordinateLimit, space::kCoordinateLimit, space::kCoordinateLimit};
  space::Point low = kFar;
  for (const space::BodyPart& part : form.body.parts) take_least(low, part.vertices());
  Look look;
  const double scale = double(form.body.scale);
  for (const space::BodyPart& part : form.body.parts)
    look.push_back(corners_from(low, part.vertices(), scale, part.radius.to_double() / scale));
  std::sort(look.begin(), look.end());
  if (form.is_exact()) return look;
  low = kFar;
  for (const space::RaySolid& solid : form.surface) take_least(low, solid.surface.points);
  for (const space::RaySolid& solid : form.surface)
    look.push_back(corners_from(low, solid.surface.points, double(form.surface_scale), 0));
  return look;
}

}  // namespace

void OverlapPair::close() {
  begins_.push_back(blocks_.size());
  for (std::size_t k = 0; k < overlaps.size(); ++k) {
    overlaps[k].planes = std::span(blocks_).subspan(begins_[k], begins_[k + 1] - begins_[k]);
    if (overlaps[k].kind != ConvexOverlap::Kind::kWithin) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      overlaps[k].on_axes[axis] = space::planes_on_axis(overlaps[k].planes, axis, margin::kAlongPlane, heights_);
  }
  const space::HeightBlock* next = heights_.data();
  for (ConvexOverlap& overlap : overlaps)
    for (space::AxisPlanes& planes : overlap.on_axes) {
      planes.blocks = next;
      next += planes.along + planes.falling + planes.rising;
    }
}

double OverlapPair::depth(const Vector& u, double shallow) const {
  if (!may_hold(u)) return 0;
  double sum = 0;
  for (const ConvexOverlap& overlap : overlaps)
    if (const double depth = overlap.depth(u); depth > shallow) sum += depth;
  return sum;
}

SolidTable::SolidTable(const SolidProblem& problem)
    : problem_(problem), gap_(problem.widest_gap_of_all().to_double()), edge_(problem.edge.to_double()) {
  const auto widen = [&](const Fraction& side) {
    size_ = std::max(size_, (side - problem.edge - problem.edge).to_double());
  };
  for (const SolidContainer& container : problem.containers) {
    widen(container.width);
    widen(container.depth);
  }
  if (!problem.in_containers()) {
    widen(problem.width);
    widen(problem.depth);
  }
  if (has_ties()) greatest_level_ = packing::greatest_level(problem.conditions, 3);
  room_ = size_ * margin::kSolidTie;
  contact_ = size_ * margin::kNoOverlap;
  of_part_.resize(problem.parts.size());
  for (std::size_t p = 0; p < problem.parts.size(); ++p) add_variants(p);
  add_fixed();
  add_walls();
  pairs_ = std::vector<std::atomic<const OverlapPair*>>(variants_.size() * variants_.size());
}

void SolidTable::add_variants(std::size_t part) {
  const std::vector<SolidForm>& forms = problem_.parts[part].forms;
  std::vector<Look> looks;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const SolidBox box = box_of(problem_, forms[f]);
    if (!fits(problem_, box)) continue;
    Look look = look_of(forms[f]);
    if (std::find(looks.begin(), looks.end(), look) != looks.end()) continue;
    looks.push_back(std::move(look));
    of_part_[part].push_back(variants_.size());
    variants_.push_back({part, f, in_doubles(box.low), in_doubles(box.high)});
    lowest = std::min(lowest, variants_.back().high.z - variants_.back().low.z);
  }
  if (problem_.parts[part].demand > 0 && !of_part_[part].empty()) tallest_ = std::max(tallest_, lowest);
}

/// A fixed solid stands in its own form, though another may look the same.
void SolidTable::add_fixed() {
  for (const FixedSolid& fixed : problem_.fixed) {
    const std::size_t part = fixed.placed.part, form = fixed.placed.form;
    const auto same = [&](const SolidVariant& v) { return v.part == part && v.form == form; };
    const auto known = std::find_if(variants_.begin(), variants_.end(), same);
    fixed_.push_back(std::size_t(known - variants_.begin()));
    if (known != variants_.end()) continue;
    const SolidBox box = box_of(problem_, problem_.parts[part].forms[form]);
    variants_.push_back({part, form, in_doubles(box.low), in_doubles(box.high)});
  }
}

SolidPose SolidTable::pose_of(const SolidPlaced& item) const {
  const Vector at = in_doubles(item.at) - Vector{edge_, edge_, edge_};
  const SolidForm& mine = packing::form_of(problem_, item);
  const Look look = look_of(mine);
  for (const std::size_t v : of_part_[item.part]) {
    if (look_of(form_of(variants_[v])) != look) continue;
    const SolidBox box = box_of(problem_, mine);
    return {v, at + (in_doubles(box.low) - variants_[v].low)};
  }
  return {of_part_[item.part][0], at};
}

/// From the corner within the edges; they reach as far as the room.
void SolidTable::add_walls() {
  walls_of_.resize(problem_.containers.size());
  for (std::size_t kind = 0; kind < problem_.containers.size(); ++kind) {
    const SolidContainer& c = problem_.containers[kind];
    if (!c.inside) continue;
    walls_of_[kind] = variants_.size();
    const Vector edges{edge_, edge_, edge_};
    variants_.push_back({kWallPart, kind, edges, in_doubles({c.width, c.depth, c.height}) - edges});
    walls_.push_back(container_walls(problem_, c));
  }
}

const OverlapPair& SolidTable::make(std::size_t a, std::size_t b) const {
  std::unique_ptr<OverlapPair> pair = variants_[b].part == kWallPart ? of_walls(a, b) : of_parts(a, b);
  const std::lock_guard lock(guard_);
  std::atomic<const OverlapPair*>& known = pairs_[a * variants_.size() + b];
  if (const OverlapPair* other = known.load(std::memory_order_acquire)) return *other;
  made_.push_back(std::move(pair));
  known.store(made_.back().get(), std::memory_order_release);
  return *made_.back();
}

std::unique_ptr<OverlapPair> SolidTable::of_parts(std::size_t a, std::size_t b) const {
  const space::Body &first = form_of(variants_[a]).body, &second = form_of(variants_[b]).body;
  auto pair = std::make_unique<OverlapPair>();
  const CommonParts common = common_parts(first, second, double(problem_.steps()));
  const std::size_t of_a = variants_[a].part, of_b = variants_[b].part;
  const double gap = problem_.gap_of(of_a, of_b).to_double();
  if (problem_.are_tied(of_a, of_b))
    pair->tie.emplace(problem_, of_a, form_of(variants_[a]), of_b, form_of(variants_[b]));
  constexpr double far = std::numeric_limits<double>::infinity();
  pair->low = {far, far, far};
  pair->high = {-far, -far, -far};
  for (const space::BodyPart& p : common.first)
    for (const space::BodyPart& q : common.second) {
      pair->add([&](ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
        add_overlap(p, q, 1 / common.steps, gap, {}, overlap, blocks);
      });
      pair->low = least_of(pair->low, pair->overlaps.back().low);
      pair->high = most_of(pair->high, pair->overlaps.back().high);
    }
  pair->close();
  return pair;
}

/// Walls without an end count where the part's box meets that of the container.
std::unique_ptr<OverlapPair> SolidTable::of_walls(std::size_t part, std::size_t wall) const {
  const SolidVariant &v = variants_[part], &w = variants_[wall];
  const ContainerWalls& walls = walls_[wall + walls_.size() - variants_.size()];
  const space::Body& body = form_of(v).body;
  auto pair = std::make_unique<OverlapPair>();
  pair->low = v.low - w.high;
  pair->high = v.high - w.low;
  const double steps = double(problem_.steps());
  for (const space::BodyPart& p : body.parts)
    for (const ContainerWalls::Plane& plane : walls.planes)
      pair->add([&](ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
        add_overlap(p, steps * double(body.scale), plane.normal, plane.offset, edge_, overlap, blocks);
      });
  for (const ContainerWalls::Ball& ball : walls.balls)
    pair->add([&](ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
      add_ball_walls(body, steps * double(body.scale), ball, edge_, overlap, blocks);
    });
  for (const ContainerWalls::Cell& cell : walls.cells) {
    const CommonParts common = common_parts(body, cell.body, steps);
    for (const space::BodyPart& p : common.first)
      for (const space::BodyPart& q : common.second)
        pair->add([&](ConvexOverlap& overlap, std::vector<space::PlaneBlock>& blocks) {
          add_overlap(p, q, 1 / common.steps, edge_, cell.open, overlap, blocks);
        });
  }
  pair->close();
  return pair;
}

}  // namespace findspace::packing
