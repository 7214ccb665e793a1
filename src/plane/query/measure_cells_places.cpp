// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/measure_cells_places.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using exact::Real;
using Number = BoundedTwofold;

Number rounded(const Twofold& value, double error) {
  return {value, (error + margin::kTwofoldOperation * std::fabs(value.hi)) * margin::kGrowError};
}
}  // namespace

Number operator+(const Number& p, const Number& q) { return rounded(p.value + q.value, p.error + q.error); }
Number operator-(const Number& p, const Number& q) { return rounded(p.value - q.value, p.error + q.error); }
Number operator*(const Number& p, const Number& q) {
  return rounded(p.value * q.value,
                 std::fabs(p.value.hi) * q.error + std::fabs(q.value.hi) * p.error + p.error * q.error);
}
Number operator/(const Number& p, const Number& q) {
  const Twofold ratio = p.value / q.value;
  const double least = std::fabs(q.value.hi) - q.error;
  if (!(least > 0)) return {ratio, std::numeric_limits<double>::infinity()};
  return rounded(ratio, (p.error + std::fabs(ratio.hi) * q.error) / least * margin::kGrowError);
}
namespace {

Number root(const Number& p) {
  const Twofold r = sqrt(p.value);
  if (!(p.value.hi > 4 * p.error)) return {r, std::numeric_limits<double>::infinity()};
  return rounded(r, p.error / r.hi);
}

Number number(exact::int128 n) {
  const double high = static_cast<double>(n);
  const exact::int128 rest = n - static_cast<exact::int128>(high);
  return rounded(Twofold(high) + Twofold(static_cast<double>(rest)), 0);
}

Number number(const Real& value) {
  if (const auto parts = value.fraction()) {
    const Number above = number((*parts)[0]);
    return (*parts)[1] == 1 ? above : above / number((*parts)[1]);
  }
  return rounded(Twofold(value), 0);
}

}  // namespace

VertexPlaces::VertexPlaces(const exact::Geometry& geometry) : geometry_(geometry) {}

VertexPlaces::Numbers VertexPlaces::numbers(Index supporting_curve) {
  constexpr std::size_t kMost = std::size_t(1) << 15;  // a few megabytes: neighbours are asked for together
  if (known_.empty()) known_.resize(std::min(kMost, std::bit_ceil(geometry_.supporting_curves.size())));
  Known& known = known_[supporting_curve & (known_.size() - 1)];
  if (known.supporting_curve != supporting_curve)
    known = {supporting_curve, computed(geometry_.supporting_curves[supporting_curve])};
  return known.numbers;
}

VertexPlaces::Numbers VertexPlaces::computed(const exact::SupportingCurve& k) const {
  if (k.circle && k.grid) return {number(k.a), number(k.b), number(k.w())};
  if (k.circle) return {number(k.real()->x), number(k.real()->y), number(k.w())};
  const Number a = number(k.a), b = number(k.b);
  if (k.real()) return {a, b, number(k.real()->x)};
  if (k.grid) return {a, b, number(k.c)};
  return {a, b, number(k.c) + number(k.w()) * root(number(exact::int128(k.a) * k.a + exact::int128(k.b) * k.b))};
}

VertexPlaces::Crossing VertexPlaces::crossing(const exact::Point& p) {
  const bool swap = geometry_.supporting_curves[p.i].circle && !geometry_.supporting_curves[p.j].circle;
  const Index i = swap ? p.j : p.i, j = swap ? p.i : p.j;
  const Numbers s = numbers(i), t = numbers(j);
  const bool line = !geometry_.supporting_curves[i].circle;
  if (line && !geometry_.supporting_curves[j].circle) {
    const Number det = s.a * t.b - s.b * t.a;
    return {(s.c * t.b - t.c * s.b) / det, (s.a * t.c - t.a * s.c) / det};
  }
  const auto along = [&](const Number& square) {
    return p.root == 0 ? Number{} : Number{Twofold(double(p.root)), 0} * root(square);
  };
  if (line) {
    const Number n2 = s.a * s.a + s.b * s.b, h = s.a * t.a + s.b * t.b - s.c;
    const Number half = along(t.c * t.c * n2 - h * h);
    return {t.a + (s.b * half - s.a * h) / n2, t.b - (s.a * half + s.b * h) / n2};
  }
  const Number dx = t.a - s.a, dy = t.b - s.b, l2 = dx * dx + dy * dy, r2 = s.c * s.c;
  const Number k = (l2 + r2 - t.c * t.c) / Number{Twofold(2), 0}, half = along(r2 * l2 - k * k);
  return {s.a + (dx * k + dy * half) / l2, s.b + (dy * k - dx * half) / l2};
}

std::array<Twofold, 2> VertexPlaces::at(Index point) {
  const exact::Point& p = geometry_.points[point];
  if (p.kind == exact::Point::Kind::kGrid) return {double(p.gx), double(p.gy)};  // at most 2^40 and sums of such: exact
  if (p.kind == exact::Point::Kind::kCross) {
    const Crossing c = crossing(p);
    const auto good = [](const Number& v) {
      return v.error <= margin::kGoodPlace * std::max(std::fabs(v.value.hi), 1.0);
    };
    if (good(c[0]) && good(c[1])) return {c[0].value, c[1].value};
  }
  const exact::RealPoint q = geometry_.exact(point);
  const auto exactly = [&](const Real& value, double near) {
    return p.error <= margin::kGoodFirstHalf * std::max(std::fabs(near), 1.0) ? Twofold(value, near) : Twofold(value);
  };
  return {exactly(q.x, p.x), exactly(q.y, p.y)};
}

}  // namespace findspace::plane
