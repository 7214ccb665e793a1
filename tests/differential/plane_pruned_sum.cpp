// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of sets with arcs, or with corners off the grid, from the curves that are left without equal ones and without
// those in cells certainly inside, against the arrangement of the whole convolution: cell by cell. Large sums, which
// are made so anyway; and small ones full of ties, with cells whose borders lie on the same lattice.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "differential/whole_sum.h"
#include "plane/complex/extent.h"
#include "plane/offset/level.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/sum/sum_mask.h"

namespace findspace::plane {
namespace plane_pruned_sum {

using exact::Real;

Region star(std::mt19937& rng, int n, double size) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    const double r = (k % 2 ? 0.4 + 0.01 * double(rng() % 10) : 0.9 + 0.01 * double(rng() % 10)) * size;
    points.push_back(
        {std::llround(r * std::cos(6.283185307179586 * k / n)), std::llround(r * std::sin(6.283185307179586 * k / n))});
  }
  return ring(points);
}

/// {d <= level} of the set.
Region grown(const Region& set, const Real& level) {
  return remark(distance_map(set, level), [](Mark m) { return Mark(m <= 0); });
}

Region teeth(int n) {
  std::vector<GridPoint> points{{0, 0}, {400 * n, 0}};
  for (int k = n; k-- > 0;) points.insert(points.end(), {{400 * k + 300, 600}, {400 * k + 210, 200}});
  return ring(points);
}

void compare(const Region& a, const Region& b, const std::string& what) {
  expect_same(contact_map(a, b), -1, whole_sum(a, in, b), what);
  expect_same(containment_map(a, b), 1, whole_sum(a, out, b), what + ", contained");
}

