// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Grounds of space. Where all sign maps are made of boxes the cells are known, and so is what conflicts; levels too
// where box_extreme.h knows them. Elsewhere, and for all else, a search over positions decides (place_search.h), as all
// distances change by at most the length of a step. It leaves undecided what holds at a touching alone, unless the
// contacts near the best position tell (nearest_feasible). Which demands conflict it finds by asking about the smallest
// set that the positions seen so far do not refute, until one is proved; so that set is minimal, and smallest.
// Source: Ignatiev et al., "Smallest MUS extraction with minimal hitting set dualization" (2015).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "findspace/error.h"
#include "formula/explain/box_extreme.h"
#include "formula/explain/common_relaxation.h"
#include "formula/explain/demand_values.h"
#include "formula/explain/ground.h"
#include "formula/explain/place_search.h"
#include "formula/solid/solve_rays.h"

namespace findspace::formula {
namespace {

using distance::Sense;
using exact::Real;
using exact::Tried;
using space::BoxComplex;
using space::Mark;
using space::RealVector;
using space::Vector;
using Kind = LevelChange::Kind;

constexpr double kPartsOfWindow = 0x1p17;  // no sign: a search ends within such a part of the window,
constexpr double kLeastPart = 1e-3;        // no sign: or of a grid step

/// The positions beyond which no sign changes, widened by their size; halves are powers of two, so that boxes divide
/// without rounding.
PlaceBox window_of(const SpaceSolver& solver, const Formula& formula) {
  if (!solver.world().rays) throw Error(ErrorCode::kUnsupported, "these shapes have no box around them");
  const RayWindow all = window(*solver.world().rays, formula);
  const Vector low{double(all.low.x), double(all.low.y), double(all.low.z)},
      high{double(all.high.x), double(all.high.y), double(all.high.z)};
  const Vector size = high - low;
  const double wide = std::max({size.x, size.y, size.z});
  return {
      {std::floor((low.x + high.x) / 2), std::floor((low.y + high.y) / 2), std::floor((low.z + high.z) / 2)},
      {std::exp2(std::ceil(std::log2(size.x / 2 + wide + 1))), std::exp2(std::ceil(std::log2(size.y / 2 + wide + 1))),
       std::exp2(std::ceil(std::log2(size.z / 2 + wide + 1)))}};
}

class SearchedGround : public Ground {
 public:
  SearchedGround(const SpaceSolver& solver, const Demands& demands)
      : solver_(solver), demands_(demands), values_(solver, demands), window_(window_of(solver, demands.formula())) {
    const Vector away = space::plus(window_.center, space::scaled(4, window_.half));
    far_ = values_.at(space::real(away));
    cells_.push_back(far_.met);
  }

  Tried<bool> room(const std::optional<AssumedDemand>& assumed) override {
    std::vector<Part> parts(demands_.size(), Part::kAsked);
    if (assumed) parts[assumed->atom] = assumed->met ? Part::kMet : Part::kUnmet;
    return room(parts);
  }

  Conflict conflict() override {
    bool certain = true;
    for (;;) {
      FailingCells cells(demands_, cells_);
      Conflict found = find_conflict(cells);
      std::vector<Part> parts(demands_.size(), Part::kMet);
      for (const std::size_t k : found.atoms) parts[k] = Part::kAsked;
      const Tried<bool> there = room(parts);
      if (there && !*there) {
        found.smallest = found.smallest && certain;
        return found;
      }
      if (there) continue;  // a cell that refutes it is known now
      // A larger set may be proved: this one counts as refuted.
      certain = false;
      MetDemands met(demands_.size(), false);
      for (const std::size_t k : found.atoms) met[k] = true;
      cells_.push_back(std::move(met));
    }
  }

