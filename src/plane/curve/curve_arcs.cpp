// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Greedy: from each joint the longest stretch that one arc is found and proved for. Joints of a chain on a side lie
// half the window beside the curve, so that the error has the whole window to swing in.
#include "plane/curve/curve_arcs.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "findspace/error.h"
#include "plane/contour/contour.h"
#include "plane/curve/arc_fit.h"

namespace findspace::plane {
namespace {

using exact::Interval;

double middle(const Interval& a) { return a.lo + (a.hi - a.lo) / 2; }

double value(const IntervalPolynomial& a, double t) {
  std::vector<double> c;
  for (const Interval& i : a) c.push_back(middle(i));
  for (std::size_t n = c.size() - 1; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
  return c[0];
}

class Chainer {
 public:
  Chainer(const Curve& curve, double bound, CurveSide side)
      : curve_(curve), bound_(bound), side_(side), end_(double(curve.pieces.size())) {}

  ArcChain run() {
    at_ = 0;
    joint_ = curve_.from;
    double step = 0.25;
    while (at_ < end_) {
      const double before = at_;
      if (!arc_from(step) && !patch()) break;
      step = std::max(at_ - before, end_ / kMostJoints);
    }
    return std::move(chain_);
  }

 private:
  /// Far more than any bound needs, and few enough to end.
  static constexpr double kMostJoints = 1 << 20;
  static constexpr int kSamples = 14, kTries = 24, kHalvings = 7;
  static constexpr double kTurnNear = 2.8, kTurnSided = 1.3;  // radians

  Sample point(double s) const {
    const auto i = std::size_t(std::min(std::floor(s), end_ - 1));
    const CurvePiece& p = curve_.pieces[i];
    const double t = s - double(i), w = p.w.empty() ? 1 : value(p.w, t);
    return {value(p.x, t) / w, value(p.y, t) / w};
  }

  /// The direction in which the curve goes on from s, or comes to it; of length 1, or 0 where it has none.
  Sample direction(double s, bool before = false) const {
    const double h = kStep;
    const double a = before || s + h > end_ ? s - h : s, b = before || s + h > end_ ? s : s + h;
    const Sample p = point(std::max(a, 0.0)), q = point(b);
    const double dx = q.x - p.x, dy = q.y - p.y, length = std::hypot(dx, dy);
    if (!(length > 0)) return {0, 0};
    return {dx / length, dy / length};
  }
  static constexpr double kMostRadius = double(std::int64_t{1} << 40);
  static constexpr double kStep = 1.0 / (1 << 20);  // no sign: only where arcs are tried; the bound is proved

  double towards() const { return double(static_cast<int>(side_)); }

  /// The grid point beside the curve at s where arcs join.
  GridPoint joint(double s, double part) const {
    if (s >= end_) return curve_.to;
    const Sample p = point(s), d = direction(s);
    const double away = towards() * bound_ * part;
    return {curve_.from.x + std::llround(p.x - d.y * away), curve_.from.y + std::llround(p.y + d.x * away)};
  }

  FitQuestion question(double s, const GridPoint& to) const {
    FitQuestion f;
    f.from = local(joint_);
    f.to = local(to);
    for (int i = 1; i <= kSamples; ++i) f.samples.push_back(point(at_ + (s - at_) * i / (kSamples + 1)));
    const double window = side_ == CurveSide::kNear ? bound_ - 4 : bound_ * kWindowPart;
    f.window = {side_ == CurveSide::kRight ? 0 : -window, side_ == CurveSide::kLeft ? 0 : window};
    f.turn = side_ == CurveSide::kNear ? kTurnNear : kTurnSided;
    if (side_ != CurveSide::kNear && at_ == 0) f.first_tangent = direction(0);
    if (side_ != CurveSide::kNear && s >= end_) f.last_tangent = direction(end_, true);
    return f;
  }

  Sample local(const GridPoint& p) const { return {double(p.x - curve_.from.x), double(p.y - curve_.from.y)}; }

  bool fits(double s) const {
    const GridPoint to = joint(s, kWindowPart / 2);
    const auto range = bulges(question(s, to));
    return range && has_radius(*range, to);
  }

  /// Whether one of them is a segment, or an arc whose radius the grid has.
  bool has_radius(const BulgeRange& range, const GridPoint& to) const {
    const double b = std::max(std::abs(range.low), std::abs(range.high));
    if (range.low <= 0 && range.high >= 0) return true;
    const double chord = std::hypot(double(to.x - joint_.x), double(to.y - joint_.y));
    return chord * (1 + b * b) <= kMostRadius * 4 * b;
  }

  /// The largest s that fits, about; 0 where none was found.
  double farthest(double step) const {
    double good = 0, bad = end_ * 2;
    for (double s = std::min(at_ + step, end_); good < end_;) {
      if (fits(s)) {
        good = s;
        if (bad <= end_) break;
        s = std::min(at_ + 2 * (s - at_), end_);
      } else {
        bad = s;
        if (good > 0 || bad - at_ < end_ / kMostJoints) break;
        s = at_ + (s - at_) / 4;
      }
    }
    if (good == 0 || good >= end_) return good;
    for (int i = 0; i < kHalvings; ++i) {
      const double s = good + (bad - good) / 2;
      (fits(s) ? good : bad) = s;
    }
    // The last two share what is left, so that the last is not a splinter.
    return end_ - good < (good - at_) / 2 ? at_ + (end_ - at_) / 2 : good;
  }

  bool arc_from(double step) {
    double s = farthest(step);
    if (s == 0) return false;
    for (int i = 0; i < kTries; ++i) {
      if (point_moved(s) < bound_ / 4) return false;  // a patch reaches as far
      if (try_arc(s)) return true;
      s = at_ + (s - at_) * (i < 4 ? 0.95 : 0.7);
    }
    return false;
  }

  double point_moved(double s) const {
    const Sample a = point(at_), b = point(s);
    return std::hypot(b.x - a.x, b.y - a.y);
  }

  bool try_arc(double s) {
    const GridPoint to = joint(s, kWindowPart / 2);
    const auto range = bulges(question(s, to));
    if (!range) return false;
    ContourEdge edge = arc_between(to, *range);
    if (edge.arc && !(edge.arc->r.to_double() <= kMostRadius)) return false;
    const std::vector<CurvePiece> stretch = stretch_to(s);
    const ArcClaim claim{&stretch, curve_.from, edge, to, bound_, side_, at_ == 0, s >= end_};
    if (!proved(claim)) return false;
    advance(s, to, std::move(edge));
    return true;
  }

  /// An arc whose tangent at the joint is a rational unit vector of few digits, so that its centre and its radius are
  /// rational; a segment where the range allows it.
  ContourEdge arc_between(const GridPoint& to, const BulgeRange& range) const {
    using exact::Real;
    if (simplest_between(range.low, range.high) == 0) return {.start = joint_};
    const double chord = std::atan2(double(to.y - joint_.y), double(to.x - joint_.x));
    double low = chord - 2 * std::atan(range.high), high = chord - 2 * std::atan(range.low);  // of the tangent
    int flip = 1;
    for (const double turn = std::numbers::pi; low + high > turn; flip = -flip) {
      low -= turn;
      high -= turn;
    }
    for (const double turn = std::numbers::pi; low + high < -turn; flip = -flip) {
      low += turn;
      high += turn;
    }
    const Real t = Real::from_double(simplest_between(std::tan(low / 2), std::tan(high / 2)));
    const Real size = Real(flip) / (Real(1) + t * t), c = (Real(1) - t * t) * size, s = (t + t) * size;
    const Real dx(to.x - joint_.x), dy(to.y - joint_.y);
    const Real beside = c * dy - s * dx;  // of the chord's end, to the left of the tangent
    if (beside.sign() == 0) return {.start = joint_};
    const Real rho = (dx * dx + dy * dy) / (beside + beside);  // the radius, positive where the centre is on the left
    return {joint_,
            std::make_shared<const ArcCircle>(
                ArcCircle{Real(joint_.x) - s * rho, Real(joint_.y) + c * rho, rho.sign() > 0 ? rho : -rho}),
            rho.sign() > 0};
  }

  std::vector<CurvePiece> stretch_to(double s) const {
    std::vector<CurvePiece> out;
    for (double i = std::floor(at_); i < s; ++i) {
      const double t0 = std::max(at_ - i, 0.0), t1 = std::min(s - i, 1.0);
      if (t0 < t1) out.push_back(part_of(curve_.pieces[std::size_t(i)], t0, t1));
    }
    return out;
  }

  void advance(double s, const GridPoint& to, ContourEdge edge) {
    if (joint_ != to) chain_.edges.push_back(std::move(edge));
    at_ = s;
    joint_ = to;
  }

  /// A segment over a stretch whose box is smaller than the bound; on a side the box is a cap.
  bool patch() {
    for (double s = end_, step = end_ - at_; step > 0; step /= 2, s = at_ + step) {
      if (s == at_) break;
      const GridPoint to = joint(s, kWindowPart / 8);
      const StretchBox box = box_of(stretch_to(s), curve_.from, joint_, to);
      if (!(box.diameter() <= bound_)) continue;
      if (side_ != CurveSide::kNear) chain_.caps.push_back({moved(box.x0, box.y0), moved(box.x1, box.y1)});
      advance(s, to, {.start = joint_});
      return true;
    }
    throw Error(ErrorCode::kUnsupported, "a curve that no arcs were found for; a larger tolerance may help");
  }

  GridPoint moved(double x, double y) const {
    return {curve_.from.x + std::llround(x), curve_.from.y + std::llround(y)};
  }

  const Curve& curve_;
  double bound_;
  CurveSide side_;
  double end_, at_ = 0;
  GridPoint joint_{};
  ArcChain chain_;
};

}  // namespace

ArcChain arcs_of(const Curve& curve, double bound, CurveSide side) {
  if (!(bound >= kLeastBound))
    throw Error(ErrorCode::kBadValue,
                fmt::format("a tolerance of {:.3g} grid steps; it must be at least {}", bound, kLeastBound));
  return Chainer(curve, bound, side).run();
}

}  // namespace findspace::plane
