// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/contact_curves.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {

using exact::Real;
using Kind = ContactPair::Kind;

namespace {

RoughPoint center(const RoundFeature& f) { return {f.x, f.y}; }
RoughPoint normal(const EdgeFeature& e) { return {e.nx, e.ny}; }

/// dot(v, rotated w).
HalfAngle dot_rotated(RoughPoint v, RoughPoint w) { return HalfAngle::linear(0, dot(v, w), cross(w, v)); }

}  // namespace

bool RoughCurve::allows(RoughPoint u, double tolerance) const {
  const Cone here{std::arg(u), 0};
  return cones_meet(here, normals, tolerance) && cones_meet(here, opposed, tolerance);
}

bool RoughCurve::holds(RoughPoint at, double tolerance) const {
  if (line) {
    const double whole = length(q - p), along = dot(q - p, at - p);
    return along >= -tolerance * whole && along <= (whole + tolerance) * whole;
  }
  if (std::abs(radius) <= tolerance) return true;
  return allows((at - center) / radius, margin::kOneDirection + tolerance / std::abs(radius));
}

RoughPoint RoughCurve::normal_at(RoughPoint at) const { return line ? normal : (at - center) / radius; }

double RoughCurve::least() const {
  if (!line) return std::abs(length(center) - std::abs(radius));
  const RoughPoint d = q - p;
  const double along = -dot(d, p), square = std::norm(d);
  if (along <= 0) return length(p);
  return along >= square ? length(q) : std::abs(cross(d, p)) / std::sqrt(square);
}

bool can_touch(const Cone& a, Outside of_a, const Cone& b, Outside of_b, double middle, double half) {
  return may_meet(of_a, of_b) &&
         cones_meet(a, {b.from + middle - half + kPi, b.width + 2 * half}, margin::kOneDirection);
}

bool ContactCurves::may_touch(const ContactPair& k, double middle, double half) const {
  if (k.kind == Kind::kTurningEdge) {
    const RoundFeature& a = fixed_.rounds[k.fixed];
    const EdgeFeature& b = rotation_->edges[k.rotating];
    return can_touch(a.normals, a.outside, {b.normal, 0}, b.outside, middle, half);
  }
  const RoundFeature& b = rotation_->rounds[k.rotating];
  if (k.kind == Kind::kRounds) {
    const RoundFeature& a = fixed_.rounds[k.fixed];
    return can_touch(a.normals, a.outside, b.normals, b.outside, middle, half);
  }
  const EdgeFeature& a = fixed_.edges[k.fixed];
  return can_touch({a.normal, 0}, a.outside, b.normals, b.outside, middle, half);
}

bool may_touch_one(const ContactFeatures& these, bool fixed, const FeatureOutline& other) {
  const auto touches = [&](const Cone& normals, Outside outside) {
    return fixed ? can_touch(normals, outside, other.normals, other.outside, 0, 0)
                 : can_touch(other.normals, other.outside, normals, outside, 0, 0);
  };
  const auto round = [&](const RoundFeature& f) { return touches(f.normals, f.outside); };
  const auto edge = [&](const EdgeFeature& f) { return touches({f.normal, 0}, f.outside); };
  return std::any_of(these.rounds.begin(), these.rounds.end(), round) ||
         (!other.edge && std::any_of(these.edges.begin(), these.edges.end(), edge));
}

std::vector<ContactPair> ContactCurves::pairs(double middle, double half) const {
  std::vector<ContactPair> out;
  const auto add = [&](Kind kind, std::size_t fixed, std::size_t rotating) {
    for (Index a = 0; a < fixed; ++a)
      for (Index b = 0; b < rotating; ++b) {
        const ContactPair pair{kind, a, b};
        if (may_touch(pair, middle, half)) out.push_back(pair);
      }
  };
  add(Kind::kRounds, fixed_.rounds.size(), rotation_->rounds.size());
  add(Kind::kFixedEdge, fixed_.edges.size(), rotation_->rounds.size());
  add(Kind::kTurningEdge, fixed_.rounds.size(), rotation_->edges.size());
  return out;
}

std::vector<ContactPair> ContactCurves::pairs(const std::vector<ContactPair>& among, double middle, double half) const {
  std::vector<ContactPair> out;
  for (const ContactPair& k : among) {
    if (may_touch(k, middle, half)) out.push_back(k);
  }
  return out;
}

RoughCurve ContactCurves::rough(const ContactPair& k, double angle) const {
  const RoughPoint by = std::polar(1.0, angle);
  RoughCurve c;
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = fixed_.rounds[k.fixed], &b = rotation_->rounds[k.rotating];
    c.center = center(a) - by * center(b);
    c.radius = a.r + b.r;
    c.normals = a.normals;
    c.opposed = {b.normals.from + angle + kPi, b.normals.width};
    return c;
  }
  c.line = true;
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = fixed_.edges[k.fixed];
    const RoundFeature& b = rotation_->rounds[k.rotating];
    const RoughPoint way = b.r * normal(a) - by * center(b);
    c.normal = normal(a);
    c.p = RoughPoint(a.x0, a.y0) + way;
    c.q = RoughPoint(a.x1, a.y1) + way;
    return c;
  }
  const RoundFeature& a = fixed_.rounds[k.fixed];
  const EdgeFeature& b = rotation_->edges[k.rotating];
  c.normal = -by * normal(b);
  const RoughPoint from = center(a) + a.r * c.normal;
  c.p = from - by * RoughPoint(b.x0, b.y0);
  c.q = from - by * RoughPoint(b.x1, b.y1);
  return c;
}

