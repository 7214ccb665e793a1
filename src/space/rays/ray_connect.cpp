// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_connect.h"

#include <algorithm>
#include <tuple>

namespace findspace::space {
namespace {

/// Stretches of a splinter: as many as lines meet a cube of two steps.
constexpr int kMostOfSplinter = 27;

std::size_t next(int axis, int by) { return static_cast<std::size_t>((axis + by) % 3); }

/// Where the stretch is, its line going through the lattice point.
std::array<std::array<double, 2>, 3> box_of(const RayLattice& lattice, const Stretch& s, int axis,
                                            const std::array<int, 3>& p) {
  std::array<std::array<double, 2>, 3> box{};
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<double>(lattice.at(k, p[static_cast<std::size_t>(k)]));
    box[static_cast<std::size_t>(k)] = {at, at};
  }
  box[static_cast<std::size_t>(axis)] = {s.from, s.to};
  return box;
}

/// Calls visit(axis, lattice point) for the edges of the four cells about the edge from p along the axis, p the first
/// point of each; some may be beyond the lattice.
template <class Visit>
void each_edge_about(int axis, const std::array<int, 3>& p, Visit visit) {
  const std::size_t u = next(axis, 1), v = next(axis, 2);
  std::array<int, 3> q = p;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      q[u] = p[u] + i;
      q[v] = p[v] + j;
      visit(axis, q);
    }
  }
  for (const auto& [along, across] : {std::pair(u, v), std::pair(v, u)}) {
    for (int i = -1; i <= 0; ++i) {
      for (int j = -1; j <= 1; ++j) {
        for (int k = 0; k <= 1; ++k) {
          q = p;
          q[along] += i;
          q[across] += j;
          q[static_cast<std::size_t>(axis)] += k;
          visit(static_cast<int>(along), q);
        }
      }
    }
  }
}

}  // namespace

Connector::Connector(const RayLattice& lattice, std::array<Lines, 3>& lines) : lattice_(lattice), lines_(lines) {
  int base = 0;
  for (Lines& axis : lines_) {
    axis.base = base;
    base += static_cast<int>(axis.stretches.size());
  }
  for (int k = 0; k < base; ++k) {
    crossing_.add();
    near_.add();
  }
}

std::size_t Connector::line_of(int axis, const std::array<int, 3>& p) const {
  const std::size_t u = next(axis, 1), v = next(axis, 2);
  return static_cast<std::size_t>(p[v]) * static_cast<std::size_t>(lattice_.count[u]) + static_cast<std::size_t>(p[u]);
}

std::optional<int> Connector::at(const std::array<int, 3>& p) const {
  const Lines& x = lines_[0];
  const std::size_t k = line_of(0, p);
  const auto line = x.line(k);
  const auto found = std::partition_point(line.begin(), line.end(), [&](const Stretch& s) { return s.last < p[0]; });
  if (found == line.end() || found->first > p[0]) return std::nullopt;
  return x.base + static_cast<int>(x.first[k] + static_cast<std::size_t>(found - line.begin()));
}

void Connector::cross() {
  for (int axis = 1; axis < 3; ++axis) {
    each(axis, [&](const Stretch& s, int number, std::array<int, 3> p) {
      for (int k = s.first; k <= s.last; ++k) {
        p[static_cast<std::size_t>(axis)] = k;
        const std::optional<int> other = at(p);
        if (!other) continue;  // maps that a search tells differ within their error
        crossing_.join(number, *other);
        near_.join(number, *other);
      }
    });
  }
}

void Connector::overlap() {
  for (const Lines& axis : lines_) {
    const auto across = static_cast<std::size_t>(lattice_.count[next(static_cast<int>(&axis - lines_.data()), 1)]);
    for (std::size_t line = 0; line + 1 < axis.first.size(); ++line) {
      if (line % across != 0) join_lines(axis, line, line - 1);
      if (line >= across) join_lines(axis, line, line - across);
    }
  }
}

void Connector::join_lines(const Lines& axis, std::size_t a, std::size_t b) {
  const auto p = axis.line(a), q = axis.line(b);
  for (std::size_t i = 0, j = 0; i < p.size() && j < q.size();) {
    if (p[i].from <= q[j].to && q[j].from <= p[i].to)
      near_.join(axis.base + static_cast<int>(axis.first[a] + i), axis.base + static_cast<int>(axis.first[b] + j));
    p[i].to < q[j].to ? ++i : ++j;
  }
}

std::vector<char> Connector::large_sets() {
  std::vector<int> count(near_.size());
  for (int k = 0; k < static_cast<int>(count.size()); ++k) ++count[static_cast<std::size_t>(near_.find(k))];
  std::vector<char> large;
  for (const int c : count) large.push_back(c > kMostOfSplinter);
  return large;
}

void Connector::joins_of(const Stretch& s, int number, int axis, std::array<int, 3> p, std::vector<Join>& out) const {
  const auto box = box_of(lattice_, s, axis, p);
  const auto at_edge = [&](int along, const std::array<int, 3>& q) {
    const std::size_t u = next(along, 1), v = next(along, 2);
    if (q[u] < 0 || q[v] < 0 || q[u] >= lattice_.count[u] || q[v] >= lattice_.count[v]) return;
    const Lines& lines = lines_[static_cast<std::size_t>(along)];
    const std::size_t line = line_of(along, q);
    const auto on = lines.line(line);
    const int edge = q[static_cast<std::size_t>(along)];
    auto other = std::partition_point(on.begin(), on.end(), [&](const Stretch& t) { return t.last < edge; });
    for (; other != on.end() && other->first - 1 <= edge; ++other) {
      const auto that = box_of(lattice_, *other, along, q);
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double gap = std::max({0.0, that[k][0] - box[k][1], box[k][0] - that[k][1]});
        square += gap * gap;
      }
      const int b = lines.base + static_cast<int>(lines.first[line] + static_cast<std::size_t>(other - on.begin()));
      if (b != number) out.push_back({square, number, b});
    }
  };
  for (int k = s.first - 1; k <= s.last; ++k) {
    p[static_cast<std::size_t>(axis)] = k;
    each_edge_about(axis, p, at_edge);
  }
}

void Connector::gather() {
  std::vector<char> large = large_sets();
  std::vector<Join> joins;
  for (int axis = 0; axis < 3; ++axis) {
    each(axis, [&](const Stretch& s, int number, const std::array<int, 3>& p) {
      if (!large[static_cast<std::size_t>(near_.find(number))]) joins_of(s, number, axis, p, joins);
    });
  }
  std::sort(joins.begin(), joins.end(),
            [](const Join& a, const Join& b) { return std::tie(a.square, a.a, a.b) < std::tie(b.square, b.a, b.b); });
  for (const Join& join : joins) {
    const int a = near_.find(join.a), b = near_.find(join.b);
    const char one = large[static_cast<std::size_t>(a)], other = large[static_cast<std::size_t>(b)];
    if (a == b || (one && other)) continue;
    near_.join(a, b);
    large[static_cast<std::size_t>(near_.find(a))] = one || other;
  }
}

}  // namespace findspace::space
