// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/round_directional.h"

#include <findspace/error.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "distance/rays/ray_covers.h"
#include "distance/rays/ray_signs.h"
#include "distance/rays/value_rays.h"
#include "distance/search/grown_set.h"
#include "distance/search/position_set.h"
#include "distance/search/solid_max_min.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"
#include "space/body/body_boxes.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::RayGrid;
using space::Vector;
using Source = space::RaySourcePointer;

namespace {

struct PathStretch {
  Vector unit;
  double from = 0, to = 0;
};

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

/// The greatest of the least of convex functions on a stretch of a line. Between two places a convex function is below
/// its chord, so the minimum is below the highest meeting of two chords; stretches are divided there.
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
        plane::allowed(kMostPieces),
        [&](const Piece& top) { return settled(best_, std::max(best_, top.bound), size_) || plane::cells_left() <= 0; },
        [&](const Piece& top) {
          plane::count_cell();
          divide(top);
        });
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

/// max over the stretch of min over the functions, of which there is one: between two bounds, which have one sign and a
/// ratio of at most 2, or are within 2^-40 of the size of each other (or what kMostPieces pieces gave). `size`: of
/// coordinates and functions.
Between greatest_of_least(std::span<const ConvexDistance> functions, const Vector& p, const PathStretch& way,
                          double size) {
  return Search(functions, p, way, size).run();
}

/// min over the stretch, likewise. By thirds: of a convex function the third beyond the greater value goes.
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

/// min over the stretch and the functions.
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

/// Constraints along the ways of a query.
class Sweeper {
 public:
  Sweeper(const DirectionalQuery& query, std::int64_t scale, const RayGrid& grid)
      : unit_(space::rounded(query.unit)), both_ways_(query.both_ways), scale_(scale), grid_(grid) {}

  /// Forward, or both ways, as far as that.
  PathStretch way(double reach) const { return {unit_, both_ways_ ? -reach : 0, reach}; }
  PathStretch stretch(double from, double to) const { return {unit_, from, to}; }

  /// - where all of the way lies in the union of the open sets that the functions are less than 0 in.
  Source held(const PositionSet& sets, const PathStretch& way) const {
    return map(sets, way, [functions = sets.constraints().reverse_convex, way](const Vector& p, double size) {
      return greatest_of_least(functions, p, way, size);
    });
  }
  /// - where some place of the way belongs to the inside of the positions, + where none belongs.
  Source met(const PositionSet& fits, const PathStretch& way) const {
    return map(fits, way,
               [in = breaking(fits), out = fits.constraints().reverse_convex, way](const Vector& p, double size) {
                 if (in) return least_on(in, p, way, size);
                 const Between most = greatest_of_least(out, p, way, size);
                 return Between{-most.high, -most.low};
               });
  }
  /// - where all places of the way do.
  Source kept(const PositionSet& fits, const PathStretch& way) const {
    return map(fits, way,
               [in = breaking(fits), out = fits.constraints().reverse_convex, way](const Vector& p, double size) {
                 if (!in) {
                   const Between least = least_on(out, p, way, size);
                   return Between{-least.high, -least.low};
                 }
                 const auto at = [&](double s) { return in(space::plus(p, space::scaled(s, way.unit))); };
                 const double most = std::max(at(way.from), at(way.to)), noise = margin::kRayNoise * size;
                 return Between{most - noise, most + noise};
               });
  }

 private:
  using Rule = std::function<Between(const Vector&, double)>;

  /// The worst of what an intersection of convex sets says of a position; nothing of what a union leaves.
  static ConvexDistance breaking(const PositionSet& fits) {
    if (fits.constraints().convex.empty()) return nullptr;
    return [all = fits.constraints().convex](const Vector& x) {
      double most = -kInfinity;
      for (const TouchingConstraint& f : all) most = std::max(most, f(x).value);
      return most;
    };
  }
  Source map(const PositionSet& set, const PathStretch& way, const Rule& rule) const {
    const double reach = std::max(std::fabs(way.from), std::fabs(way.to));
    const Vector &low = set.box().low, &high = set.box().high;
    const double size = space::length(high - low) + 2 * reach + 1;
    const double all = size + space::size_of(low) + space::size_of(high);
    const RayRule at = [rule, all](const space::RealVector& p) { return rule(space::rounded(p), all); };
    return std::make_unique<ValueRays>(at, set.box().middle(), size, scale_, grid_);
  }

  Vector unit_;
  bool both_ways_;
  std::int64_t scale_;
  RayGrid grid_;
};

/// The open sets of U.
PositionSet overlaps(const Body& b, const Body& a) {
  const space::Bounds3 box = space::meeting(bounds(b), bounds(a));
  return PositionSet::outside(differences_of_parts(a, b), box.low, box.high);
}

/// E, in the box; A is convex, or without radii.
PositionSet fits(const Body& b, const Body& a, const space::Bounds3& box) {
  return a.convex() ? PositionSet::inside(b, a.parts[0], box.low, box.high)
                    : PositionSet::outside(differences_of_outside(a, b), box.low, box.high);
}

}  // namespace

Source round_depth_map(const Real& level, const DirectionalQuery& query, const Body& b, const Body& a,
                       const RayGrid& grid) {
  const Sweeper sweep(query, b.scale, grid);
  return sweep.held(overlaps(b, a), sweep.way(-level.to_double()));
}

exact::Tried<Source> round_fit_map(const Real& level, const DirectionalQuery& query, const Body& b, const Body& a,
                                   const RayGrid& grid) {
  if (a.round() && !a.convex())
    return exact::Refusal(
        "containment in a union of round parts along a direction is computed on rays at level 0 only");
  const auto box = space::fitting(bounds(b), bounds(a));
  if (!box || (query.farthest && level.sign() < 0)) return space::constant_rays(grid, 1);
  const PositionSet places = fits(b, a, *box);
  const Sweeper sweep(query, b.scale, grid);
  const double reach = std::fabs(level.to_double());
  if (!query.farthest)
    return level.sign() > 0 ? sweep.met(places, sweep.way(reach)) : sweep.kept(places, sweep.way(reach));
  std::vector<Source> all;
  // At level 0 only what is met at once counts.
  all.push_back(level.sign() > 0 ? sweep.met(places, sweep.way(reach))
                                 : space::mapped_rays(ray_sign_map(Which::kEta1, Real(), b, a, grid),
                                                      [](int s) { return s <= 0 ? 0 : 1; }));
  // From within the level of a place no other place is farther than this.
  const double most = reach + space::length(places.box().high - places.box().low) + 1;
  all.push_back(space::negated_rays(sweep.met(places, sweep.stretch(reach, most))));
  if (query.both_ways) all.push_back(space::negated_rays(sweep.met(places, sweep.stretch(-most, -reach))));
  return space::greatest_rays(std::move(all));
}

}  // namespace findspace::distance
