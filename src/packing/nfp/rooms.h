// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers in a row, as one strip with walls, so that one search serves both: the shorter the row, the fewer
// containers are used, and the emptier the last one is. Sheets of the plane stand side by side along x, containers of
// space upon each other along z. A strip is a row of one room without an end. V is a vector of doubles, x first. Cost:
// linear. Keywords: bin packing, cutting stock.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "packing/problem/fraction.h"

namespace findspace::packing {

template <class V>
inline constexpr std::size_t kAxesOf = sizeof(V) / sizeof(double);
template <class V>
using Coordinates = std::array<double, kAxesOf<V>>;
template <class V>
Coordinates<V> coordinates(const V& v) {
  return std::bit_cast<Coordinates<V>>(v);
}
/// The axis of the row, and the coordinate on it.
template <class V>
inline constexpr std::size_t kAlong = kAxesOf<V> == 3 ? 2 : 0;
template <class V>
double along(const V& v) {
  return coordinates(v)[kAlong<V>];
}

/// What a container leaves between its edges.
template <class V>
struct Room {
  V low, high;           // in the row
  std::size_t kind = 0;  // of sheet or container
};

template <class V>
class Rooms {
 public:
  /// Behind those before it.
  void add(const V& sizes, double wall, std::size_t kind) {
    Coordinates<V> low{}, high = coordinates(sizes);
    if (!rooms_.empty()) low[kAlong<V>] = end() + wall;
    high[kAlong<V>] += low[kAlong<V>];
    rooms_.push_back({std::bit_cast<V>(low), std::bit_cast<V>(high), kind});
  }

  const std::vector<Room<V>>& all() const { return rooms_; }
  const Room<V>& operator[](std::size_t k) const { return rooms_[k]; }
  /// Where the last room ends.
  double end() const { return along(rooms_.back().high); }
  /// The room in which a point lies; of one that is in none, the one before.
  std::size_t room_of(const V& point) const {
    const auto behind = [](double x, const Room<V>& room) { return x < along(room.low); };
    const auto next = std::upper_bound(rooms_.begin(), rooms_.end(), along(point), behind);
    return next == rooms_.begin() ? 0 : std::size_t(next - rooms_.begin()) - 1;
  }

 private:
  std::vector<Room<V>> rooms_;
};

/// The rooms that hold something, numbered in their order.
class UsedRooms {
 public:
  /// The room of each item.
  explicit UsedRooms(std::vector<std::size_t> rooms) : rooms_(std::move(rooms)) {
    std::sort(rooms_.begin(), rooms_.end());
    rooms_.erase(std::unique(rooms_.begin(), rooms_.end()), rooms_.end());
  }
  const std::vector<std::size_t>& all() const { return rooms_; }
  std::size_t number_of(std::size_t room) const {
    return std::size_t(std::lower_bound(rooms_.begin(), rooms_.end(), room) - rooms_.begin());
  }

 private:
  std::vector<std::size_t> rooms_;
};

/// The containers of one kind.
struct Stock {
  std::size_t count = 0;         // how many may be used
  std::size_t occupied = 0;      // how many hold fixed parts
  std::optional<Fraction> cost;  // of one
  double size = 0;               // area or volume
};
/// A kind for each container: those with fixed parts, then the cheapest for their size first; in the order given where
/// there are no costs.
std::vector<std::size_t> cheapest_first(const std::vector<Stock>& stock);

}  // namespace findspace::packing
