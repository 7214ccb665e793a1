// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The placement of several bodies (distances.md 6): body i at angle a_i, translated by p_i, such that every condition
// holds. A condition is a formula whose distances are between two bodies, or a body and something that stands still;
// the first kind depends on p_i - p_j only. Values, made by the caller (io has the scene, apps the command). Keywords:
// nesting, layout, arrangement.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/language/formula.h"
#include "formula/language/parse_goal.h"
#include "formula/planar/solve.h"
#include "planning/order/orientation.h"

namespace findspace::planning {

/// What has one position: a shape of the scene, or several that move together, at one of its allowed angles.
struct Body {
  std::string name;                 // for reports: "A1", "A1+A2"
  int copy = 0;                     // from 1 where the same body is placed several times
  std::vector<std::string> shapes;  // as formulas name them
  std::vector<Orientation> angles;  // about the pole, at least one
  /// variants[a][k]: the name in the world of shapes[k] rotated by angles[a].
  std::vector<std::vector<std::string>> variants;
  /// In grid steps: it goes to the nearest position there is, before all goals, and on the grid.
  std::optional<std::vector<exact::Real>> near{};
};

/// A name in a formula: a whole body, or one shape of it.
struct Role {
  std::size_t body = 0;
  std::optional<std::size_t> shape;
};
using Roles = std::map<std::string, Role, std::less<>>;

struct Condition {
  std::shared_ptr<const formula::Formula> formula;
  Roles roles;  // every name that is not here stands still
};

/// What is asked for, in the plane or in space.
struct Demands {
  std::vector<Body> bodies;
  std::vector<Condition> conditions;
  std::vector<formula::Goal> goals;  // the first first; "self" is the body at hand
  Roles names;                       // bodies and shapes as goals name them
};

struct Problem : Demands {
  formula::World world;  // every shape, and every rotated one; all variants of all bodies are `moving`
};

/// Where a body stands.
template <class V>
struct PoseOf {
  std::size_t angle = 0;  // index into Body::angles
  V at{};                 // in grid steps
};
template <class V>
using PosesOf = std::vector<std::optional<PoseOf<V>>>;  // by body
using Pose = PoseOf<exact::RealPoint>;
using Poses = PosesOf<exact::RealPoint>;

/// When to stop and give what there is.
class Limit {
 public:
  using Clock = std::chrono::steady_clock;
  Limit() = default;
  /// `seconds` <= 0, or more than thirty years: none.
  explicit Limit(double seconds) {
    if (seconds > 0 && seconds < kMost)
      end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  }
  bool over() const { return end_ && Clock::now() >= *end_; }
  /// Whether it will be over before another step of so many seconds is done.
  bool over_after(double seconds) const {
    return end_ &&
           Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)) >= *end_;
  }

 private:
  static constexpr double kMost = 1e9;
  std::optional<Clock::time_point> end_;
};

/// How long steps take, to stop before one that would come too late: the next takes as long as the longest so far.
class StepTimes {
 public:
  bool next_is_late(const Limit& limit) const { return limit.over_after(longest_); }
  void begin() { begin_ = Limit::Clock::now(); }
  void end() { longest_ = std::max(longest_, std::chrono::duration<double>(Limit::Clock::now() - begin_).count()); }

 private:
  Limit::Clock::time_point begin_{};
  double longest_ = 0;
};

}  // namespace findspace::planning
