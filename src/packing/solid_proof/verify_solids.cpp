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

class SolidCheck {
 public:
  SolidCheck(const SolidProblem& problem, const SolidLayout& layout) : problem_(problem), layout_(layout) {
    std::vector<SolidBox> of_part;
    for (const SolidPart& part : problem.parts) of_part.push_back(box_of(problem, part));
    for (const SolidPlaced& item : layout.items) {
      SolidBox& box = boxes_.emplace_back(of_part[item.part]);
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = box.low[k] + item.at[k];
        box.high[k] = box.high[k] + item.at[k];
      }
    }
  }

  SolidVerdict verdict() {
    count_copies();
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      check_inside(i);
      result_.used = std::max(result_.used, boxes_[i].high[2]);
    }
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
    const SolidBox& box = boxes_[i];
    const Position most{problem_.width, problem_.depth, layout_.height};
    Fraction out = 0;
    for (std::size_t k = 0; k < 3; ++k)
      out = std::max({out, problem_.edge - box.low[k], box.high[k] + problem_.edge - most[k]});
    if (out > 0)
      result_.faults.push_back(
          {.kind = SolidFault::Kind::kOutside, .first = i, .depth = out.to_double(), .at = middle(box, box)});
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
      if (boxes_[i].high[k] + problem_.gap <= boxes_[j].low[k] || boxes_[j].high[k] + problem_.gap <= boxes_[i].low[k])
        return false;
    return true;
  }

  std::optional<SolidFault> pair_fault(std::size_t i, std::size_t j) const {
    if (!boxes_meet(i, j)) return std::nullopt;
    const SolidPlaced &a = layout_.items[i], &b = layout_.items[j];
    const SolidPairProof& proof = proof_of(a.part, b.part);
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

  const SolidPairProof& proof_of(std::size_t a, std::size_t b) const {
    {
      const std::lock_guard lock(guard_);
      if (const auto known = proofs_.find({a, b}); known != proofs_.end()) return *known->second;
    }
    auto made = std::make_unique<const SolidPairProof>(problem_, problem_.parts[a], problem_.parts[b]);
    const std::lock_guard lock(guard_);
    return *proofs_.emplace(std::pair(a, b), std::move(made)).first->second;
  }

  /// Of what the boxes have in common, or of what is between them.
  static std::array<double, 3> middle(const SolidBox& a, const SolidBox& b) {
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = (std::max(a.low[k], b.low[k]).to_double() + std::min(a.high[k], b.high[k]).to_double()) / 2;
    return at;
  }

  const SolidProblem& problem_;
  const SolidLayout& layout_;
  std::vector<SolidBox> boxes_;
  mutable std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<const SolidPairProof>> proofs_;
  mutable std::mutex guard_;
  SolidVerdict result_;
};

}  // namespace

SolidVerdict verify(const SolidProblem& problem, const SolidLayout& layout) {
  return SolidCheck(problem, layout).verdict();
}

}  // namespace findspace::packing
