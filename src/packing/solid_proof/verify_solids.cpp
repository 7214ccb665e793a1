// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/verify_solids.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

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
    gap_ = problem.gap.over(common_);
  }

  SolidVerdict verdict() {
    count_copies();
    int128 used = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      check_inside(i);
      used = std::max(used, boxes_[i].high[2]);
    }
    result_.used = Fraction(used, common_);
    check_pairs();
    double volume = 0;
    for (const SolidPlaced& item : layout_.items) volume += volume_of(problem_, problem_.parts[item.part]);
    const double room = problem_.width.to_double() * problem_.depth.to_double() * layout_.height.to_double();
    result_.density = room > 0 ? volume / room : 0;
    std::stable_sort(result_.faults.begin(), result_.faults.end(),
                     [](const SolidFault& f, const SolidFault& g) { return f.depth > g.depth; });
    return std::move(result_);
  }

 private:
  void count_copies() {
    std::vector<int> left;
    for (const SolidPart& part : problem_.parts) left.push_back(part.demand);
    for (const SolidPlaced& item : layout_.items) --left[item.part];
    for (std::size_t p = 0; p < left.size(); ++p)
      if (left[p] != 0)
        result_.faults.push_back({.kind = SolidFault::Kind::kCount, .first = p, .depth = -double(left[p])});
  }

  void check_inside(std::size_t i) {
    const Box& box = boxes_[i];
    const int128 edge = problem_.edge.over(common_);
    const int128 most[] = {problem_.width.over(common_), problem_.depth.over(common_), layout_.height.over(common_)};
    int128 out = 0;
    for (std::size_t k = 0; k < 3; ++k) out = std::max({out, edge - box.low[k], box.high[k] + edge - most[k]});
    if (out > 0)
      result_.faults.push_back({.kind = SolidFault::Kind::kOutside,
                                .first = i,
                                .depth = double(out) / double(common_),
                                .at = middle(box, box)});
  }

  void check_pairs() {
    std::vector<std::vector<SolidFault>> found(boxes_.size());
    plane::parallel_for(boxes_.size(), [&](std::size_t i) {
      for (std::size_t j = i + 1; j < boxes_.size(); ++j)
        if (const auto fault = pair_fault(i, j)) found[i].push_back(*fault);
    });
    for (const auto& faults : found) result_.faults.insert(result_.faults.end(), faults.begin(), faults.end());
  }

  bool boxes_meet(std::size_t i, std::size_t j) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (boxes_[i].high[k] + gap_ <= boxes_[j].low[k] || boxes_[j].high[k] + gap_ <= boxes_[i].low[k]) return false;
    return true;
  }

  std::optional<SolidFault> pair_fault(std::size_t i, std::size_t j) const {
    if (!boxes_meet(i, j)) return std::nullopt;
    const SolidPlaced &a = layout_.items[i], &b = layout_.items[j];
    const SolidPairProof& proof = proof_of(a, b);
    const Position u{b.at[0] - a.at[0], b.at[1] - a.at[1], b.at[2] - a.at[2]};
    SolidFault fault{.first = i, .second = j, .at = middle(boxes_[i], boxes_[j])};
    if (proof.interiors_meet(u)) {
      fault.depth = proof.depth(u);
      return fault;
    }
    if (problem_.gap <= 0 || !proof.is_nearer(u, problem_.gap)) return std::nullopt;
    fault.kind = SolidFault::Kind::kGap;
    return fault;
  }

  const SolidPairProof& proof_of(const SolidPlaced& a, const SolidPlaced& b) const {
    const FormPair key{a.part, a.form, b.part, b.form};
    {
      const std::lock_guard lock(guard_);
      if (const auto known = proofs_.find(key); known != proofs_.end()) return *known->second;
    }
    auto made = std::make_unique<const SolidPairProof>(problem_, form_of(problem_, a), form_of(problem_, b));
    const std::lock_guard lock(guard_);
    return *proofs_.emplace(key, std::move(made)).first->second;
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
  int128 common_ = 1, gap_ = 0;  // boxes are integers over it, and so is the gap
  std::vector<Box> boxes_;
  mutable std::map<FormPair, std::unique_ptr<const SolidPairProof>> proofs_;
  mutable std::mutex guard_;
  SolidVerdict result_;
};

}  // namespace

SolidVerdict verify(const SolidProblem& problem, const SolidLayout& layout) {
  return SolidCheck(problem, layout).verdict();
}

}  // namespace findspace::packing
