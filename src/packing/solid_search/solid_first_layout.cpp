// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_first_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/margins/packing.h"
#include "packing/search/random.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kCornersTried = 24, kRandomTried = 8;
constexpr int kMostFalls = 6;

class SolidBuilder {
 public:
  SolidBuilder(const SolidProblem& problem, const SolidTable& table, std::uint64_t seed)
      : problem_(problem), table_(table), random_(seed), shallow_(table.size() * margin::kNoOverlap) {}

  LayoutInDoubles<SolidPose> build() {
    std::vector<std::size_t> order(problem_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> volumes;
    for (const SolidVariant& v : table_.variants())
      volumes.push_back((v.high.x - v.low.x) * (v.high.y - v.low.y) * (v.high.z - v.low.z));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return volumes[p] > volumes[q]; });
    for (const std::size_t part : order)
      for (int copy = 0; copy < problem_.parts[part].demand; ++copy) place(part);
    return std::move(result_);
  }

 private:
  void place(std::size_t variant) {
    const SolidVariant& v = table_.variants()[variant];
    const double top = result_.length;  // there it is free
    Vector best;
    double lowest = std::numeric_limits<double>::infinity();
    const auto attempt = [&](double x, double y) {
      const Vector start{std::clamp(x, -v.low.x, table_.width() - v.high.x),
                         std::clamp(y, -v.low.y, table_.depth() - v.high.y), top + table_.gap() - v.low.z};
      const Vector at = settled(variant, start);
      if (at.z + v.high.z < lowest || (at.z + v.high.z == lowest && at.x + at.y < best.x + best.y)) {
        lowest = at.z + v.high.z;
        best = at;
      }
    };
    attempt(-v.low.x, -v.low.y);
    attempt(table_.width(), -v.low.y);
    attempt(-v.low.x, table_.depth());
    attempt(table_.width(), table_.depth());
    const std::size_t placed = result_.poses.size();
    for (std::size_t k = 0; k < std::min(placed, kCornersTried); ++k) {
      // Behind or beside the box of what stands.
      const SolidPose& other = result_.poses[placed <= kCornersTried ? k : random_.below(placed)];
      const SolidVariant& w = table_.variants()[other.variant];
      attempt(other.at.x + w.high.x - v.low.x, other.at.y + w.low.y - v.low.y);
      attempt(other.at.x + w.low.x - v.low.x, other.at.y + w.high.y - v.low.y);
    }
    for (std::size_t k = 0; k < kRandomTried; ++k) {
      const double x = random_.between(-v.low.x, table_.width() - v.high.x);
      attempt(x, random_.between(-v.low.y, table_.depth() - v.high.y));
    }
    result_.poses.push_back({variant, best});
    result_.length = std::max(result_.length, lowest);
  }

  /// It falls, then slides back and left, as long as that lets it fall again.
  Vector settled(std::size_t variant, Vector at) const {
    const SolidVariant& v = table_.variants()[variant];
    at = at - Vector{0, 0, free_way(variant, at, {0, 0, -1}, at.z + v.low.z)};
    for (int k = 0; k < kMostFalls; ++k) {
      at = at - Vector{0, free_way(variant, at, {0, -1, 0}, at.y + v.low.y), 0};
      at = at - Vector{free_way(variant, at, {-1, 0, 0}, at.x + v.low.x), 0, 0};
      const double fall = free_way(variant, at, {0, 0, -1}, at.z + v.low.z);
      if (fall <= table_.size() * margin::kSolidContact) break;
      at = at - Vector{0, 0, fall};
    }
    return at;
  }

  /// How far it can go from a free place.
  double free_way(std::size_t variant, const Vector& at, const Vector& way, double most) const {
    for (const SolidPose& other : result_.poses) {
      const auto [pair, sign] = table_.link(other.variant, variant);
      const Vector u = sign * (at - other.at), along = sign * way;
      for (const ConvexOverlap& overlap : pair.overlaps) {
        const Vector low = overlap.low, high = overlap.high;
        if (way.x == 0 && !(u.x > low.x && u.x < high.x)) continue;
        if (way.y == 0 && !(u.y > low.y && u.y < high.y)) continue;
        if (way.z == 0 && !(u.z > low.z && u.z < high.z)) continue;
        const space::LineStretch t = overlap.stretch(u, along, 0.5 * shallow_);
        if (t.from < t.to && t.to > shallow_ && t.from < most) most = std::max(t.from, 0.0);
      }
    }
    return std::max(most, 0.0);
  }

  const SolidProblem& problem_;
  const SolidTable& table_;
  Random random_;
  double shallow_;
  LayoutInDoubles<SolidPose> result_;
};

}  // namespace

LayoutInDoubles<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table, std::uint64_t seed) {
  return SolidBuilder(problem, table, seed).build();
}

}  // namespace findspace::packing
