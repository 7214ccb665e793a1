// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Knobbly balls: meshes of 8 n^2 triangles, star-shaped about the origin, with vertices on the grid; and whether a
// place lies in one, by the tetrahedra over its faces.
#pragma once

#include <cmath>
#include <map>
#include <random>

#include "space/body/body.h"
#include "space/mesh/mesh.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

/// Of radius between `radius` and half as much again.
inline Mesh knobbly_ball(int n, std::int64_t radius, unsigned seed) {
  std::mt19937 engine(seed);
  Mesh mesh;
  std::map<std::array<int, 3>, int> at;
  const auto vertex = [&](std::array<int, 3> c) {
    const auto [it, fresh] = at.emplace(c, static_cast<int>(mesh.vertices.size()));
    if (fresh) {
      const double size = std::sqrt(double(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]));
      const double r = static_cast<double>(radius) * (1 + static_cast<double>(engine() % 512) / 1024) / size;
      mesh.vertices.push_back({std::llround(r * c[0]), std::llround(r * c[1]), std::llround(r * c[2])});
    }
    return it->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    const auto corner = [&](int i, int j) { return vertex({sx * i, sy * j, sz * (n - i - j)}); };
    const auto face = [&](int a, int b, int c) {
      mesh.faces.push_back(sx * sy * sz > 0 ? std::vector{a, b, c} : std::vector{a, c, b});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        face(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < n) face(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
    }
  }
  return mesh;
}

inline Body body_of(const Mesh& mesh) {
  plane::Shape shape;
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.mesh = mesh;
  shape.solid = std::make_shared<const Solid>(std::move(solid));
  return body(shape);
}

/// 1 inside, 0 on the surface, -1 outside; by the sign in each tetrahedron of the origin and a face.
inline int side_of_star(const Mesh& mesh, const RealVector& p) {
  int best = -1;
  for (const auto& face : mesh.faces) {
    const RealVector a = real(mesh.vertices[static_cast<std::size_t>(face[0])]),
                     b = real(mesh.vertices[static_cast<std::size_t>(face[1])]),
                     c = real(mesh.vertices[static_cast<std::size_t>(face[2])]);
    if (dot(cross(a, b), p).sign() < 0 || dot(cross(b, c), p).sign() < 0 || dot(cross(c, a), p).sign() < 0) continue;
    best = std::max(best, -dot(cross(minus(b, a), minus(c, a)), minus(p, a)).sign());
  }
  return best;
}

}  // namespace findspace::space
