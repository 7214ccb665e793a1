// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/motion_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "distance/planar_features/boundary_features.h"
#include "distance/rotation/rated_gap.h"
#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/build/swept.h"
#include "plane/build/transform.h"
#include "plane/complex/overlay.h"
#include "plane/query/moved.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;

namespace {

constexpr int kMostPieces = 48;       // of a leg
constexpr double kDegreesInTime = 3;  // no sign: how fine the time is cut

double rotated(const Real& from, const Real& to) { return std::abs(near_value(to - from)); }

std::vector<RotatingPiece> pieces_of(const std::vector<RotatingPose>& poses, double b_reach, double a_reach) {
  std::vector<RotatingPiece> out;
  for (std::size_t leg = 0; leg + 1 < poses.size(); ++leg) {
    const RotatingPose &p = poses[leg], &q = poses[leg + 1];
    const int n = pieces_of_leg(p, q);
    const double moved = rotated(p.moving, q.moving) * b_reach + rotated(p.fixed, q.fixed) * a_reach;
    for (int k = 0; k < n; ++k) {
      const Real from = Real::ratio(k, n), to = Real::ratio(k + 1, n), mid = Real::ratio(2 * k + 1, 2 * n);
      out.push_back({{between(p.at, q.at, from), between(p.at, q.at, to)},
                     between(p.moving, q.moving, mid),
                     between(p.fixed, q.fixed, mid),
                     moved * std::numbers::pi / 360 / n});
    }
  }
  return out;
}

SignMap over_way(const SignMap& m, const RotatingPiece& piece, Sense sense) {
  return sense == Sense::kMinimum ? least_along(m, piece.way) : negated(least_along(negated(m), piece.way));
}

/// Rounded up.
Real slightly_above(double r) { return r > 0 ? Real::from_double(r * margin::kUpward + margin::kUpwardSteps) : Real(); }

/// The signs of functions <= and >= f - level, for all pairs that are off by at most `off`.
class SignBounds {
 public:
  SignBounds(const ShapePair& pair, Which which, bool convex) : pair_(pair), which_(which), gap_(pair, convex) {}
  SignMap lower(const Real& level, const Real& off) const { return bound(level, off, true); }
  SignMap upper(const Real& level, const Real& off) const { return bound(level, off, false); }

 private:
  SignMap bound(const Real& level, const Real& off, bool low) const {
    if (which_ == Which::kGamma1) return low ? gap_.lower(level, off) : gap_.upper(level, off);
    if (which_ != Which::kPenetration) return pair_.distance(which_)->sign_map(low ? level + off : level - off);
    // max(0, -gamma1)
    if (level.sign() < 0) return SignMap::uniform(1);
    const Mark floor = level.sign() == 0 ? 0 : -1;
    return plane::remark(low ? gap_.upper(-level, off) : gap_.lower(-level, off),
                         [floor](Mark k) { return std::max(floor, Mark(-k)); });
  }

  const ShapePair& pair_;
  Which which_;
  RatedGap gap_;
};

BoundedMaps bounds_of_piece(const plane::Region& b, const plane::Region& a, Which which, bool convex,
                            const RotatingPiece& piece, const RotationSenses& senses, const Real& level, double step) {
  plane::Rounding rounding;
  const ShapePair pair(rotated(b, {0, 0}, piece.moving, step, rounding),
                       rotated(a, {0, 0}, piece.fixed, step, rounding));
  const SignBounds f(pair, which, convex);
  const bool least = senses.pieces == Sense::kMinimum;
  // Two shapes, each off by the rounding (ends of an arc carry its bulge along: twice that).
  const double off = 4 * rounding.largest;
  // Over the turns of the piece the least value is not above that in the middle, the greatest not below.
  const Real chosen = slightly_above(off + piece.in_time),
             all = slightly_above(off + piece.in_time + piece.over_rotations);
  SignMap low = over_way(f.lower(level, least ? all : chosen), piece, senses.low),
          high = over_way(f.upper(level, least ? chosen : all), piece, senses.high);
  if (piece.in_time == 0 || senses.low != senses.high) return {std::move(low), std::move(high)};
  // The instant in the middle bounds better from one side: inf f is not above it, sup f not below.
  const Real still = slightly_above(off);
  const RealPoint middle = between(piece.way[0], piece.way[1], Real::ratio(1, 2));
  const SignMap instant = plane::moved(least ? f.upper(level, still) : f.lower(level, still), {-middle.x, -middle.y});
  SignMap& worse = least ? high : low;
  worse = plane::overlay(std::array<const CellComplex*, 2>{&worse, &instant}, [least](std::span<const Mark> m) {
    return least ? std::min(m[0], m[1]) : std::max(m[0], m[1]);
  });
  return {std::move(low), std::move(high)};
}

}  // namespace

int pieces_of_leg(const RotatingPose& p, const RotatingPose& q) {
  const double most = std::max(rotated(p.moving, q.moving), rotated(p.fixed, q.fixed));
  return int(std::clamp(std::ceil(most / kDegreesInTime), 1.0, double(kMostPieces)));
}

BoundedMaps motion_maps(const plane::Region& b, const plane::Region& a, Which which,
                        std::span<const RotatingPiece> pieces, const RotationSenses& senses, const Real& level,
                        double step) {
  const bool gap = which == Which::kGamma1 || which == Which::kPenetration,
             convex = gap && is_convex(b) && is_convex(a);
  std::vector<BoundedMaps> all(pieces.size());
  plane::parallel_for(all.size(), [&](std::size_t k) {
    all[k] = bounds_of_piece(b, a, which, convex, pieces[k], senses, level, step);
  });
  auto joined = [&](SignMap BoundedMaps::*side) {
    std::vector<const CellComplex*> maps;
    for (const BoundedMaps& m : all) maps.push_back(&(m.*side));
    return plane::overlay(maps, [&senses](std::span<const Mark> m) {
      return senses.pieces == Sense::kMinimum ? *std::min_element(m.begin(), m.end())
                                              : *std::max_element(m.begin(), m.end());
    });
  };
  return {joined(&BoundedMaps::low), joined(&BoundedMaps::high)};
}

BoundedMaps motion_maps(const plane::Region& b, const plane::Region& a, Which which,
                        const std::vector<RotatingPose>& poses, Sense sense, const Real& level, double step) {
  return motion_maps(b, a, which, pieces_of(poses, reach(b), reach(a)), {sense, sense, sense}, level, step);
}

}  // namespace findspace::distance
