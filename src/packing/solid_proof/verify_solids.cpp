// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/verify_solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "packing/problem/pair_formula.h"
#include "packing/solid_problem/solid_pair_formula.h"
#include "packing/solid_proof/solid_containment.h"
#include "packing/solid_proof/solid_pair_proof.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

using Position = std::array<Fraction, 3>;
using FormPair = std::array<std::size_t, 4>;

class SolidCheck {
  struct Box {
    std::array<int128, 3> low{}, high{};
  };

 public:
  SolidCheck(const SolidProblem& problem, const SolidLayout& layout) : problem_(problem), layout_(layout) {
    common_ = common_multiple(common_multiple(problem.width.denominator(), problem.depth.denominator()),
                              common_multiple(problem.gap.denominator(), problem.edge.denominator()));
    common_ = common_multiple(common_, layout.height.denominator());
    for (const PairGap& pair : problem.pair_gaps) common_ = common_multiple(common_, pair.gap.denominator());
    for (const std::size_t kind : layout.containers)
      for (const Fraction& side : sides_of(problem.containers[kind]))
        common_ = common_multiple(common_, side.denominator());
    std::map<std::array<std::size_t, 2>, SolidBox> of_form;
    for (const SolidPlaced& item : layout.items) {
      const auto [known, is_new] = of_form.try_emplace({item.part, item.form});
      if (is_new) known->second = box_of(problem, form_of(problem, item));
      for (std::size_t k = 0; k < 3; ++k)
        for (const Fraction& f : {item.at[k], known->second.low[k], known->second.high[k]})
          common_ = common_multiple(common_, f.denominator());
    }
    for (const SolidPlaced& item : layout.items) {
      const SolidBox& form = of_form.at({item.part, item.form});
      Box& box = boxes_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = form.low[k].over(common_) + item.at[k].over(common_);
        box.high[k] = form.high[k].over(common_) + item.at[k].over(common_);
      }
    }
    widest_gap_ = problem.widest_gap_of_all().over(common_);
    if (!problem.conditions.empty() && layout.containers.size() > 1)
      greatest_level_ = Fraction(int128(std::ceil(packing::greatest_level(problem.conditions, 3))), 1);
  }

  SolidVerdict verdict() {
    count_copies();
    count_containers();
    find_fixed();
    check_inside();
    int128 used = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (is_in_last(i)) used = std::max(used, boxes_[i].high[2]);
    result_.used = Fraction(used, common_);
    check_pairs();
    const double room = container_volume(problem_, layout_);
    result_.density = room > 0 ? volume(problem_, layout_) / room : 0;
    std::stable_sort(result_.faults.begin(), result_.faults.end(),
                     [](const SolidFault& f, const SolidFault& g) { return f.depth > g.depth; });
    return std::move(result_);
  }

 private:
  void count_copies() {
    std::vector<int> left;
    for (const SolidPart& part : problem_.parts) left.push_back(part.demand);
    for (const SolidPlaced& item : layout_.items) --left[item.part];
    for (const LeftOut& out : layout_.left_out) left[out.part] -= out.copies;
    for (std::size_t p = 0; p < left.size(); ++p)
      if (left[p] != 0)
        result_.faults.push_back({.kind = SolidFault::Kind::kCount, .first = p, .depth = -double(left[p])});
  }

  static std::array<Fraction, 3> sides_of(const SolidContainer& c) { return {c.width, c.depth, c.height}; }

  /// No more of a kind than there are.
  void count_containers() {
    std::vector<int> left;
    for (const SolidContainer& container : problem_.containers) left.push_back(container.count);
    for (const std::size_t kind : layout_.containers) --left[kind];
    for (std::size_t kind = 0; kind < left.size(); ++kind)
      if (left[kind] < 0)
        result_.faults.push_back({.kind = SolidFault::Kind::kContainers, .first = kind, .depth = -double(left[kind])});
  }

  void find_fixed() {
    for (const FixedSolid& f : problem_.fixed) {
      const auto is_it = [&](const SolidPlaced& item) { return is_fixed_solid(layout_, item, f); };
      if (std::any_of(layout_.items.begin(), layout_.items.end(), is_it)) continue;
      const auto& [x, y, z] = f.placed.at;
      result_.faults.push_back({.kind = SolidFault::Kind::kFixed,
                                .first = f.placed.part,
                                .at = {x.to_double(), y.to_double(), z.to_double()}});
    }
  }

  std::size_t container_of(std::size_t i) const { return layout_.items[i].container; }
  bool is_in_last(std::size_t i) const { return container_of(i) + 1 >= layout_.containers.size(); }

  void check_inside() {
    std::vector<std::optional<SolidFault>> found(boxes_.size());
    plane::parallel_for(boxes_.size(), [&](std::size_t i) { found[i] = outside_fault(i); });
    for (const auto& fault : found)
      if (fault) result_.faults.push_back(*fault);
  }

  std::optional<SolidFault> outside_fault(std::size_t i) const {
    const Box& box = boxes_[i];
    const int128 edge = problem_.edge.over(common_);
    SolidFault fault{.kind = SolidFault::Kind::kOutside, .first = i, .at = middle(box, box)};
    std::array<Fraction, 3> sides{problem_.width, problem_.depth, layout_.height};
    if (container_of(i) >= std::max<std::size_t>(layout_.containers.size(), problem_.in_containers() ? 0 : 1))
      return fault;
    if (problem_.in_containers()) {
      sides = sides_of(problem_.containers[layout_.containers[container_of(i)]]);
      // The height that is stated is that up to which the last one is used.
      if (is_in_last(i)) sides[2] = std::min(sides[2], layout_.height);
    }
    const int128 most[] = {sides[0].over(common_), sides[1].over(common_), sides[2].over(common_)};
    int128 out = 0;
    for (std::size_t k = 0; k < 3; ++k) out = std::max({out, edge - box.low[k], box.high[k] + edge - most[k]});
    fault.depth = double(out) / double(common_);
    if (out > 0) return fault;
    return within_walls(i, fault.depth) ? std::nullopt : std::optional(fault);
  }

  /// Of a container that is no box; else by how much it is outside.
  bool within_walls(std::size_t i, double& excess) const {
    if (!problem_.in_containers()) return true;
    const SolidPlaced& item = layout_.items[i];
    const std::size_t kind = layout_.containers[container_of(i)];
    if (!problem_.containers[kind].inside) return true;
    const SolidContainment& proof = made_once<SolidContainment>(containments_, {item.part, item.form, kind, 0}, [&] {
      return containment_of(problem_, problem_.containers[kind], form_of(problem_, item));
    });
    if (proof.holds(item.at, problem_.edge)) return true;
    excess = proof.excess(item.at, problem_.edge);
    return false;
  }

  void check_pairs() {
    std::vector<std::vector<SolidFault>> found(boxes_.size());
    plane::parallel_for(boxes_.size(), [&](std::size_t i) {
      for (std::size_t j = i + 1; j < boxes_.size(); ++j)
        if (const auto fault = pair_fault(i, j)) found[i].push_back(*fault);
    });
    for (const auto& faults : found) result_.faults.insert(result_.faults.end(), faults.begin(), faults.end());
  }

  bool boxes_meet(std::size_t i, std::size_t j, int128 gap) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (boxes_[i].high[k] + gap <= boxes_[j].low[k] || boxes_[j].high[k] + gap <= boxes_[i].low[k]) return false;
    return true;
  }

  std::optional<SolidFault> pair_fault(std::size_t i, std::size_t j) const {
    const SolidPlaced &a = layout_.items[i], &b = layout_.items[j];
    const bool near = container_of(i) == container_of(j) && boxes_meet(i, j, widest_gap_);
    const bool tied = problem_.are_tied(a.part, b.part);
    if (!near && !tied) return std::nullopt;
    SolidFault fault{.first = i, .second = j, .at = middle(boxes_[i], boxes_[j])};
    const Fraction gap = problem_.gap_of(a.part, b.part);
    if (near && boxes_meet(i, j, gap.over(common_))) {
      const SolidPairProof& proof = made_once<SolidPairProof>(proofs_, of_both(a, b), [&] {
        return std::make_unique<const SolidPairProof>(problem_, form_of(problem_, a), form_of(problem_, b));
      });
      const Position u = between(a, b);
      if (proof.interiors_meet(u)) {
        fault.depth = proof.depth(u);
        return fault;
      }
      fault.kind = SolidFault::Kind::kGap;
      if (gap > 0 && proof.is_nearer(u, gap)) return fault;
    }
    if (!tied || conditions_hold(i, j)) return std::nullopt;
    fault.kind = SolidFault::Kind::kCondition;
    return fault;
  }

  /// In different containers: those of two parts that are farther apart than any condition asks.
  bool conditions_hold(std::size_t i, std::size_t j) const {
    const SolidPlaced &a = layout_.items[i], &b = layout_.items[j];
    const SolidPairFormula& pair = made_once<SolidPairFormula>(formulas_, of_both(a, b), [&] {
      return std::make_unique<const SolidPairFormula>(problem_, a.part, form_of(problem_, a), b.part,
                                                      form_of(problem_, b));
    });
    if (container_of(i) == container_of(j)) return pair.holds(between(a, b));
    return pair.holds({reach_of(i) + reach_of(j) + greatest_level_ + 1, 0, 0});
  }

  static Position between(const SolidPlaced& a, const SolidPlaced& b) {
    return {b.at[0] - a.at[0], b.at[1] - a.at[1], b.at[2] - a.at[2]};
  }

  /// How far a part reaches from its origin along x.
  Fraction reach_of(std::size_t i) const {
    const int128 origin = layout_.items[i].at[0].over(common_);
    return Fraction(std::max({boxes_[i].high[0] - origin, origin - boxes_[i].low[0], int128(0)}), common_);
  }

  template <class T>
  using OfForms = std::map<FormPair, std::unique_ptr<const T>>;

  static FormPair of_both(const SolidPlaced& a, const SolidPlaced& b) { return {a.part, a.form, b.part, b.form}; }

  template <class T, class Make>
  const T& made_once(OfForms<T>& all, const FormPair& key, const Make& make) const {
    {
      const std::lock_guard lock(guard_);
      if (const auto known = all.find(key); known != all.end()) return *known->second;
    }
    auto made = make();
    const std::lock_guard lock(guard_);
    return *all.emplace(key, std::move(made)).first->second;
  }

  /// Of what the boxes have in common, or of what is between them.
  std::array<double, 3> middle(const Box& a, const Box& b) const {
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = (double(std::max(a.low[k], b.low[k])) + double(std::min(a.high[k], b.high[k]))) / 2 / double(common_);
    return at;
  }

  const SolidProblem& problem_;
  const SolidLayout& layout_;
  int128 common_ = 1;  // boxes are integers over it, and so are gaps
  std::vector<Box> boxes_;
  int128 widest_gap_ = 0;
  Fraction greatest_level_;  // of conditions, or more; 0 where there is one container
  mutable OfForms<SolidPairProof> proofs_;
  mutable OfForms<SolidPairFormula> formulas_;
  mutable OfForms<SolidContainment> containments_;  // of a form and a kind of container
  mutable std::mutex guard_;
  SolidVerdict result_;
};

}  // namespace

SolidVerdict verify(const SolidProblem& problem, const SolidLayout& layout) {
  return SolidCheck(problem, layout).verdict();
}

}  // namespace findspace::packing
