// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a variant lies within a row of rooms that ends at a given length: a box of positions for each room that it
// fits. Where it fits none, it is put into the one that it sticks out of least, and what sticks out counts as an
// overlap. Guarantee: none; it is a search's state. Cost: rooms times variants. Keywords: inner-fit rectangle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "packing/nfp/rooms.h"
#include "packing/search/random.h"

namespace findspace::packing {

template <class V>
class PositionRanges {
 public:
  /// Variants have boxes about their origins. What sticks out by no more than `shallow` fits.
  template <class Variants>
  void find(const Variants& variants, const Rooms<V>& rooms, double length, double shallow);

  /// The nearest position in a room.
  V inside(std::size_t variant, const V& at) const;
  V random_position(std::size_t variant, Random& random) const;
  /// How much longer the variant is than the rooms allow.
  double excess(std::size_t variant) const { return excess_[variant]; }

 private:
  using Numbers = Coordinates<V>;
  struct Range {
    Numbers low{}, high{};  // high may be below low by a rounding
  };

  static V into(const Range& range, const V& at);

  std::vector<Range> ranges_;  // of a variant those from its first to that of the next
  std::vector<std::uint32_t> first_range_;
  std::vector<double> excess_;
};

template <class V>
template <class Variants>
void PositionRanges<V>::find(const Variants& variants, const Rooms<V>& rooms, double length, double shallow) {
  ranges_.clear();
  first_range_.assign(1, 0);
  excess_.clear();
  for (const auto& v : variants) {
    Range tightest;
    double least_excess = std::numeric_limits<double>::infinity();
    const Numbers low = coordinates(v.low), high = coordinates(v.high);
    for (const Room<V>& room : rooms.all()) {
      Range range{coordinates(room.low), coordinates(room.high)};
      range.high[kAlong<V>] = std::min(range.high[kAlong<V>], length);
      bool fits_across = true;
      for (std::size_t k = 0; k < kAxesOf<V>; ++k) {
        range.low[k] -= low[k];
        range.high[k] -= high[k];
        fits_across &= k == kAlong<V> || range.low[k] <= range.high[k] + shallow;
      }
      if (!fits_across) continue;
      const double out = range.low[kAlong<V>] - range.high[kAlong<V>];
      if (out <= shallow) {
        ranges_.push_back(range);
      } else if (out < least_excess) {
        least_excess = out;
        tightest = range;
      }
    }
    const bool fits = ranges_.size() > first_range_.back();
    if (!fits) ranges_.push_back(tightest);
    excess_.push_back(fits ? 0 : least_excess);
    first_range_.push_back(std::uint32_t(ranges_.size()));
  }
}

template <class V>
V PositionRanges<V>::into(const Range& range, const V& at) {
  Numbers c = coordinates(at);
  for (std::size_t k = 0; k < kAxesOf<V>; ++k) c[k] = std::max(range.low[k], std::min(c[k], range.high[k]));
  return std::bit_cast<V>(c);
}

template <class V>
V PositionRanges<V>::inside(std::size_t variant, const V& at) const {
  const auto off = [&](const V& to) {
    const Numbers from = coordinates(at), c = coordinates(to);
    double sum = 0;
    for (std::size_t k = 0; k < kAxesOf<V>; ++k) sum += std::abs(c[k] - from[k]);
    return sum;
  };
  V best = into(ranges_[first_range_[variant]], at);
  for (std::uint32_t k = first_range_[variant] + 1; k < first_range_[variant + 1]; ++k) {
    const V other = into(ranges_[k], at);
    if (off(other) < off(best)) best = other;
  }
  return best;
}

template <class V>
V PositionRanges<V>::random_position(std::size_t variant, Random& random) const {
  const std::uint32_t first = first_range_[variant], count = first_range_[variant + 1] - first;
  const Range& range = ranges_[first + (count > 1 ? random.below(count) : 0)];
  Numbers c{};
  for (std::size_t k = 0; k < kAxesOf<V>; ++k)
    c[k] = std::max(range.low[k], random.between(range.low[k], range.high[k]));
  return std::bit_cast<V>(c);
}

}  // namespace findspace::packing
