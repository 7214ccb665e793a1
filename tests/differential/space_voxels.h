// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids made of unit cells under a linear map: their surfaces as triangles, and the same solids as convex cells, which
// give an independent exact oracle. On the lattice every contact is degenerate; under general maps hardly any.
#pragma once

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "space/body/body.h"
#include "space/convolution/ray_body.h"
#include "space/phi/phi_union.h"

namespace findspace::space {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

struct LinearMap {
  std::int64_t m[3][3];
  Point operator()(const Cell& c) const {
    return {m[0][0] * c[0] + m[0][1] * c[1] + m[0][2] * c[2], m[1][0] * c[0] + m[1][1] * c[1] + m[1][2] * c[2],
            m[2][0] * c[0] + m[2][1] * c[1] + m[2][2] * c[2]};
  }
};

inline LinearMap stretch(std::int64_t k) { return {{{k, 0, 0}, {0, k, 0}, {0, 0, k}}}; }

/// The cells of a drawing: layers of rows of characters, '#' for a cell.
inline Cells drawn(const std::vector<std::vector<std::string>>& layers) {
  Cells cells;
  for (int z = 0; z < static_cast<int>(layers.size()); ++z) {
    for (int y = 0; y < static_cast<int>(layers[z].size()); ++y) {
      for (int x = 0; x < static_cast<int>(layers[z][y].size()); ++x) {
        if (layers[z][y][x] == '#') cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

inline Cells extruded(const std::vector<std::string>& layer, int height) {
  return drawn(std::vector<std::vector<std::string>>(static_cast<std::size_t>(height), layer));
}

/// The boundary, outward. The map has a positive determinant.
inline Triangles surface(const Cells& cells, const LinearMap& map) {
  Triangles t;
  std::map<Cell, int> index;
  const auto vertex = [&](const Cell& c) {
    const auto [at, fresh] = index.emplace(c, static_cast<int>(t.points.size()));
    if (fresh) t.points.push_back(map(c));
    return at->second;
  };
  for (const Cell& c : cells) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell next = c;
        next[axis] += side ? 1 : -1;
        if (cells.contains(next)) continue;
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        Cell p = c;
        p[axis] += side;
        Cell q = p, r = p, s = p;
        q[a] += 1;
        r[a] += 1;
        r[b] += 1;
        s[b] += 1;
        if (!side) std::swap(q, s);
        t.faces.push_back({vertex(p), vertex(q), vertex(r)});
        t.faces.push_back({vertex(p), vertex(r), vertex(s)});
      }
    }
  }
  return t;
}

inline std::vector<Polytope> parts_of(const Cells& cells, const LinearMap& map) {
  std::vector<Polytope> result;
  for (const Cell& c : cells) {
    std::vector<Point> corners;
    for (int k = 0; k < 8; ++k) corners.push_back(map({c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)}));
    result.push_back(Polytope::hull(corners));
  }
  return result;
}

inline Body body_of(const Cells& cells, const LinearMap& map) {
  Body body;
  for (Polytope& p : parts_of(cells, map)) body.parts.push_back({std::move(p), {}, exact::Real()});
  return body;
}

/// Cells grown at random; connected over faces.
inline Cells random_cells(std::mt19937& random, int count, int size) {
  Cells cells{{size / 2, size / 2, size / 2}};
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  while (static_cast<int>(cells.size()) < count) {
    Cell c = *std::next(cells.begin(), pick(static_cast<int>(cells.size())));
    c[pick(3)] += pick(2) ? 1 : -1;
    if (c[0] >= 0 && c[1] >= 0 && c[2] >= 0 && c[0] < size && c[1] < size && c[2] < size) cells.insert(c);
  }
  return cells;
}

/// A box of cells about `inner`, `margin` wider, less its cells.
inline Cells around(const Cells& inner, int margin) {
  Cell low = *inner.begin(), high = low;
  for (const Cell& c : inner) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], c[k]);
      high[k] = std::max(high[k], c[k]);
    }
  }
  Cells cells;
  for (int x = low[0] - margin; x <= high[0] + margin; ++x) {
    for (int y = low[1] - margin; y <= high[1] + margin; ++y) {
      for (int z = low[2] - margin; z <= high[2] + margin; ++z) {
        if (!inner.contains({x, y, z})) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

}  // namespace findspace::space
