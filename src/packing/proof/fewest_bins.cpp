// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/proof/fewest_bins.h"

#include <algorithm>

namespace findspace::packing {
namespace {

using exact::Real;

void sort_down(std::vector<Alike>& all) {
  std::sort(all.begin(), all.end(), [](const Alike& a, const Alike& b) { return a.size > b.size; });
}

/// The least whole number that is not below the value, which is not below 0.
std::size_t rounded_up(const Real& value) { return std::size_t(-exact::floor(-value)); }

/// The largest bins until they make up the sum.
std::size_t by_sum(const std::vector<Alike>& bins, Real rest) {
  std::size_t count = 0;
  for (const Alike& bin : bins) {
    if (rest.sign() <= 0) break;
    const bool enough = Real(bin.count) * bin.size >= rest;
    count += enough ? rounded_up(rest / bin.size) : bin.count;
    rest = enough ? Real() : rest - Real(bin.count) * bin.size;
  }
  return count;
}

/// Items from the largest on, with the counts and sums of those before each.
class SortedItems {
 public:
  explicit SortedItems(const std::vector<Alike>& items) : items_(items), counts_{0}, sums_{Real()} {
    for (const Alike& i : items) {
      counts_.push_back(counts_.back() + i.count);
      sums_.push_back(sums_.back() + Real(i.count) * i.size);
    }
  }

  const Real& sum() const { return sums_.back(); }
  /// In equal bins, the items below `least`, which is at most half a bin, left out.
  std::size_t bins(const Real& bin, const Real& least) const {
    const std::size_t alone = first([&](const Real&s) { return s + least > bin; }),
                      large = first([&](const Real&s) { return s + s > bin; }),
                      counted = first([&](const Real&s) { return s >= least; });
    const std::size_t half_full = counts_[large] - counts_[alone];
    const Real room = Real(half_full) * bin - (sums_[large] - sums_[alone]),
               others = sums_[counted] - sums_[large] - room;
    return counts_[large] + (others.sign() > 0 ? rounded_up(others / bin) : 0);
  }

 private:
  /// The first item for which the test, true of the largest ones, is false.
  template <class Test>
  std::size_t first(const Test& test) const {
    return std::size_t(
        std::partition_point(items_.begin(), items_.end(), [&](const Alike& i) { return test(i.size); }) -
        items_.begin());
  }

  const std::vector<Alike>& items_;
  std::vector<std::size_t> counts_;
  std::vector<Real> sums_;
};

}  // namespace

std::size_t fewest_bins(std::vector<Alike> bins, std::vector<Alike> items) {
  const auto is_nothing = [](const Alike& a) { return a.count == 0 || a.size.sign() <= 0; };
  std::erase_if(bins, is_nothing);
  std::erase_if(items, is_nothing);
  if (bins.empty() || items.empty()) return 0;
  sort_down(bins);
  sort_down(items);
  const SortedItems sorted(items);
  const Real& bin = bins.front().size;
  std::size_t fewest = by_sum(bins, sorted.sum()), all = 0;
  for (const Alike& b : bins) all += b.count;
  for (const Alike& item : items)
    if (item.size + item.size <= bin) fewest = std::max(fewest, sorted.bins(bin, item.size));
  return std::min(all, std::max(fewest, sorted.bins(bin, Real())));
}

}  // namespace findspace::packing
