// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/optimize_rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/margins/formula.h"
#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/base/subdivide.h"

namespace findspace::formula {

using space::RayInterval;
using Place = std::array<double, 3>;

namespace {

/// How many groups are looked at together, whatever the number of threads.
constexpr std::size_t kAtOnce = 32;

/// What neighbouring intervals of one axis have between two heights.
struct Group {
  std::size_t first = 0, last = 0;
  double bound = 0;
  Place low{}, high{};
  bool operator<(const Group& other) const { return bound > other.bound; }  // the least is on top
};

class Search {
 public:
  Search(std::vector<RayInterval> intervals, double sense, const std::function<double(const Place&)>& value)
      : intervals_(std::move(intervals)), sense_(sense), value_(value) {}

  RayBest run() {
    std::vector<Group> start;
    for (std::size_t k = 0, first = 0; k < intervals_.size(); ++k) {
      if (k + 1 < intervals_.size() && intervals_[k].axis == intervals_[k + 1].axis) continue;
      arrange(first, k + 1);
      add_group(first, k + 1, -exact::kInfinity, exact::kInfinity, start);
      first = k + 1;
    }
    look(std::move(start));
    const auto worth = [&](const Group& g) { return best_.value - g.bound > tolerance_; };
    std::vector<Group> parts;
    queue_.run(
        kMostPlaces, kAtOnce, [&](const Group& top) { return count_ >= kMostPlaces || !worth(top); },
        [&](const Group& top) {
          if (worth(top)) divide(top, parts);
        },
        [&] { look(std::exchange(parts, {})); });
    best_.bound = queue_.empty() ? best_.value : std::min(queue_.best().bound, best_.value);
    best_.value *= sense_;
    best_.bound *= sense_;
    return best_;
  }

 private:
  static std::size_t half(std::size_t first, std::size_t last) { return first + (last - first) / 2; }
  static double width(const Group& g, std::size_t axis) { return g.high[axis] - g.low[axis]; }

  /// The wider one of the two coordinates across the lines.
  static std::size_t across(const Group& g, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return width(g, u) > width(g, v) ? u : v;
  }

  /// Orders the intervals so that every half, quarter ... of them lies together.
  void arrange(std::size_t first, std::size_t last) {
    if (last - first < 2) return;
    std::vector<Group> all;
    add_group(first, last, -exact::kInfinity, exact::kInfinity, all);
    const std::size_t wide = across(all[0], intervals_[first].axis), middle = half(first, last);
    const auto at = [&](std::size_t k) { return intervals_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](const RayInterval& a, const RayInterval& b) { return a.at[wide] < b.at[wide]; });
    arrange(first, middle);
    arrange(middle, last);
  }

  void add_group(std::size_t first, std::size_t last, double from, double to, std::vector<Group>& out) const {
    Group g{last, first, 0, {}, {}};
    g.low.fill(exact::kInfinity);
    g.high.fill(-exact::kInfinity);
    for (std::size_t k = first; k < last; ++k) {
      const RayInterval& r = intervals_[k];
      Place low = r.at, high = r.at;
      low[r.axis] = std::max(r.from, from);
      high[r.axis] = std::min(r.to, to);
      if (low[r.axis] > high[r.axis]) continue;
      g.first = std::min(g.first, k);
      g.last = k + 1;
      for (std::size_t c = 0; c < 3; ++c) {
        g.low[c] = std::min(g.low[c], low[c]);
        g.high[c] = std::max(g.high[c], high[c]);
      }
    }
    if (g.low[0] <= g.high[0]) out.push_back(g);
  }

  void divide(const Group& g, std::vector<Group>& parts) const {
    const std::size_t axis = intervals_[g.first].axis;
    if (g.last - g.first == 1 || width(g, axis) > width(g, across(g, axis))) {
      const double middle = g.low[axis] + width(g, axis) / 2;
      add_group(g.first, g.last, g.low[axis], middle, parts);
      add_group(g.first, g.last, middle, g.high[axis], parts);
    } else {
      add_group(g.first, half(g.first, g.last), g.low[axis], g.high[axis], parts);
      add_group(half(g.first, g.last), g.last, g.low[axis], g.high[axis], parts);
    }
  }

  static Place center(const Group& g) {
    Place p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = g.low[k] + width(g, k) / 2;
    return p;
  }

