// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <array>

#include "distance/planar_features/curved_level_curve.h"
#include "exact/margins/planar_distance.h"
#include "exact/number/polynomial_root.h"

namespace findspace::distance {

using exact::Interval;
using exact::Polynomial;
using exact::Real;

namespace {

constexpr std::size_t kMostRoots = 3, kMostDegree = 16, kPlainDegree = 4;
constexpr double kMostWork = 512;  // of a level's degree, once over all and once over its coefficients: about a second

bool is_plainly_zero(const Real& r) { return r.is_closed() && r.sign() == 0; }

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && is_plainly_zero(p.back())) p.pop_back();
  return p;
}

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  Polynomial out(std::max(p.size(), q.size()));
  for (std::size_t k = 0; k < p.size(); ++k) out[k] += p[k];
  for (std::size_t k = 0; k < q.size(); ++k) out[k] += q[k];
  return trimmed(std::move(out));
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return {};
  Polynomial out(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
  return trimmed(std::move(out));
}

Polynomial times(const Real& s, Polynomial p) {
  for (Real& c : p) c *= s;
  return p;
}

Interval enclosure(const Polynomial& p, const Interval& x) {
  Interval out;
  for (std::size_t k = p.size(); k-- > 0;) out = out * x + p[k].interval();
  return out;
}

/// A polynomial in the level for each product of corners' square roots, these as bits.
using Rooted = std::array<Polynomial, std::size_t(1) << kMostRoots>;

Rooted plain(Polynomial p) { return {trimmed(std::move(p))}; }

Rooted operator+(const Rooted& p, const Rooted& q) {
  Rooted out;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = p[k] + q[k];
  return out;
}

Rooted times(const Real& s, Rooted p) {
  for (Polynomial& f : p) f = times(s, std::move(f));
  return p;
}

Rooted operator-(const Rooted& p, const Rooted& q) { return p + times(-1, q); }

/// Line: x * px + y * py = c; circle: about (x, y) of radius c; at a level.
struct Curve {
  bool circle;
  Rooted x, y, c;
};

class Elimination {
 public:
  explicit Elimination(std::span<const LevelCurve* const> level_curves) {
    for (const LevelCurve* f : level_curves) curves_.push_back(curve(*f));
  }

  bool possible() const { return possible_; }
  std::vector<Rooted> equations() const;
  std::vector<Real> roots(const Rooted& equation, const Real& low, const Real& high) const;

 private:
  Rooted root(const Bend& b, const Real& weight);
  Curve curve(const LevelCurve& f);
  Rooted product(const Rooted& p, const Rooted& q) const;
  Rooted square(const Rooted& p) const { return product(p, p); }
  Rooted determinant(const Curve& f, const Curve& g) const { return product(f.x, g.y) - product(f.y, g.x); }
  Polynomial norm(Rooted p) const;
  bool may_vanish(const Rooted& p, const Interval& level) const;
  std::vector<Rooted> touching(const Curve& line, const Curve& circle) const;
  std::vector<Rooted> of_two() const;
  Rooted of_lines() const;
  Curve line_from(const Curve& base, const Curve& other) const;
  Rooted of_three() const;

  std::vector<Polynomial> t_;  // under the square roots
  std::vector<Curve> curves_;
  bool possible_ = true;
};

/// weight * sqrt(T)
Rooted Elimination::root(const Bend& b, const Real& weight) {
  Rooted out;
  if (is_plainly_zero(weight)) return out;
  const auto same = [&](const Polynomial& t) { return t[0] == b.t[0] && t[1] == b.t[1] && t[2] == b.t[2]; };
  const auto known = std::find_if(t_.begin(), t_.end(), same);
  const auto at = std::size_t(known - t_.begin());
  if (known == t_.end() && t_.size() == kMostRoots) {
    possible_ = false;
    return out;
  }
  if (known == t_.end()) t_.push_back({b.t[0], b.t[1], b.t[2]});
  out[std::size_t(1) << at] = {weight};
  return out;
}

Curve Elimination::curve(const LevelCurve& f) {
  if (!f.circle)
    return {false, plain({f.a}), plain({f.b}), plain({f.c, f.k}) + (f.bend ? root(*f.bend, f.bend->weight) : Rooted{})};
  if (!f.bend) return {true, plain({f.a}), plain({f.b}), plain({f.c, f.k})};
  const Bend& b = *f.bend;
  return {true, plain({f.a, b.along[0]}) + root(b, b.across[0]), plain({f.b, b.along[1]}) + root(b, b.across[1]),
          plain({f.c, f.k})};
}

Rooted Elimination::product(const Rooted& p, const Rooted& q) const {
  Rooted out;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) {
      if (p[i].empty() || q[j].empty()) continue;
      Polynomial f = p[i] * q[j];
      for (std::size_t k = 0; k < t_.size(); ++k)
        if ((i & j) >> k & 1u) f = f * t_[k];
      out[i ^ j] = out[i ^ j] + f;
    }
  return out;
}

