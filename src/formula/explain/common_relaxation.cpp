// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/common_relaxation.h"

#include <array>

#include "plane/base/search_work.h"

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
  Bisection(const FindPlace& find, const Demands& demands) : find_(find), demands_(demands) {}

  /// Keeps what it learns of the enclosure.
  bool room(const Real& by) {
    const auto place = find_(demands_.with([&](std::size_t k) { return relaxed(demands_, k, by); }));
    if (!place) {
      found_.lower = by;
      return false;
    }
    found_.upper = by;
    found_.place = *place;
    return true;
  }
  const CommonRelaxation& found() const { return found_; }

 private:
  const FindPlace& find_;
  const Demands& demands_;
  CommonRelaxation found_;
};

/// An amount as large as the levels, and at least a grid step.
Real first_amount(const Real& step, const Demands& demands) {
  Real most = step;
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

CommonRelaxation common_relaxation(const FindPlace& find, const Real& step, const Demands& demands,
                                   const std::optional<Real>& enough) {
  Bisection search(find, demands);
  Real high = enough && enough->sign() > 0 ? *enough : first_amount(step, demands);
  Real part = decimal_part(high);
  const Real finest = step / Real(kParts);
  high = Real(floor(high / part) + 1) * part;
  for (int times = 0; !search.room(high); ++times) {
    if (times == kDoublings || plane::cells_left() <= 0) return search.found();
    high *= Real(2);
  }
  // In whole parts; the last amount without room is one of them.
  int128 without = floor(search.found().lower / part), with = floor(high / part);
  while ((with - without) * kParts > with && (with - without > 1 || part > finest) && plane::cells_left() > 0) {
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
