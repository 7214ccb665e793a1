// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_arrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "exact/margins/packing.h"
#include "packing/search/weights.h"

namespace findspace::packing {
namespace {

constexpr double kMostLacking = 4;  // of the floor: also of parts that no position is near enough for
constexpr int kPlacesOfTie = 8, kHalvings = 24, kGoldenSteps = 48;

/// Where a function with one lowest place between `from` and `to` is lowest, by golden sections.
template <class Function>
double lowest_place(const Function& value, double from, double to) {
  constexpr double kRatio = 1 / std::numbers::phi;
  double left = to - kRatio * (to - from), right = from + kRatio * (to - from);
  double of_left = value(left), of_right = value(right);
  for (int step = 0; step < kGoldenSteps && std::min(of_left, of_right) > 0; ++step) {
    if (of_left <= of_right) {
      to = right;
      right = std::exchange(left, right - kRatio * (right - from));
      of_right = std::exchange(of_left, value(left));
    } else {
      from = left;
      left = std::exchange(right, left + kRatio * (to - left));
      of_left = std::exchange(of_right, value(right));
    }
  }
  return of_left <= of_right ? left : right;
}

}  // namespace

SolidArrangement::SolidArrangement(const SolidTable& table, const SolidColumn& column, std::vector<SolidPose> poses,
                                   double height)
    : table_(table),
      column_(column),
      size_(poses.size()),
      poses_(std::move(poses)),
      height_(height),
      shallow_(table.size() * margin::kNoOverlap),
      slack_(std::max(height, table.size()) * margin::kBoxRounding),
      boxes_(poses_.size() + column.obstacles().size()),
      depths_(poses_.size() + column.obstacles().size()) {
  poses_.insert(poses_.end(), column.obstacles().begin(), column.obstacles().end());
  for (std::size_t i = size_; i < poses_.size(); ++i) move(i, poses_[i]);
  if (table.has_ties()) find_ties();
  find_sizes();
  reset_weights();
  set_length(height);
}

void SolidArrangement::find_ties() {
  for (std::size_t i = 0; i < size(); ++i) {
    std::vector<std::uint32_t>& others = tied_.emplace_back();
    for (std::size_t j = 0; j < poses_.size(); ++j)
      if (j != i && table_.are_tied(poses_[i].variant, poses_[j].variant)) others.push_back(std::uint32_t(j));
  }
}

double SolidArrangement::lacks(std::size_t i, const SolidPose& pose, std::size_t j) const {
  looked_at_ += kWorkOfTie;
  const double slack = table_.slack(poses_[j].variant, pose.variant, pose.at - poses_[j].at);
  return i != j && slack < 0 ? std::min(-slack, kMostLacking * table_.size()) : 0;
}

double SolidArrangement::cost_of_ties(std::size_t i, const SolidPose& pose, double bound) const {
  double sum = 0;
  if (tied_.empty()) return sum;
  const std::vector<double>& weights = weights_of(i);
  for (const std::uint32_t j : tied_[i]) {
    if (sum >= bound) break;
    sum += weights[j] * lacks(i, pose, j);
  }
  return sum;
}

/// Obstacles are as large as the parts in the mean.
void SolidArrangement::find_sizes() {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < size(); ++i) {
    const SolidVariant& v = table_.variants()[poses_[i].variant];
    const Vector sides = v.high - v.low;
    lengths.push_back(std::cbrt(sides.x * sides.y * sides.z));
  }
  sizes_ = root_sizes(std::move(lengths));
  sizes_.resize(poses_.size(), 1);
}

void SolidArrangement::reset_weights() {
  weights_.assign(poses_.size(), {});
  row_ = sizes_;
  row_of_ = size();
  height_weights_.assign(size(), 1);
}

const std::vector<double>& SolidArrangement::weights_of(std::size_t i) const {
  if (row_of_ == i) return row_;
  if (row_of_ < size())
    for (const auto& [j, weight] : weights_[row_of_]) row_[j] = sizes_[j];
  for (const auto& [j, weight] : weights_[i]) row_[j] = weight * sizes_[j];
  row_of_ = i;
  return row_;
}

