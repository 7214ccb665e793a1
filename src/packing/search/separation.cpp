// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/separation.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

constexpr int kRepairAfter = 20;                  // passes without progress
constexpr double kProgress = 0.98;                // a loss below this times the last counts as progress
constexpr std::uint64_t kWorkOfProgram = 100000;  // pairs that take about as long as a linear program

}  // namespace

Separation::Separation(const FieldTable& table, const Row& row, std::vector<Pose> poses, double length, Random& random)
    : random_(random),
      arrangement_(table, row, std::move(poses), length),
      mover_(arrangement_, random_),
      linear_(table, row) {}

void Separation::begin(const std::vector<Pose>& poses, double length, double most) {
  arrangement_.set_length(length);
  arrangement_.set_poses(poses);
  arrangement_.reset_weights();
  most_ = most;
  idle_ = strikes_ = 0;
  least_loss_ = first_loss_ = repaired_loss_ = std::numeric_limits<double>::infinity();
  nearest_ = arrangement_.poses();
}

Separation::State Separation::pass(const Patience& patience) {
  loss_ = arrangement_.loss();
  if (loss_ <= 0) {
    free_ = {arrangement_.poses(), arrangement_.length()};
    return State::kFree;
  }
  if (loss_ < least_loss_) {
    if (loss_ < kProgress * least_loss_) idle_ = 0;
    least_loss_ = loss_;
    nearest_ = arrangement_.poses();
  }
  if (++idle_ > patience.passes) return strike(patience);
  if (idle_ % kRepairAfter == 0 && repair()) return State::kFree;
  arrangement_.update_weights();
  order_.clear();
  for (std::size_t i = 0; i < arrangement_.size(); ++i)
    if (arrangement_.depth_of(i) > 0) order_.push_back(i);
  for (std::size_t k = order_.size(); k > 1; --k) std::swap(order_[k - 1], order_[random_.below(k)]);
  for (const std::size_t i : order_) mover_.improve(i);
  return State::kUnderWay;
}

Separation::State Separation::strike(const Patience& patience) {
  if (repair()) return State::kFree;
  strikes_ = least_loss_ < kProgress * first_loss_ ? 0 : strikes_ + 1;
  first_loss_ = std::min(first_loss_, least_loss_);
  if (strikes_ >= patience.strikes) return State::kStuck;
  arrangement_.set_poses(nearest_);
  idle_ = 0;
  return State::kUnderWay;
}

/// Any length up to the most will do.
bool Separation::repair() {
  if (least_loss_ >= repaired_loss_) return false;
  repaired_loss_ = least_loss_;
  std::vector<Pose> poses = nearest_;
  const double target = arrangement_.length();
  double length = target;
  const int before = linear_.solved();
  const bool separated = linear_.separate(poses, length, most_);
  if (separated) length = linear_.shorten(poses, length);
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  if (!separated || length > most_ * (1 - margin::kCompactionGain)) return false;
  arrangement_.set_length(length);
  arrangement_.set_poses(poses);
  if (arrangement_.loss() > 0) {
    arrangement_.set_length(target);
    return false;
  }
  free_ = {std::move(poses), length};
  return true;
}

double Separation::shorten(std::vector<Pose>& poses, double length) {
  const int before = linear_.solved();
  const double shorter = linear_.shorten(poses, length);
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  return shorter;
}

}  // namespace findspace::packing
