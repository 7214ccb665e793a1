// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/over_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/planar_features/boundary_features.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/plane.h"
#include "exact/margins/rounding.h"
#include "plane/base/subdivide.h"
#include "plane/build/path_region.h"
#include "plane/build/swept.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/moved.h"
#include "plane/query/section.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::SignMap;
using plane::operator+;
using plane::operator-;

namespace {

using plane::PathPiece;

/// f at some points of pieces, as numbers, brackets its extremum: it changes by at most the way (Piyavskii 1972).
class PathSearch {
 public:
  PathSearch(const TDistance& f, std::span<const PathPiece> pieces, Sense sense)
      : f_(f), pieces_(pieces), sign_(sense == Sense::kMinimum ? 1 : -1) {}

  std::optional<Bracket> run() {
    constexpr int kFirst = 4, kMost = 200;
    double length = 0;
    for (std::size_t leg = 0; leg < pieces_.size(); ++leg) {
      double f = look(leg, 0);
      if (way(leg) == 0) continue;
      for (int k = 1; k <= kFirst; ++k) {
        const double to = double(k) / kFirst, g = look(leg, to);
        push({leg, to - 1.0 / kFirst, to, f, g, 0});
        f = g;
      }
      length += way(leg);
    }
    gaps_.run(
        kMost, [&](const Gap& gap) { return best_ - gap.low <= length * margin::kPathEnough; },
        [&](const Gap& gap) {
          const double middle = gap.from + (gap.to - gap.from) / 2, f = look(gap.leg, middle);
          push({gap.leg, gap.from, middle, gap.f, f, 0});
          push({gap.leg, middle, gap.to, f, gap.g, 0});
        });
    refine();
    return Bracket{sign_ * best_, sign_ * (gaps_.empty() ? best_ : std::min(best_, gaps_.best().low)), true};
  }

 private:
  struct Gap {
    std::size_t leg;
    double from, to, f, g, low;
    bool operator<(const Gap& other) const { return low > other.low; }
  };

  /// Golden sections of the gaps beside the best point: f is smooth or has one kink there.
  void refine() {
    constexpr double kGolden = 0.6180339887498949;  // no sign: where to look next
    constexpr int kSteps = 50;
    const std::span<const Gap> gaps = gaps_.left();
    const auto best = std::min_element(
        gaps.begin(), gaps.end(), [](const Gap& g, const Gap& h) { return std::min(g.f, g.g) < std::min(h.f, h.g); });
    if (best == gaps.end()) return;
    const std::size_t leg = best->leg;
    const double at = best->f < best->g ? best->from : best->to;
    double from = best->from, to = best->to;
    for (const Gap& g : gaps) {
      if (g.leg == leg && g.to == at) from = g.from;
      if (g.leg == leg && g.from == at) to = g.to;
    }
    double low = to - kGolden * (to - from), high = from + kGolden * (to - from);
    double f = look(leg, low), g = look(leg, high);
    for (int k = 0; k < kSteps; ++k) {
      if (f < g) {
        to = high;
        high = low;
        g = f;
        low = to - kGolden * (to - from);
        f = look(leg, low);
      } else {
        from = low;
        low = high;
        f = g;
        high = from + kGolden * (to - from);
        g = look(leg, high);
      }
    }
  }

  double way(std::size_t leg) const {
    const RealPoint d = pieces_[leg].to - pieces_[leg].from;
    return std::hypot(near_value(d.x), near_value(d.y)) * margin::kUpward;
  }

  double look(std::size_t leg, double part) {
    const RealPoint& from = pieces_[leg].from;
    const Real s = Real::from_double(part);
    const RealPoint d = pieces_[leg].to - from;
    const double v = sign_ * f_.value({from.x + s * d.x, from.y + s * d.y})->value.to_double();
    best_ = std::min(best_, v);
    return v;
  }

  void push(Gap gap) {
    gap.low = (gap.f + gap.g - way(gap.leg) * (gap.to - gap.from)) / 2;
    gaps_.push(gap);
  }

  const TDistance& f_;
  std::span<const PathPiece> pieces_;
  double sign_, best_ = std::numeric_limits<double>::infinity();
  plane::Subdivision<Gap> gaps_;
};

/// The sign of the least (greatest) value along the path from every position.
SignMap extreme_along(SignMap m, const RelativePath& path, Sense sense) {
  if (sense == Sense::kMinimum) return least_along(m, path);
  return negated(least_along(negated(std::move(m)), path));
}

class OverTime : public PositionFunction {
 public:
  OverTime(TDistancePointer f, RelativePath path, Sense sense)
      : f_(std::move(f)), path_(std::move(path)), sense_(sense) {}

