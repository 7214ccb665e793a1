// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/solid_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/margins/packing.h"
#include "space/phi/contact_surface.h"

namespace findspace::packing {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Vector least(const Vector& a, const Vector& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vector most(const Vector& a, const Vector& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// The planes of A - B in units, the gap farther out; `step` of the common grid.
void add_planes(const space::ContactSurface& surface, double step, double gap, ConvexOverlap& overlap,
                std::vector<space::PlaneBlock>& blocks) {
  std::vector<Vector> normals;
  std::vector<double> offsets;
  for (int f = 0; f < surface.facet_count(); ++f) {
    const space::Plane& plane = surface.raw_plane(f);
    const Vector n = exact::approx(plane.normal);
    const double size = space::length(n);
    normals.push_back((1 / size) * n);
    offsets.push_back(double(plane.offset) / size * step - gap);
  }
  overlap.low = {kFar, kFar, kFar};
  overlap.high = {-kFar, -kFar, -kFar};
  for (const space::Point& p : surface.vertices()) {
    const Vector v = step * exact::approx(p);
    overlap.low = least(overlap.low, v);
    overlap.high = most(overlap.high, v);
  }
  overlap.low = overlap.low - Vector{gap, gap, gap};
  overlap.high = overlap.high + Vector{gap, gap, gap};
  const std::vector<space::PlaneBlock> packed = space::pack_planes(normals, offsets);
  blocks.insert(blocks.end(), packed.begin(), packed.end());
}

/// Convex parts on a common grid, and its steps in a unit; rounded where their exact one is out of range.
struct CommonParts {
  std::vector<space::Polytope> first, second;
  double steps;
};

std::vector<space::Polytope> rounded_parts(const space::Body& body, double factor) {
  std::vector<space::Polytope> result;
  for (const space::BodyPart& part : body.parts) {
    std::vector<space::Point> points;
    for (const space::Point& p : part.vertices())
      points.push_back(
          {std::llround(double(p.x) * factor), std::llround(double(p.y) * factor), std::llround(double(p.z) * factor)});
    if (auto hull = space::Polytope::try_hull(points)) result.push_back(std::move(*hull));
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
  const auto parts_of = [](const space::Body& body) {
    std::vector<space::Polytope> result;
    for (const space::BodyPart& part : body.parts) result.push_back(*part.core);
    return result;
  };
  if (const auto scale = common_scale(a, b))
    return {parts_of(space::at_scale(a, *scale)), parts_of(space::at_scale(b, *scale)), steps * double(*scale)};
  const double scale = double(space::kCoordinateLimit / 4) / std::max(farthest(a), farthest(b));
  return {rounded_parts(a, scale / double(a.scale)), rounded_parts(b, scale / double(b.scale)), steps * scale};
}

/// All corners of its convex parts from the low corner of its box, sorted: equal where two bodies are, moved.
std::vector<space::Point> look_of(const space::Body& body) {
  std::vector<space::Point> corners;
  space::Point low{space::kCoordinateLimit, space::kCoordinateLimit, space::kCoordinateLimit};
  for (const space::BodyPart& part : body.parts)
    for (const space::Point& p : part.vertices()) {
      corners.push_back(p);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    }
  for (space::Point& p : corners) p = p - low;
  const auto key = [](const space::Point& p) { return std::array{p.x, p.y, p.z}; };
  std::sort(corners.begin(), corners.end(), [&](const auto& p, const auto& q) { return key(p) < key(q); });
  return corners;
}

}  // namespace

double ConvexOverlap::depth(const Vector& u) const {
  if (!may_hold(u)) return 0;
  const double value = highest(u).value;
  return value < 0 ? -value : 0;
}

space::LineStretch ConvexOverlap::stretch(const Vector& u, const Vector& way, double shallow) const {
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
    : problem_(problem),
      width_((problem.width - problem.edge - problem.edge).to_double()),
      depth_((problem.depth - problem.edge - problem.edge).to_double()),
      gap_(problem.gap.to_double()),
      edge_(problem.edge.to_double()) {
  of_part_.resize(problem.parts.size());
  for (std::size_t p = 0; p < problem.parts.size(); ++p) add_variants(p);
  pairs_ = std::vector<std::atomic<const OverlapPair*>>(variants_.size() * variants_.size());
}

void SolidTable::add_variants(std::size_t part) {
  const std::vector<SolidForm>& forms = problem_.parts[part].forms;
  const auto vector = [](const std::array<Fraction, 3>& v) {
    return Vector{v[0].to_double(), v[1].to_double(), v[2].to_double()};
  };
  std::vector<std::vector<space::Point>> looks;
  double lowest = kFar;
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const SolidBox box = box_of(problem_, forms[f]);
    if (!fits(problem_, box)) continue;
    std::vector<space::Point> look = look_of(forms[f].body);
    if (std::find(looks.begin(), looks.end(), look) != looks.end()) continue;
    looks.push_back(std::move(look));
    of_part_[part].push_back(variants_.size());
    variants_.push_back({part, f, vector(box.low), vector(box.high)});
    lowest = std::min(lowest, variants_.back().high.z - variants_.back().low.z);
  }
  if (problem_.parts[part].demand > 0) tallest_ = std::max(tallest_, lowest);
}

SolidPose SolidTable::pose_of(const SolidPlaced& item) const {
  const Vector at{item.at[0].to_double() - edge_, item.at[1].to_double() - edge_, item.at[2].to_double() - edge_};
  const SolidForm& mine = packing::form_of(problem_, item);
  const std::vector<space::Point> look = look_of(mine.body);
  for (const std::size_t v : of_part_[item.part]) {
    if (look_of(form_of(variants_[v]).body) != look) continue;
    const SolidBox box = box_of(problem_, mine);
    const Vector low{box.low[0].to_double(), box.low[1].to_double(), box.low[2].to_double()};
    return {v, at + (low - variants_[v].low)};
  }
  return {of_part_[item.part][0], at};
}

const OverlapPair& SolidTable::make(std::size_t a, std::size_t b) const {
  const space::Body &first = form_of(variants_[a]).body, &second = form_of(variants_[b]).body;
  auto pair = std::make_unique<OverlapPair>();
  const CommonParts common = common_parts(first, second, double(problem_.steps()));
  std::vector<std::size_t> begins;
  pair->low = {kFar, kFar, kFar};
  pair->high = {-kFar, -kFar, -kFar};
  for (const space::Polytope& p : common.first)
    for (const space::Polytope& q : common.second) {
      begins.push_back(pair->blocks_.size());
      ConvexOverlap& overlap = pair->overlaps.emplace_back();
      add_planes(space::ContactSurface(p, q), 1 / common.steps, gap_, overlap, pair->blocks_);
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
