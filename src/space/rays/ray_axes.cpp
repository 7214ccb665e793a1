// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "space/rays/ray_connect.h"

namespace findspace::space {
namespace {

class Collector {
 public:
  Collector(const RayLattice& lattice, const std::function<bool(std::int8_t)>& inside)
      : lattice_(lattice), inside_(inside) {}

  void add(const RayGrid& grid, const RayRow& row, Lines& out, RaySummary& summary) const {
    for (int i = 0; i < grid.nu; ++i) {
      add_line(row, i, grid.axis, out, summary);
      out.first.push_back(out.stretches.size());
    }
  }

 private:
  void add_line(const RayRow& row, int i, int axis, Lines& out, RaySummary& summary) const {
    ++summary.lines;
    const int begin = row.first[static_cast<std::size_t>(i)], end = row.first[static_cast<std::size_t>(i) + 1];
    const auto event = [&](int e) -> const RayEvent& { return row.events[static_cast<std::size_t>(e)]; };
    bool in = inside_(row.before[static_cast<std::size_t>(i)]);
    int from = -1;  // the event at which the stretch begins; -1: before all
    bool from_in = true;
    const auto close = [&](int to, bool to_in) { put(row, axis, from, from_in, to, to_in, begin, end, out, summary); };
    for (int e = begin; e < end; ++e) {
      summary.precision = std::max(summary.precision, event(e).at.radius / static_cast<double>(lattice_.parts));
      const bool here = inside_(event(e).here), after = inside_(event(e).after);
      if (in && !(here && after)) close(e, here);
      if (!in && here && !after) {
        from = e;
        from_in = true;
        close(e, true);
      }
      if (after && !(in && here)) {
        from = e;
        from_in = here && !in;
      }
      in = after;
    }
    if (in) close(-1, true);
  }

  /// The first lattice point beyond the event, or at it where `with`.
  int beyond(const RayPosition& at, int axis, bool with) const {
    const auto origin = static_cast<double>(lattice_.at(axis, 0));
    int k = static_cast<int>(std::clamp(std::floor((at.value - origin) / static_cast<double>(lattice_.step)) - 1, 0.0,
                                        static_cast<double>(lattice_.count[static_cast<std::size_t>(axis)])));
    for (; k < lattice_.count[static_cast<std::size_t>(axis)]; ++k) {
      RayPosition point;
      point.exact = {lattice_.at(axis, k), 1};
      point.value = static_cast<double>(lattice_.at(axis, k));
      const int order = compare_positions(point, at);
      if (order > 0 || (with && order == 0)) break;
    }
    return k;
  }

  void put(const RayRow& row, int axis, int from, bool from_in, int to, bool to_in, int begin, int end, Lines& out,
           RaySummary& summary) const {
    const auto at = [&](int e) -> const RayPosition& { return row.events[static_cast<std::size_t>(e)].at; };
    Stretch s;
    s.first = from < 0 ? 0 : beyond(at(from), axis, from_in);
    s.last = (to < 0 ? lattice_.count[static_cast<std::size_t>(axis)] : beyond(at(to), axis, !to_in)) - 1;
    const auto edge = [&](int k) { return static_cast<double>(lattice_.at(axis, k)); };
    // Without end: cut at the lattice.
    s.from = from < 0 ? edge(0) : at(from).value;
    s.to = to < 0 ? edge(lattice_.count[static_cast<std::size_t>(axis)] - 1) : at(to).value;
    if (begin == end && s.last < s.first) return;
    out.stretches.push_back(s);
    ++summary.intervals;
    summary.points += from >= 0 && from == to;
  }

  const RayLattice& lattice_;
  const std::function<bool(std::int8_t)>& inside_;
};

/// One component while it is being made.
struct Part {
  RayComponent component;
  std::array<double, 3> along{};  // the volume that lines of one axis give
  double surface = 0;
  bool any = false, solid = false;
  int crossing = -1;  // the set of crossing intervals with its lattice points; -1: none, -2: several
};

void extend(Part& part, const std::array<double, 3>& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    part.component.low[k] = part.any ? std::min(part.component.low[k], p[k]) : p[k];
    part.component.high[k] = part.any ? std::max(part.component.high[k], p[k]) : p[k];
  }
  part.any = true;
}

/// The components, each with the number of its set of stretches.
class Parts {
 public:
  explicit Parts(Sets& sets) : sets_(sets), number_(sets.size(), -1) {}

