// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/turning_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "distance/sites.h"
#include "plane/moved.h"
#include "plane/overlay.h"
#include "plane/parallel.h"
#include "plane/swept.h"
#include "plane/transform.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;

namespace {

constexpr int kMostPieces = 48;       // of a leg
constexpr double kDegreesAPiece = 3;  // no sign: how fine the time is cut

Real between(const Real& from, const Real& to, const Real& s) { return from + s * (to - from); }

RealPoint between(const RealPoint& from, const RealPoint& to, const Real& s) {
  return {between(from.x, to.x, s), between(from.y, to.y, s)};
}

/// A short time with fixed angles: the way of the translation, its middle, and by how much f may differ.
struct Piece {
  std::array<RealPoint, 2> way;
  RealPoint middle;
  Real moving, fixed;
  double radians_moving, radians_fixed;  // half the angles turned
};

std::vector<Piece> pieces_of(const std::vector<TurningPose>& poses) {
  std::vector<Piece> out;
  for (std::size_t leg = 0; leg + 1 < poses.size(); ++leg) {
    const TurningPose &p = poses[leg], &q = poses[leg + 1];
    const double b = std::abs(near_value(q.moving - p.moving)), a = std::abs(near_value(q.fixed - p.fixed));
    const int n = std::clamp(int(std::ceil(std::max(a, b) / kDegreesAPiece)), 1, kMostPieces);
    const double half = std::numbers::pi / 360 / n;
    for (int k = 0; k < n; ++k) {
      const Real from = Real::ratio(k, n), to = Real::ratio(k + 1, n), mid = Real::ratio(2 * k + 1, 2 * n);
      out.push_back({{between(p.at, q.at, from), between(p.at, q.at, to)},
                     between(p.at, q.at, mid),
                     between(p.moving, q.moving, mid),
                     between(p.fixed, q.fixed, mid),
                     b * half,
                     a * half});
    }
  }
  return out;
}

SignMap negated(SignMap m) {
  return remark(std::move(m), [](Mark k) { return Mark(-k); });
}

SignMap over_way(const SignMap& m, const Piece& piece, Sense sense) {
  return sense == Sense::kMinimum ? least_along(m, piece.way) : negated(least_along(negated(m), piece.way));
}

/// Rounded up.
Real upward(double r) { return Real::from_double(r * (1 + 0x1p-40) + 0x1p-20); }

BoundedMaps bounds_of_piece(const plane::Region& b, const plane::Region& a, Which which, const Piece& piece,
                            Sense sense, const Real& level, double b_reach, double a_reach) {
  plane::Rounding rounding;
  const ShapePair pair(rotated(b, {0, 0}, piece.moving, 1, rounding), rotated(a, {0, 0}, piece.fixed, 1, rounding));
  const TDistancePointer f = pair.distance(which);
  // Two shapes, each off by the rounding (ends of an arc carry its bulge along: twice that).
  const double off = 4 * rounding.largest;
  const Real still = upward(off), all = upward(off + piece.radians_moving * b_reach + piece.radians_fixed * a_reach);
  const SignMap low = over_way(f->sign_map(level + all), piece, sense),
                high = over_way(f->sign_map(level - all), piece, sense);
  // The instant in the middle bounds better from one side: inf f is not above it, sup f not below.
  const bool least = sense == Sense::kMinimum;
  const SignMap instant =
      plane::moved(f->sign_map(least ? level - still : level + still), {-piece.middle.x, -piece.middle.y});
  const std::array<const CellComplex*, 2> better{least ? &high : &low, &instant};
  SignMap best = plane::overlay(
      better, [least](std::span<const Mark> m) { return least ? std::min(m[0], m[1]) : std::max(m[0], m[1]); });
  if (least) return {low, std::move(best)};
  return {std::move(best), high};
}

}  // namespace

BoundedMaps turning_maps(const plane::Region& b, const plane::Region& a, Which which,
                         const std::vector<TurningPose>& poses, Sense sense, const Real& level) {
  const std::vector<Piece> pieces = pieces_of(poses);
  const double b_reach = reach(b), a_reach = reach(a);
  std::vector<BoundedMaps> all(pieces.size());
  plane::parallel_for(all.size(), [&](std::size_t k) {
    all[k] = bounds_of_piece(b, a, which, pieces[k], sense, level, b_reach, a_reach);
  });
  auto joined = [&](SignMap BoundedMaps::*side) {
    std::vector<const CellComplex*> maps;
    for (const BoundedMaps& m : all) maps.push_back(&(m.*side));
    return plane::overlay(maps, [sense](std::span<const Mark> m) {
      return sense == Sense::kMinimum ? *std::min_element(m.begin(), m.end()) : *std::max_element(m.begin(), m.end());
    });
  };
  return {joined(&BoundedMaps::low), joined(&BoundedMaps::high)};
}

}  // namespace findspace::distance
