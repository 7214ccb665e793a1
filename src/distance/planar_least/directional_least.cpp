// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/directional_least.h"

#include <algorithm>
#include <memory>

#include "distance/planar_least/level_probe.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using plane::Index;
using plane::Mark;
using plane::RealVector;
using plane::Section;
using plane::SignMap;

using plane::cross;
using plane::dot;
using plane::left_normal;
using plane::operator+;
using plane::operator-;
using plane::operator*;

namespace {

/// Distances of two places on one line along the direction, in vectors of the direction.
class Lengths {
 public:
  Lengths(const SignMap& base, const TranslationDirection& direction)
      : base_(base), d_{Real(direction.dx), Real(direction.dy)}, square_(dot(d_, d_)), found_{Real()} {
    for (const plane::Vertex& v : base.vertices) add_line(base.geometry.exact(v.point));
    for (Index e = 0; e < base.edges.size(); ++e) {
      if (!base.is_arc(e)) continue;
      const Arc arc = arc_of(e);
      const Real scale = arc.radius / sqrt(square_);
      add_line(arc.center + scale * left_normal(d_));
      add_line(arc.center - scale * left_normal(d_));
      for (Index f = 0; f < base.edges.size(); ++f)
        base.is_arc(f) ? add_arcs(arc, arc_of(f)) : add_arc_and_line(arc, f);
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  }

  /// Ascending, 0 first.
  const std::vector<Real>& all() const { return found_; }

 private:
  struct Arc {
    RealVector center;
    Real radius;
  };

  Arc arc_of(Index e) const {
    const exact::SupportingCurve& k = base_.supporting_curve(e);
    return {{k.center_x(), k.center_y()}, k.w()};
  }

  void add_line(const RealVector& through) {
    const Section s = section(base_, through, d_);
    for (std::size_t i = 0; i < s.stops.size(); ++i)
      for (std::size_t j = i + 1; j < s.stops.size(); ++j) found_.push_back(s.stops[j].t - s.stops[i].t);
  }

  /// Places c1 + r1 n and c2 +- r2 n with a common normal n of length 1, on one line: cross(d, n) follows, and dot(d,
  /// n) from it.
  void add_arcs(const Arc& a, const Arc& b) {
    const RealVector between = b.center - a.center;
    for (const Real& r : {b.radius - a.radius, -b.radius - a.radius}) {
      if (r.sign() == 0) continue;
      const Real across = cross(d_, between) / r, rest = square_ - across * across;
      if (rest.sign() < 0) continue;
      for (int sign : {1, -1}) found_.push_back(abs(dot(d_, between) + Real(sign) * r * sqrt(rest)) / square_);
    }
  }

  void add_arc_and_line(const Arc& a, Index f) {
    const exact::SupportingCurve& k = base_.supporting_curve(f);
    const RealVector normal{Real(k.a), Real(k.b)};
    const Real slope = dot(normal, d_);
    if (slope.sign() == 0) return;
    const Real middle = k.offset() - dot(normal, a.center), tolerance = a.radius * sqrt(dot(normal, normal));
    for (const Real& r : {tolerance, -tolerance}) found_.push_back(abs((middle + r) / slope));
  }

  const SignMap& base_;
  const RealVector d_;
  const Real square_;
  std::vector<Real> found_;
};

}  // namespace

Extremum least_directional(const SignMap& base, const TranslationDirection& direction, bool farthest) {
  std::unique_ptr<PositionFunction> f;
  if (farthest)
    f = std::make_unique<DirectionalFarthest>(base, direction);
  else
    f = std::make_unique<DirectionalSigned>(base, direction);
  Extremum e;
  if (!f->defined() || (!farthest && base.faces[0].mark < 0)) return e;
  const Lengths lengths(base, direction);
  const Real unit = sqrt(Real(direction.dx) * Real(direction.dx) + Real(direction.dy) * Real(direction.dy)) /
                    Real(direction.both_ways ? 2 : 1);
  std::vector<Real> levels;
  for (const Real& l : lengths.all()) levels.push_back(farthest ? l * unit : -(l * unit));
  if (!farthest) std::reverse(levels.begin(), levels.end());
  // The greatest level below which there is nothing.
  std::size_t low = 0, high = levels.size();  // below levels[low] there is nothing, below levels[high] something
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (has_mark(f->sign_map(levels[middle]), -1) ? high : low) = middle;
  }
  const SignMap at = f->sign_map(levels[low]);
  e.set_exact(levels[low], Way::kMap);
  e.attained = has_mark(at, 0);
  e.at = plane::remark(at, [](Mark m) { return Mark(m == 0); });
  return e;
}

}  // namespace findspace::distance