  Part& of(int stretch) {
    int& number = number_[static_cast<std::size_t>(sets_.find(stretch))];
    if (number < 0) {
      number = static_cast<int>(parts_.size());
      parts_.emplace_back();
    }
    return parts_[static_cast<std::size_t>(number)];
  }
  /// By the first stretch of each.
  std::vector<Part> in_order() && {
    std::vector<Part> out;
    for (const int number : number_)
      if (number >= 0) out.push_back(parts_[static_cast<std::size_t>(number)]);
    return out;
  }

 private:
  Sets& sets_;
  std::vector<int> number_;  // of each root
  std::vector<Part> parts_;
};

void add_stretches(const RayLattice& lattice, Connector& sets, Parts& parts) {
  const auto unit = static_cast<double>(lattice.parts);
  const double step = static_cast<double>(lattice.step) / unit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sets.each(static_cast<int>(axis), [&](const Stretch& s, int number, const std::array<int, 3>& p) {
      Part& part = parts.of(number);
      if (s.first <= s.last) {
        const int crossing = sets.crossing().find(number);
        part.crossing = part.crossing == -1 || part.crossing == crossing ? crossing : -2;
      }
      std::array<double, 3> low{};
      for (std::size_t k = 0; k < 3; ++k) low[k] = static_cast<double>(lattice.at(static_cast<int>(k), p[k])) / unit;
      std::array<double, 3> high = low, middle = low;
      low[axis] = s.from / unit;
      high[axis] = s.to / unit;
      middle[axis] = (low[axis] + high[axis]) / 2;
      extend(part, low);
      extend(part, high);
      part.along[axis] += (high[axis] - low[axis]) * step * step;
      part.solid = part.solid || s.first <= s.last;
      if (high[axis] - low[axis] > part.component.longest) {
        part.component.longest = high[axis] - low[axis];
        part.component.sample = middle;
      }
    });
  }
}

void add_surface(const RaySurface& surface, Connector& sets, Parts& parts) {
  for (const auto& face : surface.faces) {
    const auto corner = [&](std::size_t k) { return surface.vertices[static_cast<std::size_t>(face[k])]; };
    const auto a = corner(0), b = corner(1), c = corner(2);
    parts.of(*sets.at(surface.inside[static_cast<std::size_t>(face[0])])).surface +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
  }
}

}  // namespace

RayAxes ray_axes(const RayLattice& lattice, const std::function<std::unique_ptr<RaySource>(int axis)>& source,
                 const std::function<bool(std::int8_t)>& inside,
                 const std::function<void(const RayGrid&, const RayRow&)>& watch) {
  RayAxes out;
  RaySummary& summary = out.summary;
  const Collector collector(lattice, inside);
  std::array<Lines, 3> lines;
  out.surface = ray_surface(lattice, source, inside, [&](const RayGrid& grid, const RayRow& row) {
    collector.add(grid, row, lines[static_cast<std::size_t>(grid.axis)], summary);
    if (watch) watch(grid, row);
  });
  Connector sets(lattice, lines);
  sets.cross();
  sets.overlap();
  sets.gather();
  Parts parts(sets.near());
  add_stretches(lattice, sets, parts);
  add_surface(out.surface, sets, parts);
  for (Part& part : std::move(parts).in_order()) {
    part.component.volume = part.solid ? part.surface : *std::max_element(part.along.begin(), part.along.end());
    part.component.certified = part.crossing >= 0;
    summary.components.push_back(part.component);
  }
  std::stable_sort(summary.components.begin(), summary.components.end(),
                   [](const RayComponent& a, const RayComponent& b) { return a.volume > b.volume; });
  summary.empty = summary.components.empty();
  Part all;
  for (const RayComponent& c : summary.components) {
    summary.volume += c.volume;
    extend(all, c.low);
    extend(all, c.high);
  }
  summary.low = all.component.low;
  summary.high = all.component.high;
  return out;
}

}  // namespace findspace::space
