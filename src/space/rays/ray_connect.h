// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which intervals of the lines of a lattice belong together: sets of stretches, in two ways. Internal to ray_axes.
//   crossing   stretches that share a lattice point of the region: certainly connected;
//   near       those, stretches of neighbouring lines that overlap, and splinters: sets of few stretches (where the
//              region thins out to an edge, or is a slanted surface) go with the nearest stretch on the cells about
//              them. Larger sets are never joined by splinters.
// Cost: the lattice points in the region; for a splinter the 33 edges of the cells about it, a binary search on each.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "space/rays/ray_surface.h"

namespace findspace::space {

/// Disjoint sets of numbers.
class Sets {
 public:
  int add() {
    root_.push_back(static_cast<int>(root_.size()));
    return root_.back();
  }
  int find(int k) {
    while (root_[static_cast<std::size_t>(k)] != k)
      k = root_[static_cast<std::size_t>(k)] = root_[static_cast<std::size_t>(root_[static_cast<std::size_t>(k)])];
    return k;
  }
  void join(int a, int b) {
    a = find(a);
    b = find(b);
    root_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::size_t size() const { return root_.size(); }

 private:
  std::vector<int> root_;
};

struct Stretch {  // in parts of grid steps
  double from = 0, to = 0;
  int first = 0, last = -1;  // the lattice points on it
};

/// The intervals of the lines of one axis.
struct Lines {
  std::vector<Stretch> stretches;
  std::vector<std::size_t> first{0};  // of each line; the line (i, j) has number j * nu + i
  int base = 0;                       // the number of the first stretch among those of all axes

  std::span<const Stretch> line(std::size_t k) const { return {stretches.data() + first[k], first[k + 1] - first[k]}; }
};

class Connector {
 public:
  Connector(const RayLattice& lattice, std::array<Lines, 3>& lines);

  /// The number of the stretch along x that holds a lattice point; nothing where none does.
  std::optional<int> at(const std::array<int, 3>& p) const;

  /// In this order.
  void cross();
  void overlap();
  void gather();

  Sets& crossing() { return crossing_; }
  Sets& near() { return near_; }

  /// Calls visit(stretch, its number, a lattice point on its line).
  template <class Visit>
  void each(int axis, Visit visit) const {
    const Lines& lines = lines_[static_cast<std::size_t>(axis)];
    const auto a = static_cast<std::size_t>(axis);
    const auto across = static_cast<std::size_t>(lattice_.count[(a + 1) % 3]);
    for (std::size_t line = 0; line + 1 < lines.first.size(); ++line) {
      std::array<int, 3> p{};
      p[(a + 1) % 3] = static_cast<int>(line % across);
      p[(a + 2) % 3] = static_cast<int>(line / across);
      for (std::size_t s = lines.first[line]; s < lines.first[line + 1]; ++s)
        visit(lines.stretches[s], lines.base + static_cast<int>(s), p);
    }
  }

 private:
  struct Join {
    double square;
    int a, b;
  };

  std::size_t line_of(int axis, const std::array<int, 3>& p) const;
  void join_lines(const Lines& axis, std::size_t a, std::size_t b);
  /// Of each set of near(), by the number of its root: whether it is not a splinter.
  std::vector<char> large_sets();
  void joins_of(const Stretch& s, int number, int axis, std::array<int, 3> p, std::vector<Join>& out) const;

  const RayLattice& lattice_;
  std::array<Lines, 3>& lines_;
  Sets crossing_, near_;
};

}  // namespace findspace::space
