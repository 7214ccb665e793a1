// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/box/box_topology.h"

#include <array>

#include "space/box/box_operations.h"

namespace findspace::space {
namespace {

/// Visits the cells whose closure holds the cell, itself included; true as soon as `visit` is.
template <class Visit>
bool star(const BoxComplex& set, int x, int y, int z, Visit visit) {
  const int rx = x % 2, ry = y % 2, rz = z % 2;
  for (int k = z - rz; k <= z + rz; ++k) {
    for (int j = y - ry; j <= y + ry; ++j) {
      for (int i = x - rx; i <= x + rx; ++i) {
        if (visit(set.mark(i, j, k))) return true;
      }
    }
  }
  return false;
}

}  // namespace

BoxComplex closure(const BoxComplex& set) {
  BoxComplex out = set;
  if (set.too_fine()) return out;
  for (int z = 0; z < set.cells(2); ++z) {
    for (int y = 0; y < set.cells(1); ++y) {
      for (int x = 0; x < set.cells(0); ++x) out.set_mark(x, y, z, star(set, x, y, z, [](Mark m) { return m != 0; }));
    }
  }
  return out;
}

BoxComplex complement(const BoxComplex& set) {
  return set.remarked([](Mark m) { return Mark(m == 0); });
}

BoxComplex interior(const BoxComplex& set) { return complement(closure(complement(set))); }

BoxComplex boundary(const BoxComplex& set) {
  const BoxComplex closed = closure(set), open = interior(set);
  return overlay(std::array<const BoxComplex*, 2>{&closed, &open},
                 [](std::span<const Mark> m) { return Mark(m[0] && !m[1]); });
}

BoxComplex regularized(const BoxComplex& set) { return closure(interior(set)); }

}  // namespace findspace::space
