// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Ray maps of non-convex solids against the union of the Phi-functions of their convex cells: at every event, in every
// cell of every line, and at random heights. Lines run through the lattice itself (edges, walls, exact fits), beside
// it, and at random.
#include <gtest/gtest.h>

#include <cmath>

#include "space/convolution/ray_pair.h"
#include "space_voxels.h"

namespace findspace::space {
namespace space_ray_pair {

using exact::Fraction;
using exact::Real;

/// The bodies are scaled by `parts` through the grid; the oracle works in steps.
struct Question {
  const PairRays& rays;
  const PhiUnion& oracle;
  int sense = 1;                    // -1: the oracle knows the complement
  double low = -1e18, high = 1e18;  // heights in parts within which the oracle is right
  int checked = 0, wrong = 0;

  void ask(int i, int j, const Real& z, int sign) {
    const RayGrid& g = rays.grid();
    const double at = z.to_double();
    if (at < low || at > high) return;
    const Real parts(g.parts);
    RealVector u;
    u[static_cast<std::size_t>((g.axis + 1) % 3)] = Real(g.u_at(i)) / parts;
    u[static_cast<std::size_t>((g.axis + 2) % 3)] = Real(g.v_at(j)) / parts;
    u[static_cast<std::size_t>(g.axis)] = z / parts;
    ++checked;
    const int truth = sense * oracle.sign_at(u);
    if (truth == sign) return;
    if (++wrong <= 5) {
      ADD_FAILURE() << "line " << i << ", " << j << " along axis " << g.axis << " at " << u[0].text() << ", "
                    << u[1].text() << ", " << u[2].text() << ": " << sign << ", should be " << truth;
    }
  }

  void ask_line(const RayRow& row, int i, int j) {
    const int first = row.first[i], last = row.first[i + 1];
    int before = row.before[i];
    for (int k = first; k < last; ++k) {
      const RayEvent& e = row.events[k];
      const Real at = e.at.to_real();
      ask(i, j, at, e.here);
      const Real below = k == first ? at - Real(7) : (at + row.events[k - 1].at.to_real()) / Real(2);
      ask(i, j, below, before);
      ask(i, j, (at * Real(9) + below) / Real(10), before);
      if (k > first) ask(i, j, (at + below * Real(30)) / Real(31), before);
      before = e.after;
      if (k + 1 == last) ask(i, j, at + Real(1), before);
    }
    if (first == last) ask(i, j, Real(0), before);
  }

