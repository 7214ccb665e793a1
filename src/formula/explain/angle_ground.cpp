// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <cmath>
#include <set>
#include <span>
#include <type_traits>
#include <vector>

#include "findspace/error.h"
#include "formula/explain/common_relaxation.h"
#include "formula/explain/ground.h"
#include "formula/language/text.h"
#include "plane/base/search_work.h"

namespace findspace::formula {
namespace {

using distance::Sense;
using exact::Real;
using plane::Mark;
using plane::RotationMap;

/// One of the set in degrees: the first that ends an interval and belongs to it, else the middle of an interval.
std::optional<RemainingPlace> angle_in(const RotationMap& set) {
  const std::vector<plane::RotationInterval> all = plane::intervals(set);
  if (all.empty()) return std::nullopt;
  RemainingPlace out;
  for (const plane::RotationInterval& i : all)
    if (!out.degrees && (i.from_in || i.to_in)) out.degrees = (i.from_in ? i.from : i.to).degrees();
  if (out.degrees) return out;
  const auto [from, to] = all[0].degrees();
  out.degrees = std::fmod((from + to) / 2, 360);
  return out;
}

class AngleGround : public KnownCells {
 public:
  AngleGround(const RotationMaps& maps, const Demands& demands) : KnownCells(demands), maps_(maps) {
    for (const Atom& a : demands.formula().atoms())
      if (maps.rotations_twice(a.distance))
        refuse(a.distance, "over angles an explanation knows no distance in rotation about another point");
    for (const SignMap& wanted : demands.formula().sign_maps()) signs_.push_back(maps.sign_map(wanted));
    std::set<MetDemands> distinct;
    angles([&](std::span<const Mark> signs) {
      distinct.insert(met_at(demands, signs));
      return true;
    });
    know(distinct);
  }

  LevelChange best(std::size_t k, int sign, Sense sense) override {
    const RotationMap within =
        angles([&](std::span<const Mark> signs) { return holds_without(demands(), signs, k, sign); });
    const distance::RotationOptimum best =
        counted([&] { return maps_.best(demands().formula().atoms()[k].distance, within, sense); });
    if (!best.proven() && !best.value()) return unknown(k);
    LevelChange out = changed(demands(), k, best, best.attained && best.proven());
    if (out.kind == LevelChange::Kind::kTo) out.place = angle_in(best.at).value_or(RemainingPlace());
    return out;
  }
  CommonRelaxation together(const std::optional<Real>& enough) override {
    const FindPlace find = [this](const Formula& near) { return angle_in(maps_.feasible(near)); };
    return counted([&] { return common_relaxation(find, maps_.world().step(), demands(), enough); });
  }

 private:
  /// {angle : rule(signs there)}
  template <class Rule>
  RotationMap angles(const Rule& rule) const {
    std::vector<const RotationMap*> operands;
    for (const RotationMap& m : signs_) operands.push_back(&m);
    return plane::overlay(operands, [&](std::span<const Mark> signs) { return Mark(rule(signs) ? 1 : 0); });
  }

  /// With a share of the work that is left.
  template <class Search>
  std::invoke_result_t<Search> counted(const Search& search) {
    constexpr long kShareOfAngles = 3;  // some ten seconds of the first one
    plane::SearchWork share{work_.left / kShareOfAngles};
    work_.left -= share.left;
    const plane::ScopedSearchWork here(&share);
    auto out = search();
    work_.left += share.left;
    return out;
  }
  static LevelChange unknown(std::size_t k) {
    LevelChange out;
    out.atom = k;
    out.kind = LevelChange::Kind::kUnknown;
    out.refused = plane::search_spent("the best value over angles was not found").error.message();
    return out;
  }

  const RotationMaps& maps_;
  std::vector<RotationMap> signs_;
  plane::SearchWork work_;
};

}  // namespace

std::unique_ptr<Ground> angle_ground(const RotationMaps& maps, const Demands& demands) {
  return std::make_unique<AngleGround>(maps, demands);
}

}  // namespace findspace::formula
