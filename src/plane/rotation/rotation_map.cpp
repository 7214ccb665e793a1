// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotation_map.h"

#include <algorithm>

#include "plane/base/counted_tasks.h"

namespace findspace::plane {

using exact::Angle;

RotationMap merged(RotationMap map) {
  RotationMap out = RotationMap::uniform(map.at.empty() ? map.everywhere : map.after.back());
  for (std::size_t k = 0; k < map.at.size(); ++k) {
    if (map.here[k] == map.after[k] && map.here[k] == map.before(k)) continue;
    out.at.push_back(map.at[k]);
    out.here.push_back(map.here[k]);
    out.after.push_back(map.after[k]);
  }
  return out;
}

namespace {

/// The marks of one map along the ascending angles of an overlay.
class Walk {
 public:
  explicit Walk(const RotationMap& map) : map_(map), on_arc_(map.at.empty() ? map.everywhere : map.after.back()) {}

  const Angle* next() const { return next_ < map_.at.size() ? &map_.at[next_] : nullptr; }
  Mark here(const Angle& a) const { return stops_at(a) ? map_.here[next_] : on_arc_; }
  void pass(const Angle& a) {
    if (stops_at(a)) on_arc_ = map_.after[next_++];
  }
  Mark on_arc() const { return on_arc_; }

 private:
  bool stops_at(const Angle& a) const { return next() != nullptr && compare(*next(), a) == 0; }

  const RotationMap& map_;
  Mark on_arc_;
  std::size_t next_ = 0;
};

const Angle* first_of(const std::vector<Walk>& walks) {
  const Angle* first = nullptr;
  for (const Walk& w : walks) {
    if (w.next() != nullptr && (first == nullptr || compare(*w.next(), *first) < 0)) first = w.next();
  }
  return first;
}

}  // namespace

RotationMap overlay(std::span<const RotationMap* const> operands,
                    const std::function<Mark(std::span<const Mark>)>& rule) {
  std::vector<Walk> walks;
  for (const RotationMap* m : operands) walks.emplace_back(*m);
  std::vector<Mark> marks(walks.size());
  RotationMap out;
  for (std::size_t i = 0; i < walks.size(); ++i) marks[i] = walks[i].on_arc();
  out.everywhere = rule(marks);
  while (const Angle* first = first_of(walks)) {
    const Angle a = *first;
    for (std::size_t i = 0; i < walks.size(); ++i) marks[i] = walks[i].here(a);
    out.at.push_back(a);
    out.here.push_back(rule(marks));
    for (std::size_t i = 0; i < walks.size(); ++i) {
      walks[i].pass(a);
      marks[i] = walks[i].on_arc();
    }
    out.after.push_back(rule(marks));
  }
  return merged(std::move(out));
}

RotationMap remark(const RotationMap& map, const std::function<Mark(Mark)>& rule) {
  RotationMap out = map;
  out.everywhere = rule(map.everywhere);
  std::transform(map.here.begin(), map.here.end(), out.here.begin(), rule);
  std::transform(map.after.begin(), map.after.end(), out.after.begin(), rule);
  return merged(std::move(out));
}

RotationMap closure(RotationMap set) {
  for (std::size_t k = 0; k < set.at.size(); ++k) set.here[k] = std::max({set.here[k], set.after[k], set.before(k)});
  return merged(std::move(set));
}

namespace {

/// Of the angles, at 2 k, and the arcs after them, at 2 k + 1: those that the set meets.
std::vector<std::size_t> places_met(const RotationMap& set, const std::vector<exact::ExactAngle>& angles) {
  std::vector<char> met(2 * angles.size());
  Walk walk(set);
  std::size_t arc = met.size() - 1;
  const auto look = [&](Mark mark) {
    if (mark != 0) met[arc] = 1;
  };
  const auto pass_until = [&](const Angle* end) {
    while (walk.next() != nullptr && (end == nullptr || compare(*walk.next(), *end) < 0)) {
      const Angle& stop = *walk.next();
      look(walk.here(stop));
      walk.pass(stop);
      look(walk.on_arc());
    }
  };
  look(walk.on_arc());
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Angle here{angles[k], exact::Real()};
    pass_until(&here);
    met[2 * k] = walk.here(here) != 0;
    walk.pass(here);
    arc = 2 * k + 1;
    look(walk.on_arc());
  }
  pass_until(nullptr);
  std::vector<std::size_t> out;
  for (std::size_t place = 0; place < met.size(); ++place)
    if (met[place] != 0) out.push_back(place);
  return out;
}

}  // namespace

