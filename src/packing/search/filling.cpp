// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/filling.h"

#include <algorithm>

namespace findspace::packing {
namespace {

constexpr Patience kFillPatience{60, 2};

/// A part that is left; the more valuable it is, the more often.
std::size_t candidate(const std::vector<std::size_t>& left, const std::vector<double>& values, Random& random) {
  std::size_t best = random.below(left.size());
  const std::size_t other = random.below(left.size());
  return values[left[other]] > values[left[best]] ? other : best;
}

/// An item that is worth less than the part, or nothing: then the part is added.
std::optional<std::size_t> victim(const FieldTable& table, const FirstLayout& from, double value,
                                  const std::vector<double>& values, Random& random) {
  std::vector<std::size_t> cheaper;
  for (std::size_t i = 0; i < from.layout.poses.size(); ++i)
    if (values[table.variants()[from.layout.poses[i].variant].part] < value) cheaper.push_back(i);
  if (cheaper.empty() || random.unit() < 0.5) return std::nullopt;
  return cheaper[random.below(cheaper.size())];
}

}  // namespace

std::optional<FirstLayout> filled(const FieldTable& table, const Row& row, const std::vector<double>& values,
                                  const FirstLayout& from, std::uint64_t seed, std::uint64_t& work) {
  if (from.left.empty()) return std::nullopt;
  Random random(seed);
  FirstLayout to = from;
  const std::size_t chosen = candidate(to.left, values, random), part = to.left[chosen];
  to.left.erase(to.left.begin() + std::ptrdiff_t(chosen));
  Pose pose{table.variants_of(part)[random.below(table.variants_of(part).size())], {}};
  auto& poses = to.layout.poses;
  if (const auto out = victim(table, from, values[part], values, random)) {
    pose.at = poses[*out].at;
    to.left.push_back(table.variants()[poses[*out].variant].part);
    poses.erase(poses.begin() + std::ptrdiff_t(*out));
  } else {
    pose.at = {random.between(0, row.end()), random.between(0, table.height())};
  }
  poses.push_back(pose);
  Separation separation(table, row, poses, row.end(), random);
  separation.begin(poses, row.end(), 2 * row.end());
  Separation::State state = Separation::State::kUnderWay;
  while (state == Separation::State::kUnderWay) state = separation.pass(kFillPatience);
  work += separation.work();
  if (state == Separation::State::kStuck) return std::nullopt;
  to.layout = separation.free();
  return to;
}

}  // namespace findspace::packing
