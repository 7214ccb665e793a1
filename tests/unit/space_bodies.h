// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Small solids for tests: boxes as shapes and bodies, random unions of boxes, and lattices.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <random>
#include <vector>

#include "space/body/body.h"
#include "space/box/box_complex.h"

namespace findspace::space {

using Corners = std::array<std::array<std::int64_t, 3>, 2>;  // low, high

inline Polytope box_polytope(const Corners& c) {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.push_back({c[i & 1][0], c[i >> 1 & 1][1], c[i >> 2 & 1][2]});
  return Polytope::hull(points);
}

inline Body box_body(const std::vector<Corners>& boxes) {
  Body body;
  for (const Corners& c : boxes) body.parts.push_back({box_polytope(c), {}, exact::Real()});
  return body;
}

inline BoxComplex box_set(const std::vector<Corners>& boxes) {
  std::vector<IntervalBox> all;
  for (const Corners& c : boxes) {
    IntervalBox box;
    for (std::size_t k = 0; k < 3; ++k) box[k] = {exact::Real(c[0][k]), exact::Real(c[1][k]), true, true};
    all.push_back(box);
  }
  return BoxComplex::of_boxes(all);
}

inline std::shared_ptr<const Body> shared(Body body) { return std::make_shared<const Body>(std::move(body)); }

inline RealVector place(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t over = 1) {
  return {exact::Real::ratio(x, over), exact::Real::ratio(y, over), exact::Real::ratio(z, over)};
}

/// Two to `most` boxes within [0, size]^3 that are often neighbours: L and U shapes, rooms with slits of one unit.
inline std::vector<Corners> random_boxes(std::mt19937& random, int most, std::int64_t size) {
  const auto pick = [&](std::int64_t a, std::int64_t b) {
    return std::uniform_int_distribution<std::int64_t>(a, b)(random);
  };
  std::vector<Corners> boxes;
  const auto count = pick(1, most);
  for (std::int64_t i = 0; i < count; ++i) {
    Corners c{};
    for (std::size_t k = 0; k < 3; ++k) {
      c[0][k] = pick(0, size - 1);
      c[1][k] = pick(c[0][k] + 1, size);
    }
    boxes.push_back(c);
  }
  return boxes;
}

}  // namespace findspace::space