void SolidArrangement::grow_weight(std::size_t i, std::size_t j, double factor) {
  const auto known = std::find_if(weights_[i].begin(), weights_[i].end(), [&](const auto& e) { return e.first == j; });
  if (known != weights_[i].end())
    known->second *= factor;
  else
    weights_[i].emplace_back(std::uint32_t(j), factor);
}

void SolidArrangement::set_length(double height) {
  height_ = height;
  ranges_.find(table_.variants(), column_.rooms(), height, shallow_);
  set_poses(poses());
}

void SolidArrangement::set_poses(const std::vector<SolidPose>& poses) {
  for (std::size_t i = 0; i < size(); ++i) move(i, {poses[i].variant, inside(poses[i].variant, poses[i].at)});
}

BoxList<3>::Box SolidArrangement::box_at(const SolidPose& pose, double wider) const {
  const SolidVariant& v = table_.variants()[pose.variant];
  const Vector low = pose.at + v.low, high = pose.at + v.high;
  return {{float(low.x - wider), float(low.y - wider), float(low.z - wider)},
          {float(high.x + wider), float(high.y + wider), float(high.z + wider)}};
}

void SolidArrangement::move(std::size_t i, const SolidPose& pose) {
  poses_[i] = pose;
  boxes_.put(i, box_at(pose, slack_));
}

double SolidArrangement::cost(std::size_t i, const SolidPose& pose, double bound) const {
  const std::vector<double>& weights = weights_of(i);
  double sum = ranges_.excess(pose.variant) * height_weights_[i];
  boxes_.for_each_meeting(box_at(pose, table_.gap()), looked_at_, [&](std::size_t j) {
    if (j == i) return true;
    const auto [pair, sign] = table_.link(poses_[j].variant, pose.variant);
    looked_at_ += pair.overlaps.size();
    sum += weights[j] * pair.depth(sign * (pose.at - poses_[j].at), shallow_);
    return sum < bound;
  });
  if (sum < bound) sum += cost_of_ties(i, pose, bound - sum);
  return sum;
}

void SolidArrangement::touches(std::size_t i, const SolidPose& pose, std::vector<Touch>& result) const {
  const double near = table_.size() * margin::kSolidContact;
  const std::vector<double>& weights = weights_of(i);
  result.clear();
  boxes_.for_each_meeting(box_at(pose, table_.gap() + near), looked_at_, [&](std::size_t j) {
    if (j == i) return true;
    const auto [pair, sign] = table_.link(poses_[j].variant, pose.variant);
    const double sense = sign;
    const Vector u = sense * (pose.at - poses_[j].at);
    looked_at_ += pair.overlaps.size();
    for (const ConvexOverlap& overlap : pair.overlaps)
      overlap.for_each_facing(u, near, [&](const Facing& facing) {
        if (facing.value > near) return;
        const double depth = -facing.value;
        result.push_back({depth > shallow_ ? depth * weights[j] : 0, sense * facing.normal});
      });
    return true;
  });
}

