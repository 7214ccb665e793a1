// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/near_rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "distance/rays/value_rays.h"
#include "distance/search/strict_work.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using space::RayRow;
using space::Vector;

namespace {

/// Searches of a line before the coarser certainty is enough, and at most.
constexpr int kFineSearches = 400, kMostSearches = 6000;
/// Where work is shared: how near ends are told first, of the sizes, and how much nearer each time after that.
constexpr double kRoughly = 0x1p-3, kFiner = 4;  // no sign: less is left to be told
constexpr int kHard = 100;                       // searches that one counts for that does not tell
constexpr double kHardly = 0.75;                 // of the blur: that counts as 0
constexpr int kSteps = 64;                       // that halve

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

/// Along one line.
class Walk {
 public:
  Walk(const NearRule& rule, const NearLine& line, double size)
      : rule_(rule), line_(line), size_(size), certain_(strictly_limited() ? kRoughly : ValueRays::kCertain) {}

  exact::Tried<std::vector<SignStretch>> run(double from, double to) {
    const exact::Tried<NearRule::Known> known = rule_.known(line_);
    if (!known) return known.refusal();
    // Where what is known ends, more may be less than 0.
    for (const auto& [near, far] : *known) {
      if (!(from < far) || !(near < to)) continue;
      const double first = std::max(from, near), last = std::min(to, far);
      leave(from, first);
      put(first, last, -1);
      from = last;
    }
    leave(from, to);
    look_at_left();
    while (certain_ > ValueRays::kCertain && !refused_) again(std::max(ValueRays::kCertain, certain_ / kFiner));
    if (refused_ && !(strictly_limited() && spent_ && told())) return *refused_;
    for (const auto& [low, high] : left_) put(low, high, 0);
    std::sort(known_.begin(), known_.end(), [](const SignStretch& a, const SignStretch& b) { return a.from < b.from; });
    return std::move(known_);
  }

 private:
  double blur() const {
    return size_ * std::max(certain_, searches_ < kFineSearches ? ValueRays::kCertain : ValueRays::kCoarse);
  }

  void look_at_left() {
    while (!left_.empty() && !refused_) {
      const auto [low, high] = left_.back();
      left_.pop_back();
      look(low, high);
    }
  }

  /// What is not told is looked at again, with the work that is left. So where work is shared, all of a line is told
  /// roughly before any end is told finely.
  void again(double certain) {
    certain_ = certain;
    const auto rest = std::stable_partition(known_.begin(), known_.end(),
                                            [](const SignStretch& s) { return s.sign != 0 || !(s.from < s.to); });
    const std::vector<SignStretch> untold(rest, known_.end());
    known_.erase(rest, known_.end());
    for (const SignStretch& s : untold) leave(s.from, s.to);
    look_at_left();
  }

  /// Nothing once the walk is refused.
  std::optional<NearRule::Least> least(double from, double to, const Until& until) {
    if (!refused_ && (++asked_ > plane::allowed(kMostSearches) || plane::cells_left() <= 0)) {
      refused_.emplace(plane::search_spent("the signs along a line were not found"));
      spent_ = true;
    }
    if (refused_) return std::nullopt;
    exact::Tried<NearRule::Least> found = rule_.least(line_, from, to, until);
    if (!found) {
      refused_ = found.refusal();
      spent_ = plane::cells_left() <= 0;
      return std::nullopt;
    }
    if (!found->quick) ++searches_;
    return *std::move(found);
  }

  /// Whether a sign is known anywhere.
  bool told() const {
    return std::any_of(known_.begin(), known_.end(), [](const SignStretch& s) { return s.sign != 0; });
  }
  void put(double from, double to, int sign) {
    if (from < to || sign == 0) known_.push_back({from, to, sign});
  }
  void leave(double from, double to) {
    if (from < to) left_.emplace_back(from, to);
  }
  /// The search did not tell: a shorter stretch may be easier.
  void halve(double from, double to) {
    const double middle = (from + to) / 2;
    searches_ += kHard;
    asked_ += kHard;
    if (!(from < middle && middle < to)) return put(from, to, 0);
    leave(from, middle);
    leave(middle, to);
  }

  /// From the end `from` of a stretch on which the function is less than 0 towards `to`, by the nearest places: the end
  /// of what is less than 0, and whether the function is hardly less there.
  std::pair<double, bool> end(double from, double to) {
    while (from != to) {
      const double blur = this->blur();
      const auto v = least(from, from, {0, margin::kLineShare, blur / 8});
      if (!v) return {from, false};
      const bool hardly = v->low >= -blur / 2;
      if (!(v->high < 0)) return {from, hardly && v->high <= blur / 2};
      const double next = reaches(v->beyond, from, to, 0, blur / 64);
      const bool still = std::fabs(next - from) <= blur / 4;
      from = next;
      if (still) return {from, hardly};
    }
    return {from, false};
  }