  /// A place of the region in the middle of the group's intervals; nothing where that one does not reach so far.
  std::optional<Place> example(const Group& g) const {
    const RayInterval& r = intervals_[half(g.first, g.last)];
    const double from = std::max(r.from, g.low[r.axis]), to = std::min(r.to, g.high[r.axis]);
    if (from > to) return std::nullopt;
    Place p = r.at;
    p[r.axis] = from + (to - from) / 2;
    return p;
  }

  /// Values at the centre, and of a part of one interval at its ends, of several at an example.
  void look(std::vector<Group> groups) {
    std::vector<std::array<double, 3>> values(groups.size());
    plane::parallel_for(groups.size(), [&](std::size_t k) {
      const Group& g = groups[k];
      values[k][0] = sense_ * value_(center(g));
      if (g.last - g.first > 1) {
        const auto p = example(g);
        values[k][1] = p ? sense_ * value_(*p) : exact::kInfinity;
        return;
      }
      values[k][1] = sense_ * value_(g.low);
      values[k][2] = sense_ * value_(g.high);
    });
    for (std::size_t k = 0; k < groups.size(); ++k) take(groups[k], values[k]);
  }

  void take(Group g, const std::array<double, 3>& values) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += width(g, k) * width(g, k);
    const double length = std::sqrt(square);
    tolerance_ = std::max(tolerance_, margin::kLineOptimum * length);
    if (g.last - g.first > 1) {
      count_ += 2;
      if (const auto p = example(g)) {
        const RayInterval& r = intervals_[half(g.first, g.last)];
        offer(values[1], *p, inside(r, (*p)[r.axis]));
      }
      g.bound = values[0] - length / 2;
    } else {
      count_ += 3;
      const RayInterval& r = intervals_[g.first];
      const Place places[3] = {center(g), g.low, g.high};
      for (std::size_t k = 0; k < 3; ++k) offer(values[k], places[k], inside(r, places[k][r.axis]));
      // Between two places of a line the value lies above both slopes.
      g.bound = (values[0] + std::min(values[1], values[2])) / 2 - length / 4;
      if (!(length > 0)) return;
    }
    queue_.push(g);
  }

  static bool inside(const RayInterval& r, double z) { return (z > r.from || r.from_in) && (z < r.to || r.to_in); }

  void offer(double value, const Place& p, bool in) {
    if (found_ && !(value < best_.value) && !(in && !best_.attained && !(value > best_.value))) return;
    best_.value = value;
    best_.at = p;
    best_.attained = in;
    found_ = true;
  }

  std::vector<RayInterval> intervals_;
  double sense_;
  const std::function<double(const Place&)>& value_;
  plane::Subdivision<Group> queue_;
  double tolerance_ = 0;
  int count_ = 0;
  bool found_ = false;
  RayBest best_{exact::kInfinity, 0, {}, false};
};

}  // namespace

std::optional<RayBest> best_on_lines(std::vector<RayInterval> intervals, bool greatest,
                                     const std::function<double(const Place&)>& value) {
  if (intervals.empty()) return std::nullopt;
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const RayInterval& a, const RayInterval& b) { return a.axis < b.axis; });
  return Search(std::move(intervals), greatest ? -1 : 1, value).run();
}

distance::OptimalValue best_over_region(const RayBest& found, distance::Sense sense, const LinesOfRegion& lines,
                                        double step) {
  const auto real = [step](double v) { return exact::Real::from_double(v * step); };
  distance::OptimalValue out;
  out.sense = sense;
  if (!std::isfinite(found.value)) {  // -infinity there
    out.unbounded = true;
    return out;
  }
  const double radius = lines.cell_radius.to_double() * margin::kUpward;
  std::optional<exact::Real> bound;
  if (lines.cells == Side::kOuter && both(lines.cells, lines.on_lines) == Side::kOuter && std::isfinite(found.bound))
    bound = real(out.maximum() ? found.bound + radius : found.bound - radius);
  const bool certain =
      lines.cells != Side::kOuter && (lines.on_lines == Side::kExact || lines.on_lines == Side::kInner);
  if (certain)
    out.set_enclosed(real(found.value), std::move(bound), distance::Way::kLines);
  else
    out.set_nearby(real(found.value), std::move(bound), distance::Way::kLines);
  out.attained = certain && found.attained;
  for (const double c : found.at) out.answer->at.push_back(real(c));
  return out;
}

}  // namespace findspace::formula
