// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/unreduced_lines.h"

#include <algorithm>
#include <array>

#include "exact/number/primitive.h"
#include "exact/planar/geometry_stages.h"

namespace findspace::exact {
namespace {

/// `factor` divides k.
int128 exact_quotient(int128 k, std::int64_t factor) {
  const std::int64_t narrow = std::int64_t(k);
  return narrow == k ? int128(narrow / factor) : k / factor;
}

void reduce(SupportingCurve& line, const Normal& primitive) {
  if (line.a == primitive.a && line.b == primitive.b) return;
  line.c = exact_quotient(line.c, primitive.a != 0 ? line.a / primitive.a : line.b / primitive.b);
  line.a = primitive.a;
  line.b = primitive.b;
}

}  // namespace

void reduce_lines(Geometry& geometry, std::span<const std::uint32_t> lines, std::span<const std::uint32_t> crossings) {
  std::array<Normal, 16> normals;
  while (!lines.empty()) {
    const std::size_t some = std::min(lines.size(), normals.size());
    for (std::size_t k = 0; k < some; ++k) {
      const SupportingCurve& line = geometry.supporting_curves[lines[k]];
      normals[k] = {line.a, line.b};
    }
    make_primitive({normals.data(), some});
    for (std::size_t k = 0; k < some; ++k) {
      SupportingCurve& line = geometry.supporting_curves[lines[k]];
      reduce(line, normals[k]);
      set_line_filter(line);
    }
    lines = lines.subspan(some);
  }
  for (const std::uint32_t k : crossings) {
    Point& p = geometry.points[k];
    p = geometry.crossing(p.i, p.j, p.root);
  }
}

}  // namespace findspace::exact
