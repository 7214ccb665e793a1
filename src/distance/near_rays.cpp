// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/near_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "distance/value_rays.h"

namespace findspace::distance {

using space::RayRow;
using space::Vector;

namespace {

/// Searches of a line before the coarser certainty is enough, and at most.
constexpr int kFine = 400, kMost = 6000;
constexpr int kHard = 100;           // searches that one counts for that does not tell
constexpr double kShare = 0x1.8p-1;  // of how near the nearest place is: one that is used to go on from
constexpr double kHardly = 0.75;     // of the blur: that counts as 0
constexpr int kSteps = 64;           // that halve

/// The place at which the function is least on the stretch, or one of a value of at most `enough`.
double lowest(const std::function<AlongPlace(double)>& f, double from, double to, double enough) {
  for (const double end : {from, to}) {
    if (f(end).value <= enough) return end;
  }
  for (int k = 0; k < kSteps; ++k) {
    const double middle = (from + to) / 2;
    const AlongPlace at = f(middle);
    if (at.value <= enough || at.slope == 0 || !(from < middle && middle < to)) return middle;
    (at.slope > 0 ? to : from) = middle;
  }
  return (from + to) / 2;
}

/// From `in`, where the function is at most `most`, towards `out`, as far as it stays so.
double reaches(const std::function<AlongPlace(double)>& f, double in, double out, double most, double blur) {
  if (f(out).value <= most) return out;
  for (int k = 0; k < kSteps && std::fabs(out - in) > blur; ++k) {
    const double middle = (in + out) / 2;
    (f(middle).value <= most ? in : out) = middle;
  }
  return in;
}

}  // namespace

std::vector<std::pair<double, double>> NearRule::known(const NearLine&) const { return {}; }

NearRays::NearRays(std::unique_ptr<const NearRule> rule, const Vector& middle, double size, std::int64_t scale,
                   const space::RayGrid& grid)
    : rule_(std::move(rule)),
      grid_(grid),
      unit_(static_cast<double>(scale) / static_cast<double>(grid.parts)),
      size_(size),
      middle_(middle) {}

struct NearRays::Walk {
  const NearLine& line;
  double size;
  std::vector<SignStretch> known;
  std::vector<std::pair<double, double>> left;
  int searches = 0;
  bool touching = false;  // what was looked at last

  double blur() const { return size * (searches < kFine ? ValueRays::kCertain : ValueRays::kCoarse); }
  void count() {
    if (++searches > kMost)
      throw Error(ErrorCode::kUnsupported, "the signs along a line were not found within the limit of the search");
  }
  void put(double from, double to, int sign) {
    if (from < to || sign == 0) known.push_back({from, to, sign});
  }
  /// The search did not tell: a shorter stretch may be easier.
  void halve(double from, double to) {
    const double middle = (from + to) / 2;
    searches += kHard;
    if (!(from < middle && middle < to)) return put(from, to, 0);
    leave(from, middle), leave(middle, to);
  }
  void leave(double from, double to) {
    if (from < to) left.emplace_back(from, to);
  }
};

/// From the end `from` of a stretch on which the function is less than 0 towards `to`, by the nearest places: the end
/// of what is less than 0, and whether the function is hardly less there.
std::pair<double, bool> NearRays::end(Walk& walk, double from, double to) const {
  while (from != to) {
    walk.count();
    const double blur = walk.blur();
    const auto v = rule_->least(walk.line, from, from, {0, kShare, blur / 8});
    const bool hardly = v.low >= -blur / 2;
    if (!(v.high < 0)) return {from, hardly && v.high <= blur / 2};
    const double next = reaches(v.beyond, from, to, 0, blur / 64);
    const bool still = std::fabs(next - from) <= blur / 4;
    from = next;
    if (still) return {from, hardly};
  }
  return {from, false};
}

/// The function is less than 0 between `near` and `far`, of what is left between `from` and `to`.
void NearRays::grow(Walk& walk, double from, double to, double near, double far) const {
  const auto [first, first_is_end] = end(walk, near, from);
  const auto [last, last_is_end] = end(walk, far, to);
  walk.put(first, last, -1);
  const double pad = walk.blur() / 4;
  const double before = first_is_end ? std::max(from, first - pad) : first,
               behind = last_is_end ? std::min(to, last + pad) : last;
  if (before < first) walk.put(before, first, 0);
  if (last < behind) walk.put(last, behind, 0);
  walk.leave(from, before), walk.leave(behind, to);
}

/// The function is hardly less than 0 on what is left from `from` to `to`, and by a place hardly more on a part of it.
/// Where it is so again and again the line runs along the front: then its middle is looked at, too.
void NearRays::touch(Walk& walk, double from, double to, const NearRule::Least& v) const {
  const double blur = walk.blur(), middle = (from + to) / 2;
  const auto hardly = [&](const NearRule::Least& at, double in) {
    const double most = kHardly * blur, near = reaches(at.beyond, in, from, most, blur / 64),
                 far = reaches(at.beyond, in, to, most, blur / 64);
    walk.put(near, far, 0);
    walk.leave(from, near), walk.leave(far, to);
  };
  if (std::exchange(walk.touching, true)) {
    walk.count();
    const auto there = rule_->least(walk.line, middle, middle, {0, kShare, blur / 4});
    if (there.high <= blur / 2) return hardly(there, middle);
    if (there.low > blur) {
      const double first = std::max(from, middle - there.low), last = std::min(to, middle + there.low);
      walk.put(first, last, 1);
      walk.leave(from, first), walk.leave(last, to);
      return;
    }
  }
  hardly(v, lowest(v.beyond, from, to, blur / 2));
}

void NearRays::look(Walk& walk, double from, double to) const {
  walk.count();
  const double blur = walk.blur();
  auto v = rule_->least(walk.line, from, to, {0, 0, blur / 4});
  if (v.high < 0 && v.high > -blur) v = rule_->least(walk.line, from, to, {0, kShare, blur / 4});
  if (v.low >= -kHardly * blur && v.high <= blur / 2) return touch(walk, from, to, v);
  walk.touching = false;
  if (v.low > 0) return walk.put(from, to, 1);
  if (v.high > -blur / 64) return walk.halve(from, to);
  const double in = lowest(v.beyond, from, to, v.high / 2);
  grow(walk, from, to, reaches(v.beyond, in, from, 0, blur / 64), reaches(v.beyond, in, to, 0, blur / 64));
}

std::vector<SignStretch> NearRays::stretches(const NearLine& line) const {
  Walk walk{line, size_, {}, {}};
  const double place = space::dot(middle_ - line.start, line.unit);
  double from = place - 2 * size_;
  const double to = place + 2 * size_;
  // Where what is known ends, more may be less than 0.
  for (const auto& [near, far] : rule_->known(line)) {
    if (!(from < far) || !(near < to)) continue;
    const double first = std::max(from, near), last = std::min(to, far);
    walk.leave(from, first);
    walk.put(first, last, -1);
    from = last;
  }
  walk.leave(from, to);
  while (!walk.left.empty()) {
    const auto [low, high] = walk.left.back();
    walk.left.pop_back();
    look(walk, low, high);
  }
  std::sort(walk.known.begin(), walk.known.end(),
            [](const SignStretch& a, const SignStretch& b) { return a.from < b.from; });
  return std::move(walk.known);
}

RayRow NearRays::row(int j) const {
  RayRow out;
  for (int i = 0; i < grid_.nu; ++i) {
    const PositionLine line = position_line(grid_, unit_, i, j);
    put_line(stretches({space::rounded(line.start), space::rounded(line.unit)}), unit_, out);
  }
  return out;
}

}  // namespace findspace::distance
