// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "findspace/error.h"

namespace findspace::exact {
namespace {

constexpr double kNear = 1e-9;  // no sign: below it the exact comparison takes over
constexpr double kDegree = std::numbers::pi / 180;

double wrapped(double degrees) {
  double r = std::fmod(degrees, 360);
  if (r < 0) r += 360;
  return r >= 360 ? 0 : r;
}

/// The turn `n` times.
ExactAngle times(ExactAngle t, int128 n) {
  ExactAngle out;
  for (; n > 0; n /= 2, t = t + t) {
    if (n % 2 != 0) out = out + t;
  }
  return out;
}

/// The least n such that n * d is a whole number of circles, if it is at most kMostParts.
std::optional<int128> parts_of_circle(const Real& d) {
  constexpr int kMostParts = 4096;
  const Real x = d / Real(360);
  for (int n = 1; n <= kMostParts; ++n) {
    if ((x * Real(n)).integer()) return n;
  }
  return std::nullopt;
}

/// The remainder of d by 360, in (-180, 180].
Real centred(const Real& d) {
  Real r = d - Real(360) * Real(floor(d / Real(360)));
  return r > Real(180) ? r - Real(360) : r;
}

/// An exact rational, cut after 2^-260: what the series below is summed with.
Real cut(const Real& x, const Real& scale) {
  // floor() takes up to 126 bits, so in three portions.
  Real rest = x, out(0), unit(1);
  for (int portion = 0; portion < 3; ++portion) {
    const int128 part = floor(rest * scale / unit);
    const Real taken = Real(part) * unit / scale;
    out += taken;
    rest -= taken;
    unit = unit / scale;
  }
  return out;
}

/// Sine and cosine of d degrees, |d| <= 180, within 2^-200.
ExactAngle series(const Real& d) {
  static constexpr const char* kPi =
      "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798";
  Real scale(int128(1) << 85);
  const Real x = cut(d * Real::parse_decimal(kPi) / Real(180), scale);
  Real term(1), cosine(1), sine(0);
  for (int k = 1; k < 90; ++k) {
    term = cut(term * x / Real(k), scale);
    Real& sum = k % 2 == 0 ? cosine : sine;
    sum = k % 4 == 2 || k % 4 == 3 ? sum - term : sum + term;
  }
  return {cosine, sine};
}

/// Sign of the angle of `t` minus d degrees, the two being near each other on the circle.
int compare_near(const ExactAngle& t, const Real& d) {
  const Real r = centred(d);
  if (r.sign() == 0) return t.sin.sign();
  const ExactAngle s = series(r);
  const Real gap = t.sin * s.cos - t.cos * s.sin,
             tolerance = Real(1) / (Real(int128(1) << 100) * Real(int128(1) << 80));
  if (gap > tolerance) return 1;
  if (gap < -tolerance) return -1;
  if (const auto n = parts_of_circle(r)) {
    const ExactAngle round = times(t, *n);
    if (round.sin.sign() == 0 && round.cos.sign() > 0) return 0;
  }
  throw Error(ErrorCode::kUnsupported, "two angles are too close to each other to be distinguished");
}

double rough(const Angle& a) { return wrapped(a.rotation.degrees() + rounded_degrees(a.more)); }

}  // namespace

double rounded_degrees(const Real& degrees) {
  const double d = degrees.to_double();
  return std::abs(d) <= 360 ? d : centred(degrees).to_double();
}

ExactAngle ExactAngle::near(double degrees, int bits) {
  const double quarters = std::round(degrees / 90), rest = (degrees - 90 * quarters) * kDegree;
  const auto q = std::int64_t(1) << bits;
  const auto p = std::int64_t(std::llround(std::tan(rest / 2) * double(q)));
  const Real t = Real::ratio(p, q), one(1), below = one + t * t;
  ExactAngle rotation{(one - t * t) / below, (t + t) / below};
  for (int k = int(std::fmod(quarters, 4) + 4) % 4; k > 0; --k) rotation = {-rotation.sin, rotation.cos};
  return rotation;
}

double ExactAngle::degrees() const { return wrapped(std::atan2(sin.to_double(), cos.to_double()) / kDegree); }

std::vector<ExactAngle> rotations_where(const Real& a, const Real& b, const Real& c) {
  const Real square = a * a + b * b;
  if (square.sign() == 0) return {};
  const Real rest = square - c * c;
  if (rest.sign() < 0) return {};
  if (rest.sign() == 0) return {{a * c / square, b * c / square}};
  const Real root = sqrt(rest);
  return {{(a * c - b * root) / square, (b * c + a * root) / square},
          {(a * c + b * root) / square, (b * c - a * root) / square}};
}

double Angle::degrees() const {
  const double d = rough(*this);
  if (kNear < d && d < 360 - kNear) return d;
  // Near 0 or 360: on which side?
  if (compare_near(rotation, -more) >= 0) return d > 180 ? 0 : d;
  return d > 180 ? d : std::nextafter(360.0, 0.0);
}

int compare(const Angle& p, const Angle& q) {
  const double a = p.degrees(), b = q.degrees();
  if (a - b > kNear) return 1;
  if (b - a > kNear) return -1;
  return compare_near(p.rotation + -q.rotation, q.more - p.more);
}

double way(const Angle& from, const Angle& to) {
  const double d = to.degrees() - from.degrees();
  const bool forward = std::abs(d) > kNear ? d > 0 : compare(to, from) >= 0;
  return forward ? std::max(d, 0.0) : 360 + std::min(d, 0.0);
}

ExactAngle between(const ExactAngle& from, const ExactAngle& to) {
  const ExactAngle gap = to + -from;
  if (gap.sin.sign() == 0 && gap.cos.sign() > 0) return {-from.cos, -from.sin};
  const double start = from.degrees(), width = Angle{gap, {}}.degrees();
  for (int bits = 4; bits <= 30 && width > kNear; bits += 2) {
    if (std::ldexp(1.0, -bits) / kDegree > width) continue;
    const ExactAngle middle = ExactAngle::near(wrapped(start + width / 2), bits);
    // Strictly between where the way there, and from there on, are both shorter than the whole.
    const double there = (middle + -from).degrees(), on = (to + -middle).degrees();
    if (there > width / 4 && on > width / 4 && there + on < width * 1.5) return middle;
  }
  // The angles are very close: the middle of the short way, with square roots.
  const Real x = from.cos + to.cos, y = from.sin + to.sin, length = sqrt(x * x + y * y);
  return {x / length, y / length};
}

}  // namespace findspace::exact
