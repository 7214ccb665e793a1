// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

constexpr double kLeastGrowth = 1.2, kMostGrowth = 2.0, kDecay = 0.95;

}  // namespace

Arrangement::Arrangement(const FieldTable& table, std::vector<Pose> poses, double length)
    : table_(&table), poses_(std::move(poses)), length_(length), shallow_(table.height() * margin::kNoOverlap) {
  const std::size_t n = poses_.size();
  for (auto* side : {&low_x_, &low_y_, &high_x_, &high_y_}) side->resize(n);
  depths_.resize(n);
  near_.resize(n + 1);
  looks_.resize(n);
  reset_weights();
  set_length(length);
}

void Arrangement::reset_weights() {
  weights_.assign(size() * size(), 1);
  strip_weights_.assign(size(), 1);
}

Vec Arrangement::least_position(std::size_t variant) const {
  const Variant& v = table_->variants()[variant];
  return {-v.low.x, -v.low.y};
}

Vec Arrangement::greatest_position(std::size_t variant) const {
  const Variant& v = table_->variants()[variant];
  return {length_ - v.high.x, table_->height() - v.high.y};
}

Vec Arrangement::inside(std::size_t variant, Vec at) const {
  const Vec least = least_position(variant), most = greatest_position(variant);
  return {std::max(least.x, std::min(at.x, most.x)), std::max(least.y, std::min(at.y, most.y))};
}

double Arrangement::excess(std::size_t variant) const {
  return std::max(0.0, least_position(variant).x - greatest_position(variant).x);
}

void Arrangement::set_length(double length) {
  length_ = length;
  set_poses(std::vector<Pose>(poses_));
}

void Arrangement::set_poses(const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < size(); ++i) move(i, {poses[i].variant, inside(poses[i].variant, poses[i].at)});
}

void Arrangement::move(std::size_t i, const Pose& pose) {
  const Variant& v = table_->variants()[pose.variant];
  poses_[i] = pose;
  low_x_[i] = pose.at.x + v.low.x;
  low_y_[i] = pose.at.y + v.low.y;
  high_x_[i] = pose.at.x + v.high.x;
  high_y_[i] = pose.at.y + v.high.y;
}

std::span<const std::uint32_t> Arrangement::near(std::size_t i, const Pose& pose) const {
  const Variant& v = table_->variants()[pose.variant];
  const double gap = 1.01 * table_->gap();  // a grown polygon is a little larger than the gap
  const double low_x = pose.at.x + v.low.x - gap, low_y = pose.at.y + v.low.y - gap,
               high_x = pose.at.x + v.high.x + gap, high_y = pose.at.y + v.high.y + gap;
  std::size_t count = 0;
  for (std::size_t j = 0; j < size(); ++j) {
    near_[count] = std::uint32_t(j);
    // All at once: which one fails cannot be foreseen.
    count += std::size_t(int(low_x < high_x_[j]) & int(low_x_[j] < high_x) & int(low_y < high_y_[j]) &
                         int(low_y_[j] < high_y) & int(j != i));
  }
  looked_at_ += size();
  return {near_.data(), count};
}

double Arrangement::cost(std::size_t i, const Pose& pose, double bound) const {
  const std::span<const std::uint32_t> others = near(i, pose);
  const double* weights = &weights_[i * size()];
  const double out = excess(pose.variant);
  double sum = out > 0 ? out * strip_weights_[i] : 0;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Pose& other = poses_[others[k]];
    const bool first = other.variant <= pose.variant;
    Look& look = looks_[k];
    look.field = first ? &table_->field(other.variant, pose.variant) : &table_->field(pose.variant, other.variant);
    look.at = first ? pose.at - other.at : other.at - pose.at;
    look.least = weights[others[k]] * look.field->least(look.at);
    sum += look.least;
  }
  for (std::size_t k = 0; k < others.size(); ++k) {
    if (sum >= bound) return std::numeric_limits<double>::infinity();
    const double depth = looks_[k].field->depth(looks_[k].at);
    sum += (depth > shallow_ ? weights[others[k]] * depth : 0) - looks_[k].least;
  }
  return sum;
}

Arrangement::Exit Arrangement::exit(const Pose& pose, std::size_t j) const {
  const Pose& other = poses_[j];
  const bool first = other.variant <= pose.variant;
  const DepthField& field =
      first ? table_->field(other.variant, pose.variant) : table_->field(pose.variant, other.variant);
  const Vec t = first ? pose.at - other.at : other.at - pose.at;
  const Nearest nearest = field.nearest(t);
  if (nearest.depth <= shallow_) return {};
  const NoFitEdge& edge = field.polygon().edges[std::size_t(nearest.edge)];
  const Vec move = first ? nearest.foot - t : t - nearest.foot;
  return {nearest.depth, move, edge.to - edge.from};
}

double Arrangement::loss() {
  double sum = 0;
  overlaps_.clear();
  std::fill(depths_.begin(), depths_.end(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const double out = excess(poses_[i].variant);
    depths_[i] += out;
    sum += out;
    for (const std::uint32_t j : near(i, poses_[i])) {
      if (j < i) continue;
      const double depth = table_->depth(poses_[i], poses_[j]);
      if (depth <= shallow_) continue;
      overlaps_.push_back({std::uint32_t(i), j, depth});
      depths_[i] += depth;
      depths_[j] += depth;
      sum += depth;
    }
  }
  return sum;
}

void Arrangement::update_weights() {
  double deepest = 0;
  for (const Overlap& o : overlaps_) deepest = std::max(deepest, o.depth);
  for (const Overlap& o : overlaps_) {
    const double growth = kLeastGrowth + (kMostGrowth - kLeastGrowth) * o.depth / deepest;
    const double weight = weights_[o.i * size() + o.j] * growth / kDecay;
    weights_[o.i * size() + o.j] = weight;
    weights_[o.j * size() + o.i] = weight;
  }
  for (double& w : weights_) w = std::max(1.0, w * kDecay);
  for (std::size_t i = 0; i < size(); ++i)
    if (excess(poses_[i].variant) > 0) strip_weights_[i] *= kMostGrowth;
}

}  // namespace findspace::packing