  LevelChange best(std::size_t k, int sign, Sense sense) override {
    if (unbounded(k, sense)) return endless(k);
    const Real level = demands_.formula().atoms()[k].level / step();
    PlaceSearch search = searching([this, k, sign, sense, level](const DemandsAt& here) {
      PlaceSeen seen = value_seen(here, k, sense);
      std::vector<double> most;
      for (const exact::Interval& s : here.slack) most.push_back(s.hi);
      most[k] = exact::kInfinity;
      seen.inside = demands_.measure(most);
      MetDemands met = here.met;
      met[k] = true;
      seen.belongs = demands_.truth(met);
      if (sign != 0) {
        const exact::Interval beyond = here.distance[k] - level.interval();
        seen.inside = std::min(seen.inside, sign > 0 ? beyond.hi : -beyond.lo);
        seen.belongs = seen.belongs && exact::certain_sign(beyond) == sign;
      }
      return seen;
    });
    search.tolerance = tolerance();
    search.first = places_;
    PlaceFound found = find_place(search, {window_});
    if (!found.at && found.bound < exact::kInfinity) {
      std::vector<Part> parts(demands_.size(), Part::kAsked);
      parts[k] = Part::kMet;
      if (const auto at = touching(parts, found.nearly)) {
        const PlaceSeen seen = search.look(*at);
        if (seen.belongs) found = {at, seen.value.hi, std::min(found.bound, seen.value.lo), *at};
      }
    }
    return changed_to(k, sense, found);
  }

  CommonRelaxation together(const std::optional<Real>&) override {
    PlaceSearch search = searching([this](const DemandsAt& here) {
      std::vector<double> least, most;
      for (std::size_t k = 0; k < demands_.size(); ++k) {
        const bool moves = demands_.has_level(k);
        least.push_back(moves ? here.slack[k].lo : here.met[k] ? exact::kInfinity : -exact::kInfinity);
        most.push_back(moves ? here.slack[k].hi : exact::kInfinity);
      }
      const double low = demands_.measure(least), high = demands_.measure(most);
      return PlaceSeen{{-high, -low}, exact::kInfinity, low > -exact::kInfinity};
    });
    search.tolerance = tolerance();
    const PlaceFound found = find_place(search, {window_});
    CommonRelaxation out;
    if (!found.at) return out;
    // Beyond the window some level lacks at least its least side.
    const double beyond = std::min({window_.half.x, window_.half.y, window_.half.z}) / 2;
    const Real upper = Real::from_double(found.least) * step(),
               lower = Real::from_double(std::max(0.0, std::min(found.bound, beyond))) * step();
    const Real part = decimal_part(upper.sign() > 0 ? upper : step());
    out.upper = Real(floor(upper / part) + 1) * part;
    const Real below = -(Real(floor(-lower / part)) + Real(1)) * part;  // the greatest multiple below
    out.lower = below.sign() > 0 ? below : Real();
    out.place.at = distance::coordinates(space::scaled(step(), *found.at));
    return out;
  }

 protected:
  const Real& step() const { return solver_.world().step; }
  const SpaceSolver& solver() const { return solver_; }
  const Demands& demands() const { return demands_; }
  const PlaceBox& window() const { return window_; }
  const DemandValues& values() const { return values_; }
  double tolerance() const {
    return std::max(std::max({window_.half.x, window_.half.y, window_.half.z}) / kPartsOfWindow, kLeastPart);
  }