RealVector exact_normal(const EdgeFeature& e) { return e.side > 0 ? left_normal(e.q - e.p) : right_normal(e.q - e.p); }

Real times_length(const Real& r, const RealVector& n) { return r.sign() == 0 ? Real() : r * sqrt(plane::dot(n, n)); }

ExactCurve ContactCurves::exact(const ContactPair& k, const exact::ExactAngle& rotation) const {
  ExactCurve c;
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = fixed_.rounds[k.fixed], &b = rotation_->rounds[k.rotating];
    c.center = a.center - rotation(b.center);
    c.radius = a.radius + b.radius;
    return c;
  }
  c.line = true;
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = fixed_.edges[k.fixed];
    const RoundFeature& b = rotation_->rounds[k.rotating];
    c.normal = exact_normal(a);
    c.offset = plane::dot(c.normal, a.p - rotation(b.center)) + times_length(b.radius, c.normal);
    return c;
  }
  const RoundFeature& a = fixed_.rounds[k.fixed];
  const EdgeFeature& b = rotation_->edges[k.rotating];
  const RealVector n = exact_normal(b);
  c.normal = -rotation(n);
  c.offset = plane::dot(c.normal, a.center) + times_length(a.radius, n) + plane::dot(n, b.p);
  return c;
}

ExactSectorCurve ContactCurves::exact_sector(const ContactPair& k, int quarters) const {
  using exact::RotationPolynomial;
  const auto linear = [&](const Real& constant, const Real& cosine, const Real& sine) {
    return RotationPolynomial::linear(constant, cosine, sine, quarters);
  };
  const auto dot_rotated = [&](const RealVector& v, const RealVector& w) {
    return linear(0, plane::dot(v, w), plane::cross(w, v));
  };
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = fixed_.rounds[k.fixed], &b = rotation_->rounds[k.rotating];
    const RealVector &p = a.center, &v = b.center;
    const Real radius = a.radius + b.radius;
    const Real squares = plane::dot(p, p) + plane::dot(v, v) - radius * radius;
    return {false, linear(p.x, -v.x, v.y), linear(p.y, -v.y, -v.x),
            RotationPolynomial::constant(squares) - Real(2) * dot_rotated(p, v), radius};
  }
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = fixed_.edges[k.fixed];
    const RoundFeature& b = rotation_->rounds[k.rotating];
    const RealVector n = exact_normal(a);
    const Real own = plane::dot(n, a.p) + times_length(b.radius, n);
    return {true,
            RotationPolynomial::constant(n.x),
            RotationPolynomial::constant(n.y),
            RotationPolynomial::constant(own) - dot_rotated(n, b.center),
            {}};
  }
  const RoundFeature& a = fixed_.rounds[k.fixed];
  const EdgeFeature& b = rotation_->edges[k.rotating];
  const RealVector n = exact_normal(b), back = -n;
  const Real own = times_length(a.radius, n) + plane::dot(n, b.p);
  return {true,
          linear(0, back.x, -back.y),
          linear(0, back.y, back.x),
          dot_rotated(a.center, back) + RotationPolynomial::constant(own),
          {}};
}

SectorCurve ContactCurves::sector(const ContactPair& k, double middle) const {
  const RoughPoint by = std::polar(1.0, middle);
  SectorCurve c;
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = fixed_.rounds[k.fixed], &b = rotation_->rounds[k.rotating];
    const RoughPoint v = by * center(b);
    c.radius = a.r + b.r;
    c.nx = HalfAngle::linear(a.x, -v.real(), v.imag());
    c.ny = HalfAngle::linear(a.y, -v.imag(), -v.real());
    const double squares = std::norm(center(a)) + std::norm(v) - c.radius * c.radius;
    c.h = HalfAngle::linear(squares, 0, 0) - 2.0 * dot_rotated(center(a), v);
    return c;
  }
  c.line = true;
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = fixed_.edges[k.fixed];
    const RoundFeature& b = rotation_->rounds[k.rotating];
    c.nx = HalfAngle::linear(a.nx, 0, 0);
    c.ny = HalfAngle::linear(a.ny, 0, 0);
    const double own = dot(normal(a), {a.x0, a.y0}) + b.r;
    c.h = HalfAngle::linear(own, 0, 0) - dot_rotated(normal(a), by * center(b));
    return c;
  }
  const RoundFeature& a = fixed_.rounds[k.fixed];
  const EdgeFeature& b = rotation_->edges[k.rotating];
  const RoughPoint n = -by * normal(b);
  c.nx = HalfAngle::linear(0, n.real(), -n.imag());
  c.ny = HalfAngle::linear(0, n.imag(), n.real());
  c.h = dot_rotated(center(a), n) + HalfAngle::linear(a.r + dot(normal(b), {b.x0, b.y0}), 0, 0);
  return c;
}

}  // namespace findspace::plane
