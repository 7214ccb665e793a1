// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the benchmarks measure on: simple polygons with integer vertices, counter-clockwise, without collinear or
// repeated vertices, |coordinate| < 2^24, so that every rival runs in its fastest number type. Generated ones are the
// same in every run.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bench {

struct Point {
  std::int64_t x = 0, y = 0;
};
using Polygon = std::vector<Point>;

/// n vertices, every other one drawn in, on an inner circle: jagged, its sums have many more crossings than vertices.
Polygon star(int n, unsigned seed);
/// A spine with about n/4 teeth of uneven length, rotated by `degrees`.
Polygon comb(int n, unsigned seed, double degrees);
/// A wavy closed curve of four low frequencies, sampled: flat angles, about ten inlets.
Polygon smooth(int n, unsigned seed);
/// `count` stars of 10 vertices over a square, so that about `depth` of them cover a place.
std::vector<Polygon> litter(int count, double depth, unsigned seed);
/// The outer rings of a nesting instance (tests/data/nesting), to 1/1000 of its unit.
std::vector<Polygon> nesting(const std::string& instance);

/// The polygon reflected through the origin.
Polygon mirrored(const Polygon& polygon);

}  // namespace bench