  /// Far away the formula holds without demand k, whose distance grows there, or falls, for ever.
  bool unbounded(std::size_t k, Sense sense) const {
    MetDemands met = far_.met;
    met[k] = true;
    const bool grows = far_.distance[k].lo > 0;
    return demands_.truth(met) && grows == (sense == Sense::kMaximum);
  }
  static LevelChange endless(std::size_t k) {
    LevelChange out;
    out.atom = k;
    out.kind = Kind::kFree;
    return out;
  }
  /// `see`: what the demands at a place say of it.
  template <class See>
  PlaceSearch searching(See see) const {
    const auto seen = [see](const DemandsAt& here) {
      PlaceSeen out = see(here);
      out.open = here.open;
      return out;
    };
    PlaceSearch search;
    search.look = [this, seen](const RealVector& p) { return seen(values_.at(p)); };
    search.glance = [this, seen](const Vector& p, const PlaceSearch::Needless& needless) {
      return seen(values_.within(p, [&](const DemandsAt& here) { return needless(seen(here)); }));
    };
    return search;
  }
  static PlaceSeen value_seen(const DemandsAt& here, std::size_t k, Sense sense) {
    return {sense == Sense::kMinimum ? here.distance[k] : -here.distance[k], exact::kInfinity, true};
  }
  /// What a search for the best value of the distance of demand k has found.
  LevelChange changed_to(std::size_t k, Sense sense, const PlaceFound& found) const {
    LevelChange out;
    out.atom = k;
    if (!found.at) {
      if (found.bound == exact::kInfinity) return out;
      out.kind = Kind::kUnknown;
      out.refused = "none of the positions that were looked at meets the other conditions";
      return out;
    }
    const auto v = values_.value(k, *found.at);
    if (!v || v->minus_infinity) return endless(k);
    const distance::Enclosure ends = v->bounds();
    const bool least = sense == Sense::kMinimum;
    distance::OptimalValue best;
    best.sense = sense;
    best.attained = true;
    const Real taken = (least ? ends.upper : ends.lower).value_or(v->value);
    if (v->proven && found.bound >= found.least) {
      best.set_exact(taken * step(), distance::Way::kSearch);
    } else {
      const Real bound = Real::from_double(least ? found.bound : -found.bound);
      best.set_enclosed(taken * step(), bound * step(), distance::Way::kSearch);
    }
    out = changed(demands_, k, best, true);
    out.place.at = distance::coordinates(space::scaled(step(), *found.at));
    return out;
  }

 private:
  enum class Part { kAsked, kMet, kUnmet };

  MetDemands assumed(MetDemands met, const std::vector<Part>& parts) const {
    for (std::size_t k = 0; k < met.size(); ++k)
      if (parts[k] != Part::kAsked) met[k] = parts[k] == Part::kMet;
    return met;
  }
  bool known(const std::vector<Part>& parts) const {
    return std::any_of(cells_.begin(), cells_.end(),
                       [&](const MetDemands& met) { return demands_.truth(assumed(met, parts)); });
  }
  Tried<bool> room(const std::vector<Part>& parts) {
    if (!demands_.truth(assumed(MetDemands(demands_.size(), true), parts))) return false;
    if (known(parts)) return true;
    PlaceSearch search = searching([&](const DemandsAt& here) {
      std::vector<double> least, most;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const double known = parts[k] == Part::kMet ? exact::kInfinity : -exact::kInfinity;
        least.push_back(parts[k] == Part::kAsked ? here.slack[k].lo : known);
        most.push_back(parts[k] == Part::kAsked ? here.slack[k].hi : known);
      }
      const double low = demands_.measure(least), high = demands_.measure(most);
      return PlaceSeen{{-high, -low}, high, demands_.truth(assumed(here.met, parts))};
    });
    search.enough = std::numeric_limits<double>::max();
    search.beyond = 0;
    const PlaceFound found = find_place(search, {window_});
    if (found.at) {
      keep(*found.at, values_.at(*found.at).met);
      return true;
    }
    if (found.bound == exact::kInfinity) return false;
    if (const auto at = touching(parts, found.nearly)) {
      MetDemands met = values_.at(*at).met;
      if (demands_.truth(assumed(met, parts))) {
        keep(*at, std::move(met));
        return true;
      }
    }
    return exact::Refusal(
        Error(ErrorCode::kLimit, fmt::format("whether there is room is not decided: the boxes of positions that were "
                                             "looked at leave it open, the best lacks {:.3g} "
                                             "at most",
                                             std::max(0.0, found.bound * step().to_double()))));
  }
  void keep(const RealVector& p, MetDemands met) {
    cells_.push_back(std::move(met));
    places_.push_back(p);
  }
  /// A position near p at which shapes touch and the formula holds so, if contacts tell one.
  std::optional<RealVector> touching(const std::vector<Part>& parts, const RealVector& p) const {
    const Formula wanted = demands_.with([&](std::size_t k) {
      return parts[k] == Part::kAsked ? demands_.demand(k) : constant(parts[k] == Part::kMet);
    });
    const TriedNearest near = nearest_feasible(solver_, wanted, space::scaled(step(), p));
    if (!near || !*near || !(*near)->attained) return std::nullopt;
    const distance::Coordinates& at = (*near)->at;
    return space::scaled(Real(1) / step(), {at[0], at[1], at[2]});
  }

