// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/union_protrusion.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_columns.h"
#include "distance/search/convex_distance.h"
#include "distance/search/grown_set.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::plus;
using space::scaled;
using space::Vector;

namespace {

/// To the nearest place that protrudes farthest; a place before is as good.
constexpr int kMostFarSteps = 12;

/// How far a point is beyond the tetrahedron, about: the most beyond a face.
double beyond_faces(const Tetrahedron& t, const Vector& x) {
  double out = -exact::kInfinity;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector &a = t[(v + 1) % 4], e = t[(v + 2) % 4] - a, g = t[(v + 3) % 4] - a;
    const Vector n{e.y * g.z - e.z * g.y, e.z * g.x - e.x * g.z, e.x * g.y - e.y * g.x};
    const double own = space::dot(n, t[v] - a), there = space::dot(n, x - a), size = space::length(n);
    out = std::max(out, (own > 0 ? -there : there) / size);
  }
  return out;
}

}  // namespace

TouchingConstraint signed_touching(const space::BodyPart& part) {
  const double radius = part.radius.to_double();
  if (part.vertices().size() <= 2) {
    return [core = round_solid(part, {})](const Vector& x) {
      const Vector off = x - core.projection(x);
      const double d = space::length(off);
      return Touching{d - core.radius, d > 0 ? scaled(1 / d, off) : Vector{}};
    };
  }
  return [planes = part.planes(), outside = touching_distance(part, {}, radius), radius](const Vector& x) {
    Touching most{-exact::kInfinity, {}};
    for (const space::HalfSpace& h : planes) {
      const double value = h.approx_value(x) - radius;
      if (value > most.value) most = {value, h.unit};
    }
    if (most.value < -radius) return most;
    const Touching far = outside(x);
    return far.value > most.value ? far : most;
  };
}

UnionProtrusion::UnionProtrusion(const space::Body& b, const space::Body& a) : b_(solids_of(b, {})) {
  for (const space::BodyPart& part : a.parts) parts_.push_back(signed_touching(part));
  for (const space::Body* body : {&b, &a}) {
    const space::Bounds3 box = bounds(*body);
    size_ += std::max(space::length(space::rounded(box.low)), space::length(space::rounded(box.high)));
  }
}

std::size_t UnionProtrusion::piece_of(const Vector& point) const {
  std::size_t best = 0;
  double least = exact::kInfinity;
  for (std::size_t k = 0; k < b_.cells.size() + b_.round.size(); ++k) {
    const double d =
        k < b_.cells.size() ? beyond_faces(b_.cells[k], point) : b_.round[k - b_.cells.size()].beyond(point);
    if (d < least) {
      least = d;
      best = k;
    }
  }
  return best;
}

/// The distances to the parts of A of a point of B at x, up to so much.
SolidMaxMin UnionProtrusion::max_min(const Vector& x, double slack, double share, int most) const {
  std::vector<ConvexDistance> sets;
  for (const TouchingConstraint& part : parts_)
    sets.emplace_back([&part, &x](const Vector& y) { return part(plus(x, y)).value; });
  return solid_max_min(b_, sets, slack, share, most);
}

UnionProtrusion::Farthest UnionProtrusion::farthest(const Vector& x, double precision, int most) const {
  // Nothing is deeper than that: so all of it counts.
  const double depth = 2 * (size_ + space::length(x));
  const SolidMaxMin found = max_min(x, -depth, precision / (2 * depth), most);
  return {found.value,
          found.complete ? std::max(found.bound, found.value + precision) : found.bound,
          {found.place, x, piece_of(found.place)}};
}

bool UnionProtrusion::deeper(const Vector& x, double than, int most, std::optional<Witness>& out) const {
  const SolidMaxMin found = max_min(x, -than, 1, most);
  if (!(found.value > -than)) return found.complete;
  out = Witness{found.place, x, piece_of(found.place)};
  return false;
}

double UnionProtrusion::beyond(const Vector& y) const {
  double least = exact::kInfinity;
  for (const TouchingConstraint& part : parts_) least = std::min(least, part(y).value);
  return least;
}

/// A tetrahedron within the piece; of a round one near the point, and nearly touching its boundary.
Tetrahedron UnionProtrusion::around(const Witness& witness, double reach) const {
  if (witness.piece < b_.cells.size()) return b_.cells[witness.piece];
  const RoundSolid& solid = b_.round[witness.piece - b_.cells.size()];
  Vector out = witness.point - solid.projection(witness.point);
  const double far = space::length(out);
  // Deep inside any way will do.
  out = far > solid.radius / 2 && far > 0 ? scaled(1 / far, out) : Vector{0, 0, 1};
  const Vector aside = std::fabs(out.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};  // no sign: any other way
  Vector u{out.y * aside.z - out.z * aside.y, out.z * aside.x - out.x * aside.z, out.x * aside.y - out.y * aside.x};
  u = scaled(1 / space::length(u), u);
  const Vector w{out.y * u.z - out.z * u.y, out.z * u.x - out.x * u.z, out.x * u.y - out.y * u.x};
  const auto at = [&](double a, double b, double c) {
    return solid.pulled_in(plus(witness.point, scaled(reach, plus(scaled(a, u), plus(scaled(b, w), scaled(c, out))))));
  };
  const double rise = far < solid.radius * (1 - margin::kInsideBall) ? 0.5 : 0;  // no sign: which tetrahedron
  return {at(1, 0, rise), at(-0.5, 0.8, rise), at(-0.5, -0.8, rise), at(0, 0, -1)};
}

std::vector<Touching> UnionProtrusion::touching(const Vector& y) const {
  std::vector<Touching> out;
  for (const TouchingConstraint& part : parts_) out.push_back(part(y));
  return out;
}

/// The point of a tetrahedron of B that protrudes farthest at x, by what touches the distances at `at`.
Vector UnionProtrusion::farthest_out(const Tetrahedron& among, const Vector& x, std::span<const Touching> touching,
                                     const Vector& at) const {
  std::vector<Column> columns;
  for (const Touching& t : touching) columns.push_back(tangent(t, at - x, among));
  return highest_place(std::move(columns), among).place;
}

void UnionProtrusion::follow(Witness& witness, const Vector& to, double reach) const {
  witness.at = to;
  Vector at = plus(witness.point, witness.at);
  double out = beyond(at);
  for (int k = 0; k < kMostFarSteps; ++k) {
    Witness next = witness;
    next.point = farthest_out(around(witness, reach), witness.at, touching(at), at);
    const Vector there = plus(next.point, next.at);
    const double farther = beyond(there);
    if (farther > out) {
      witness = next;
      at = there;
      out = farther;
    } else if (witness.piece < b_.cells.size()) {
      return;
    } else {
      reach /= 3;
    }
  }
}

std::vector<Column> UnionProtrusion::holders(const Witness& witness, const Tetrahedron& cell, double reach) const {
  Vector at = plus(witness.point, witness.at);
  const Tetrahedron near = around(witness, 1.5 * reach);
  const std::vector<Touching> there = touching(at);
  Tetrahedron moved;  // the point at each corner of the cell
  for (std::size_t v = 0; v < 4; ++v)
    moved[v] = plus(cell[v], reach > 0 ? farthest_out(near, cell[v], there, at) : witness.point);
  at = centre(moved);
  std::vector<Column> out;
  for (const TouchingConstraint& part : parts_) {
    const Column c = tangent(part(at), at, moved);
    if (least(c) <= margin::kDistanceNoise * size_) out.push_back(c);
  }
  return out;
}

}  // namespace findspace::distance
