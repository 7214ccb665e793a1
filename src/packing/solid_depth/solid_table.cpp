// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/solid_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "exact/margins/packing.h"
#include "packing/problem/pair_formula.h"
#include "space/phi/contact_surface.h"

namespace findspace::packing {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Vector least(const Vector& a, const Vector& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vector most(const Vector& a, const Vector& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

constexpr int kTangents = 256;  // about a ball: the planes stand out by a hundredth of the radius at most

/// Directions spread evenly: points of a spiral on the sphere.
std::vector<Vector> spread_directions() {
  std::vector<Vector> directions;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < kTangents; ++k) {
    const double z = 1 - (2 * k + 1) / double(kTangents), r = std::sqrt(1 - z * z);
    directions.push_back({r * std::cos(turn * k), r * std::sin(turn * k), z});
  }
  return directions;
}

void set_box(ConvexOverlap& overlap, const Vector& low, const Vector& high, double out) {
  overlap.low = low - Vector{out, out, out};
  overlap.high = high + Vector{out, out, out};
}

/// The planes of A - B in units, farther out by the gap and the radius of a ball; `step` of the common grid.
void add_planes(const space::ContactSurface& surface, double step, double gap, double radius, ConvexOverlap& overlap,
                std::vector<space::PlaneBlock>& blocks) {
  std::vector<Vector> normals, corners;
  std::vector<double> offsets;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const space::Plane& plane = surface.raw_plane(f);
    const Vector n = exact::approx(plane.normal);
    const double size = space::length(n);
    normals.push_back((1 / size) * n);
    offsets.push_back(double(plane.offset) / size * step - gap - radius);
  }
  Vector low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const space::Point& p : surface.vertices()) {
    corners.push_back(step * exact::approx(p));
    low = least(low, corners.back());
    high = most(high, corners.back());
  }
  set_box(overlap, low, high, gap + radius);
  if (radius > 0)
    for (const Vector& n : spread_directions()) {
      double support = -kFar;
      for (const Vector& v : corners) support = std::max(support, space::dot(n, v));
      normals.push_back(n);
      offsets.push_back(-support - gap - radius);
    }
  const std::vector<space::PlaneBlock> packed = space::pack_planes(normals, offsets);
  blocks.insert(blocks.end(), packed.begin(), packed.end());
}

/// Of two parts on a common grid.
void add_overlap(const space::BodyPart& p, const space::BodyPart& q, double step, double gap, ConvexOverlap& overlap,
                 std::vector<space::PlaneBlock>& blocks) {
  const double radius = step * (p.radius + q.radius).to_double();
  if (p.core && q.core) return add_planes(space::ContactSurface(*p.core, *q.core), step, gap, radius, overlap, blocks);
  if (p.core) return add_planes(space::ContactSurface(*p.core, q.center), step, gap, radius, overlap, blocks);
  if (q.core) return add_planes(space::ContactSurface(p.center, *q.core), step, gap, radius, overlap, blocks);
  const Vector center = step * (exact::approx(p.center) - exact::approx(q.center));
  overlap.radius = radius + gap;
  set_box(overlap, center, center, overlap.radius);
}

/// Convex parts on a common grid, and its steps in a unit; rounded where their exact one is out of range.
struct CommonParts {
  std::vector<space::BodyPart> first, second;
  double steps;
};

std::vector<space::BodyPart> rounded_parts(const space::Body& body, double factor) {
  std::vector<space::BodyPart> result;
  for (const space::BodyPart& part : body.parts) {
    std::vector<space::Point> points;
    for (const space::Point& p : part.vertices())
      points.push_back(
          {std::llround(double(p.x) * factor), std::llround(double(p.y) * factor), std::llround(double(p.z) * factor)});
    const exact::Real radius = exact::Real::from_double(part.radius.to_double() * factor);
    if (!part.core) result.push_back(space::part_of(points, radius));
    if (part.core && space::Polytope::try_hull(points)) result.push_back(space::part_of(points, radius));
  }
  return result;
}

double farthest(const space::Body& body) {
  double most = 1;
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices())
      most = std::max({most, std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
  return most / double(body.scale);
}

CommonParts common_parts(const space::Body& a, const space::Body& b, double steps) {
  if (const auto scale = common_scale(a, b))
    return {space::at_scale(a, *scale).parts, space::at_scale(b, *scale).parts, steps * double(*scale)};
  const double scale = double(space::kCoordinateLimit) / 4 / std::max(farthest(a), farthest(b));
  return {rounded_parts(a, scale / double(a.scale)), rounded_parts(b, scale / double(b.scale)), steps * scale};
}

Vector in_doubles(const std::array<Fraction, 3>& v) { return {v[0].to_double(), v[1].to_double(), v[2].to_double()}; }

/// All corners of its convex parts from the least of them, and the radii about them, sorted: equal where two bodies
/// are, moved.
using Look = std::vector<std::array<double, 4>>;

Look look_of(const space::Body& body) {
  space::Point low{space::kCoordinateLimit, space::kCoordinateLimit, space::kCoordinateLimit};
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices())
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  Look look;
  const double scale = double(body.scale);
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices())
      look.push_back({double(p.x - low.x) / scale, double(p.y - low.y) / scale, double(p.z - low.z) / scale,
                      part.radius.to_double() / scale});
  std::sort(look.begin(), look.end());
  return look;
}

}  // namespace

