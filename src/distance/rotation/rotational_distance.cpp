// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotational_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace findspace::distance {

using exact::Angle;
using exact::Real;
using plane::Mark;
using plane::RotationMap;

namespace {

using exact::kInfinity;
const Real kHalfCircle(180);

/// The distance of the angle, which carries `sign`, to the nearest one that does not (or lies at an end of those that
/// do).
double distance_out_of(const RotationMap& map, const Angle& at, Mark sign) {
  double best = kInfinity;
  for (std::size_t k = 0; k < map.at.size(); ++k) {
    if (map.here[k] == sign && map.after[k] == sign && map.before(k) == sign) continue;
    const double ahead = way(at, map.at[k]);
    best = std::min({best, ahead, 360 - ahead});
  }
  return best;
}

/// Marks along an open arc of the base map that carries `sign`, as f behaves there: - sign near its ends, 0 at the
/// distance t from an end, sign deeper inside.
class LevelArcs {
 public:
  LevelArcs(const RotationMap& base, Real distance, Mark sign) : base_(base), t_(std::move(distance)), sign_(sign) {}

  RotationMap run() {
    out_.everywhere = Mark(-sign_);
    const std::size_t n = base_.at.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Angle &from = base_.at[k], &to = base_.at[(k + 1) % n];
      if (base_.after[k] == sign_) arc(from, to, n == 1 ? 360 : way(from, to));
    }
    std::sort(points_.begin(), points_.end(), [](const Point& p, const Point& q) { return compare(p.at, q.at) < 0; });
    for (const Point& p : points_) {
      out_.at.push_back(p.at);
      out_.here.push_back(0);
      out_.after.push_back(p.after);
    }
    return out_;
  }

 private:
  struct Point {
    Angle at;
    Mark after;
  };

  void arc(const Angle& from, const Angle& to, double width) {
    const Angle first = from + t_, last = to - t_;
    const int order = order_of(width - 2 * t_.to_double(), first, last);
    if (order < 0) return;
    points_.push_back({first, order > 0 ? sign_ : Mark(-sign_)});
    if (order > 0) points_.push_back({last, Mark(-sign_)});
  }

  /// The sign of `gap`, the way from the first angle to the second; exact where it is small.
  static int order_of(double gap, const Angle& first, const Angle& last) {
    if (std::abs(gap) > 1) return gap > 0 ? 1 : -1;  // no sign: certain by far
    const int order = compare(last, first);
    return std::abs(last.degrees() - first.degrees()) < 180 ? order : -order;
  }

  const RotationMap& base_;
  Real t_;
  Mark sign_;
  RotationMap out_;
  std::vector<Point> points_;
};

bool has(const RotationMap& map, bool (*wanted)(Mark)) {
  if (map.at.empty()) return wanted(map.everywhere);
  return std::any_of(map.here.begin(), map.here.end(), wanted) ||
         std::any_of(map.after.begin(), map.after.end(), wanted);
}

bool in_c(Mark m) { return m <= 0; }
bool out_of_o(Mark m) { return m >= 0; }

}  // namespace

double rotation_distance(const RotationMap& base, const Angle& at) {
  const Mark sign = mark_at(base, at);
  if (sign == 0) return 0;
  const double d = distance_out_of(base, at, sign);
  return sign > 0 ? d : -d;
}

RotationMap rotation_sign_map(const RotationMap& base, const Real& level) {
  const int sign = level.sign();
  if (sign == 0) return base;
  if (!has(base, in_c)) return RotationMap::uniform(1);
  if (!has(base, out_of_o)) return RotationMap::uniform(-1);
  return LevelArcs(base, abs(level), Mark(sign)).run();
}

double farthest_rotation(const RotationMap& base, const Angle& at) {
  const double d = rotation_distance(base, at + kHalfCircle);
  return d == kInfinity ? d : 180 - std::max(0.0, d);
}

RotationMap farthest_rotation_sign_map(const RotationMap& base, const Real& level) {
  // The sign of 180 - d - level, d = max(0, f) of the opposite angle.
  if (!has(base, in_c)) return RotationMap::uniform(1);
  const Real rest = kHalfCircle - level;
  if (rest.sign() < 0) return RotationMap::uniform(-1);
  const bool at_least = rest.sign() == 0;
  const RotationMap f = rotation_sign_map(base, rest);
  return shifted(remark(f, [at_least](Mark k) { return at_least ? Mark(k > 0 ? -1 : 0) : Mark(-k); }), kHalfCircle);
}

}  // namespace findspace::distance
