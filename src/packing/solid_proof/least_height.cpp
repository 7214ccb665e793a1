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
constexpr double kMostWays = 1024;                // in which the copies can stand
constexpr std::size_t kTrees = 64, kNodes = 200;  // of a tree in a round
constexpr std::size_t kMostVisited = 256;         // trees in a round

/// So many times one of `kinds` is taken, where their order does not count.
double choices_of(std::size_t kinds, int times) {
  double result = 1;
  for (int k = 1; k <= times; ++k) result = result * double(kinds + std::size_t(k) - 1) / k;
  return result;
}

/// The variants of all copies, those of a part one after another in the order of their numbers.
class Ways {
 public:
  Ways(const SolidProblem& problem, const SolidTable& table) : problem_(problem), table_(table) {}

  std::vector<std::vector<std::size_t>> all() {
    add(0, 0, 0);
    return std::move(all_);
  }

 private:
  /// From a copy of a part on, which is one of its variants from `first` on.
  void add(std::size_t part, int copy, std::size_t first) {
    if (part == problem_.parts.size()) return all_.push_back(way_);
    if (copy == problem_.parts[part].demand) return add(part + 1, 0, 0);
    const std::vector<std::size_t>& variants = table_.variants_of(part);
    for (std::size_t k = first; k < variants.size(); ++k) {
      way_.push_back(variants[k]);
      add(part, copy + 1, k);
      way_.pop_back();
    }
  }

  const SolidProblem& problem_;
  const SolidTable& table_;
  std::vector<std::size_t> way_;
  std::vector<std::vector<std::size_t>> all_;
};

}  // namespace

bool is_provable(const SolidProblem& problem, const SolidTable& table) {
  if (problem.in_containers() || !problem.fixed.empty() || problem.items() > kMostCopies) return false;
  double ways = 1;
  for (std::size_t part = 0; part < problem.parts.size(); ++part) {
    const int demand = problem.parts[part].demand;
    if (demand == 0) continue;
    const std::vector<std::size_t>& variants = table.variants_of(part);
    ways *= choices_of(variants.size(), demand);
    for (const std::size_t v : variants) {
      const SolidForm& form = problem.parts[part].forms[table.variants()[v].form];
      if (!form.is_exact() || form.has_balls()) return false;
    }
  }
  return ways >= 1 && ways <= kMostWays;
}

double LeastHeight::below(double height) { return height * (1 - margin::kHeightProof); }

LeastHeight::LeastHeight(const SolidProblem& problem, const SolidTable& table, double height) : below_(below(height)) {
  for (std::vector<std::size_t>& way : Ways(problem, table).all()) {
    choices_.push_back(std::make_unique<const HeightChoices>(problem, table, std::move(way), height));
    trees_.emplace_back(*choices_.back());
  }
}

double LeastHeight::bound() const {
  double result = std::min(over_, below_);
  for (const HeightTree& tree : trees_) result = std::min(result, tree.bound());
  return std::max(result, 0.0);  // of trees that were not visited nothing is known
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

std::optional<std::vector<SolidPose>> LeastHeight::collect() {
  std::optional<std::vector<SolidPose>> lowest;
  double height = exact::kInfinity;
  for (HeightTree& tree : trees_) {
    const std::vector<double> found = tree.take_found();
    if (!found.empty() && found.back() < height) {
      height = found.back();
      lowest = tree.choices().poses(found);
    }
    if (!tree.is_over()) continue;
    over_ = std::min(over_, tree.bound());
    programs_ += tree.programs();
  }
  std::erase_if(trees_, [](const HeightTree& tree) { return tree.is_over(); });
  return lowest;
}

/// Those that promise the lowest layouts go on first.
std::optional<std::vector<SolidPose>> LeastHeight::search() {
  if (trees_.size() < kTrees) {
    divide();
    return collect();
  }
  if (trees_.size() > kTrees)
    std::stable_sort(trees_.begin(), trees_.end(),
                     [](const HeightTree& s, const HeightTree& t) { return s.bound() < t.bound(); });
  plane::parallel_for(std::min(trees_.size(), kMostVisited), [&](std::size_t k) { trees_[k].visit(below_, kNodes); });
  return collect();
}

}  // namespace findspace::packing