double ConvexOverlap::depth(const Vector& u) const {
  if (!may_hold(u)) return 0;
  const double out = value(u);
  return out < 0 ? -out : 0;
}

Facing ConvexOverlap::facing(const Vector& u) const {
  if (planes.empty()) {
    const Vector way = u - center();
    const double size = space::length(way);
    return {size - radius, size > 0 ? (1 / size) * way : Vector{0, 0, 1}};
  }
  const space::Highest top = highest(u);
  const space::PlaneBlock& b = planes[std::size_t(top.plane) / 8];
  return {top.value, {b.x[top.plane % 8], b.y[top.plane % 8], b.z[top.plane % 8]}};
}

/// |u + t way - center| < radius, where the line comes deeper than `shallow`.
space::LineStretch ConvexOverlap::stretch_of_ball(const Vector& u, const Vector& way, double shallow) const {
  const Vector from = u - center();
  const double square = space::dot(way, way), middle = -space::dot(from, way) / square;
  const double nearest = space::length(from + middle * way);
  if (nearest >= radius - shallow) return {};
  const double half = std::sqrt((radius * radius - nearest * nearest) / square);
  return {middle - half, middle + half};
}

space::LineStretch ConvexOverlap::stretch(const Vector& u, const Vector& way, double shallow) const {
  if (planes.empty()) return stretch_of_ball(u, way, shallow);
  const space::LineStretch deep = space::scan_line(planes.data(), planes.size(), u, way, shallow, margin::kAlongPlane);
  if (!(deep.from < deep.to)) return deep;
  return space::scan_line(planes.data(), planes.size(), u, way, 0, margin::kAlongPlane);
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
  of_part_.resize(problem.parts.size());
  for (std::size_t p = 0; p < problem.parts.size(); ++p) add_variants(p);
  add_fixed();
  pairs_ = std::vector<std::atomic<const OverlapPair*>>(variants_.size() * variants_.size());
}

void SolidTable::add_variants(std::size_t part) {
  const std::vector<SolidForm>& forms = problem_.parts[part].forms;
  std::vector<Look> looks;
  double lowest = kFar;
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const SolidBox box = box_of(problem_, forms[f]);
    if (!fits(problem_, box)) continue;
    Look look = look_of(forms[f].body);
    if (std::find(looks.begin(), looks.end(), look) != looks.end()) continue;
    looks.push_back(std::move(look));
    of_part_[part].push_back(variants_.size());
    variants_.push_back({part, f, in_doubles(box.low), in_doubles(box.high)});
    lowest = std::min(lowest, variants_.back().high.z - variants_.back().low.z);
  }
  if (problem_.parts[part].demand > 0 && lowest < kFar) tallest_ = std::max(tallest_, lowest);
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
  const Look look = look_of(mine.body);
  for (const std::size_t v : of_part_[item.part]) {
    if (look_of(form_of(variants_[v]).body) != look) continue;
    const SolidBox box = box_of(problem_, mine);
    return {v, at + (in_doubles(box.low) - variants_[v].low)};
  }
  return {of_part_[item.part][0], at};
}

const OverlapPair& SolidTable::make(std::size_t a, std::size_t b) const {
  const space::Body &first = form_of(variants_[a]).body, &second = form_of(variants_[b]).body;
  auto pair = std::make_unique<OverlapPair>();
  const CommonParts common = common_parts(first, second, double(problem_.steps()));
  const std::size_t of_a = variants_[a].part, of_b = variants_[b].part;
  const double gap = problem_.gap_of(of_a, of_b).to_double();
  if (problem_.are_tied(of_a, of_b))
    pair->tie.emplace(problem_, of_a, form_of(variants_[a]), of_b, form_of(variants_[b]));
  std::vector<std::size_t> begins;
  pair->low = {kFar, kFar, kFar};
  pair->high = {-kFar, -kFar, -kFar};
  for (const space::BodyPart& p : common.first)
    for (const space::BodyPart& q : common.second) {
      begins.push_back(pair->blocks_.size());
      ConvexOverlap& overlap = pair->overlaps.emplace_back();
      add_overlap(p, q, 1 / common.steps, gap, overlap, pair->blocks_);
      pair->low = least(pair->low, overlap.low);
      pair->high = most(pair->high, overlap.high);
    }
  begins.push_back(pair->blocks_.size());
  for (std::size_t k = 0; k < pair->overlaps.size(); ++k)
    pair->overlaps[k].planes = std::span(pair->blocks_).subspan(begins[k], begins[k + 1] - begins[k]);
  const std::lock_guard lock(guard_);
  std::atomic<const OverlapPair*>& known = pairs_[a * variants_.size() + b];
  if (const OverlapPair* other = known.load(std::memory_order_acquire)) return *other;
  made_.push_back(std::move(pair));
  known.store(made_.back().get(), std::memory_order_release);
  return *made_.back();
}

}  // namespace findspace::packing
