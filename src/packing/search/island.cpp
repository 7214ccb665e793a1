// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/island.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace findspace::packing {
namespace {

constexpr double kExploreShrink = 0.001;
constexpr double kFirstCompression = 0.0005, kLastCompression = 0.00001;
constexpr double kExploration = 0.8;  // of the whole search
constexpr std::size_t kPool = 12;
constexpr Patience kExplorePatience{120, 3}, kCompressPatience{80, 3};

double box_area(const Variant& v) { return (v.high.x - v.low.x) * (v.high.y - v.low.y); }

}  // namespace

Island::Island(const FieldTable& table, const Row& row, DoubleLayout start, std::uint64_t seed)
    : table_(table),
      row_(row),
      random_(seed),
      separation_(table, row, start.poses, start.length, random_),
      best_(std::move(start)) {
  for (std::size_t i = 0; i < best_.poses.size(); ++i) large_.push_back(i);
  const auto larger = [&](std::size_t i, std::size_t j) {
    return box_area(table_.variants()[best_.poses[i].variant]) > box_area(table_.variants()[best_.poses[j].variant]);
  };
  std::stable_sort(large_.begin(), large_.end(), larger);
  large_.resize(std::max<std::size_t>(std::min<std::size_t>(large_.size(), 2), large_.size() * 2 / 3));
  best_.length = separation_.shorten(best_.poses, best_.length);
}

void Island::step(double progress) {
  progress_ = progress;
  if (phase_ == Phase::kExplore && progress >= kExploration) {
    phase_ = Phase::kCompress;
    separating_ = false;
  }
  if (!separating_) return begin();
  const Separation::State state = separation_.pass(phase_ == Phase::kCompress ? kCompressPatience : kExplorePatience);
  if (state == Separation::State::kStuck) fail();
  if (state != Separation::State::kFree) return;
  DoubleLayout better = separation_.free();
  better.length = separation_.shorten(better.poses, better.length);
  keep(std::move(better));
}

void Island::adopt(const DoubleLayout& better) { keep(better); }

void Island::begin() {
  std::vector<Pose> poses;
  if (phase_ == Phase::kCompress) {
    const double over = (progress_ - kExploration) / (1 - kExploration);
    poses = shrunk(kFirstCompression + (kLastCompression - kFirstCompression) * std::clamp(over, 0.0, 1.0));
  } else {
    poses = pool_.empty() ? shrunk(kExploreShrink) : from_pool();
  }
  separation_.begin(poses, target_, best_.length);
  separating_ = true;
}

/// What lies behind a random place moves up by what is cut off.
std::vector<Pose> Island::shrunk(double ratio) {
  const double cut = ratio * best_.length, split = random_.between(0, best_.length);
  std::vector<Pose> poses = best_.poses;
  for (Pose& p : poses) {
    const Variant& v = table_.variants()[p.variant];
    if (p.at.x + 0.5 * (v.low.x + v.high.x) > split) p.at.x -= cut;
  }
  target_ = std::max(best_.length - cut, row_.fixed_end());
  return poses;
}

std::vector<Pose> Island::from_pool() {
  const double place = std::min(random_.half_normal() * 0.25, 0.999);
  std::vector<Pose> poses = pool_[std::size_t(place * double(pool_.size()))].poses;
  swap_two_large(poses);
  return poses;
}

void Island::swap_two_large(std::vector<Pose>& poses) {
  if (large_.size() < 2) return;
  const std::size_t i = large_[random_.below(large_.size())];
  const auto part_of = [&](std::size_t k) { return table_.variants()[poses[k].variant].part; };
  std::size_t j = i;
  for (int tries = 0; tries < 20 && part_of(j) == part_of(i); ++tries) j = large_[random_.below(large_.size())];
  const Pose p = poses[i], q = poses[j];
  const auto middle = [&](const Pose& pose) {
    const Variant& v = table_.variants()[pose.variant];
    return 0.5 * (v.low + v.high);
  };
  poses[i].at = q.at + middle(q) - middle(p);
  poses[j].at = p.at + middle(p) - middle(q);
}

void Island::keep(DoubleLayout better) {
  best_ = std::move(better);
  pool_.clear();
  separating_ = false;
}

void Island::fail() {
  separating_ = false;
  if (phase_ == Phase::kCompress) return;
  const double loss = separation_.least_loss();
  const auto above = [](double least, const Near& near) { return least < near.loss; };
  pool_.insert(std::upper_bound(pool_.begin(), pool_.end(), loss, above), {separation_.nearest(), loss});
  if (pool_.size() > kPool) pool_.pop_back();
}

}  // namespace findspace::packing
