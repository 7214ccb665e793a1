// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random numbers that are the same on every machine: splitmix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace findspace::packing {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// From 0 to 1, without 1.
  double unit() { return double(next() >> 11) / double(std::uint64_t{1} << 53); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::size_t below(std::size_t count) { return std::size_t(unit() * double(count)); }
  /// The absolute value of a normal number, by Box and Muller.
  double half_normal() {
    return std::abs(std::sqrt(-2 * std::log(1 - unit())) * std::cos(2 * std::numbers::pi * unit()));
  }

 private:
  std::uint64_t state_;
};

}  // namespace findspace::packing