/// The product over the signs of all square roots; nothing where its degree is too high.
Polynomial Elimination::norm(Rooted p) const {
  for (std::size_t k = 0; k < t_.size(); ++k) {
    Rooted with, without;
    bool occurs = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const bool has = (i >> k & 1u) != 0;
      occurs = occurs || (has && !p[i].empty());
      (has ? with[i ^ std::size_t(1) << k] : without[i]) = p[i];
    }
    if (!occurs) continue;
    p = square(without) - product(square(with), plain(t_[k]));
    for (const Polynomial& f : p)
      if (f.size() > kMostDegree + 1) return {};
  }
  return p[0];
}

/// As far as numbers tell.
bool Elimination::may_vanish(const Rooted& p, const Interval& level) const {
  std::vector<Interval> roots;
  for (const Polynomial& t : t_) {
    const Interval square = enclosure(t, level);
    if (square.hi < 0) return false;
    roots.push_back(sqrt(Interval{std::max(square.lo, 0.0), square.hi}));
  }
  Interval sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i].empty()) continue;
    Interval part = enclosure(p[i], level);
    for (std::size_t k = 0; k < roots.size(); ++k)
      if (i >> k & 1u) part = part * roots[k];
    sum = sum + part;
  }
  return certain_sign(sum) == 0;
}

std::vector<Real> Elimination::roots(const Rooted& equation, const Real& low, const Real& high) const {
  const Interval range{low.interval().lo, high.interval().hi};
  if (!may_vanish(equation, range)) return {};
  const Polynomial p = norm(equation);
  const double most = std::max(std::abs(range.lo), std::abs(range.hi));
  if (p.size() > kPlainDegree + 1 && range.hi - range.lo > most * margin::kNarrowLevel) return {};
  std::vector<Real> out;
  for (const Real& level : exact::roots_between(p, low, high))
    if (may_vanish(equation, level.interval()) && degree_bound(level) * double(p.size() - 1) <= kMostWork)
      out.push_back(level);
  return out;
}

/// The signed distance of the centre is the radius or its opposite.
std::vector<Rooted> Elimination::touching(const Curve& line, const Curve& circle) const {
  const Real &a = line.x[0].empty() ? Real() : line.x[0][0], b = line.y[0].empty() ? Real() : line.y[0][0];
  const Rooted at = product(line.x, circle.x) + product(line.y, circle.y) - line.c;
  const Rooted r = times(sqrt(a * a + b * b), circle.c);
  return {at - r, at + r};
}

std::vector<Rooted> Elimination::of_two() const {
  const Curve &f = curves_[0], &g = curves_[1];
  if (f.circle != g.circle) return f.circle ? touching(g, f) : touching(f, g);
  if (f.circle) {
    const Rooted d = square(f.x - g.x) + square(f.y - g.y);
    return {d - square(f.c + g.c), d - square(f.c - g.c)};
  }
  for (const Polynomial& p : determinant(f, g))
    if (std::any_of(p.begin(), p.end(), [](const Real& r) { return r.sign() != 0; })) return {};
  const auto dot = [&](const Curve& h) { return product(f.x, h.x) + product(f.y, h.y); };
  return {product(f.c, dot(g)) - product(g.c, dot(f))};
}

Rooted Elimination::of_lines() const {
  const Curve &f = curves_[0], &g = curves_[1], &h = curves_[2];
  return product(f.c, determinant(g, h)) + product(g.c, determinant(h, f)) + product(h.c, determinant(f, g));
}

/// With the base circle's centre as the origin: a line as it is, of a circle the difference of the equations.
Curve Elimination::line_from(const Curve& base, const Curve& other) const {
  if (!other.circle) return {false, other.x, other.y, other.c - product(other.x, base.x) - product(other.y, base.y)};
  const Rooted x = other.x - base.x, y = other.y - base.y;
  const Rooted twice = square(x) + square(y) + square(base.c) - square(other.c);
  return {false, times(2, x), times(2, y), twice};
}

/// The crossing of two lines, on a circle about the origin.
Rooted Elimination::of_three() const {
  const auto moves = [](const Curve& c) { return c.x[0].size() > 1 || c.y[0].size() > 1; };
  const auto rank = [&](const Curve& c) { return c.circle ? moves(c) ? 1 : 0 : 2; };
  const auto base = std::min_element(curves_.begin(), curves_.end(),
                                     [&](const Curve& f, const Curve& g) { return rank(f) < rank(g); });
  if (!base->circle) return of_lines();
  std::vector<Curve> lines;
  for (const Curve& c : curves_)
    if (&c != &*base) lines.push_back(line_from(*base, c));
  const Curve &f = lines[0], &g = lines[1];
  return square(product(f.c, g.x) - product(g.c, f.x)) + square(product(f.c, g.y) - product(g.c, f.y)) -
         square(product(base->c, determinant(f, g)));
}

std::vector<Rooted> Elimination::equations() const { return curves_.size() == 2 ? of_two() : std::vector{of_three()}; }

}  // namespace

std::vector<Real> curved_levels(std::span<const LevelCurve* const> level_curves, double low, double high) {
  const Elimination elimination(level_curves);
  std::vector<Real> out;
  if (!elimination.possible()) return out;
  for (const Rooted& equation : elimination.equations())
    for (Real& level : elimination.roots(equation, Real::from_double(low), Real::from_double(high)))
      out.push_back(std::move(level));
  return out;
}

}  // namespace findspace::distance
