// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/curve/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::plane {
namespace {

/// With the chord along x and of length L the circles of the pencil are a (x^2 + y^2 - L x) = y: a point (x, y) lies
/// (y - a q) / sqrt(1 + (a L)^2) to their left, where q = x^2 + y^2 - L x.
struct Pencil {
  double ux, uy, length;
  Sample from;

  explicit Pencil(const FitQuestion& f)
      : ux(f.to.x - f.from.x), uy(f.to.y - f.from.y), length(std::hypot(ux, uy)), from(f.from) {
    ux /= length;
    uy /= length;
  }
  Sample rotated(const Sample& d) const { return {d.x * ux + d.y * uy, d.y * ux - d.x * uy}; }
  Sample local(const Sample& p) const { return rotated({p.x - from.x, p.y - from.y}); }
  double q(const Sample& p) const { return p.x * p.x + p.y * p.y - length * p.x; }
  double bulge(double a) const {
    const double t = a * length;
    return t / (1 + std::sqrt(1 + t * t));
  }
};

struct Range {
  double low, high;

  /// low <= y - a q <= high.
  void allow(double y, double q, double least, double most) {
    if (q == 0) {
      if (y < least || y > most) high = low - 1;
      return;
    }
    const double a = (y - most) / q, b = (y - least) / q;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};

/// y' - a q' at an end, going into the curve, must not lead out of the window.
void allow_tangent(Range& range, const Pencil& pencil, const Sample& tangent, const FitWindow& window, bool first) {
  const Sample d = pencil.rotated(tangent);
  constexpr double kFree = std::numeric_limits<double>::infinity();
  range.allow(first ? d.y : -d.y, -pencil.length * d.x, window.low < 0 ? -kFree : 0, window.high > 0 ? kFree : 0);
}

}  // namespace

std::optional<BulgeRange> bulges(const FitQuestion& f) {
  const Pencil pencil(f);
  if (!(pencil.length > 0)) return std::nullopt;
  const double most = std::tan(f.turn / 2) / pencil.length;
  Range range{-most, most};
  double stretch = 1;
  if (!f.samples.empty()) {
    const Sample middle = pencil.local(f.samples[f.samples.size() / 2]);
    const double q = pencil.q(middle), t = q == 0 ? 0 : std::clamp(middle.y / q, -most, most) * pencil.length;
    stretch = std::sqrt(1 + t * t);
  }
  for (const Sample& s : f.samples) {
    const Sample p = pencil.local(s);
    range.allow(p.y, pencil.q(p), f.window.low * stretch, f.window.high * stretch);
    if (!(range.low <= range.high)) return std::nullopt;
  }
  if (f.first_tangent) allow_tangent(range, pencil, *f.first_tangent, f.window, true);
  if (f.last_tangent) allow_tangent(range, pencil, *f.last_tangent, f.window, false);
  if (!(range.low <= range.high)) return std::nullopt;
  return BulgeRange{pencil.bulge(range.low), pencil.bulge(range.high)};
}

double simplest_between(double least, double most) {
  const double low = least + (most - least) / 4, high = most - (most - least) / 4;
  if (low <= 0 && high >= 0) return 0;
  constexpr int kMostDigits = 52;
  for (int digits = 0; digits < kMostDigits; ++digits) {
    const double k = std::ceil(std::ldexp(low, digits));
    if (k <= std::ldexp(high, digits)) return std::ldexp(k, -digits);
  }
  return low + (high - low) / 2;
}

}  // namespace findspace::plane
