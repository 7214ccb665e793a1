// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/least_height.h"

#include <algorithm>

#include "exact/margins/packing.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostCopies = 10;
constexpr std::size_t kTrees = 64, kNodes = 200;  // of a tree in a round

}  // namespace

bool is_provable(const SolidProblem& problem, const SolidTable& table) {
  if (problem.in_containers() || !problem.fixed.empty() || problem.items() > kMostCopies) return false;
  return std::all_of(problem.parts.begin(), problem.parts.end(), [&](const SolidPart& part) {
    if (part.demand == 0) return true;
    const std::vector<std::size_t>& variants = table.variants_of(std::size_t(&part - problem.parts.data()));
    if (variants.size() != 1) return false;
    const SolidForm& form = part.forms[table.variants()[variants[0]].form];
    return form.is_exact() && !form.has_balls();
  });
}

double LeastHeight::below(double height) { return height * (1 - margin::kHeightProof); }

LeastHeight::LeastHeight(const SolidProblem& problem, const SolidTable& table, double height)
    : choices_(problem, table, height), below_(below(height)) {
  trees_.emplace_back(choices_);
}

double LeastHeight::bound() const {
  double result = std::min(over_, below_);
  for (const HeightTree& tree : trees_) result = std::min(result, tree.bound());
  return result;
}

std::uint64_t LeastHeight::programs() const {
  std::uint64_t result = programs_;
  for (const HeightTree& tree : trees_) result += tree.programs();
  return result;
}

void LeastHeight::divide() {
  for (std::size_t k = 0, count = trees_.size(); k < count; ++k)
    for (HeightTree& part : trees_[k].divided(below_)) trees_.push_back(std::move(part));
}

std::vector<double> LeastHeight::collect() {
  std::vector<double> lowest;
  for (HeightTree& tree : trees_) {
    if (std::vector<double> found = tree.take_found();
        lowest.empty() || (!found.empty() && found.back() < lowest.back()))
      lowest = std::move(found);
    if (!tree.is_over()) continue;
    over_ = std::min(over_, tree.bound());
    programs_ += tree.programs();
  }
  std::erase_if(trees_, [](const HeightTree& tree) { return tree.is_over(); });
  return lowest;
}

std::optional<std::vector<SolidPose>> LeastHeight::search() {
  if (trees_.size() < kTrees)
    divide();
  else
    plane::parallel_for(trees_.size(), [&](std::size_t k) { trees_[k].visit(below_, kNodes); });
  const std::vector<double> lowest = collect();
  if (lowest.empty()) return std::nullopt;
  return choices_.poses(lowest);
}

}  // namespace findspace::packing