  bool defined() const override { return f_->defined(); }

  SignMap sign_map(const Real& level) const override { return extreme_along(f_->sign_map(level), path_, sense_); }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    RelativePath moved = path_;
    for (RealPoint& w : moved) w = w + p;
    return best_on_pieces(*f_, plane::pieces_of_path(moved), sense_);
  }

 private:
  TDistancePointer f_;
  RelativePath path_;
  Sense sense_;
};

class JumpingOverTime : public PositionFunction {
 public:
  JumpingOverTime(PositionFunctionPointer f, RelativePath path, Sense sense)
      : f_(std::move(f)), path_(std::move(path)), sense_(sense) {
    for (std::size_t k = 0; k < path_.size(); ++k) times_.emplace_back(int(k));
  }

  bool defined() const override { return f_->defined(); }

  SignMap sign_map(const Real& level) const override { return extreme_along(f_->sign_map(level), path_, sense_); }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    if (!defined()) return std::nullopt;
    return bisected([&](const Real& level) { return sign(p, level); });
  }

 private:
  /// Of the extremum at p minus the level.
  Mark sign(const RealPoint& p, const Real& level) const {
    const SignMap m = f_->sign_map(level);
    if (path_.size() == 1) return mark_of(m, locate(m, p + path_[0]));
    const plane::Section line = plane::section_of_path(m, p, path_, times_);
    Mark best = line.stops[0].at;
    for (std::size_t k = 0; k < line.stops.size(); ++k) {
      for (const Mark mark : {line.stops[k].at, k + 1 < line.stops.size() ? line.stops[k].after : line.stops[k].at})
        best = sense_ == Sense::kMinimum ? std::min(best, mark) : std::max(best, mark);
    }
    return best;
  }

  PositionFunctionPointer f_;
  RelativePath path_;
  Sense sense_;
  std::vector<Real> times_;
};

class AtInstant : public PositionFunction {
 public:
  AtInstant(PositionFunctionPointer f, const RealPoint& by) : f_(std::move(f)), by_(by) {}

  bool defined() const override { return f_->defined(); }
  SignMap sign_map(const Real& level) const override { return plane::moved(f_->sign_map(level), -by_); }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    auto v = f_->value(p + by_);
    if (v && v->nearest) v->nearest = *v->nearest - by_;
    return v;
  }

 private:
  PositionFunctionPointer f_;
  RealPoint by_;
};

}  // namespace

std::optional<PlanarAnswer> best_on_pieces(const TDistance& f, std::span<const PathPiece> pieces, Sense sense) {
  if (!f.defined()) return std::nullopt;
  // It changes no faster than the position, so it is infinite everywhere or nowhere.
  if (auto v = f.value(pieces.front().from); !v || v->minus_infinity) return v;
  const Extremum e = extremum(f, plane::region_of_pieces(pieces), sense, PathSearch(f, pieces, sense).run());
  if (!e.exists()) return std::nullopt;
  if (e.proven()) return exact_answer(e.answer->value, Way::kMap);
  return enclosed_answer(*e.value(), *e.value(), *e.bound());
}

std::optional<PlanarAnswer> bisected(const std::function<Mark(const Real&)>& sign) {
  if (sign(Real()) == 0) return exact_answer(Real(), Way::kMap);
  if (sign(Real::from_double(-margin::kBeyondAll)) <= 0) return lowest_answer(Way::kMap);
  if (sign(Real::from_double(margin::kBeyondAll)) > 0) return std::nullopt;
  double low = -margin::kBeyondAll, high = margin::kBeyondAll;  // f is above the one, not above the other
  for (int k = 0; k < 110; ++k) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (sign(Real::from_double(middle)) > 0 ? low : high) = middle;
  }
  const Real whole = exact::round(Real::from_double(high));
  if (sign(whole) == 0) return exact_answer(whole, Way::kMap);
  return enclosed_answer(Real::from_double(high), Real::from_double(low), Real::from_double(high));
}

PositionFunctionPointer over_time(TDistancePointer f, RelativePath path, Sense sense) {
  return std::make_shared<OverTime>(std::move(f), std::move(path), sense);
}

PositionFunctionPointer jumping_over_time(PositionFunctionPointer f, RelativePath path, Sense sense) {
  return std::make_shared<JumpingOverTime>(std::move(f), std::move(path), sense);
}

PositionFunctionPointer at_instant(PositionFunctionPointer f, const RealPoint& by) {
  return std::make_shared<AtInstant>(std::move(f), by);
}

}  // namespace findspace::distance