  void ask_all() {
    for (int j = 0; j < rays.grid().nv; ++j) {
      const RayRow row = rays.row(j);
      for (int i = 0; i < rays.grid().nu; ++i) ask_line(row, i, j);
    }
    EXPECT_EQ(wrong, 0) << "of " << checked;
  }
};

/// Lines about the sum of the two bodies, `step` parts apart, starting `offset` parts from a lattice point.
RayGrid lines(const Triangles& a, const Triangles& b, int axis, std::int64_t parts, std::int64_t step,
              std::int64_t offset) {
  const auto range = [&](const Triangles& t, int k) {
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    for (const Point& p : t.points) {
      const std::int64_t c = k == 0 ? p.x : k == 1 ? p.y : p.z;
      low = std::min(low, c);
      high = std::max(high, c);
    }
    return std::pair(low, high);
  };
  RayGrid g;
  g.axis = axis;
  g.parts = parts;
  g.du = g.dv = step;
  const auto one = [&](int k, std::int64_t& from, int& count) {
    const auto [al, ah] = range(a, k);
    const auto [bl, bh] = range(b, k);
    from = (al - bh) * parts + offset;
    count = static_cast<int>(((ah - bl) * parts - from) / step) + 2;
  };
  one((axis + 1) % 3, g.u, g.nu);
  one((axis + 2) % 3, g.v, g.nv);
  return g;
}

void compare(const Cells& a, const LinearMap& on_a, const Cells& b, const LinearMap& on_b, int axis, std::int64_t parts,
             std::int64_t step, std::int64_t offset) {
  const Triangles s = surface(a, on_a), t = surface(b, on_b);
  const PairRays rays(s, t, lines(s, t, axis, parts, step, offset));
  const auto p = parts_of(a, on_a), q = parts_of(b, on_b);
  const PhiUnion oracle(p, q);
  Question{rays, oracle}.ask_all();
}

const Cells kL = extruded({"#.", "##"}, 2);
const Cells kFrame = extruded({"####", "#..#", "#..#", "####"}, 1);
const Cells kBar = extruded({"#"}, 5);
const Cells kFork = extruded({"###", "#.#", "#.#"}, 1);

TEST(RayPair, boxes) {
  const Cells box = extruded({"##"}, 1), cube = extruded({"#"}, 1);
  for (const int axis : {0, 1, 2}) {
    compare(box, stretch(2), cube, stretch(2), axis, 1, 1, 0);
    compare(box, stretch(2), cube, stretch(2), axis, 4, 3, 1);
  }
}

TEST(RayPair, brackets_on_the_lattice) {
  compare(kL, stretch(2), kL, stretch(2), 2, 1, 1, 0);
  compare(kL, stretch(2), kL, stretch(1), 0, 2, 1, 0);
  compare(kL, stretch(2), kFork, stretch(2), 1, 1, 1, 0);
}

TEST(RayPair, a_frame_about_a_bar_overlaps_in_a_ring) {
  compare(kFrame, stretch(2), kBar, {{{2, 0, 0}, {0, 0, -2}, {0, 2, 0}}}, 2, 1, 1, 0);
  compare(kFrame, stretch(2), kBar, {{{3, 0, 0}, {0, 3, 0}, {0, 0, 2}}}, 2, 1, 1, 0);
  compare(kBar, stretch(2), kFrame, {{{0, 0, 3}, {3, 0, 0}, {0, 3, 0}}}, 1, 2, 1, 0);
}

TEST(RayPair, passages_of_width_zero) {
  // The bar of width 2 in the hole of width 2, and a peg in a fork.
  compare(kFrame, stretch(1), kBar, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 1}}}, 2, 2, 1, 0);
  compare(kFrame, stretch(1), kBar, {{{2, 0, 0}, {0, 2, 0}, {0, 0, 1}}}, 0, 2, 1, 0);
  compare(kFork, stretch(2), kBar, {{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1, 2, 1, 0);
}

TEST(RayPair, random_solids_in_general_position) {
  std::mt19937 random(20240607);
  for (int round = 0; round < 6; ++round) {
    const auto entry = [&] { return static_cast<std::int64_t>(random() % 61) - 30; };
    const auto map = [&] {
      return LinearMap{
          {{100 + entry(), entry(), entry()}, {entry(), 100 + entry(), entry()}, {entry(), entry(), 100 + entry()}}};
    };
    compare(random_cells(random, 9, 3), map(), random_cells(random, 7, 3), map(), round % 3, 1, 41, 17);
  }
}

TEST(RayPair, random_solids_on_the_lattice) {
  std::mt19937 random(7);
  for (int round = 0; round < 8; ++round) {
    compare(random_cells(random, 12, 3), stretch(2), random_cells(random, 8, 3), stretch(2), round % 3, 1, 1, 0);
  }
}

TEST(RayPair, off_the_origin_and_slanted_alike) {
  // One map for both: faces stay parallel, so everything is degenerate and nothing is upright.
  std::mt19937 random(11);
  const LinearMap slanted{{{7, 2, 1}, {-1, 6, 2}, {1, -2, 5}}};
  for (int round = 0; round < 4; ++round) {
    Cells a = random_cells(random, 10, 3), far;
    for (const Cell& c : a) far.insert({c[0] + 40, c[1] - 30, c[2] + 20});
    compare(far, slanted, random_cells(random, 6, 3), slanted, round % 3, 1, 5, round);
  }
}

void compare_inside(const Cells& a, const LinearMap& on_a, const Cells& b, const LinearMap& on_b, int axis,
                    std::int64_t step) {
  const Triangles s = surface(a, on_a), t = surface(b, on_b);
  const PairRays rays(s, t, lines(s, t, axis, 1, step, 0), PairRays::Side::kComplement);
  const auto p = parts_of(around(a, 2), on_a), q = parts_of(b, on_b);
  const PhiUnion oracle(p, q);
  Question question{rays, oracle, -1};
  // The oracle's box is two cells wider than A: right wherever B + p stays in it.
  question.low = 0;
  question.high = 4;
  question.ask_all();
}

TEST(RayPair, containment_by_the_complement) {
  const Cells hall = drawn({{"#####", "#####", "#####"}, {"#####", "##.##", "#####"}, {"#####", "#####", "#..##"}});
  compare_inside(hall, stretch(2), extruded({"#"}, 1), stretch(2), 2, 1);
  compare_inside(hall, stretch(2), extruded({"#.", "##"}, 1), stretch(1), 0, 2);
}

}  // namespace space_ray_pair
}  // namespace findspace::space
