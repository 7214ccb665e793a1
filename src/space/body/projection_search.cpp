// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/projection_search.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"
#include "plane/base/search_work.h"

namespace findspace::space {

using exact::Real;

namespace {

constexpr std::size_t kPlanesOfCell = 16;  // that are made exactly in the time of a cell of other searches

double determinant(const std::array<std::array<double, 3>, 3>& g, int n) {
  if (n == 1) return g[0][0];
  if (n == 2) return g[0][0] * g[1][1] - g[0][1] * g[1][0];
  return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
         g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

Real determinant(const std::array<std::array<Real, 3>, 3>& g, int n) {
  if (n == 1) return g[0][0];
  if (n == 2) return g[0][0] * g[1][1] - g[0][1] * g[1][0];
  return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
         g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

/// Cramer's rule: g x = right; the determinant is not zero.
template <class Number>
std::array<Number, 3> cramer(const std::array<std::array<Number, 3>, 3>& g, const std::array<Number, 3>& right, int n,
                             const Number& det) {
  std::array<Number, 3> x{};
  for (int k = 0; k < n; ++k) {
    auto h = g;
    for (int i = 0; i < n; ++i) h[i][k] = right[i];
    x[k] = determinant(h, n) / det;
  }
  return x;
}

}  // namespace

ProjectionSearch::ProjectionSearch(const OpenUnion& cover, const RealVector& p, std::optional<Within> within)
    : cover_(cover), p_(p), near_(space::rounded(p)), within_(std::move(within)) {
  if (within_) add_walls(within_->box);
  queue_.push({});
}

void ProjectionSearch::add_walls(const Extent& box) {
  const auto add = [&](double at, int axis, int side) {  // beyond `at` on that side: at - x < 0, or x - at < 0
    if (!std::isfinite(at)) return;
    RealVector normal;
    normal[axis] = Real(-side);
    walls_.emplace_back(std::move(normal), side > 0 ? Real::from_double(at) : -Real::from_double(at));
  };
  add(box.low.x, 0, -1);
  add(box.low.y, 1, -1);
  add(box.low.z, 2, -1);
  add(box.high.x, 0, 1);
  add(box.high.y, 1, 1);
  add(box.high.z, 2, 1);
}

/// The number of a plane; planes with the same coefficients share one.
int ProjectionSearch::seen(const HalfSpace& plane) {
  double gap = plane.approx_value(near_);
  // Next to the plane doubles cancel; there the exact value gives the gap to an ulp.
  if (std::fabs(gap) < margin::kNextToPlane * (size_of(near_) + std::fabs(plane.shift))) {
    gap = plane.value(p_).to_double() / length(space::rounded(plane.normal));
  }
  const std::array<double, 4> key{plane.unit.x, plane.unit.y, plane.unit.z, gap};
  const auto [first, last] = by_approx_.equal_range(key);
  for (auto it = first; it != last; ++it) {
    const HalfSpace& other = *planes_[it->second].plane;
    if (other.normal == plane.normal && other.offset == plane.offset) return it->second;
  }
  const int id = static_cast<int>(planes_.size());
  planes_.push_back({plane.unit, gap, &plane});
  by_approx_.emplace(key, id);
  return id;
}

const std::vector<int>& ProjectionSearch::seen_planes(std::size_t part) {
  std::vector<int>& ids = of_part_[part];
  if (!ids.empty()) return ids;
  if (part >= cover_.size()) return ids = {seen(walls_[part - cover_.size()])};
  plane::count_cells(static_cast<long>(cover_.planes(part).size() / kPlanesOfCell));
  for (const HalfSpace& plane : cover_.planes(part)) {
    if (!within_ || side_of(plane, within_->box) >= 0) ids.push_back(seen(plane));
  }
  return ids;
}

bool ProjectionSearch::surely_out(std::size_t part, const Vector& at, double error) const {
  if (part >= cover_.size() || !cover_.rounds_early(part) || of_part_.count(part) > 0) return false;
  const double size = size_of(at);
  const auto planes = cover_.rounded_planes(part);
  return std::any_of(planes.begin(), planes.end(), [&](const OpenUnion::RoundedPlane& h) {
    return dot(h.unit, at) + h.shift > error + h.share * (size + 2 * std::fabs(h.shift)) + h.off;
  });
}

bool ProjectionSearch::exact_multipliers(const std::array<int, 3>& planes, int count, std::array<Real, 3>& out) const {
  std::array<std::array<Real, 3>, 3> g;
  std::array<Real, 3> right;
  for (int i = 0; i < count; ++i) {
    const HalfSpace& a = *planes_[planes[i]].plane;
    right[i] = -a.value(p_);
    for (int j = 0; j < count; ++j) g[i][j] = dot(a.normal, planes_[planes[j]].plane->normal);
  }
  const Real det = determinant(g, count);
  if (det.sign() == 0) return false;
  out = cramer(g, right, count, det);
  return true;
}

/// The multipliers of the unit normals whose combination is the projection on all the planes; false where they are
/// dependent.
bool ProjectionSearch::multipliers(const std::array<int, 3>& planes, int count, std::array<double, 3>& out,
                                   double& error) const {
  std::array<std::array<double, 3>, 3> g{};
  std::array<double, 3> right{};
  double size = 0;
  for (int i = 0; i < count; ++i) {
    const Seen& a = planes_[planes[i]];
    right[i] = -a.gap;
    size += std::fabs(a.gap);
    for (int j = 0; j < count; ++j) g[i][j] = dot(a.unit, planes_[planes[j]].unit);
  }
  const double det = determinant(g, count);
  if (det > margin::kThinWedge) {
    out = cramer(g, right, count, det);
    error = margin::kRoundings512 * size / det;
    return true;
  }
  std::array<Real, 3> exact;
  if (!exact_multipliers(planes, count, exact)) return false;
  error = margin::kRoundings512 * size;
  for (int i = 0; i < count; ++i) {
    out[i] = exact[i].to_double() * length(space::rounded(planes_[planes[i]].plane->normal));
    error += margin::kRoundings32 * std::fabs(out[i]);
  }
  return true;
}

RealVector ProjectionSearch::exact_projection(const Projection& projection) const {
  RealVector q = p_;
  std::array<Real, 3> m;
  if (projection.count == 0 || !exact_multipliers(projection.active, projection.count, m)) return q;
  for (int i = 0; i < projection.count; ++i) q = along(q, m[i], planes_[projection.active[i]].plane->normal);
  return q;
}

std::optional<ProjectionSearch::Projection> ProjectionSearch::projection_on(std::array<int, 3> planes,
                                                                            int count) const {
  Projection projection;
  std::array<double, 3> m{};
  if (!multipliers(planes, count, m, projection.error)) return std::nullopt;
  for (int i = 0; i < count; ++i) {
    if (m[i] < -projection.error) return std::nullopt;
    projection.at = plus(projection.at, scaled(m[i], planes_[planes[i]].unit));
  }
  projection.distance = length(projection.at);
  projection.error += margin::kRoundings128 * projection.distance;
  projection.active = planes;
  projection.count = count;
  return projection;
}

/// Adds the projection on the constraints of `projection` and one more that it breaks. Those that do not touch the new
/// projection are left out.
void ProjectionSearch::beyond(const Projection& projection, int plane) {
  std::optional<Projection> next;
  for (int kept = 0; kept < (1 << projection.count) && !next; ++kept) {
    std::array<int, 3> planes{plane, -1, -1};
    int count = 1;
    for (int i = 0; i < projection.count && count < 4; ++i) {
      if ((kept >> i & 1) == 0) continue;
      if (count < 3) planes[count] = projection.active[i];
      ++count;
    }
    if (count > 3) continue;
    next = projection_on(planes, count);
    bool close = false;  // numbers do not tell whether all are kept
    for (int i = 0; next && i < projection.count; ++i) {
      const Seen& s = planes_[projection.active[i]];
      const double kept_by = dot(s.unit, next->at) + s.gap;
      close = close || ((kept >> i & 1) == 0 && kept_by < 8 * next->error);
      if (kept_by < -8 * next->error) next.reset();
    }
    if (!next) continue;
    std::array<int, 3> key = next->active;
    std::sort(key.begin(), key.end());
    if (known_.insert(key).second)
      queue_.push(*next);
    else if (close)
      next.reset();  // it may break one of them: more of them are tried
  }
}

bool ProjectionSearch::covers_exactly(std::size_t part, const Projection& projection,
                                      std::optional<RealVector>& exact) {
  if (!exact) exact = exact_projection(projection);
  for (const int id : seen_planes(part)) {
    const Seen& s = planes_[id];
    if (dot(s.unit, projection.at) + s.gap < -8 * projection.error) continue;
    if (s.plane->value(*exact).sign() >= 0) return false;
  }
  return true;
}

int ProjectionSearch::covering_part(const Projection& projection, std::optional<RealVector>& exact) {
  int deepest = -1;
  double depth = 0;
  std::vector<std::size_t> open;
  const Vector at = plus(near_, projection.at);
  const double tolerance = 8 * projection.error + margin::kWiderBox * size_of(at);
  const auto consider = [&](std::size_t k) {
    if (surely_out(k, at, 8 * projection.error)) return;
    double highest = -exact::kInfinity;
    for (const int id : seen_planes(k)) {
      const Seen& s = planes_[id];
      highest = std::max(highest, dot(s.unit, projection.at) + s.gap);
      if (highest > 8 * projection.error) break;
    }
    if (highest < -8 * projection.error) {
      if (deepest < 0 || highest < depth) {
        depth = highest;
        deepest = static_cast<int>(k);
      }
    } else if (highest <= 8 * projection.error) {
      open.push_back(k);
    }
  };
  if (within_) {
    for (const std::size_t k : within_->sets) {
      if (cover_.extent(k).holds(at, tolerance)) consider(k);
    }
    for (std::size_t k = 0; k < walls_.size(); ++k) consider(cover_.size() + k);
  } else {
    cover_.tree().each([&](const Extent& e) { return e.holds(at, tolerance); }, consider);
  }
  if (deepest >= 0) return deepest;
  for (const std::size_t k : open) {
    if (covers_exactly(k, projection, exact)) return static_cast<int>(k);
  }
  return -1;
}

plane::SubdivisionEnd ProjectionSearch::run(long most, double bound) {
  return queue_.run(
      most, [&](const Projection& best) { return found_ || best.distance > bound; },
      [&](const Projection& projection) {
        if (++looks_ % kLooksOfCell == 0) plane::count_cell();
        std::optional<RealVector> exact;
        const int part = covering_part(projection, exact);
        if (part >= 0) {
          for (const int id : seen_planes(static_cast<std::size_t>(part))) beyond(projection, id);
          return;
        }
        found_ = exact ? *exact : exact_projection(projection);
        distance_ = projection.distance;
      });
}

}  // namespace findspace::space
