// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_summary.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "space/rays/ray_intervals.h"

namespace findspace::space {

RaySummarizer::RaySummarizer(const RayGrid& grid, const Point& low, const Point& high)
    : grid_(grid),
      low_(static_cast<double>(component(low, grid.axis) * grid.parts)),
      high_(static_cast<double>(component(high, grid.axis) * grid.parts)) {}

int RaySummarizer::find(int k) {
  while (root_[k] != k) k = root_[k] = root_[root_[k]];
  return k;
}

void RaySummarizer::join(int a, int b) {
  a = find(a);
  b = find(b);
  if (a == b) return;
  if (b < a) std::swap(a, b);
  root_[b] = a;
  RayComponent &p = parts_[a].component, &q = parts_[b].component;
  p.volume += q.volume;
  for (int k = 0; k < 3; ++k) {
    p.low[k] = std::min(p.low[k], q.low[k]);
    p.high[k] = std::max(p.high[k], q.high[k]);
  }
  if (q.longest > p.longest) {
    p.longest = q.longest;
    p.sample = q.sample;
  }
}

void RaySummarizer::take(Interval interval, int i, int j) {
  const double parts = static_cast<double>(grid_.parts);
  const double cell = static_cast<double>(grid_.du) * static_cast<double>(grid_.dv) / (parts * parts * parts);
  RayComponent part;
  const int u = (grid_.axis + 1) % 3, v = (grid_.axis + 2) % 3;
  part.low[u] = part.high[u] = static_cast<double>(grid_.u_at(i)) / parts;
  part.low[v] = part.high[v] = static_cast<double>(grid_.v_at(j)) / parts;
  double from = interval.from, to = interval.to;
  cut_at(low_, high_, from, to);
  part.low[grid_.axis] = from / parts;
  part.high[grid_.axis] = to / parts;
  part.longest = to - from;
  part.volume = part.longest * cell;
  part.sample = part.low;
  part.sample[grid_.axis] = (part.low[grid_.axis] + part.high[grid_.axis]) / 2;
  interval.component = static_cast<int>(parts_.size());
  parts_.push_back({part, summary_.intervals});
  root_.push_back(interval.component);
  const auto join_with = [&](const std::vector<Interval>& line) {
    auto other =
        std::partition_point(line.begin(), line.end(), [&](const Interval& o) { return o.to < interval.from; });
    for (; other != line.end() && other->from <= interval.to; ++other) join(other->component, interval.component);
  };
  if (i > 0) join_with(now_[i - 1]);
  if (!before_.empty()) join_with(before_[i]);
  now_[i].push_back(interval);
  ++summary_.intervals;
  summary_.points += interval.to <= interval.from;
}

RowIntervals intervals_of(const RayRow& row) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  RowIntervals out;
  const auto put = [&](int line, double from, double to) {
    out.lines.push_back(line);
    out.from.push_back(from);
    out.to.push_back(to);
  };
  for (int i = 0; i < static_cast<int>(row.before.size()); ++i) {
    bool in = row.before[i] <= 0;
    double from = -kInfinite;
    for (int e = row.first[i]; e < row.first[i + 1]; ++e) {
      const RayEvent& event = row.events[e];
      out.radius = std::max(out.radius, event.at.radius);
      const bool here = event.here <= 0, after = event.after <= 0;
      if (in && !(here && after)) put(i, from, event.at.value);
      if (!in && here && !after) put(i, event.at.value, event.at.value);
      if (after && !(in && here)) from = event.at.value;
      in = after;
    }
    if (in) put(i, from, kInfinite);
  }
  return out;
}

void RaySummarizer::add(int j, const RowIntervals& row) {
  now_.assign(grid_.nu, {});
  summary_.precision = std::max(summary_.precision, row.radius / static_cast<double>(grid_.parts));
  for (std::size_t k = 0; k < row.lines.size(); ++k) take({row.from[k], row.to[k], 0}, row.lines[k], j);
  summary_.lines += grid_.nu;
  end_row();
}

/// Components that the row does not meet are done; the others get new numbers, by birth.
void RaySummarizer::end_row() {
  std::vector<int> number(parts_.size(), -1);
  for (const auto& line : now_) {
    for (const Interval& i : line) number[find(i.component)] = 0;
  }
  std::vector<Part> left;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (root_[k] != static_cast<int>(k)) continue;
    if (number[k] < 0) {
      done_.push_back(parts_[k]);
      continue;
    }
    number[k] = static_cast<int>(left.size());
    left.push_back(parts_[k]);
  }
  for (auto& line : now_) {
    for (Interval& i : line) i.component = number[find(i.component)];
  }
  parts_ = std::move(left);
  root_.resize(parts_.size());
  std::iota(root_.begin(), root_.end(), 0);
  before_ = std::move(now_);
}

RaySummary RaySummarizer::finish() {
  done_.insert(done_.end(), parts_.begin(), parts_.end());
  std::sort(done_.begin(), done_.end(), [](const Part& a, const Part& b) { return a.born < b.born; });
  for (const Part& part : done_) summary_.components.push_back(part.component);
  std::stable_sort(summary_.components.begin(), summary_.components.end(),
                   [](const RayComponent& a, const RayComponent& b) { return a.volume > b.volume; });
  summary_.empty = summary_.components.empty();
  for (const RayComponent& c : summary_.components) {
    summary_.volume += c.volume;
    const bool first = &c == &summary_.components[0];
    for (int k = 0; k < 3; ++k) {
      summary_.low[k] = first ? c.low[k] : std::min(summary_.low[k], c.low[k]);
      summary_.high[k] = first ? c.high[k] : std::max(summary_.high[k], c.high[k]);
    }
  }
  return std::move(summary_);
}

}  // namespace findspace::space
