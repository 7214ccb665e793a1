// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_surface.h"

#include <algorithm>
#include <unordered_map>

namespace findspace::space {
namespace {

using exact::Fraction;

/// The corners of a cube's six faces, counter-clockwise seen from outside; corner c has x = c & 1, y = c >> 1 & 1, z =
/// c >> 2.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

class Marching {
 public:
  explicit Marching(const RayLattice& lattice) : lattice_(lattice) {
    for (int k = 0; k < 3; ++k) size_[k] = lattice.count[k] + 2;  // a layer outside all around
    inside_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], false);
  }

  void scan(const RaySource& rays, int axis, const std::function<bool(std::int8_t)>& inside,
            const std::function<void(const RayGrid&, const RayRow&)>& watch) {
    const RayGrid& grid = rays.grid();
    each_row(rays, [&](int j, RayRow&& row) {
      for (int i = 0; i < grid.nu; ++i) scan_line(row, i, j, axis, inside);
      if (watch) watch(grid, row);
    });
  }

  RaySurface run() {
    for (int z = 0; z + 1 < size_[2]; ++z) {
      for (int y = 0; y + 1 < size_[1]; ++y) {
        for (int x = 0; x + 1 < size_[0]; ++x) cube({x, y, z});
      }
    }
    return std::move(surface_);
  }

 private:
  using Index = std::array<int, 3>;

  std::size_t number(const Index& c) const {
    return (static_cast<std::size_t>(c[2]) * size_[1] + c[1]) * size_[0] + c[0];
  }

  void scan_line(const RayRow& row, int i, int j, int axis, const std::function<bool(std::int8_t)>& inside) {
    Index c{};
    c[(axis + 1) % 3] = i + 1;
    c[(axis + 2) % 3] = j + 1;
    const double half = static_cast<double>(lattice_.step) / 2;
    const auto corner = [&](int k) { return static_cast<double>(lattice_.at(axis, k)); };
    int e = row.first[i];
    bool now = inside(row.before[i]), before = false;  // just before what comes, and at the corner before
    for (int k = 0; k < lattice_.count[axis]; ++k) {
      RayPosition at;
      at.exact = {lattice_.at(axis, k), 1};
      at.value = corner(k);
      double change = k == 0 ? corner(0) - half : corner(k);
      bool changed = k == 0;
      const auto note = [&](bool value, double where) {
        if (!changed && value != before) change = where;
        changed = changed || value != before;
      };
      if (k > 0) note(now, corner(k - 1));
      int order = 1;
      for (; e < row.first[i + 1] && (order = compare_positions(row.events[e].at, at)) < 0; ++e) {
        note(inside(row.events[e].here), row.events[e].at.value);
        now = inside(row.events[e].after);
        note(now, row.events[e].at.value);
      }
      bool here = now;
      if (e < row.first[i + 1] && order == 0) {
        here = inside(row.events[e].here);
        now = inside(row.events[e++].after);
      }
      c[axis] = k + 1;
      if (axis == 0)
        inside_[number(c)] = here;
      else  // maps that a search tells differ within their error
        here = inside_[number(c)];
      if (here != before) add_vertex(c, axis, change, here);
      before = here;
    }
    c[axis] = lattice_.count[axis] + 1;
    if (before) add_vertex(c, axis, corner(lattice_.count[axis] - 1) + half, false);
  }

  /// The vertex on the lattice edge that ends in corner c, along `axis`.
  void add_vertex(const Index& c, int axis, double at, bool enters) {
    std::array<double, 3> p{};
    const auto parts = static_cast<double>(lattice_.parts);
    for (int k = 0; k < 3; ++k) p[k] = (k == axis ? at : static_cast<double>(lattice_.at(k, c[k] - 1))) / parts;
    vertex_[number(c) * 3 + axis] = static_cast<int>(surface_.vertices.size());
    surface_.vertices.push_back(p);
    Index inside{c[0] - 1, c[1] - 1, c[2] - 1};
    if (!enters) --inside[axis];
    surface_.inside.push_back(inside);
  }

  /// The vertex between two corners of the cube at `low`.
  int vertex(const Index& low, int a, int b) const {
    const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2, high = a | b;
    const Index c{low[0] + (high & 1), low[1] + (high >> 1 & 1), low[2] + (high >> 2)};
    return vertex_.at(number(c) * 3 + axis);
  }

  void cube(const Index& low) {
    int in = 0;
    for (int c = 0; c < 8; ++c) {
      if (inside_[number({low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2)})]) in |= 1 << c;
    }
    if (in == 0 || in == 255) return;
    // On every face each run of inside corners is parted from the rest by a segment, from where it begins to where it
    // ends.
    std::vector<std::pair<int, int>> segments;
    for (const auto& face : kFaces) {
      for (int k = 0; k < 4; ++k) {
        const int before = face[k], first = face[(k + 1) % 4];
        if ((in >> before & 1) != 0 || (in >> first & 1) == 0) continue;
        int m = k + 1;
        while ((in >> face[(m + 1) % 4] & 1) != 0) ++m;
        segments.emplace_back(vertex(low, before, first), vertex(low, face[m % 4], face[(m + 1) % 4]));
      }
    }
    while (!segments.empty()) {
      std::vector<int> loop{segments.back().first};
      int next = segments.back().second;
      segments.pop_back();
      while (next != loop[0]) {
        loop.push_back(next);
        const auto s = std::find_if(segments.begin(), segments.end(), [&](const auto& p) { return p.first == next; });
        next = s->second;
        segments.erase(s);
      }
      for (std::size_t k = 1; k + 1 < loop.size(); ++k) surface_.faces.push_back({loop[0], loop[k], loop[k + 1]});
    }
  }

  const RayLattice& lattice_;
  Index size_{};
  std::vector<bool> inside_;
  std::unordered_map<std::size_t, int> vertex_;
  RaySurface surface_;
};

}  // namespace

RayGrid RayLattice::grid(int axis) const {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  return {axis, parts, component(origin, a), component(origin, b), step, step, count[a], count[b]};
}

namespace {

/// Cubes like the cells of a grid, from half a cube before the box on.
RayLattice lattice_of(const Point& low, const Point& size, const RayGrid& even) {
  RayLattice lattice;
  lattice.parts = even.parts;
  lattice.step = even.du;
  lattice.origin = {low.x * even.parts - even.du / 2, low.y * even.parts - even.du / 2,
                    low.z * even.parts - even.du / 2};
  for (int k = 0; k < 3; ++k) lattice.count[k] = static_cast<int>(component(size, k) * even.parts / even.du) + 3;
  return lattice;
}

/// The axis of lines whose first coordinate across is the longest.
int across_longest(const Point& size) {
  const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return (longest + 2) % 3;
}

}  // namespace

RayLattice ray_lattice(const Point& low, const Point& high, int n) {
  const Point size = high - low;
  return lattice_of(low, size, ray_grid(low, high, across_longest(size), n));
}

RayLattice ray_lattice_by_step(const Point& low, const Point& high, std::int64_t step) {
  const Point size = high - low;
  return lattice_of(low, size, ray_grid_by_step(low, high, across_longest(size), step));
}

RaySurface ray_surface(const RayLattice& lattice, const std::function<std::unique_ptr<RaySource>(int axis)>& source,
                       const std::function<bool(std::int8_t)>& inside,
                       const std::function<void(const RayGrid&, const RayRow&)>& watch) {
  Marching marching(lattice);
  for (int axis = 0; axis < 3; ++axis) marching.scan(*source(axis), axis, inside, watch);
  return marching.run();
}

}  // namespace findspace::space
