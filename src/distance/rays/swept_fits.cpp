// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/swept_fits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/solid/space_sign.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using exact::int128;
using exact::Real;
using space::Body;
using space::Point;
using space::RealVector;

namespace {

constexpr double kLengths = 1 << 14;                // that are told apart
constexpr double kFarthestOut = double(1LL << 39);  // of coordinates in finer steps
constexpr int kMostSweeps = 24, kMostUnknown = 4;

/// A direction in whole steps that have no common part; nothing where it is irrational or of more than 2^30 steps.
std::optional<Point> in_steps(const RealVector& direction) {
  int128 common = 1;
  std::array<std::array<int128, 2>, 3> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto fraction = direction[k].fraction();
    if (!fraction || (*fraction)[1] > 1 << 30) return std::nullopt;
    parts[k] = *fraction;
    common = common / exact::gcd(common, parts[k][1]) * parts[k][1];
    if (common > 1 << 30) return std::nullopt;
  }
  std::array<int128, 3> out{};
  int128 shared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (parts[k][0] > 1 << 30 || parts[k][0] < -(1 << 30)) return std::nullopt;
    out[k] = parts[k][0] * (common / parts[k][1]);
    shared = exact::gcd(shared, out[k] < 0 ? -out[k] : out[k]);
  }
  for (int128& c : out) c /= shared;
  if (std::any_of(out.begin(), out.end(), [](int128 c) { return c > 1 << 30 || c < -(1 << 30); })) return std::nullopt;
  return Point{static_cast<std::int64_t>(out[0]), static_cast<std::int64_t>(out[1]), static_cast<std::int64_t>(out[2])};
}

/// What the body covers on its way.
Body swept(const Body& body, const Point& way) {
  Body out = body;
  out.around.clear();
  for (space::BodyPart& part : out.parts) {
    std::vector<Point> corners;
    for (const Point& v : part.vertices()) {
      corners.push_back(v);
      corners.push_back(v + way);
    }
    part = space::part_of(corners, part.radius);
  }
  return out;
}

/// Lengths between one that fits and one that does not; in the middle perhaps such that the search does not tell.
class SweptLengths {
 public:
  explicit SweptLengths(std::int64_t too_long) : none_(too_long) {}

  /// The next to be looked at; nothing where all that is told is known.
  std::optional<std::int64_t> next() const {
    const std::int64_t below = (untold() ? from_ : none_) - fits_, above = untold() ? none_ - to_ : 0;
    if (std::max(below, above) <= 1) return std::nullopt;
    return below >= above ? fits_ + below / 2 : to_ + above / 2;
  }
  void take(std::int64_t length, SweptFit::Found found) {
    if (found == SweptFit::Found::kSomewhere) {
      fits_ = length;
    } else if (found == SweptFit::Found::kNowhere) {
      none_ = length;
    } else {
      from_ = untold() ? std::min(from_, length) : length;
      to_ = std::max(to_, length);
    }
    if (untold() && (fits_ > from_ || none_ < to_)) from_ = to_ = 0;
  }
  std::int64_t fits() const { return fits_; }
  std::int64_t none() const { return none_; }

 private:
  bool untold() const { return to_ > 0; }

  std::int64_t fits_ = 0, none_, from_ = 0, to_ = 0;
};

}  // namespace

SweptFit any_fit(const PositionSet& fits, const space::Vector& near, long cells) {
  const Until any{8 * (fits.size() + space::length(near)), 0, 0, cells};
  const BoundaryPlace found = fits.nearest_to(distance_to_point(near), {0, {}, &any});
  if (found.found) return {SweptFit::Found::kSomewhere, found.place};
  if (found.unresolved || !found.complete) return {};
  return {SweptFit::Found::kNowhere};
}

TriedAnswer least_of_swept_fits(const Body& b, const space::Bounds3& within, const RealVector& direction,
                                bool both_ways, const FitSearch& search) {
  const auto box = space::fitting(bounds(b), within);
  if (!box) return std::nullopt;
  const std::optional<Point> unit = in_steps(direction);
  if (!unit) return exact::Refusal("along such a direction the least fit is not computed: choose one of fewer digits");
  const RealVector way = space::real(*unit);
  double longest = exact::kInfinity, far = 0;  // in lengths of the unit
  for (std::size_t k = 0; k < 3; ++k) {
    if (way[k].sign() != 0)
      longest = std::min(longest, (box->high[k] - box->low[k]).to_double() / std::fabs(way[k].to_double()));
    far = std::max({far, std::fabs(within.low[k].to_double()), std::fabs(within.high[k].to_double()),
                    std::fabs(box->low[k].to_double()), std::fabs(box->high[k].to_double())});
  }
  std::int64_t finer = 1;
  while (longest * double(finer) < kLengths && far * 2 * double(finer) < kFarthestOut) finer *= 2;
  const Body fine = at_scale(b, b.scale * finer);
  const auto ask = [&](std::int64_t length) {
    return search(swept(fine, {unit->x * length, unit->y * length, unit->z * length}), finer);
  };
  const plane::SearchQuestion question;
  const exact::Tried<SweptFit> still = search(fine, finer);
  if (!still) return still.refusal();
  if (still->found == SweptFit::Found::kNowhere) return std::nullopt;
  SweptLengths lengths(static_cast<std::int64_t>(std::ceil(longest * double(finer))) + 1);
  SweptFit best = *still;
  if (best.found == SweptFit::Found::kSomewhere) {
    int unknown = 0;
    for (int k = 0; k < kMostSweeps && unknown < kMostUnknown && !question.work().spent(); ++k) {
      const auto length = lengths.next();
      if (!length) break;
      const exact::Tried<SweptFit> found = ask(*length);
      if (!found) return found.refusal();
      lengths.take(*length, found->found);
      if (found->found == SweptFit::Found::kSomewhere) best = *found;
      if (found->found == SweptFit::Found::kUnknown) ++unknown;
    }
  }
  const Real steps = Real::ratio(1, finer);
  const auto value = [&](std::int64_t length) {
    return -Real(length) * steps * sqrt(space::dot(way, way)) / Real(both_ways ? 2 : 1);
  };
  const RealVector middle =
      space::along(space::scaled(steps, space::real(best.at)), Real(lengths.fits()) * steps / Real(2), way);
  Answer out = least_answer(value(lengths.fits()), value(lengths.none()), false, middle);
  // Perhaps it fits nowhere.
  if (best.found == SweptFit::Found::kUnknown) out.enclosed->upper.reset();
  if (!both_ways || best.found == SweptFit::Found::kUnknown) out.side = Side::kNone;
  return out;
}

}  // namespace findspace::distance
