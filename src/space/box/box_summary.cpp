// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/box/box_summary.h"

#include <algorithm>
#include <numeric>

#include "space/box/box_topology.h"

namespace findspace::space {

using exact::Real;

namespace {

/// The cells of a set (or of its complement) with their components.
class Components {
 public:
  Components(const BoxComplex& set, bool of_set) : set_(set), of_set_(of_set) {
    std::size_t count = 1;
    for (int k = 0; k < 3; ++k) count *= static_cast<std::size_t>(set.cells(k));
    of_.assign(count, -1);
    each([&](int x, int y, int z) {
      if (in(x, y, z) && of_[set_.index(x, y, z)] < 0) fill(x, y, z);
    });
  }
  int count() const { return static_cast<int>(unbounded_.size()); }
  bool unbounded(int c) const { return unbounded_[std::size_t(c)] != 0; }
  int of(int x, int y, int z) const { return of_[set_.index(x, y, z)]; }
  int bounded_count() const { return static_cast<int>(std::count(unbounded_.begin(), unbounded_.end(), 0)); }

 private:
  template <class Visit>
  void each(Visit visit) const {
    for (int z = 0; z < set_.cells(2); ++z) {
      for (int y = 0; y < set_.cells(1); ++y) {
        for (int x = 0; x < set_.cells(0); ++x) visit(x, y, z);
      }
    }
  }
  bool in(int x, int y, int z) const { return (set_.mark(x, y, z) != 0) == of_set_; }

  void fill(int x, int y, int z) {
    const int id = count();
    unbounded_.push_back(0);
    std::vector<std::array<int, 3>> stack{{x, y, z}};
    of_[set_.index(x, y, z)] = id;
    while (!stack.empty()) {
      const std::array<int, 3> at = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        if (at[std::size_t(k)] == 0 || at[std::size_t(k)] == set_.cells(k) - 1) unbounded_[std::size_t(id)] = 1;
      }
      neighbours(at, [&](const std::array<int, 3>& n) {
        int& slot = of_[set_.index(n[0], n[1], n[2])];
        if (!in(n[0], n[1], n[2]) || slot >= 0) return;
        slot = id;
        stack.push_back(n);
      });
    }
  }

  /// Cells in the closure of `at`, and cells in whose closure it lies.
  template <class Visit>
  void neighbours(const std::array<int, 3>& at, Visit visit) const {
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const std::array<int, 3> d{dx, dy, dz};
          bool smaller = false, larger = false, inside = true;
          std::array<int, 3> n = at;
          for (std::size_t k = 0; k < 3; ++k) {
            n[k] += d[k];
            inside = inside && n[k] >= 0 && n[k] < set_.cells(int(k));
            if (d[k] != 0) (at[k] % 2 == 0 ? smaller : larger) = true;
          }
          if (inside && smaller != larger) visit(n);
        }
      }
    }
  }

  const BoxComplex& set_;
  bool of_set_;
  std::vector<int> of_;
  std::vector<char> unbounded_;
};

int dimension(int x, int y, int z) { return 3 - x % 2 - y % 2 - z % 2; }

/// The size of a cell: volume, area, length, or 1; nothing where it is infinite.
std::optional<Real> size(const BoxComplex& set, const std::array<int, 3>& cell) {
  Real out(1);
  for (int k = 0; k < 3; ++k) {
    const int c = cell[std::size_t(k)];
    if (c % 2 == 1) continue;
    const Interval i = set.interval(k, c, c);
    if (!i.from || !i.to) return std::nullopt;
    out *= *i.to - *i.from;
  }
  return out;
}

/// A point of the cell: its middle, or a step from its finite end.
RealVector middle(const BoxComplex& set, const std::array<int, 3>& cell) {
  RealVector p;
  for (int k = 0; k < 3; ++k) {
    const Interval i = set.interval(k, cell[std::size_t(k)], cell[std::size_t(k)]);
    if (i.from && i.to)
      p[std::size_t(k)] = (*i.from + *i.to) / Real(2);
    else if (i.from)
      p[std::size_t(k)] = *i.from + Real(1);
    else if (i.to)
      p[std::size_t(k)] = *i.to - Real(1);
  }
  return p;
}

struct Exact {
  Real volume, dangling_area, dangling_length;
  bool any = false;
  int dimension = -1;
  Real sample_size;
  std::array<int, 3> sample{}, first{}, last{};  // first and last: cells along each axis
  bool bounded = true;

  void add(const BoxComplex& set, const std::array<int, 3>& cell, bool dangling) {
    const int d = space::dimension(cell[0], cell[1], cell[2]);
    const std::optional<Real> s = size(set, cell);
    if (s && d == 3) volume += *s;
    if (s && dangling && d == 2) dangling_area += *s;
    if (s && dangling && d == 1) dangling_length += *s;
    // The sample lies in the largest of the cells of highest dimension.
    if (d > dimension || (d == dimension && s && sample_size < *s)) {
      dimension = d;
      sample = cell;
      sample_size = s.value_or(Real());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      bounded = bounded && cell[k] > 0 && cell[k] < set.cells(static_cast<int>(k)) - 1;
      first[k] = any ? std::min(first[k], cell[k]) : cell[k];
      last[k] = any ? std::max(last[k], cell[k]) : cell[k];
    }
    any = true;
  }
};

class BoxSummarizer {
 public:
  BoxSummarizer(const BoxComplex& set, const Real& step)
      : set_(set),
        step_(step),
        open_(interior(set)),
        solid_(closure(open_)),
        closed_(closure(set)),
        full_(interior(closed_)),
        parts_(set, true),
        each_(std::size_t(parts_.count())) {
    out_.whole = true;
  }

