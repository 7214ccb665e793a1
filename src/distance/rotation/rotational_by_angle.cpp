// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/rotational_by_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotation_motion.h"
#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/build/transform.h"
#include "plane/query/moved.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Region;
using plane::RotationMap;

namespace {

constexpr std::size_t kMostArcs = 40;  // with two maps each
constexpr double kDegreesAnArc = 12;   // no sign: how fine the turns are cut at first
const Real kNarrowest = Real::ratio(1, 32);

/// Some turns of A, and the bounds of the extremum over them.
struct Piece {
  Real from, to;
  std::optional<BoundedRotations> maps;
};

/// Rounded up, to whole steps: levels with short numbers.
Real next_integer(double r) { return Real(std::int64_t(std::floor(r * margin::kUpward)) + 1); }

RotationMap extreme(std::span<const RotationMap* const> maps, Sense sense) {
  return overlay(maps, [sense](std::span<const Mark> m) {
    return sense == Sense::kMinimum ? *std::min_element(m.begin(), m.end()) : *std::max_element(m.begin(), m.end());
  });
}

/// 1 where the bounds differ.
RotationMap undecided(const BoundedRotations& maps) {
  return overlay(std::array<const RotationMap*, 2>{&maps.low, &maps.high},
                 [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
}

bool meet(const RotationMap& one, const RotationMap& other) {
  const RotationMap both = overlay(std::array<const RotationMap*, 2>{&one, &other},
                                   [](std::span<const Mark> m) { return Mark(m[0] != 0 && m[1] != 0); });
  return !both.at.empty() || both.everywhere != 0;
}

class RotationsOfA {
 public:
  RotationsOfA(const RotatedShapes& s, Which plain, const RealPoint& centre, double step)
      : shapes_(s),
        a_(plane::moved(s.fixed, {-centre.x, -centre.y})),
        to_{s.to.x - centre.x, s.to.y - centre.y},
        plain_(plain),
        step_(step),
        reach_(reach(a_)) {}

  /// While B rotates about the centre from one angle to another.
  BoundedRotations over(const Real& from, const Real& to, Sense sense) const {
    std::vector<Piece> pieces = first_pieces(from, to);
    for (;;) {
      plane::parallel_for(pieces.size(), [&](std::size_t k) {
        if (!pieces[k].maps) pieces[k].maps = bounds(pieces[k], sense);
      });
      BoundedRotations all = joined(pieces, sense);
      if (!halve(pieces, undecided(all))) return all;
    }
  }

 private:
  static std::vector<Piece> first_pieces(const Real& from, const Real& to) {
    const int n = std::max(1, int(std::ceil((to - from).to_double() / kDegreesAnArc)));
    std::vector<Piece> out;
    for (int k = 0; k < n; ++k)
      out.push_back({from + Real::ratio(k, n) * (to - from), from + Real::ratio(k + 1, n) * (to - from), std::nullopt});
    return out;
  }

  /// Those that leave some of the undecided angles open; false where none does or they would be too many.
  static bool halve(std::vector<Piece>& pieces, const RotationMap& open) {
    std::vector<Piece> out;
    for (Piece& p : pieces) {
      if (p.to - p.from <= kNarrowest || !meet(undecided(*p.maps), open)) {
        out.push_back(std::move(p));
        continue;
      }
      const Real middle = Real::ratio(1, 2) * (p.from + p.to);
      out.push_back({p.from, middle, std::nullopt});
      out.push_back({middle, p.to, std::nullopt});
    }
    if (out.size() == pieces.size() || out.size() > kMostArcs) return false;
    pieces = std::move(out);
    return true;
  }

  BoundedRotations bounds(const Piece& piece, Sense sense) const {
    plane::Rounding rounding;
    const Real back = -Real::ratio(1, 2) * (piece.from + piece.to);
    const RotatedPair pair(shapes_.rotating, rotated(a_, {0, 0}, back, step_, rounding), shapes_.about, to_);
    const auto map = [&](const Real& level) {
      return plain_ == Which::kGamma1 ? pair.nearest_point(level) : pair.sign_map(plain_, level);
    };
    // Ends of an arc carry its bulge along: twice what they moved.
    const double off = 2 * rounding.largest;
    const bool least = sense == Sense::kMinimum;
    const Real still = off > 0 ? next_integer(off) : Real();
    RotationMap instant = map(least ? -still : still);
    if (piece.from == piece.to) {
      if (off == 0) return {instant, instant};
      RotationMap other = map(least ? still : -still);
      return least ? BoundedRotations{std::move(other), std::move(instant)}
                   : BoundedRotations{std::move(instant), other};
    }
    // The instant in the middle bounds one side, no piece does better: the least value is not above it, the greatest
    // not below.
    const Real all = next_integer(off + (piece.to - piece.from).to_double() / 360 * std::numbers::pi * reach_);
    RotationMap whole = map(least ? all : -all);
    return least ? BoundedRotations{std::move(whole), std::move(instant)}
                 : BoundedRotations{std::move(instant), std::move(whole)};
  }

  static BoundedRotations joined(const std::vector<Piece>& pieces, Sense sense) {
    std::vector<const RotationMap*> low, high;
    for (const Piece& p : pieces) {
      low.push_back(&p.maps->low);
      high.push_back(&p.maps->high);
    }
    return {extreme(low, sense), extreme(high, sense)};
  }

  const RotatedShapes& shapes_;
  Region a_;
  RealPoint to_;
  Which plain_;
  double step_, reach_;
};

}  // namespace

BoundedRotations rotation_angle_maps(const RotatedShapes& shapes, Which which, const RealPoint& centre,
                                     const Real& level, double step) {
  const RotationsOfA rotations(shapes, plain_of(which), centre, step);
  return rotational_bounds(which, level, RotationMap::uniform(1), [&](const Real& from, const Real& to, Sense sense) {
    return rotations.over(from, to, sense);
  });
}

}  // namespace findspace::distance
