// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two shapes as they stand at instants of a motion: rotated about their origins, the vertices rounded to a grid finer
// than the scene's by up to 2^20. Questions about different distances and positions share them: the instants that
// halving a leg leads to are kept, as far as little memory allows, and so are extrema over the time, which several
// distances are made of. Guarantee: the same whether they were kept or not. Threads: safe. Cost: one arrangement of
// each shape an instant. Keywords: snapshot, cache.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "distance/planar/at_position.h"
#include "distance/planar_least/best_position.h"

namespace findspace::distance {

/// Where and how rotated both shapes are at one time: `at` = b - a, angles in degrees; `fixed_at` = a, which distances
/// in rotation ask for, since their centre stands still.
struct RotatingPose {
  exact::RealPoint at;
  exact::Real moving, fixed;
  exact::RealPoint fixed_at{};
};

inline exact::Real between(const exact::Real& from, const exact::Real& to, const exact::Real& s) {
  return from + s * (to - from);
}
inline exact::RealPoint between(const exact::RealPoint& from, const exact::RealPoint& to, const exact::Real& s) {
  return {between(from.x, to.x, s), between(from.y, to.y, s)};
}

inline RotatingPose between(const RotatingPose& p, const RotatingPose& q, const exact::Real& s) {
  return {between(p.at, q.at, s), between(p.moving, q.moving, s), between(p.fixed, q.fixed, s),
          between(p.fixed_at, q.fixed_at, s)};
}

/// At least the greatest distance of a point of the set from the origin, in grid steps.
double reach(const plane::Region& r);

class TurningShapes {
 public:
  /// Closed shapes. `poses`: at the way points, straight and even between. `step`: size of a grid step, for the place
  /// of an error.
  TurningShapes(const plane::Region& b, const plane::Region& a, std::vector<RotatingPose> poses, double step);

  /// At an instant, on the fine grid.
  struct Standing {
    std::shared_ptr<const AtPosition> measured;
    double rounding;  // by how much a point of either is off
    const ShapePair& pair() const { return measured->pair(); }
  };
  /// At part `s` (0 to 1) of leg `k`.
  Standing standing(std::size_t leg, const exact::Real& s) const;
  /// Where B is moved to then from where it stands, on the fine grid, at a position in grid steps.
  exact::RealPoint place(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;

  /// What is asked about the values of a distance over the time.
  struct ExtremumAsked {
    Which which;
    bool least;
    double enough;  // how near its bounds are to be
    bool fine;      // with more work
    exact::RealPoint at;
    bool operator==(const ExtremumAsked& other) const;
  };
  /// As `search` finds it, and for the same work; asked but once as long as few are asked.
  std::optional<ValueRange> extremum(const ExtremumAsked& asked,
                                     const std::function<std::optional<ValueRange>()>& search) const;

  const std::vector<RotatingPose>& poses() const { return poses_; }
  double factor() const { return factor_; }  // steps of the fine grid in one
  double b_reach() const { return b_reach_; }
  double a_reach() const { return a_reach_; }
  /// On the fine grid, as drawn.
  const plane::Region& b() const { return b_; }
  const plane::Region& a() const { return a_; }
  /// As rated_gap.h.
  bool b_is_convex() const { return convex(b_, b_convex_); }
  bool a_is_convex() const { return convex(a_, a_convex_); }
  std::size_t edges() const { return b_.edges.size() + a_.edges.size(); }

 private:
  Standing made(std::size_t leg, const exact::Real& s) const;
  bool convex(const plane::Region& r, std::optional<bool>& known) const;

  using Instant = std::pair<std::size_t, int>;  // a leg, and a part of it in halves of halves

  plane::Region b_, a_;
  double b_reach_, a_reach_, factor_, step_;
  std::vector<RotatingPose> poses_;
  mutable std::mutex guard_;
  mutable std::map<Instant, Standing> kept_;
  struct FoundExtremum {
    ExtremumAsked asked;
    std::optional<ValueRange> found;
    long work;
  };
  mutable std::vector<FoundExtremum> extrema_;
  mutable std::optional<bool> b_convex_, a_convex_;  // where asked for
};

}  // namespace findspace::distance
