// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Clipper 6 (libpolyclipping), the fastest inexact way to a Minkowski sum: it rounds crossings to integers. Two ways,
// of which the better one counts per input: the cycles of the signed convolution united with non-zero fill; and sums of
// convex parts, united by halves.
#include <algorithm>
#include <polyclipping/clipper.hpp>

#include "contenders.h"
#include "convolution.h"

namespace bench {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

Path path(const Polygon& polygon) {
  Path p;
  p.reserve(polygon.size());
  for (const Point& q : polygon) p.emplace_back(q.x, q.y);
  return p;
}

Paths united(const Paths& paths) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  Paths result;
  clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return result;
}

Paths united_by_halves(const std::vector<Path>& paths, std::size_t from, std::size_t to) {
  constexpr std::size_t kAtOnce = 8;
  if (to - from <= kAtOnce)
    return united(Paths(paths.begin() + std::ptrdiff_t(from), paths.begin() + std::ptrdiff_t(to)));
  std::size_t middle = (from + to) / 2;
  Paths both = united_by_halves(paths, from, middle);
  Paths right = united_by_halves(paths, middle, to);
  both.insert(both.end(), right.begin(), right.end());
  return united(both);
}

std::size_t vertices(const Paths& paths) {
  std::size_t n = 0;
  for (const Path& p : paths) n += p.size();
  return n;
}

std::size_t sum_by_cycles(const Polygon& a, const Polygon& b) {
  Paths cycles;
  for (const Polygon& cycle : convolution_cycles(a, mirrored(b))) cycles.push_back(path(cycle));
  return vertices(united(cycles));
}

std::size_t sum_by_parts(const Polygon& a, const Polygon& b) {
  std::vector<Polygon> parts_a = convex_parts(a), parts_b = convex_parts(mirrored(b));
  std::vector<Path> sums;
  for (const Polygon& p : parts_a) {
    for (const Polygon& q : parts_b) sums.push_back(path(convex_sum(p, q)));
  }
  return vertices(united_by_halves(sums, 0, sums.size()));
}

std::size_t unite(const std::vector<Polygon>& all) {
  Paths paths;
  for (const Polygon& p : all) paths.push_back(path(p));
  return vertices(united(paths));
}

}  // namespace

std::vector<Contender> clipper_rivals() {
  return {{.name = "Clipper, cycles", .sum = sum_by_cycles, .offset = {}, .unite = unite},
          {.name = "Clipper, convex parts", .sum = sum_by_parts, .offset = {}, .unite = {}}};
}

}  // namespace bench
