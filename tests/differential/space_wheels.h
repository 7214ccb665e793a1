// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Non-convex meshes about the z axis: a torus and a gear, with vertices on the grid.
#pragma once

#include <cmath>

#include "space/convolution/ray_body.h"

namespace findspace::space {

inline Point on_grid(double x, double y, double z) { return {std::llround(x), std::llround(y), std::llround(z)}; }

/// 2 * around * across triangles.
inline Triangles torus(double radius, double tube, int around, int across) {
  Triangles t;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * (k + 0.5 * (i % 2)) / across;
      const double r = radius + tube * std::cos(v);
      t.points.push_back(on_grid(r * std::cos(u), r * std::sin(u), tube * std::sin(v)));
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const int a = i * across + k, b = (i + 1) % around * across + k, next = (k + 1) % across;
      const int c = (i + 1) % around * across + next, d = i * across + next;
      t.faces.push_back({a, b, c});
      t.faces.push_back({a, c, d});
    }
  }
  return t;
}

/// A prism of `teeth` teeth, star-shaped about the axis.
inline Triangles gear(int teeth, double inner, double outer, double height) {
  Triangles t;
  const int n = 2 * teeth;
  for (const double z : {0.0, height}) {
    t.points.push_back(on_grid(0, 0, z));
    for (int k = 0; k < n; ++k) {
      const double r = k % 2 ? outer : inner, u = M_PI * k / teeth;
      t.points.push_back(on_grid(r * std::cos(u), r * std::sin(u), z));
    }
  }
  for (int k = 0; k < n; ++k) {
    const int a = 1 + k, b = 1 + (k + 1) % n, c = a + n + 1, d = b + n + 1;
    t.faces.push_back({0, b, a});
    t.faces.push_back({n + 1, c, d});
    t.faces.push_back({a, b, d});
    t.faces.push_back({a, d, c});
  }
  return t;
}

}  // namespace findspace::space