  /// The function is less than 0 between `near` and `far`, of what is left between `from` and `to`.
  void grow(double from, double to, double near, double far) {
    const auto [first, first_is_end] = end(near, from);
    const auto [last, last_is_end] = end(far, to);
    put(first, last, -1);
    const double pad = blur() / 4;
    const double before = first_is_end ? std::max(from, first - pad) : first,
                 behind = last_is_end ? std::min(to, last + pad) : last;
    if (before < first) put(before, first, 0);
    if (last < behind) put(last, behind, 0);
    leave(from, before);
    leave(behind, to);
  }

  /// A place says that the function is hardly more than 0 about `in`.
  void hardly(double from, double to, double in, const NearRule::Least& v) {
    const double most = kHardly * blur(), near = reaches(v.beyond, in, from, most, blur() / 64),
                 far = reaches(v.beyond, in, to, most, blur() / 64);
    put(near, far, 0);
    leave(from, near);
    leave(far, to);
  }

  /// The function is hardly less than 0 on what is left from `from` to `to`, and by a place hardly more on a part of
  /// it. Where it is so again and again the line runs along the boundary: then its middle is looked at, too.
  void touch(double from, double to, const NearRule::Least& v) {
    const double middle = (from + to) / 2;
    if (std::exchange(touching_, true)) {
      const auto there = least(middle, middle, {0, margin::kLineShare, blur() / 4});
      if (!there) return leave(from, to);
      if (there->high <= blur() / 2) return hardly(from, to, middle, *there);
      if (there->low > blur()) {
        const double first = std::max(from, middle - there->low), last = std::min(to, middle + there->low);
        put(first, last, 1);
        leave(from, first);
        leave(last, to);
        return;
      }
    }
    hardly(from, to, lowest(v.beyond, from, to, blur() / 2), v);
  }

  void look(double from, double to) {
    const double blur = this->blur();
    auto found = least(from, to, {0, 0, blur / 4});
    if (found && found->high < 0 && found->high > -blur) found = least(from, to, {0, margin::kLineShare, blur / 4});
    if (!found) return leave(from, to);
    const NearRule::Least& v = *found;
    if (v.low >= -kHardly * blur && v.high <= blur / 2) return touch(from, to, v);
    touching_ = false;
    if (v.low > 0) return put(from, to, 1);
    if (v.high > -blur / 64) return halve(from, to);
    const double in = lowest(v.beyond, from, to, v.high / 2);
    grow(from, to, reaches(v.beyond, in, from, 0, blur / 64), reaches(v.beyond, in, to, 0, blur / 64));
  }

  const NearRule& rule_;
  const NearLine& line_;
  double size_, certain_;
  std::vector<SignStretch> known_;
  std::vector<std::pair<double, double>> left_;
  int asked_ = 0, searches_ = 0;
  bool touching_ = false;  // what was looked at last
  std::optional<exact::Refusal> refused_;
  bool spent_ = false;  // it is as the work went that a line may take
};

}  // namespace

exact::Tried<NearRule::Known> NearRule::known(const NearLine&) const { return Known(); }

exact::Tried<std::vector<SignStretch>> near_stretches(const NearRule& rule, const NearLine& line,
                                                      const NearRange& range) {
  const double place = space::dot(range.middle - line.start, line.unit);
  return Walk(rule, line, range.size).run(place - 2 * range.size, place + 2 * range.size);
}

NearRays::NearRays(std::unique_ptr<const NearRule> rule, const NearRange& range, int outer, std::int64_t scale,
                   const space::RayGrid& grid)
    : rule_(std::move(rule)),
      range_(range),
      outer_(outer),
      grid_(grid),
      unit_(static_cast<double>(scale) / static_cast<double>(grid.parts)) {}

exact::Tried<RayRow> NearRays::try_row(int j) const {
  RayRow out;
  for (int i = 0; i < grid_.nu; ++i) {
    const PositionLine line = position_line(grid_, unit_, i, j);
    const NearLine near{space::rounded(line.start), space::rounded(line.unit)};
    const auto stretches = in_share_of_line(grid_.nu - i, [&] { return near_stretches(*rule_, near, range_); });
    if (!stretches) return stretches.refusal();
    put_line(*stretches, unit_, out, outer_);
  }
  return out;
}

}  // namespace findspace::distance
