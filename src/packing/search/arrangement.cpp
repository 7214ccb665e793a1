// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/packing.h"
#include "packing/search/weights.h"

namespace findspace::packing {
Arrangement::Arrangement(const FieldTable& table, const Row& row, std::vector<Pose> poses, double length)
    : table_(&table),
      row_(&row),
      size_(poses.size()),
      poses_(std::move(poses)),
      length_(length),
      shallow_(table.height() * margin::kNoOverlap),
      slack_(std::max(length, table.height()) * margin::kBoxRounding),
      boxes_(poses_.size() + row.obstacles().size()) {
  poses_.insert(poses_.end(), row.obstacles().begin(), row.obstacles().end());
  const std::size_t n = poses_.size();
  for (std::size_t i = size_; i < n; ++i) move(i, poses_[i]);
  depths_.resize(n);
  near_.resize(n + 1);
  looks_.resize(n);
  if (table.has_ties()) find_ties();
  find_sizes();
  reset_weights();
  set_length(length);
}

void Arrangement::find_ties() {
  for (std::size_t i = 0; i < size_; ++i) {
    std::vector<std::uint32_t>& others = tied_.emplace_back();
    for (std::size_t j = 0; j < poses_.size(); ++j)
      if (j != i && table_->are_tied(poses_[i].variant, poses_[j].variant)) others.push_back(std::uint32_t(j));
  }
}

/// Obstacles are as large as the parts in the mean.
void Arrangement::find_sizes() {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < size_; ++i) {
    const Variant& v = table_->variants()[poses_[i].variant];
    lengths.push_back(std::sqrt((v.high.x - v.low.x) * (v.high.y - v.low.y)));
  }
  sizes_ = root_sizes(std::move(lengths));
  sizes_.resize(poses_.size(), 1);
}

void Arrangement::reset_weights() {
  weights_.clear();
  for (std::size_t i = 0; i < poses_.size(); ++i)
    for (std::size_t j = 0; j < poses_.size(); ++j) weights_.push_back(least_weight(i, j));
  strip_weights_.assign(size(), 1);
}

void Arrangement::set_length(double length) {
  length_ = length;
  ranges_.find(table_->variants(), row_->rooms(), length, shallow_);
  set_poses(poses());
}

void Arrangement::set_poses(const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < size(); ++i) move(i, {poses[i].variant, inside(poses[i].variant, poses[i].at)});
}

void Arrangement::move(std::size_t i, const Pose& pose) {
  const Variant& v = table_->variants()[pose.variant];
  poses_[i] = pose;
  boxes_.put(i, {{float(pose.at.x + v.low.x - slack_), float(pose.at.y + v.low.y - slack_)},
                 {float(pose.at.x + v.high.x + slack_), float(pose.at.y + v.high.y + slack_)}});
}

template <class Meet>
void Arrangement::for_each_near(std::size_t i, const Pose& pose, const Meet& meet) const {
  const Variant& v = table_->variants()[pose.variant];
  const double gap = 1.01 * table_->gap();  // a grown polygon is a little larger than the gap
  const BoxList<2>::Box box{{float(pose.at.x + v.low.x - gap), float(pose.at.y + v.low.y - gap)},
                            {float(pose.at.x + v.high.x + gap), float(pose.at.y + v.high.y + gap)}};
  if (!boxes_.for_each_meeting(box, looked_at_, [&](std::size_t j) { return j == i || meet(j); })) return;
  if (tied_.empty()) return;
  for (const std::uint32_t j : tied_[i])
    if (!boxes_.meets(j, box) && !meet(j)) return;
}

std::span<const std::uint32_t> Arrangement::near(std::size_t i, const Pose& pose) const {
  std::size_t count = 0;
  for_each_near(i, pose, [&](std::size_t j) {
    near_[count++] = std::uint32_t(j);
    return true;
  });
  return {near_.data(), count};
}

double Arrangement::cost(std::size_t i, const Pose& pose, double bound) const {
  const double* weights = &weights_[i * poses_.size()];
  const double out = ranges_.excess(pose.variant);
  double sum = out > 0 ? out * strip_weights_[i] : 0;
  std::size_t count = 0;
  for_each_near(
      i, pose, [&](std::size_t j) __attribute__((always_inline)) {
        const Pose& other = poses_[j];
        const FieldTable::Link& link = table_->link(pose.variant, other.variant);
        const DepthGlance& glance = link.glance();
        const Vec at = other.at - pose.at;
        const int cell = glance.cell_at(at);
        if (cell == DepthGlance::kNone) return true;
        glance.expect(cell);
        looks_[count] = {&link, at, cell, weights[j] * glance.least(cell), weights[j]};
        sum += looks_[count++].least;
        return sum < bound;
      });
  for (std::size_t k = 0; k < count; ++k) {
    if (sum >= bound) return std::numeric_limits<double>::infinity();
    const Look& look = looks_[k];
    const double depth = look.link->field().depth(look.cell, look.link->in_field(look.at));
    sum += (depth > shallow_ ? look.weight * depth : 0) - look.least;
  }
  return sum;
}

Arrangement::Exit Arrangement::exit(const Pose& pose, std::size_t j) const {
  const Pose& other = poses_[j];
  const FieldTable::Link& link = table_->link(other.variant, pose.variant);
  const Vec t = link.in_field(pose.at - other.at);
  const Nearest nearest = link.field().nearest(t);
  if (nearest.depth <= shallow_) return {};
  const NoFitEdge& edge = link.field().polygon().edges[std::size_t(nearest.edge)];
  return {nearest.depth, link.rotated(nearest.projection - t), link.rotated(edge.to - edge.from)};
}

double Arrangement::loss() {
  double sum = 0;
  overlaps_.clear();
  std::fill(depths_.begin(), depths_.end(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const double out = ranges_.excess(poses_[i].variant);
    depths_[i] += out;
    sum += out;
    for (const std::uint32_t j : near(i, poses_[i])) {
      if (j < i) continue;
      const double measured = table_->depth(poses_[i], poses_[j]);
      if (measured <= shallow_) continue;
      const double depth = measured * least_weight(i, j);
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
    const double weight = weights_[o.i * poses_.size() + o.j] * grown_weight(o.depth / deepest);
    weights_[o.i * poses_.size() + o.j] = weight;
    weights_[o.j * poses_.size() + o.i] = weight;
  }
  for (std::size_t i = 0, k = 0; i < poses_.size(); ++i)
    for (std::size_t j = 0; j < poses_.size(); ++j, ++k) weights_[k] = decayed_weight(weights_[k], least_weight(i, j));
  for (std::size_t i = 0; i < size(); ++i)
    if (ranges_.excess(poses_[i].variant) > 0) strip_weights_[i] *= kMostGrowth;
}

}  // namespace findspace::packing