RotationMap marks_within(const RotationMap& set, const std::vector<exact::ExactAngle>& events,
                         const std::function<AngleMark()>& look) {
  if (events.empty()) return RotationMap::uniform(look()(1, exact::ExactAngle{}));
  constexpr std::size_t kBlock = 32;
  const std::size_t n = events.size();
  const std::vector<std::size_t> asked = places_met(set, events);
  std::vector<Mark> marks(2 * n);
  counted_tasks((asked.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    const AngleMark mark = look();
    for (std::size_t i = block * kBlock; i < std::min(asked.size(), (block + 1) * kBlock); ++i) {
      const std::size_t place = asked[i], k = place / 2;
      marks[place] = mark(place, place % 2 == 0 ? events[k] : between(events[k], events[(k + 1) % n]));
    }
  });
  RotationMap map;
  for (std::size_t k = 0; k < n; ++k) {
    map.at.push_back({events[k], exact::Real()});
    map.here.push_back(marks[2 * k]);
    map.after.push_back(marks[2 * k + 1]);
  }
  map.everywhere = map.after.back();
  return merged(std::move(map));
}

namespace {

/// The same map with its angles in the order of their places again; they are in the right circular order.
RotationMap rotated_to_start(RotationMap map) {
  if (map.at.empty()) return map;
  const auto least =
      std::min_element(map.at.begin(), map.at.end(), [](const Angle& p, const Angle& q) { return compare(p, q) < 0; });
  const auto by = least - map.at.begin();
  std::rotate(map.at.begin(), map.at.begin() + by, map.at.end());
  std::rotate(map.here.begin(), map.here.begin() + by, map.here.end());
  std::rotate(map.after.begin(), map.after.begin() + by, map.after.end());
  return map;
}

}  // namespace

RotationMap shifted(const RotationMap& map, const exact::Real& degrees) {
  RotationMap out = map;
  for (Angle& a : out.at) a = a + degrees;
  return rotated_to_start(std::move(out));
}

RotationMap mirrored(const RotationMap& map) {
  RotationMap out = RotationMap::uniform(map.everywhere);
  for (std::size_t k = map.at.size(); k-- > 0;) {
    out.at.push_back({-map.at[k].rotation, -map.at[k].more});
    out.here.push_back(map.here[k]);
    out.after.push_back(map.before(k));
  }
  return rotated_to_start(std::move(out));
}

Mark mark_at(const RotationMap& map, const Angle& angle) {
  if (map.at.empty()) return map.everywhere;
  const auto next = std::lower_bound(map.at.begin(), map.at.end(), angle,
                                     [](const Angle& p, const Angle& q) { return compare(p, q) < 0; });
  const auto k = std::size_t(next - map.at.begin());
  if (next != map.at.end() && compare(*next, angle) == 0) return map.here[k];
  return map.before(k);
}

std::array<double, 2> RotationInterval::degrees() const {
  const double first = from.degrees(), last = to.degrees() + (round || compare(to, from) < 0 ? 360 : 0);
  return {first, std::clamp(last, first, first + 360)};
}

std::vector<RotationInterval> intervals(const RotationMap& set) {
  const std::size_t n = set.at.size();
  if (n == 0) {
    if (set.everywhere == 0) return {};
    return {{Angle{}, Angle{}, true, false, true}};
  }
  std::vector<RotationInterval> out;
  for (std::size_t k = 0; k < n; ++k) {
    const bool begins = set.before(k) == 0 || set.here[k] == 0;
    if (!begins) continue;
    if (set.after[k] == 0) {
      if (set.here[k] != 0 && set.before(k) == 0) out.push_back({set.at[k], set.at[k], true, true});
      continue;
    }
    std::size_t end = (k + 1) % n;
    while (end != k && set.here[end] != 0 && set.after[end] != 0) end = (end + 1) % n;
    const bool to_in = end != k && set.here[end] != 0;
    out.push_back({set.at[k], set.at[end], set.here[k] != 0, to_in, end == k});
  }
  return out;
}

}  // namespace findspace::plane
