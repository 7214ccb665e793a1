// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The affine maps by which files of meshes place one mesh several times. Guarantee: exact. Keywords: affine transform,
// node matrix, component.
#pragma once

#include <array>

#include "exact/number/real.h"

namespace findspace::io {

/// x' = (x, 1) . row: three rows of factors and a shift.
struct MeshTransform {
  std::array<std::array<exact::Real, 3>, 4> row{{{exact::Real(1), exact::Real(), exact::Real()},
                                                 {exact::Real(), exact::Real(1), exact::Real()},
                                                 {exact::Real(), exact::Real(), exact::Real(1)},
                                                 {exact::Real(), exact::Real(), exact::Real()}}};

  std::array<exact::Real, 3> apply(const std::array<exact::Real, 3>& p, bool place = true) const {
    std::array<exact::Real, 3> out;
    for (std::size_t k = 0; k < 3; ++k) {
      out[k] = p[0] * row[0][k] + p[1] * row[1][k] + p[2] * row[2][k];
      if (place) out[k] += row[3][k];
    }
    return out;
  }
  /// -1: it mirrors; 0: it flattens.
  int sense() const {
    const auto& [a, b, c, d] = row;
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))
        .sign();
  }
  /// First `inner`, then this.
  MeshTransform after(const MeshTransform& inner) const {
    MeshTransform out;
    for (std::size_t k = 0; k < 4; ++k) out.row[k] = apply(inner.row[k], k == 3);
    return out;
  }
};

}  // namespace findspace::io
