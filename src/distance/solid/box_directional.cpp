// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances along an axis (distances.md 7.1) of sets with axis-parallel faces: sums with stretches of the axis, with or
// without their ends, are such sets again.
#include <algorithm>

#include "distance/solid/box_maps.h"
#include "space/box/box_operations.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::BoxComplex;
using space::Interval;
using space::Mark;

namespace {

/// {p : p + t e in the set, t in the stretch}.
BoxComplex seen(const BoxComplex& set, int axis, const Interval& stretch) {
  space::IntervalBox box;
  for (Interval& i : box) i = {Real(), Real(), true, true};
  Interval& back = box[static_cast<std::size_t>(axis)];
  back = {std::nullopt, std::nullopt, stretch.to_in, stretch.from_in};
  if (stretch.to) back.from = -*stretch.to;
  if (stretch.from) back.to = -*stretch.from;
  return sum(set, BoxComplex::of_boxes(std::array<space::IntervalBox, 1>{box}));
}

/// `near` where the set is seen at less than the reach, 0 where at it only, -near elsewhere.
BoxComplex reached(const BoxComplex& set, const Real& reach, int axis, int way, Mark near) {
  const auto stretch = [&](bool whole) {
    Interval i{-reach, reach, whole, whole};
    if (way > 0) {
      i.from = Real();
      i.from_in = true;
    }
    if (way < 0) {
      i.to = Real();
      i.to_in = true;
    }
    return i;
  };
  const BoxComplex open = seen(set, axis, stretch(false)), closed = seen(set, axis, stretch(true));
  return overlay(std::array<const BoxComplex*, 2>{&open, &closed}, [near](std::span<const Mark> m) {
    return Mark(m[0] != 0 ? near : m[1] != 0 ? 0 : -near);
  });
}

/// +1 where the set is seen farther off than the level, 0 where not but at the level, -1 elsewhere.
BoxComplex farther(const BoxComplex& set, const Real& level, int axis, int way) {
  const auto stretch = [&](bool at) {
    return way > 0 ? Interval{level, std::nullopt, at, false} : Interval{std::nullopt, -level, false, at};
  };
  const BoxComplex beyond = seen(set, axis, stretch(false)), from = seen(set, axis, stretch(true));
  return overlay(std::array<const BoxComplex*, 2>{&beyond, &from}, [](std::span<const Mark> m) {
    return Mark(m[0] != 0 ? 1 : m[1] != 0 ? 0 : -1);
  });
}

bool has_mark(const BoxComplex& map, Mark mark) {
  return !map.remarked([mark](Mark m) { return Mark(m == mark); }).empty();
}

/// What two places of a line along the axis at which signs change can be apart, ascending, 0 first.
std::vector<Real> lengths(const space::Axis& at) {
  std::vector<Real> out{Real()};
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t j = i + 1; j < at.size(); ++j) out.push_back(at[j] - at[i]);
  }
  space::sort_axis(out);
  return out;
}

bool is_farthest(Which which) { return which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2; }

Which nearest_one(Which which) {
  return which == Which::kGamma2   ? Which::kGamma1
         : which == Which::kEta2   ? Which::kEta1
         : which == Which::kDelta2 ? Which::kDelta1
                                   : which;
}

}  // namespace

Tried<BoxComplex> BoxMaps::directional_map(Which which, const Real& level, int axis, int way) const {
  const bool farthest = is_farthest(which);
  const Tried<Signs>& found = signs(nearest_one(which));
  if (!found) return found.refusal();
  const Signs& s = *found;
  const int side = level.sign();
  if (!s.defined || (farthest && side < 0)) return BoxComplex({}, 1);
  const auto set = [&](auto in) { return s.map.remarked([in](Mark m) { return Mark(in(m)); }); };
  const BoxComplex closed = set([](Mark m) { return m <= 0; });
  if (!farthest) {
    if (side == 0) return s.map;
    if (side > 0) return reached(closed, level, axis, way, -1).checked();
    return reached(set([](Mark m) { return m >= 0; }), -level, axis, way, 1).checked();
  }
  if (closed.mark(0, 0, 0) != 0) return BoxComplex({}, 1);  // it has no end
  std::vector<BoxComplex> maps{side == 0 ? closed.remarked([](Mark m) { return Mark(m != 0 ? 0 : 1); })
                                         : reached(closed, level, axis, way, -1)};
  for (const int forward : {1, -1}) {
    if (way != -forward) maps.push_back(farther(closed, level, axis, forward));
  }
  std::vector<const BoxComplex*> all;
  for (const BoxComplex& m : maps) all.push_back(&m);
  return overlay(all, [](std::span<const Mark> m) { return *std::max_element(m.begin(), m.end()); }).checked();
}

/// The least value is set by two places of one line: half their distance (both ways) or all of it. Below the greatest
/// of these levels below which there is nothing there is none.
Tried<std::optional<BoxMaps::Least>> BoxMaps::directional_least(Which which, int axis, int way) const {
  const Tried<Signs>& found = signs(nearest_one(which));
  if (!found) return found.refusal();
  const Signs& s = *found;
  const bool farthest = is_farthest(which);
  if (!s.defined || (!farthest && s.map.mark(0, 0, 0) < 0)) return std::nullopt;
  std::vector<Real> levels = lengths(s.map.at()[static_cast<std::size_t>(axis)]);
  for (Real& l : levels) l *= Real::ratio(farthest ? 1 : -1, way == 0 ? 2 : 1);
  if (!farthest) std::reverse(levels.begin(), levels.end());
  const auto map = [&](const Real& level) { return directional_map(which, level, axis, way); };
  const Tried<BoxComplex> beyond = map(farthest ? levels.back() + Real(1) : levels[0] - Real(1));
  if (!beyond) return beyond.refusal();
  // Beyond all lengths there are lines without an end, or nothing of finite distance.
  if (has_mark(*beyond, -1) != farthest) return std::nullopt;
  std::size_t low = 0, high = levels.size();  // below levels[low] there is nothing, below levels[high] something
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    const Tried<BoxComplex> there = map(levels[middle]);
    if (!there) return there.refusal();
    (has_mark(*there, -1) ? high : low) = middle;
  }
  const Tried<BoxComplex> at = map(levels[low]);
  if (!at) return at.refusal();
  return Least{levels[low], at->remarked([](Mark m) { return Mark(m == 0); })};
}

}  // namespace findspace::distance
