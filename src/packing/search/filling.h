// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts that found no place in the containers: each attempt adds one of them, or puts it in the place of a less
// valuable one, and separates what overlaps then. Guarantee: the value of a layout never falls, and it has no overlaps,
// in doubles. Cost: a separation an attempt. Keywords: knapsack, most valuable choice.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "packing/search/separation.h"

namespace findspace::packing {

inline constexpr Patience kFillPatience{60, 2};
inline constexpr double kExchanged = 0.5;  // of the attempts put a part in the place of another

/// A part that is left; the more valuable it is, the more often.
inline std::size_t candidate(const std::vector<std::size_t>& left, const std::vector<double>& values, Random& random) {
  const std::size_t first = random.below(left.size()), second = random.below(left.size());
  return values[left[second]] > values[left[first]] ? second : first;
}

/// An item that is worth less than the part, or nothing: then the part is added.
template <class Kit>
std::optional<std::size_t> victim(const typename Kit::Table& table, const FirstLayoutOf<typename Kit::Pose>& from,
                                  double value, const std::vector<double>& values, Random& random) {
  std::vector<std::size_t> cheaper;
  for (std::size_t i = 0; i < from.layout.poses.size(); ++i)
    if (values[Kit::part_of(table, from.layout.poses[i])] < value) cheaper.push_back(i);
  if (cheaper.empty() || random.unit() < kExchanged) return std::nullopt;
  return cheaper[random.below(cheaper.size())];
}

/// One attempt with its own random numbers; nothing where it fails.
template <class Kit>
std::optional<FirstLayoutOf<typename Kit::Pose>> filled(const typename Kit::Table& table, const typename Kit::Row& row,
                                                        const std::vector<double>& values,
                                                        const FirstLayoutOf<typename Kit::Pose>& from,
                                                        std::uint64_t seed, std::uint64_t& work) {
  using Pose = typename Kit::Pose;
  if (from.left.empty()) return std::nullopt;
  Random random(seed);
  FirstLayoutOf<Pose> to = from;
  const std::size_t chosen = candidate(to.left, values, random), part = to.left[chosen];
  to.left.erase(to.left.begin() + std::ptrdiff_t(chosen));
  Pose pose{table.variants_of(part)[random.below(table.variants_of(part).size())], {}};
  auto& poses = to.layout.poses;
  if (const auto out = victim<Kit>(table, from, values[part], values, random)) {
    pose.at = poses[*out].at;
    to.left.push_back(Kit::part_of(table, poses[*out]));
    poses.erase(poses.begin() + std::ptrdiff_t(*out));
  } else {
    pose.at = Kit::anywhere(table, row, random);
  }
  poses.push_back(pose);
  const double end = row.rooms().end();
  SeparationOf<Kit> separation(table, row, poses, end, random);
  separation.begin(poses, end, 2 * end);
  using State = typename SeparationOf<Kit>::State;
  State state = State::kUnderWay;
  while (state == State::kUnderWay) state = separation.pass(kFillPatience);
  work += separation.work();
  if (state == State::kStuck) return std::nullopt;
  to.layout = separation.free();
  return to;
}

}  // namespace findspace::packing