  const SpaceSolver& solver_;
  const Demands& demands_;
  DemandValues values_;
  PlaceBox window_;
  DemandsAt far_;
  std::vector<MetDemands> cells_;  // of positions seen
  std::vector<RealVector> places_;
};

class BoxGround : public SearchedGround {
 public:
  BoxGround(const SpaceSolver& solver, const Demands& demands, const std::vector<MetDemands>& met)
      : SearchedGround(solver, demands), met_(demands, met) {}

  Tried<bool> room(const std::optional<AssumedDemand>& assumed) override { return has_room(met_, assumed); }
  Conflict conflict() override { return find_conflict(met_); }
  LevelChange best(std::size_t k, int sign, Sense sense) override {
    const Formula& formula = demands().formula();
    const BoxComplex set =
        solver()
            .try_region(formula, [&](std::span<const Mark> signs) { return holds_without(demands(), signs, k, sign); })
            .or_throw();
    if (set.empty()) return changed_to(k, sense, {});
    if (unbounded(k, sense)) return endless(k);
    if (const auto found = box_extreme(solver(), formula.atoms()[k].distance, set, sense)) {
      distance::OptimalValue best;
      best.sense = sense;
      best.attained = found->attained;
      best.set_exact(found->value * step(), distance::Way::kBoxes);
      LevelChange out = changed(demands(), k, best, found->attained);
      out.place.at = distance::coordinates(space::scaled(step(), found->at));
      return out;
    }
    std::vector<PlaceBox> boxes;
    for (const space::IntervalBox& box : set.boxes()) boxes.push_back(place_box(box));
    PlaceSearch search = searching([k, sense](const DemandsAt& here) { return value_seen(here, k, sense); });
    search.tolerance = tolerance();
    return changed_to(k, sense, find_place(search, boxes));
  }

 private:
  PlaceBox place_box(const space::IntervalBox& box) const {
    const Vector low = window().center - window().half, high = space::plus(window().center, window().half);
    const auto from = [](const std::optional<Real>& end, double otherwise) {
      return end ? end->to_double() : otherwise;
    };
    const Vector a{from(box[0].from, low.x), from(box[1].from, low.y), from(box[2].from, low.z)},
        b{from(box[0].to, high.x), from(box[1].to, high.y), from(box[2].to, high.z)};
    return {space::scaled(0.5, space::plus(a, b)), space::scaled(0.5, b - a)};
  }

  FailingCells met_;
};

}  // namespace

std::unique_ptr<Ground> space_ground(const SpaceSolver& solver, const Demands& demands) {
  std::vector<MetDemands> cells;
  const auto whole = solver.try_region(demands.formula(), [&](std::span<const Mark> signs) {
    MetDemands met = met_at(demands, signs);
    if (std::find(cells.begin(), cells.end(), met) == cells.end()) cells.push_back(std::move(met));
    return true;
  });
  if (whole) return std::make_unique<BoxGround>(solver, demands, cells);
  return std::make_unique<SearchedGround>(solver, demands);
}

}  // namespace findspace::formula
