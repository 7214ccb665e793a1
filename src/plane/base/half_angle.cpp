// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/half_angle.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {

HalfAngle HalfAngle::linear(double constant, double cosine, double sine) {
  HalfAngle p;
  p.degree = 2;
  p.c[0] = constant + cosine;
  p.c[1] = 2 * sine;
  p.c[2] = constant - cosine;
  return p;
}

double HalfAngle::at(double u) const {
  double r = 0;
  for (int k = degree; k >= 0; --k) r = r * u + c[std::size_t(k)];
  return r;
}

HalfAngle HalfAngle::derivative() const {
  HalfAngle p;
  p.degree = std::max(0, degree - 1);
  for (int k = 1; k <= degree; ++k) p.c[std::size_t(k - 1)] = k * c[std::size_t(k)];
  return p;
}

HalfAngle operator+(const HalfAngle& a, const HalfAngle& b) {
  HalfAngle p;
  p.degree = std::max(a.degree, b.degree);
  for (std::size_t k = 0; k < p.c.size(); ++k) p.c[k] = a.c[k] + b.c[k];
  return p;
}

HalfAngle operator-(const HalfAngle& a, const HalfAngle& b) { return a + -1.0 * b; }

HalfAngle operator*(const HalfAngle& a, const HalfAngle& b) {
  HalfAngle p;
  p.degree = a.degree + b.degree;
  for (int i = 0; i <= a.degree; ++i)
    for (int k = 0; k <= b.degree; ++k)
      p.c[std::size_t(i) + std::size_t(k)] += a.c[std::size_t(i)] * b.c[std::size_t(k)];
  return p;
}

HalfAngle operator*(double s, const HalfAngle& a) {
  HalfAngle p = a;
  for (double& x : p.c) x *= s;
  return p;
}

HalfAngle raised(const HalfAngle& a) {
  static const HalfAngle one = HalfAngle::linear(1, 0, 0);
  return a * one;
}

namespace {

double bisected(const HalfAngle& a, double from, double to) {
  const bool rises = a.at(from) < 0;
  for (int k = 0; k < 100; ++k) {
    const double middle = from + (to - from) / 2;
    if (middle <= from || middle >= to) break;
    ((a.at(middle) < 0) == rises ? from : to) = middle;
  }
  return from + (to - from) / 2;
}

/// The roots, and the places where the polynomial comes as near to 0 as `tolerance`.
std::vector<double> roots(const HalfAngle& a, double span, double tolerance) {
  // No root where the constant outweighs all else.
  double rest = 0, power = 1;
  for (int k = 1; k <= a.degree; ++k) {
    power *= span;
    rest += std::abs(a.c[std::size_t(k)]) * power;
  }
  if (std::abs(a.c[0]) > rest + tolerance) return {};
  std::vector<double> stops{-span}, out;
  if (a.degree > 1) {
    for (double u : roots(a.derivative(), span, 0)) stops.push_back(u);
  }
  stops.push_back(span);
  std::sort(stops.begin(), stops.end());
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const double f = a.at(stops[k]);
    if (std::abs(f) <= tolerance) out.push_back(stops[k]);
    if (k + 1 == stops.size()) break;
    if ((f < 0) != (a.at(stops[k + 1]) < 0)) out.push_back(bisected(a, stops[k], stops[k + 1]));
  }
  return out;
}

}  // namespace

std::vector<RootPlace> root_places(const HalfAngle& a, double span, double scale) {
  const double tolerance = scale * margin::kPolynomialLost;
  double all = 0, power = 1;
  for (int k = 0; k <= a.degree; ++k, power *= span) all += std::abs(a.c[std::size_t(k)]) * power;
  if (all <= tolerance) return {{0, span}};
  std::vector<RootPlace> out;
  for (double u : roots(a, span, tolerance)) {
    if (!out.empty() && std::abs(u - out.back().u) <= out.back().tolerance) continue;
    double width = margin::kFirstRootPlace;
    while (width < span && (std::abs(a.at(u - width)) <= 2 * tolerance || std::abs(a.at(u + width)) <= 2 * tolerance))
      width *= 2;
    out.push_back({u, std::min(2 * width, span)});
  }
  return out;
}

}  // namespace findspace::plane
