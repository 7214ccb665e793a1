// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_first_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/margins/packing.h"
#include "packing/search/box_list.h"
#include "packing/search/random.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kCornersTried = 24, kRandomTried = 8;
constexpr std::size_t kCornersOfAll = 20000;  // fewer of each where parts are many
constexpr int kMostFalls = 6;
constexpr std::size_t kMostForms = 4;
constexpr double kBoxRoom = 64;                     // for containers as many times as high as the floor is wide
constexpr std::uint64_t kWorkOfFirst = 20'000'000;  // boxes and planes: some tenths of a second
constexpr std::size_t kMostOrders = 32;

/// What parts are sorted by: their boxes' volumes, heights, bases, longest sides; then these volumes times random
/// factors.
std::vector<double> keys_of(const SolidTable& table, std::size_t parts, std::size_t number, Random& random) {
  std::vector<double> keys;
  for (std::size_t part = 0; part < parts; ++part) {
    if (table.variants_of(part).empty()) {
      keys.push_back(0);
      continue;
    }
    const SolidVariant& v = table.variants()[table.variants_of(part)[0]];
    const Vector s = v.high - v.low;
    const double volume = s.x * s.y * s.z;
    keys.push_back(number == 0   ? volume
                   : number == 1 ? s.z
                   : number == 2 ? s.x * s.y
                   : number == 3 ? std::max({s.x, s.y, s.z})
                                 : volume * random.between(0.3, 1));
  }
  return keys;
}

class SolidBuilder {
 public:
  SolidBuilder(const SolidProblem& problem, const SolidTable& table, Random& random)
      : problem_(problem),
        table_(table),
        random_(random),
        shallow_(table.size() * margin::kNoOverlap),
        boxes_(problem.items()),
        corners_(std::clamp<std::size_t>(kCornersOfAll / std::max<std::size_t>(problem.items(), 1), 2, kCornersTried)) {
  }

  /// Those of the greatest keys first.
  LayoutInDoubles<SolidPose> build(const std::vector<double>& keys) {
    std::vector<std::size_t> order(problem_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return keys[p] > keys[q]; });
    for (const std::size_t part : order)
      for (int copy = 0; copy < problem_.parts[part].demand; ++copy) place(part);
    return std::move(result_);
  }
  std::uint64_t work() const { return work_; }

 private:
  /// In the form in which it comes to stand lowest; some of them where there are many.
  void place(std::size_t part) {
    std::vector<std::size_t> variants = table_.variants_of(part);
    for (std::size_t k = variants.size(); k > 1; --k) std::swap(variants[k - 1], variants[random_.below(k)]);
    variants.resize(std::min(variants.size(), kMostForms));
    SolidPose best;
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::size_t variant : variants) try_form(variant, best, lowest);
    boxes_.put(result_.poses.size(), box_at(best.variant, best.at, shallow_));
    result_.poses.push_back(best);
    result_.length = std::max(result_.length, lowest);
  }

  void try_form(std::size_t variant, SolidPose& best, double& lowest) {
    const SolidVariant& v = table_.variants()[variant];
    const double top = result_.length;  // there it is free
    const auto attempt = [&](double x, double y) {
      const Vector start{std::clamp(x, -v.low.x, table_.width() - v.high.x),
                         std::clamp(y, -v.low.y, table_.depth() - v.high.y), top + table_.gap() - v.low.z};
      const Vector at = settled(variant, start);
      if (at.z + v.high.z < lowest || (at.z + v.high.z == lowest && at.x + at.y < best.at.x + best.at.y)) {
        lowest = at.z + v.high.z;
        best = {variant, at};
      }
    };
    attempt(-v.low.x, -v.low.y);
    attempt(table_.width(), -v.low.y);
    attempt(-v.low.x, table_.depth());
    attempt(table_.width(), table_.depth());
    const std::size_t placed = result_.poses.size();
    for (std::size_t k = 0; k < std::min(placed, corners_); ++k) {
      // Behind or beside the box of what stands.
      const SolidPose& other = result_.poses[placed <= corners_ ? k : random_.below(placed)];
      const SolidVariant& w = table_.variants()[other.variant];
      attempt(other.at.x + w.high.x - v.low.x, other.at.y + w.low.y - v.low.y);
      attempt(other.at.x + w.low.x - v.low.x, other.at.y + w.high.y - v.low.y);
    }
    for (std::size_t k = 0; k < kRandomTried; ++k) {
      const double x = random_.between(-v.low.x, table_.width() - v.high.x);
      attempt(x, random_.between(-v.low.y, table_.depth() - v.high.y));
    }
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

  BoxList<3>::Box box_at(std::size_t variant, const Vector& at, double wider) const {
    const SolidVariant& v = table_.variants()[variant];
    const double w = wider + table_.size() * margin::kBoxRounding * kBoxRoom;
    const Vector low = at + v.low, high = at + v.high;
    return {{float(low.x - w), float(low.y - w), float(low.z - w)},
            {float(high.x + w), float(high.y + w), float(high.z + w)}};
  }

  /// How far it can go from a free place.
  double free_way(std::size_t variant, const Vector& at, const Vector& way, double most) const {
    const BoxList<3>::Box here = box_at(variant, at, table_.gap()),
                          there = box_at(variant, at + most * way, table_.gap());
    BoxList<3>::Box swept;
    for (std::size_t k = 0; k < 3; ++k) {
      swept.low[k] = std::min(here.low[k], there.low[k]);
      swept.high[k] = std::max(here.high[k], there.high[k]);
    }
    boxes_.for_each_meeting(swept, work_, [&](std::size_t j) {
      const SolidPose& other = result_.poses[j];
      const auto [pair, sign] = table_.link(other.variant, variant);
      const Vector u = sign * (at - other.at), along = sign * way;
      for (const ConvexOverlap& overlap : pair.overlaps) {
        const Vector low = overlap.low, high = overlap.high;
        ++work_;
        if (way.x == 0 && !(u.x > low.x && u.x < high.x)) continue;
        if (way.y == 0 && !(u.y > low.y && u.y < high.y)) continue;
        if (way.z == 0 && !(u.z > low.z && u.z < high.z)) continue;
        const space::LineStretch t = overlap.stretch(u, along, 0.5 * shallow_);
        if (t.from < t.to && t.to > shallow_ && t.from < most) most = std::max(t.from, 0.0);
      }
      return true;
    });
    return std::max(most, 0.0);
  }

  const SolidProblem& problem_;
  const SolidTable& table_;
  Random& random_;
  double shallow_;
  mutable std::uint64_t work_ = 0;
  BoxList<3> boxes_;
  std::size_t corners_;
  LayoutInDoubles<SolidPose> result_;
};

}  // namespace

LayoutInDoubles<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table, std::uint64_t seed) {
  Random random(seed);
  LayoutInDoubles<SolidPose> best;
  std::uint64_t work = 0;
  for (std::size_t number = 0; number == 0 || (number < kMostOrders && work < kWorkOfFirst); ++number) {
    SolidBuilder builder(problem, table, random);
    LayoutInDoubles<SolidPose> layout = builder.build(keys_of(table, problem.parts.size(), number, random));
    work += builder.work();
    if (number == 0 || layout.length < best.length) best = std::move(layout);
  }
  return best;
}

}  // namespace findspace::packing
