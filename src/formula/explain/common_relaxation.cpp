// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/common_relaxation.h"

#include <array>

#include "formula/planar/feasible_near.h"
#include "plane/query/summary.h"

namespace findspace::formula {
namespace {

using exact::int128;
using exact::Real;

constexpr int kParts = 1000;    // the enclosure is a part of `upper` wide
constexpr int kDoublings = 12;  // of an amount as large as the largest level

Formula relaxed(const Demands& demands, std::size_t k, const Real& by) {
  if (!demands.has_level(k)) return demands.demand(k);
  const Atom& atom = demands.formula().atoms()[k];
  switch (demands.relation(k)) {
    case Relation::kLess:
    case Relation::kLessEqual:
      return demands.demand(k, atom.level + by);
    case Relation::kGreater:
    case Relation::kGreaterEqual:
      return demands.demand(k, atom.level - by);
    case Relation::kEqual:
    case Relation::kNotEqual:
      break;
  }
  const std::array both{Formula(compare(atom.distance, Relation::kLessEqual, atom.level + by)),
                        Formula(compare(atom.distance, Relation::kGreaterEqual, atom.level - by))};
  return conjunction(both);
}

class Bisection {
 public:
  Bisection(Poses poses, const Demands& demands) : poses_(poses), demands_(demands) {}

  /// Keeps what it learns of the enclosure.
  bool room(const Real& by) {
    const Formula near = demands_.with([&](std::size_t k) { return relaxed(demands_, k, by); });
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      const Real& step = poses_[pose]->world().step;
      const plane::Summary summary = plane::summarize(feasible_near(*poses_[pose], near), step);
      if (summary.empty) continue;
      found_.upper = by;
      found_.at = distance::coordinates(distance::times(step, summary.components.front().sample_point));
      found_.pose = pose;
      return true;
    }
    found_.lower = by;
    return false;
  }
  const CommonRelaxation& found() const { return found_; }

 private:
  Poses poses_;
  const Demands& demands_;
  CommonRelaxation found_;
};

/// An amount as large as the levels, and at least a grid step.
Real first_amount(const Solver& solver, const Demands& demands) {
  Real most = solver.world().step;
  for (std::size_t k = 0; k < demands.size(); ++k) {
    const Real level = abs(demands.formula().atoms()[k].level);
    if (demands.has_level(k) && level > most) most = level;
  }
  return most;
}

}  // namespace

Real decimal_part(const Real& amount) {
  Real part = 1;
  while (part * Real(kParts) > amount) part /= Real(10);
  while (part * Real(kParts * 10) <= amount) part *= Real(10);
  return part;
}

CommonRelaxation common_relaxation(Poses poses, const Demands& demands, const std::optional<Real>& enough) {
  Bisection search(poses, demands);
  Real high = enough && enough->sign() > 0 ? *enough : first_amount(*poses.front(), demands);
  Real part = decimal_part(high);
  const Real finest = poses.front()->world().step / Real(kParts);
  high = Real(floor(high / part) + 1) * part;
  for (int times = 0; !search.room(high); ++times) {
    if (times == kDoublings) return search.found();
    high *= Real(2);
  }
  // In whole parts; the last amount without room is one of them.
  int128 without = floor(search.found().lower / part), with = floor(high / part);
  while ((with - without) * kParts > with && (with - without > 1 || part > finest)) {
    if (with - without == 1) {
      part /= Real(10);
      without *= 10;
      with *= 10;
      continue;
    }
    const int128 middle = without + (with - without) / 2;
    (search.room(Real(middle) * part) ? with : without) = middle;
  }
  return search.found();
}

}  // namespace findspace::formula