TEST(PrunedSum, RoundedStars) {
  for (unsigned seed = 0; seed < 2; ++seed) {
    std::mt19937 rng(seed);
    const Region a = grown(star(rng, 80, 100'000), seed % 2 ? 100 : 20'000);
    compare(a, star(rng, 80, seed % 2 ? 100'000 : 60'000), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(PrunedSum, SumsThatRepeatTheirEdges) {
  const Region twice = minkowski_sum(teeth(4), teeth(3)), more = minkowski_sum(twice, teeth(5));
  compare(more, twice, "sums of teeth");
  compare(twice, more, "the larger one moves");
}

/// Sets with their corners and centres on a lattice: equal arcs, arcs that touch, holes that fit, slits and points.
class TiedSets {
 public:
  TiedSets(std::mt19937& rng, std::int64_t step, unsigned size) : rng_(rng), step_(step), size_(size) {}

  Region next() {
    std::vector<Region> parts;
    for (unsigned k = 1 + below(4); k > 0; --k) parts.push_back(shape());
    Region all = any_of(parts);
    switch (below(9)) {
      case 0:
        return grown(all, level());
      case 1:
        return shrunk(all);
      case 2:
        return shrunk(grown(all, step_));
      case 3:
        return without(std::move(all), line());
      case 4:
        return without(std::move(all), point());
      case 5:
        return without(std::move(all), interior(disc()));
      case 6:
        return interior(std::move(all));
      default:
        return all;
    }
  }

  /// Of sets that `moving` fits into exactly, at least where it stands.
  Region around(const Region& moving) {
    const Region outside = complement(interior(grown(moving, 10 * step_)));
    return complement(remark(contact_map(outside, mirrored(moving)), [](Mark m) { return Mark(m < 0); }));
  }

  unsigned below(unsigned n) { return unsigned(rng_() % n); }

 private:
  /// Of the lattice, or so little beside it that doubles do not show it.
  Real level() {
    const Real on(step_ * (1 + below(2)));
    const int beside = int(below(4));
    return beside < 2 ? on : on + Real::ratio(2 * beside - 5, std::int64_t(1) << 50);
  }
  std::int64_t place() { return step_ * below(size_); }
  GridPoint corner() { return {place(), place()}; }

  static Region any_of(const std::vector<Region>& sets) {
    std::vector<const Region*> all;
    for (const Region& s : sets) all.push_back(&s);
    return unite_arranged(all);
  }
  static Region without(const Region& set, const Region& less) {
    std::array<const Region*, 2> both{&set, &less};
    return subtract(both);
  }
  Region shrunk(const Region& set) const { return complement(interior(grown(complement(interior(set)), step_))); }

  Region box(std::int64_t width, std::int64_t height) {
    const auto [x, y] = corner();
    return ring({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
  }
  Region disc() {
    const auto [x, y] = corner();
    return region_of_disc(x, y, below(3) > 0 ? Real(step_ * (1 + below(3))) : Real::ratio(step_ * (1 + below(9)), 3));
  }
  Region line() {
    const auto [x, y] = corner();
    Contour c;
    c.push_back({.start = {x, y}});
    c.push_back({.start = {x + step_ * below(4), y + step_ * (1 + below(3))}});
    return region_of_chain(c);
  }
  Region point() {
    const GridPoint p = corner();
    return region_of_points(std::span(&p, 1));
  }
  /// A disc with a hole, into which other discs fit.
  Region washer() {
    const auto [x, y] = corner();
    const std::int64_t r = step_ * (1 + below(2));
    return without(region_of_disc(x, y, r + step_ * (1 + below(2))), interior(region_of_disc(x, y, r)));
  }
  Region shape() {
    switch (below(9)) {
      case 0:
      case 1:
        return box(step_ * (1 + below(size_ / 2)), step_ * (1 + below(size_ / 2)));
      case 2:
      case 3:
        return disc();
      case 4:
        return grown(box(step_ * (1 + below(size_)), step_ * (1 + below(size_))), level());
      case 5:
        return washer();
      case 6:
        return line();
      case 7:
        return point();
      default: {
        const auto [x, y] = corner();
        const std::int64_t s = step_;
        const Region tilted = ring({{x, y}, {x + 4 * s, y + 3 * s}, {x + s, y + 7 * s}, {x - 3 * s, y + 4 * s}});
        return below(2) > 0 ? tilted : grown(tilted, 5 * s);
      }
    }
  }

  std::mt19937& rng_;
  std::int64_t step_;
  unsigned size_;  // of the lattice
};

struct Counts {
  int sums = 0, masked = 0;
};

void compare(const Operand& a, const Operand& b, std::int64_t side, const std::string& what, Counts& counts) {
  const auto mask = mask_of_sum(a, b, side, 1e7);
  if (!mask) {
    EXPECT_TRUE(is_empty(b.cells)) << what;
    return;
  }
  const SignMap whole = sum_of_parts(a, b, nullptr);
  ++counts.sums;
  const SignMap pruned = sum_of_parts(a, b, &*mask);
  EXPECT_TRUE(same_marks(whole, pruned)) << what;
  const auto box = extent(whole);
  bool any = false;
  for (std::int64_t row = box ? mask->line_of(box->y0) : 0; box && !any && row <= mask->line_of(box->y1); ++row)
    for (std::int64_t c = mask->line_of(box->x0); !any && c <= mask->line_of(box->x1); ++c)
      any = mask->depth(c, row) > 0;
  counts.masked += any;
}

/// All sums of one seed.
void compare_tied(unsigned seed, Counts& counts) {
  std::mt19937 rng(seed);
  constexpr std::array<std::int64_t, 4> kSteps{60, 210, 1'000'003, std::int64_t(1) << 28};
  const std::int64_t step = kSteps[rng() % kSteps.size()];
  const std::int64_t side = std::max<std::int64_t>(step / (1 + rng() % 5) + rng() % 2, 10);
  TiedSets sets(rng, step, 3 + unsigned(rng() % 5));
  const Region a = sets.next(), b = sets.next();
  const std::string name = "seed " + std::to_string(seed);
  if (is_bounded(b)) {
    compare({a, is_in}, {b, is_in, true}, side, name + ", contact", counts);
    compare({a, is_out, false, false}, {b, is_in, true}, side, name + ", containment", counts);
    if (seed % 4 == 0) {
      const Region slot = sets.around(b);
      compare({slot, is_out, false, false}, {b, is_in, true}, side, name + ", containment where it fits", counts);
    }
  }
  compare({b, is_in, true}, {a, is_in}, side, name + ", the other moves", counts);
}

TEST(PrunedSum, SmallSumsFullOfTies) {
  Counts counts;
  for (unsigned seed = 0; seed < 150; ++seed) compare_tied(seed, counts);
  EXPECT_GT(counts.masked, counts.sums / 2);
}

}  // namespace plane_pruned_sum
}  // namespace findspace::plane