space::LineStretch SolidArrangement::within(const SolidPose& pose, const Vector& way) const {
  const SolidVariant& v = table_.variants()[pose.variant];
  const Vector low = pose.at + v.low, high = pose.at + v.high;
  space::LineStretch within_box{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const auto clip = [&](double slope, double before, double behind) {
    if (slope == 0) return;
    const double first = before / slope, second = behind / slope;
    within_box.from = std::max(within_box.from, std::min(first, second));
    within_box.to = std::min(within_box.to, std::max(first, second));
  };
  const Room<Vector>& room = column_.room_at(v, pose.at);
  clip(way.x, room.low.x - low.x, room.high.x - high.x);
  clip(way.y, room.low.y - low.y, room.high.y - high.y);
  clip(way.z, room.low.z - low.z, std::min(room.high.z, height_) - high.z);
  return within_box;
}

void SolidArrangement::collect_stretches(std::size_t i, const SolidPose& pose, const Vector& way,
                                         const space::LineStretch& within_box) const {
  const std::vector<double>& weights = weights_of(i);
  stretches_.clear();
  lowest_.clear();
  const BoxList<3>::Box first = box_at({pose.variant, pose.at + within_box.from * way}, table_.gap()),
                        last = box_at({pose.variant, pose.at + within_box.to * way}, table_.gap());
  BoxList<3>::Box swept;
  for (std::size_t k = 0; k < 3; ++k) {
    swept.low[k] = std::min(first.low[k], last.low[k]);
    swept.high[k] = std::max(first.high[k], last.high[k]);
  }
  boxes_.for_each_meeting(swept, looked_at_, [&](std::size_t j) {
    if (j == i) return true;
    const auto [pair, sign] = table_.link(poses_[j].variant, pose.variant);
    const Vector u = sign * (pose.at - poses_[j].at), along = sign * way;
    looked_at_ += pair.overlaps.size();
    for (const ConvexOverlap& overlap : pair.overlaps) {
      if (way.x == 0 && !(u.x > overlap.low.x && u.x < overlap.high.x)) continue;
      if (way.y == 0 && !(u.y > overlap.low.y && u.y < overlap.high.y)) continue;
      if (way.z == 0 && !(u.z > overlap.low.z && u.z < overlap.high.z)) continue;
      ++looked_at_;
      overlap.for_each_stretch(u, along, 0.5 * shallow_, [&](const space::LineStretch& t) {
        if (!(t.to > within_box.from && t.from < within_box.to)) return;
        stretches_.push_back({t.from, t.to, weights[j], &overlap, u, along});
        if (std::isinf(t.from) && std::isinf(t.to)) lowest_.push_back(overlap.lowest_on(u, along));
      });
    }
    return true;
  });
}

double SolidArrangement::cost_at(double t, double bound) const {
  double sum = 0;
  for (const std::uint32_t k : active_) {
    const Stretch& s = stretches_[k];
    const double depth = -s.overlap->value(s.u + t * s.way);
    if (depth > shallow_) sum += s.weight * depth;
    if (sum >= bound) break;
  }
  looked_at_ += active_.size();
  return sum;
}

/// A line is looked at in some places; between two that differ the end is found by halving. Where a condition holds at
/// none of them it may hold where it lacks least.
void SolidArrangement::add_ends_of_ties(std::size_t i, const SolidPose& pose, const Vector& way, double start,
                                        double end, double sense) const {
  const auto place = [&](int k) { return start + (end - start) * k / kPlacesOfTie; };
  for (const std::uint32_t j : tied_[i]) {
    const auto lacking = [&](double t) { return lacks(i, {pose.variant, pose.at + sense * t * way}, j); };
    double before = lacking(start), least = before;
    int best = 0;
    for (int k = 1; k <= kPlacesOfTie; ++k) {
      double from = place(k - 1), to = place(k);
      events_.push_back({to, kNoStretch, false});
      const double behind = lacking(to);
      if ((behind <= 0) != (before <= 0)) {
        for (int step = 0; step < kHalvings; ++step) {
          const double middle = 0.5 * (from + to);
          ((lacking(middle) <= 0) == (before <= 0) ? from : to) = middle;
        }
        events_.push_back({before <= 0 ? from : to, kNoStretch, false});
      }
      if (behind < least) {
        least = behind;
        best = k;
      }
      before = behind;
    }
    if (least > 0 && least < kMostLacking * table_.size())  // else the same everywhere
      events_.push_back({lowest_place(lacking, place(std::max(best - 1, 0)), place(std::min(best + 1, kPlacesOfTie))),
                         kNoStretch, false});
  }
}

SolidArrangement::LinePlace SolidArrangement::best_on_line(std::size_t i, const SolidPose& pose, const Vector& way,
                                                           double bound, bool from_end) const {
  LinePlace best{0, bound};
  if (ranges_.excess(pose.variant) > 0) return best;
  const space::LineStretch within_box = within(pose, way);
  if (!(within_box.from <= within_box.to)) return best;
  collect_stretches(i, pose, way, within_box);
  const double sense = from_end ? -1 : 1;  // the line is walked from one side
  const double start = from_end ? -within_box.to : within_box.from, end = from_end ? -within_box.from : within_box.to;
  events_.clear();
  active_.clear();
  if (!tied_.empty()) add_ends_of_ties(i, pose, way, start, end, sense);
  for (const double t : lowest_)
    if (sense * t > start) events_.push_back({sense * t, kNoStretch, false});
  for (std::uint32_t k = 0; k < stretches_.size(); ++k) {
    const double from = from_end ? -stretches_[k].to : stretches_[k].from;
    const double to = from_end ? -stretches_[k].from : stretches_[k].to;
    if (from < start)
      active_.push_back(k);
    else
      events_.push_back({from, k, true});
    events_.push_back({to, k, false});
  }
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    return a.t != b.t ? a.t < b.t : a.begins != b.begins ? b.begins : a.stretch < b.stretch;
  });
  const auto look = [&](double t) {
    double cost = cost_at(sense * t, best.cost);
    if (!tied_.empty() && cost < best.cost)
      cost += cost_of_ties(i, {pose.variant, pose.at + sense * t * way}, best.cost - cost);
    if (cost < best.cost) best = {sense * t, cost};
  };
  look(start);
  for (const Event& e : events_) {
    if (best.cost <= 0 || e.t > end) break;
    if (!e.begins && e.stretch != kNoStretch) std::erase(active_, e.stretch);
    look(e.t);
    if (e.begins) active_.push_back(e.stretch);
  }
  if (best.cost > 0) look(end);
  return best;
}

