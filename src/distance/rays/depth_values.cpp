// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/depth_values.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostPieces = 4000;
using exact::kInfinity;

/// Whether the bounds tell all that is wanted.
bool settled(double low, double high, double size) {
  return (low > 0 && high <= 2 * low) || (high < 0 && low >= 2 * high) || high - low <= margin::kBoundsMeet * size;
}

struct Piece {
  double from = 0, to = 0;
  std::vector<int> active;
  std::vector<double> at_from, at_to;
  double bound = 0, cut = 0;  // nothing is more; where to divide
  bool operator<(const Piece& other) const { return bound < other.bound; }
};

class Search {
 public:
  Search(std::span<const ConvexDistance> functions, const Vector& p, const PathStretch& way, double size)
      : functions_(functions), p_(p), way_(way), size_(size) {}

  Between run() {
    Piece all;
    all.from = way_.from;
    all.to = way_.to;
    all.active.resize(functions_.size());
    std::iota(all.active.begin(), all.active.end(), 0);
    all.at_from = values(all.from, all.active);
    all.at_to = values(all.to, all.active);
    add(std::move(all));
    queue_.run(
        kMostPieces, [&](const Piece& top) { return settled(best_, std::max(best_, top.bound), size_); },
        [&](const Piece& top) { divide(top); });
    const double high = queue_.empty() ? best_ : std::max(best_, queue_.best().bound);
    return {best_ - margin::kRayNoise * size_, high + margin::kRayNoise * size_};
  }

 private:
  std::vector<double> values(double s, const std::vector<int>& active) {
    const Vector x = space::plus(p_, space::scaled(s, way_.unit));
    std::vector<double> out;
    double least = kInfinity;
    for (const int i : active) {
      out.push_back(functions_[static_cast<std::size_t>(i)](x));
      least = std::min(least, out.back());
    }
    best_ = std::max(best_, least);
    return out;
  }

  /// Drops functions that are the least nowhere on the piece, and bounds it by chords.
  void add(Piece piece) {
    const double length = piece.to - piece.from;
    double bound = kInfinity;
    for (std::size_t k = 0; k < piece.active.size(); ++k)
      bound = std::min(bound, std::max(piece.at_from[k], piece.at_to[k]));
    Piece kept;
    kept.from = piece.from;
    kept.to = piece.to;
    for (std::size_t k = 0; k < piece.active.size(); ++k) {
      if (std::max(piece.at_from[k], piece.at_to[k]) - length > bound) continue;
      kept.active.push_back(piece.active[k]);
      kept.at_from.push_back(piece.at_from[k]);
      kept.at_to.push_back(piece.at_to[k]);
    }
    const auto least_at = [](const std::vector<double>& v) {
      return static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
    };
    const std::size_t i = least_at(kept.at_from), j = least_at(kept.at_to);
    // The chord of i is below that of j at one end, above it at the other.
    const double gap_from = kept.at_from[j] - kept.at_from[i], gap_to = kept.at_to[i] - kept.at_to[j];
    const double share = gap_from + gap_to > 0 ? gap_from / (gap_from + gap_to) : 0.5;
    const double meeting = kept.at_from[i] + share * (kept.at_to[i] - kept.at_from[i]);
    kept.bound = std::min(bound, std::max({meeting, kept.at_from[i], kept.at_to[j]}));
    kept.cut = kept.from + std::clamp(share, 0.125, 0.875) * length;
    if (kept.bound > best_) queue_.push(std::move(kept));
  }

  void divide(const Piece& piece) {
    if (!(piece.from < piece.cut && piece.cut < piece.to)) return;
    const std::vector<double> middle = values(piece.cut, piece.active);
    Piece left{piece.from, piece.cut, piece.active, piece.at_from, middle, 0, 0};
    add(std::move(left));
    add({piece.cut, piece.to, piece.active, middle, piece.at_to, 0, 0});
  }

  std::span<const ConvexDistance> functions_;
  Vector p_;
  PathStretch way_;
  double size_, best_ = -kInfinity;
  plane::Subdivision<Piece> queue_;
};

}  // namespace

Between greatest_of_least(std::span<const ConvexDistance> functions, const Vector& p, const PathStretch& way,
                          double size) {
  return Search(functions, p, way, size).run();
}

/// By thirds: of a convex function the third beyond the greater value goes.
Between least_on(const ConvexDistance& function, const Vector& p, const PathStretch& way, double size) {
  const auto at = [&](double s) { return function(space::plus(p, space::scaled(s, way.unit))); };
  double from = way.from, to = way.to, best = std::min(at(from), at(to));
  while (!settled(best - (to - from), best, size)) {
    const double first = from + (to - from) / 3, second = to - (to - from) / 3;
    if (!(from < first && first < second && second < to)) break;
    const double a = at(first), b = at(second);
    best = std::min({best, a, b});
    (a < b ? to : from) = a < b ? second : first;
  }
  return {best - (to - from) - margin::kRayNoise * size, best + margin::kRayNoise * size};
}

Between least_on(std::span<const ConvexDistance> functions, const Vector& p, const PathStretch& way, double size) {
  Between out{kInfinity, kInfinity};
  const double half = (way.to - way.from) / 2;
  const Vector middle = space::plus(p, space::scaled(way.from + half, way.unit));
  for (const ConvexDistance& f : functions) {
    if (f(middle) - half > out.high) continue;
    const Between one = least_on(f, p, way, size);
    out = {std::min(out.low, one.low), std::min(out.high, one.high)};
  }
  return out;
}

}  // namespace findspace::distance