  SpaceSummary run() {
    for (int z = 0; z < set_.cells(2); ++z) {
      for (int y = 0; y < set_.cells(1); ++y) {
        for (int x = 0; x < set_.cells(0); ++x) count({x, y, z});
      }
    }
    out_.empty = !all_.any;
    out_.bounded = all_.bounded;
    if (all_.bounded) out_.volume = scaled_size(all_.volume, 3);
    out_.dangling_area = scaled_size(all_.dangling_area, 2);
    out_.dangling_length = scaled_size(all_.dangling_length, 1);
    out_.crack_area = scaled_size(crack_area_, 2);
    out_.crack_length = scaled_size(crack_length_, 1);
    out_.holes = Components(set_, false).bounded_count();
    if (all_.any) out_.bbox = box(all_);
    for (int c = 0; c < parts_.count(); ++c) add_component(each_[std::size_t(c)], c);
    std::stable_sort(out_.components.begin(), out_.components.end(), [](const auto& a, const auto& b) {
      return a.dimension != b.dimension ? a.dimension > b.dimension : a.sample < b.sample;
    });
    std::sort(out_.isolated.begin(), out_.isolated.end());
    return std::move(out_);
  }

 private:
  /// One cell into the sums: of the set, of its component, or of the cracks.
  void count(const std::array<int, 3>& cell) {
    const auto [x, y, z] = cell;
    const bool in = set_.mark(x, y, z) != 0;
    out_.open = out_.open && in == (open_.mark(x, y, z) != 0);
    out_.closed = out_.closed && in == (closed_.mark(x, y, z) != 0);
    out_.regular = out_.regular && in == (solid_.mark(x, y, z) != 0);
    out_.whole = out_.whole && in;
    if (in) {
      const bool dangling = solid_.mark(x, y, z) == 0 && !borders_face(cell, true);
      all_.add(set_, cell, dangling);
      each_[std::size_t(parts_.of(x, y, z))].add(set_, cell, dangling);
    } else if (full_.mark(x, y, z) != 0) {
      const auto s = size(set_, cell);
      if (s && dimension(x, y, z) == 2) crack_area_ += *s;
      if (s && dimension(x, y, z) == 1 && !borders_face(cell, false)) crack_length_ += *s;
    }
  }

  void add_component(const Exact& e, int id) {
    SpaceComponent c;
    c.dimension = e.dimension;
    if (e.bounded) c.volume = scaled_size(e.volume, 3);
    c.dangling_area = scaled_size(e.dangling_area, 2);
    c.dangling_length = scaled_size(e.dangling_length, 1);
    c.sample = place(middle(set_, e.sample));
    c.bbox = box(e);
    c.holes = e.dimension < 2 ? 0 : Components(alone(e, id), false).bounded_count();
    if (e.dimension == 0) out_.isolated.push_back(c.sample);
    out_.components.push_back(c);
  }

  /// The component on its part of the grid: what is beyond that is its complement, and unbounded.
  BoxComplex alone(const Exact& e, int id) const {
    std::array<int, 3> from{};  // an open interval, as the last one is
    Axes at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Axis& all = set_.at()[k];
      from[k] = (e.first[k] - 1) / 2 * 2;
      const auto to = std::min(static_cast<std::size_t>(e.last[k]) / 2 + 1, all.size());
      at[k].assign(all.begin() + from[k] / 2, all.begin() + static_cast<std::ptrdiff_t>(to));
    }
    BoxComplex out(std::move(at));
    for (int z = 0; z < out.cells(2); ++z) {
      for (int y = 0; y < out.cells(1); ++y) {
        for (int x = 0; x < out.cells(0); ++x)
          out.set_mark(x, y, z, parts_.of(from[0] + x, from[1] + y, from[2] + z) == id);
      }
    }
    return out;
  }

  /// Whether the cell is an edge of a face that is in (or is not): then it adds nothing to the length of lines.
  bool borders_face(const std::array<int, 3>& cell, bool in) const {
    if (dimension(cell[0], cell[1], cell[2]) != 1) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k] % 2 == 0) continue;
      for (const int d : {-1, 1}) {
        std::array<int, 3> face = cell;
        face[k] += d;
        if ((set_.mark(face[0], face[1], face[2]) != 0) == in) return true;
      }
    }
    return false;
  }

  double scaled_size(Real value, int power) const {
    for (int k = 0; k < power; ++k) value *= step_;
    return value.to_double();
  }
  Place3 place(const RealVector& p) const {
    return {(p[0] * step_).to_double(), (p[1] * step_).to_double(), (p[2] * step_).to_double()};
  }
  std::optional<PlaceBox> box(const Exact& e) const {
    if (!e.bounded) return std::nullopt;
    RealVector low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval i = set_.interval(static_cast<int>(k), e.first[k], e.last[k]);
      low[k] = *i.from;
      high[k] = *i.to;
    }
    return PlaceBox{place(low), place(high)};
  }

  const BoxComplex& set_;
  const Real& step_;
  const BoxComplex open_, solid_, closed_, full_;  // interior, its closure; closure, its interior
  const Components parts_;
  Exact all_;
  std::vector<Exact> each_;  // of each component
  Real crack_area_, crack_length_;
  SpaceSummary out_;
};

}  // namespace

SpaceSummary summarize(const BoxComplex& set, const Real& step) {
  const BoxComplex least = set.simplified();
  return BoxSummarizer(least, step).run();
}

}  // namespace findspace::space