double SolidArrangement::loss() {
  double sum = 0;
  overlaps_.clear();
  for (std::size_t i = 0; i < size(); ++i) sum += depths_[i] = ranges_.excess(poses_[i].variant);
  for (std::size_t i = 0; i < size(); ++i)
    boxes_.for_each_meeting(box_at(poses_[i], table_.gap()), looked_at_, [&](std::size_t j) {
      if (j <= i) return true;
      const auto [pair, sign] = table_.link(poses_[j].variant, poses_[i].variant);
      looked_at_ += pair.overlaps.size();
      const double depth = pair.depth(sign * (poses_[i].at - poses_[j].at), shallow_);
      if (depth <= 0) return true;
      add_overlap(i, j, depth);
      return true;
    });
  for (std::size_t i = 0; i < tied_.size(); ++i)
    for (const std::uint32_t j : tied_[i]) {
      const double lacking = j < i || j >= size() ? lacks(i, poses_[i], j) : 0;
      if (lacking > 0) add_overlap(i, j, lacking);
    }
  for (const Overlap& o : overlaps_) sum += o.depth;
  return sum;
}

void SolidArrangement::add_overlap(std::size_t i, std::size_t j, double depth) {
  depth *= sizes_[i] * sizes_[j];
  overlaps_.push_back({std::uint32_t(i), std::uint32_t(j), depth});
  depths_[i] += depth;
  depths_[j] += depth;
}

void SolidArrangement::update_weights() {
  double deepest = 0;
  for (const Overlap& o : overlaps_) deepest = std::max(deepest, o.depth);
  for (const Overlap& o : overlaps_) {
    grow_weight(o.i, o.j, grown_weight(o.depth / deepest));
    grow_weight(o.j, o.i, grown_weight(o.depth / deepest));
  }
  for (auto& row : weights_) {
    for (auto& [j, weight] : row) weight = decayed_weight(weight, 1);
    std::erase_if(row, [](const auto& entry) { return entry.second <= 1; });
  }
  row_ = sizes_;
  row_of_ = size();
  for (std::size_t i = 0; i < size(); ++i)
    if (ranges_.excess(poses_[i].variant) > 0) height_weights_[i] *= kMostGrowth;
}

}  // namespace findspace::packing
