// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/level_cover.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/planar_distance.h"
#include "plane/base/parallel.h"
#include "plane/complex/extent.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::PieceBox;

namespace {

// A sign map costs about as much as some values for each edge.
constexpr std::size_t kFewLooks = 1000, kLooksAnEdge = 2, kMostLooks = 4000;
constexpr int kMostRounds = 40;

/// A power of two: middles of squares are short numbers then.
double power_above(double size) { return std::exp2(std::ceil(std::log2(std::max(size, 1.0)))); }

}  // namespace

LevelCover::LevelCover(const TDistance& f, const plane::Region& closed, int rotation)
    : f_(&f), rotation_(rotation), whole_(plane::is_whole(closed)) {
  if (!whole_) set_ = std::make_shared<const FeatureTree>(closed);
}

std::optional<LevelCover> LevelCover::of(const TDistance& f, const plane::Region& closed, int rotation,
                                         const RealPoint& start) {
  const bool bounded = closed.faces[0].mark <= 0;
  const auto size = f.size();
  if (!size || (!bounded && (rotation < 0 || !size->reach))) return std::nullopt;
  PieceBox box{};
  if (bounded) {
    const auto all = plane::extent(closed);
    if (!all) return std::nullopt;
    box = *all;
  } else {
    // Beyond, f(p) >= |p| - reach is more than at the start.
    const auto value = f.value(start);
    if (!value || value->minus_infinity) return std::nullopt;
    const double far = *size->reach + std::abs(near_value(value->value)) + 1;
    box = {-far, -far, far, far};
  }
  LevelCover out(f, closed, rotation);
  out.most_looks_ = std::min(kMostLooks, kFewLooks + kLooksAnEdge * size->edges);
  const double x = std::round(box.x0 + (box.x1 - box.x0) / 2), y = std::round(box.y0 + (box.y1 - box.y0) / 2);
  Square root{x, y, power_above(std::max({x - box.x0, box.x1 - x, y - box.y0, box.y1 - y}))};
  out.scale_ = std::max(std::abs(x), std::abs(y)) + root.half + size->reach.value_or(0);
  if (!out.look(root)) return std::nullopt;
  out.high_ = root.high;
  out.squares_.push_back(root);
  constexpr double kFirst = 0x1p-6;  // no sign: of the root, what is looked for first
  out.narrow(root.half * kFirst, root.half * kFirst);
  return out;
}

/// False where no value is known.
bool LevelCover::look(Square& s) const {
  const double radius = s.half * std::sqrt(2.0) * margin::kUpward;
  double off = 0;  // of the nearest position of S
  if (!whole_) {
    const auto near = set_->nearest(s.x, s.y);
    const auto in = set_->contains(s.x, s.y, near);
    const double noise = scale_ * margin::kMaxMinNoise;
    if (in != true) off = near.distance + noise;
    if (in == false && near.distance - noise > radius) {
      s.low = s.high = exact::kInfinity;
      return true;
    }
  }
  const auto value = f_->value({Real::from_double(s.x), Real::from_double(s.y)});
  if (!value || value->minus_infinity) return false;
  const double v = rotation_ * near_value(value->value);
  const double noise = value->slack() + (scale_ + std::abs(v)) * margin::kKnownNumber + margin::kUpwardSteps;
  s.low = v - radius - noise;
  s.high = v + off + noise;
  return true;
}

/// One round: quarters of all squares wider than `half` in which a position may be no worse than `most`. False where
/// there are none, or too many.
bool LevelCover::split(double most, double half) {
  std::vector<Square> kept, quarters;
  for (const Square& s : squares_) {
    if (s.low > most || s.half <= half) {
      kept.push_back(s);
      continue;
    }
    const double h = s.half / 2;
    for (const double dx : {-h, h})
      for (const double dy : {-h, h}) quarters.push_back({s.x + dx, s.y + dy, h});
  }
  if (quarters.empty() || looks_ + quarters.size() > most_looks_) return false;
  looks_ += quarters.size();
  std::vector<char> known(quarters.size());
  plane::parallel_for(quarters.size(), [&](std::size_t k) { known[k] = look(quarters[k]); });
  if (std::find(known.begin(), known.end(), 0) != known.end()) return false;
  for (const Square& s : quarters) high_ = std::min(high_, s.high);
  kept.insert(kept.end(), quarters.begin(), quarters.end());
  std::erase_if(kept, [&](const Square& s) { return s.low > high_ + slack_; });
  squares_ = std::move(kept);
  return true;
}

double LevelCover::low() const {
  double least = high_;
  for (const Square& s : squares_) least = std::min(least, s.low);
  return least;
}

std::optional<bool> LevelCover::is_passed(const Real& level) const {
  const auto within = level.interval();
  if ((rotation_ > 0 ? within.lo : -within.hi) > high_) return true;
  if ((rotation_ > 0 ? within.hi : -within.lo) < low()) return false;
  return std::nullopt;
}

void LevelCover::decide(const Real& level) {
  constexpr int kMostSteps = 8;
  for (int step = 0; step < kMostSteps && !is_passed(level); ++step)
    if (!split(rotation_ * near_value(level), 0)) return;
}

bool LevelCover::narrow(double slack, double half) {
  slack_ = std::min(slack_, slack);
  for (int round = 0; round < kMostRounds && split(high_ + slack_, half); ++round) {
  }
  return std::none_of(squares_.begin(), squares_.end(),
                      [&](const Square& s) { return s.low <= high_ + slack_ && s.half > half; });
}

std::vector<PieceBox> LevelCover::boxes() const {
  std::vector<PieceBox> out;
  for (const Square& s : squares_)
    if (s.low <= high_ + slack_) out.push_back({s.x - s.half, s.y - s.half, s.x + s.half, s.y + s.half});
  return out;
}

}  // namespace findspace::distance
