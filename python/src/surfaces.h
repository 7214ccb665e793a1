// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces as numpy has them: vertices of shape (n, 3), triangles of shape (m, 3), as trimesh and others take them.
#pragma once

#include "arrays.h"
#include "findspace/surface.h"

namespace findspace::python {

inline Array vertices_of(const Surface& surface) {
  Array out({py::ssize_t(surface.vertices.size()), py::ssize_t(3)});
  double* to = out.mutable_data();
  for (const Position3& v : surface.vertices) to = std::copy(v.begin(), v.end(), to);
  return out;
}

/// Faces about their first corner; they are convex.
inline Indices triangles_of(const Surface& surface) {
  std::size_t count = 0;
  for (const auto& face : surface.faces) count += face.size() < 3 ? 0 : face.size() - 2;
  Indices out({py::ssize_t(count), py::ssize_t(3)});
  std::int32_t* to = out.mutable_data();
  for (const auto& face : surface.faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      *to++ = face[0];
      *to++ = face[k - 1];
      *to++ = face[k];
    }
  return out;
}

}  // namespace findspace::python
