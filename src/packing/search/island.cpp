// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/island.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/number/search_margins.h"

namespace findspace::packing {
namespace {

constexpr double kExploreShrink = 0.001;
constexpr double kFirstCompression = 0.0005, kLastCompression = 0.00001;
constexpr int kRepairAfter = 20;      // passes without progress
constexpr double kExploration = 0.8;  // of the whole search
constexpr double kProgress = 0.98;    // a loss below this times the last counts as progress
constexpr std::size_t kPool = 12;
constexpr std::uint64_t kWorkOfProgram = 100000;  // pairs that take about as long as a linear program

/// Passes without progress, and how often the best is tried again.
struct Patience {
  int passes, strikes;
};
constexpr Patience kExplorePatience{120, 3}, kCompressPatience{80, 3};

double box_area(const Variant& v) { return (v.high.x - v.low.x) * (v.high.y - v.low.y); }

}  // namespace

Island::Island(const FieldTable& table, DoubleLayout start, std::uint64_t seed)
    : table_(table),
      random_(seed),
      arrangement_(table, start.poses, start.length),
      mover_(arrangement_, random_),
      linear_(table),
      best_(std::move(start)) {
  for (std::size_t i = 0; i < arrangement_.size(); ++i) large_.push_back(i);
  const auto larger = [&](std::size_t i, std::size_t j) {
    return box_area(table_.variants()[best_.poses[i].variant]) > box_area(table_.variants()[best_.poses[j].variant]);
  };
  std::stable_sort(large_.begin(), large_.end(), larger);
  large_.resize(std::max<std::size_t>(std::min<std::size_t>(large_.size(), 2), large_.size() * 2 / 3));
  best_.length = linear_.shorten(best_.poses, best_.length);
}

void Island::step(double progress) {
  progress_ = progress;
  if (phase_ == Phase::kExplore && progress >= kExploration) {
    phase_ = Phase::kCompress;
    separating_ = false;
  }
  if (separating_)
    pass();
  else
    begin();
}

void Island::adopt(const DoubleLayout& better) { keep(better); }

void Island::begin() {
  if (phase_ == Phase::kCompress) {
    const double over = (progress_ - kExploration) / (1 - kExploration);
    shrink(kFirstCompression + (kLastCompression - kFirstCompression) * std::clamp(over, 0.0, 1.0));
  } else if (pool_.empty()) {
    shrink(kExploreShrink);
  } else {
    restart_from_pool();
  }
  arrangement_.reset_weights();
  separating_ = true;
  idle_ = strikes_ = 0;
  least_loss_ = first_loss_ = repaired_loss_ = std::numeric_limits<double>::infinity();
  incumbent_ = arrangement_.poses();
}

/// What lies behind a random place moves up by what is cut off.
void Island::shrink(double ratio) {
  const double cut = ratio * best_.length, split = random_.between(0, best_.length);
  std::vector<Pose> poses = best_.poses;
  for (Pose& p : poses) {
    const Variant& v = table_.variants()[p.variant];
    if (p.at.x + 0.5 * (v.low.x + v.high.x) > split) p.at.x -= cut;
  }
  arrangement_.set_length(best_.length - cut);
  arrangement_.set_poses(poses);
}

void Island::restart_from_pool() {
  const double place = std::min(random_.half_normal() * 0.25, 0.999);
  arrangement_.set_poses(pool_[std::size_t(place * double(pool_.size()))].poses);
  swap_two_large();
}

void Island::swap_two_large() {
  if (large_.size() < 2) return;
  const std::size_t i = large_[random_.below(large_.size())];
  const auto part_of = [&](std::size_t k) { return table_.variants()[arrangement_.pose(k).variant].part; };
  std::size_t j = i;
  for (int tries = 0; tries < 20 && part_of(j) == part_of(i); ++tries) j = large_[random_.below(large_.size())];
  const Pose p = arrangement_.pose(i), q = arrangement_.pose(j);
  const auto middle = [&](const Pose& pose) {
    const Variant& v = table_.variants()[pose.variant];
    return 0.5 * (v.low + v.high);
  };
  const Vec to_q = q.at + middle(q) - middle(p), to_p = p.at + middle(p) - middle(q);
  arrangement_.move(i, {p.variant, arrangement_.inside(p.variant, to_q)});
  arrangement_.move(j, {q.variant, arrangement_.inside(q.variant, to_p)});
}

void Island::pass() {
  loss_ = arrangement_.loss();
  if (loss_ <= 0) return succeed(arrangement_.poses());
  if (loss_ < least_loss_) {
    if (loss_ < kProgress * least_loss_) idle_ = 0;
    least_loss_ = loss_;
    incumbent_ = arrangement_.poses();
  }
  const Patience patience = phase_ == Phase::kExplore ? kExplorePatience : kCompressPatience;
  if (++idle_ > patience.passes) return strike();
  if (idle_ % kRepairAfter == 0 && repair()) return;
  arrangement_.update_weights();
  order_.clear();
  for (std::size_t i = 0; i < arrangement_.size(); ++i)
    if (arrangement_.depth_of(i) > 0) order_.push_back(i);
  for (std::size_t k = order_.size(); k > 1; --k) std::swap(order_[k - 1], order_[random_.below(k)]);
  for (const std::size_t i : order_) mover_.improve(i);
}

void Island::strike() {
  if (repair()) return;
  const Patience patience = phase_ == Phase::kExplore ? kExplorePatience : kCompressPatience;
  strikes_ = least_loss_ < kProgress * first_loss_ ? 0 : strikes_ + 1;
  first_loss_ = std::min(first_loss_, least_loss_);
  if (strikes_ >= patience.strikes) return fail();
  arrangement_.set_poses(incumbent_);
  idle_ = 0;
}

/// Any length below the best will do.
bool Island::repair() {
  if (least_loss_ >= repaired_loss_) return false;
  repaired_loss_ = least_loss_;
  std::vector<Pose> poses = incumbent_;
  const double target = arrangement_.length();
  double length = target;
  const int before = linear_.solved();
  const bool separated = linear_.separate(poses, length, best_.length);
  if (separated) length = linear_.shorten(poses, length);
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  if (!separated || length > best_.length * (1 - margin::kCompactionGain)) return false;
  arrangement_.set_length(length);
  arrangement_.set_poses(poses);
  if (arrangement_.loss() > 0) {
    arrangement_.set_length(target);
    return false;
  }
  keep({std::move(poses), length});
  return true;
}

void Island::succeed(std::vector<Pose> poses) {
  const int before = linear_.solved();
  const double length = linear_.shorten(poses, arrangement_.length());
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  keep({std::move(poses), length});
}

void Island::keep(DoubleLayout better) {
  best_ = std::move(better);
  pool_.clear();
  separating_ = false;
  failures_ = 0;
}

void Island::fail() {
  separating_ = false;
  ++failures_;
  if (phase_ == Phase::kCompress) return;
  const auto above = [](double loss, const Near& near) { return loss < near.loss; };
  pool_.insert(std::upper_bound(pool_.begin(), pool_.end(), least_loss_, above), {incumbent_, least_loss_});
  if (pool_.size() > kPool) pool_.pop_back();
}

}  // namespace findspace::packing
