// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What of the curves of a sum is left outside cells that are surely inside, and the places that outer numbers start at.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "differential/whole_sum.h"
#include "plane/grid/kept_parts.h"
#include "plane/query/topology.h"
#include "plane/sum/sum_mask.h"

namespace findspace::plane {
namespace plane_pruned_curves {

using exact::Real;

Outline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0, x1, y0}, {x1, y0, x1, y1}, {x1, y1, x0, y1}, {x0, y1, x0, y0}};
}

/// Cells of one size in the sum of two rectangles; `b` holds a lattice point.
InnerMask mask_of(const Outline& a, const Outline& b, std::int64_t side) {
  const InnerMask::Pair pair{&a, &b};
  return {std::span(&pair, 1), side, 1e7};
}

/// From (0, 0), in cells; what is marked are those that do not touch the sides.
InnerMask block(std::int64_t column0, std::int64_t row0, std::int64_t column1, std::int64_t row1, std::int64_t side) {
  const auto s = double(side);
  return mask_of(rectangle(double(column0 - 1) * s + 1, double(row0 - 1) * s + 1, double(column1 + 2) * s - 1,
                           double(row1 + 2) * s - 1),
                 rectangle(-s / 4, -s / 4, s / 4, s / 4), side);
}

struct Curve {
  exact::Geometry g;
  Piece piece;

  std::vector<KeptPart> kept(const InnerMask& mask) const {
    std::vector<KeptPart> out;
    add_kept_parts({g, piece}, mask, 0, out);
    return out;
  }
};

Curve straight(GridPoint from, GridPoint to) {
  if (to.x < from.x || (to.x == from.x && to.y < from.y)) std::swap(from, to);
  Curve c;
  std::int64_t a = to.y - from.y, b = from.x - to.x;
  exact::make_primitive(a, b);
  c.piece.supporting_curve = c.g.add_line(a, b, exact::int128(a) * from.x + exact::int128(b) * from.y);
  c.piece.p0 = c.g.add_grid_point(from.x, from.y);
  c.piece.p1 = c.g.add_grid_point(to.x, to.y);
  return c;
}

TEST(KeptParts, OfNoLengthAreNone) {
  const std::int64_t side = 105;  // by which a whole number of cells is divided to less
  const InnerMask mask = block(-6, -9, 3, 3, side);
  ASSERT_GT(mask.depth(-6, -9), 0);
  ASSERT_EQ(mask.depth(-7, -9), 0);
  EXPECT_TRUE(straight({-630, -630}, {-210, -630}).kept(mask).empty()) << "it starts on the border, inside";
  EXPECT_TRUE(straight({0, 0}, {420, 0}).kept(mask).empty()) << "it ends on the border";
  EXPECT_EQ(straight({-640, -630}, {-210, -630}).kept(mask).size(), 1u);
  EXPECT_EQ(straight({0, 0}, {421, 0}).kept(mask).size(), 1u);
}

TEST(KeptParts, ThatMayReachBeyondAnEnd) {
  const InnerMask mask = block(0, 0, 3, 3, 16);
  Curve c = straight({0, 20}, {40, 20});
  EXPECT_TRUE(c.kept(mask).empty());
  exact::Point& start = c.g.points[c.piece.p0];
  start.kind = exact::Point::Kind::kReal;  // in truth it may lie to the left of the cells
  start.x = 0.1;
  start.error = 0.2;
  EXPECT_EQ(c.kept(mask).size(), 1u);
  start.x = 20;
  EXPECT_TRUE(c.kept(mask).empty());
  start.error = 0.5;
  ASSERT_EQ(c.kept(mask).size(), 1u) << "of what is not known well enough all is kept";
  EXPECT_EQ(c.kept(mask)[0].from, KeptPart::kEnd);
  EXPECT_EQ(c.kept(mask)[0].to, KeptPart::kEnd);
}

TEST(KeptParts, OfArcsWhoseCirclesAreOff) {
  const InnerMask mask = block(0, 0, 60, 60, 16);
  Curve c;
  c.piece.supporting_curve = c.g.add(exact::SupportingCurve::circle_at(500, 500, Real(100)));
  c.piece.p0 = c.g.add_grid_point(400, 500);
  c.piece.p1 = c.g.add_grid_point(600, 500);
  c.piece.half = 1;
  EXPECT_TRUE(c.kept(mask).empty());
  exact::SupportingCurve& k = c.g.supporting_curves[c.piece.supporting_curve];
  k.set_filter(k.x(), k.y(), {k.z().value, 0.5});
  EXPECT_EQ(c.kept(mask).size(), 1u);
}

/// Is the point in a masked, closed cell, as far as doubles tell?
bool is_masked(const InnerMask& mask, double x, double y) {
  constexpr double kNear = 0x1p-20;
  for (const double u : {x - kNear, x + kNear})
    for (const double v : {y - kNear, y + kNear})
      if (mask.depth(mask.line_of(u), mask.line_of(v)) > 0) return true;
  return false;
}

/// In every place along a curve: kept once, or kept not at all and masked.
template <class At>
void check(const Curve& c, const InnerMask& mask, const At& at, const std::string& what) {
  const LatticeRunner run(c.g, c.piece);
  std::vector<std::array<double, 2>> parts;
  for (const KeptPart& p : c.kept(mask)) {
    const auto place = [&](std::int64_t line, double end) {
      return line == KeptPart::kEnd ? end : double(mask.border(line));
    };
    parts.push_back({place(p.from, run.start()), place(p.to, run.end())});
    ASSERT_LT(parts.back()[0], parts.back()[1]) << what;
  }
  for (int k = 0; k <= 512; ++k) {
    const auto [x, y] = at(k / 512.0);
    const double u = run.steep() ? y : x;
    int inside = 0, touched = 0;
    for (const auto& [from, to] : parts) {
      inside += from < u && u < to;
      touched += from <= u && u <= to;
    }
    ASSERT_LE(inside, 1) << what;
    ASSERT_TRUE(touched > 0 || is_masked(mask, x, y)) << what << " at " << x << ", " << y;
  }
}

TEST(KeptParts, LeaveOutOnlyWhatIsMasked) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    const std::array<std::int64_t, 4> sides{16, 21, 105, 333'333};
    const std::int64_t side = sides[rng() % sides.size()];
    const auto lattice = [&] { return side * (std::int64_t(rng() % 21) - 10) + std::int64_t(rng() % 2 * (rng() % 5)); };
    std::vector<Outline> blocks;
    for (int k = 0; k < 6; ++k) {
      const auto x = double(lattice()), y = double(lattice());
      blocks.push_back(rectangle(x, y, x + double(side) * (3 + rng() % 8), y + double(side) * (3 + rng() % 8)));
    }
    const double near = double(side) / 4;
    const Outline dot = rectangle(-near, -near, near, near);
    std::vector<InnerMask::Pair> pairs;
    for (const Outline& b : blocks) pairs.push_back({&b, &dot});
    const InnerMask mask(pairs, side, 1e7);
    const std::string name = "seed " + std::to_string(seed);
    for (int k = 0; k < 20; ++k) {
      const GridPoint p{lattice(), lattice()}, q{lattice(), rng() % 3 > 0 ? lattice() : p.y};
      if (p.x == q.x && p.y == q.y) continue;
      check(
          straight(p, q), mask,
          [&](double t) {
            return std::array{double(p.x) + t * double(q.x - p.x), double(p.y) + t * double(q.y - p.y)};
          },
          name + ", segment");
      Curve arc;
      const std::int64_t radius = side * (1 + std::int64_t(rng() % 8)) + std::int64_t(rng() % 3);
      arc.piece.supporting_curve = arc.g.add(exact::SupportingCurve::circle_at(p.x, p.y, Real(radius)));
      arc.piece.p0 = arc.g.add_grid_point(p.x - radius, p.y);
      arc.piece.p1 = arc.g.add_grid_point(p.x + radius, p.y);
      arc.piece.half = rng() % 2 ? 1 : -1;
      check(
          arc, mask,
          [&](double t) {
            const double angle = M_PI * (1 - t), r = double(radius);
            return std::array{double(p.x) + r * std::cos(angle), double(p.y) + arc.piece.half * r * std::sin(angle)};
          },
          name + ", arc");
      if (HasFatalFailure()) return;
    }
  }
}

Region box(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height) {
  return ring({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

// A curve of which nothing but an end was left made two vertices of one place, and wrong numbers.
TEST(PrunedCurves, EndsOnBordersOfCells) {
  const Region a = box(210, 420, 420, 630), boxes = box(420, 840, 420, 210);
  const Region tilted = ring({{420, 1050}, {1260, 1680}, {630, 2520}, {-210, 1890}});
  const Region b = united({boxes, tilted, box(1050, 0, 630, 420)});
  for (const std::int64_t side : {105, 106, 70, 210}) {
    const Operand x{a, is_in}, y{b, is_in, true};
    const auto mask = mask_of_sum(x, y, side, 1e7);
    ASSERT_TRUE(mask);
    EXPECT_TRUE(same_marks(sum_of_parts(x, y, &*mask), sum_of_parts(x, y, nullptr))) << side;
  }
}

// At (90, 120) one arc goes on smoothly into another, and so do two parts of a circle. They cross there, and again.
TEST(PrunedCurves, SmoothEndsThatBecomeOne) {
  const Region round = region_of_disc(0, 0, 100), bite = interior(region_of_disc(120, 0, 100));
  const std::array<const Region*, 2> both{&round, &bite};
  const Region crescent = subtract(both), a = united({crescent, region_of_disc(30, 120, 10)});
  const Region b = region_of_disc(0, 0, 50);
  const Operand x{a, is_in}, y{b, is_in, true};
  const InnerMask none({}, 64, 1);
  EXPECT_TRUE(same_marks(sum_of_parts(x, y, &none), sum_of_parts(x, y, nullptr)));
}

/// A frame of four curves, and a path inside.
ConvolutionBuilder framed(const std::vector<exact::RealPoint>& path) {
  ConvolutionBuilder c(true);
  exact::Geometry& g = c.curves.geometry;
  const auto add = [&](const exact::RealPoint& from, const exact::RealPoint& to, std::int64_t a, std::int64_t b) {
    const bool right = compare(from.x, to.x) < 0 || (compare(from.x, to.x) == 0 && compare(from.y, to.y) < 0);
    const exact::RealPoint &p = right ? from : to, &q = right ? to : from;
    const Index line = g.add(exact::SupportingCurve::line(a, b, Real(a) * p.x + Real(b) * p.y));
    const Index p0 = g.add_real_point(p.x, p.y), p1 = g.add_real_point(q.x, q.y);
    c.curves.pieces.push_back({.supporting_curve = line, .p0 = p0, .p1 = p1});
    c.curves.forward.push_back(right);
    c.chains.push_back({.forward = right});
  };
  const Real low(-3200), high(3200);
  add({low, low}, {high, low}, 0, 1);
  add({high, low}, {high, high}, 1, 0);
  add({high, high}, {low, high}, 0, 1);
  add({low, high}, {low, low}, 1, 0);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const bool upright = compare(path[k].x, path[k + 1].x) == 0;
    const bool rises = !upright && (compare(path[k].x, path[k + 1].x) < 0) == (compare(path[k].y, path[k + 1].y) < 0);
    add(path[k], path[k + 1], 1, upright ? 0 : rises ? -1 : 1);
  }
  return c;
}

exact::RealPoint first_place(ConvolutionBuilder&& c, std::int32_t& number) {
  InnerMask mask = block(5, 5, 8, 8, 64);
  mask.mark_beyond({-50, 49, -50, 49});
  const auto inner = prune(c, mask, 0);
  EXPECT_TRUE(inner && inner->seeds.size() == 1);
  number = inner->seeds[0].number;
  return c.curves.geometry.exact(inner->seeds[0].point);
}

TEST(PrunedCurves, NumbersAreCountedInPlacesOnNoCurve) {
  std::int32_t number = 0;
  const exact::RealPoint at = first_place(framed({}), number);
  EXPECT_EQ(number, 1);
  const auto beside = [&](std::int64_t x, std::int64_t y) { return exact::RealPoint{at.x + Real(x), at.y + Real(y)}; };
  const auto lies_there = [&](const std::vector<exact::RealPoint>& path) {
    const exact::RealPoint found = first_place(framed(path), number);
    return found.x == at.x && found.y == at.y;
  };
  EXPECT_FALSE(lies_there({beside(-9, 9), at, beside(-9, -9)})) << "a tip to the right";
  EXPECT_FALSE(lies_there({beside(9, 9), at, beside(9, -9)})) << "a tip to the left";
  EXPECT_FALSE(lies_there({beside(0, 9), beside(0, -9)})) << "a vertical curve";
  EXPECT_FALSE(lies_there({beside(0, 0), beside(0, 9)})) << "one that begins there";
  EXPECT_FALSE(lies_there({beside(-9, -9), beside(9, 9)})) << "an oblique one";
  EXPECT_TRUE(lies_there({beside(-9, -8), beside(9, 10)}));
  EXPECT_EQ(number, 1) << "it lies above";
  EXPECT_TRUE(lies_there({beside(-9, -10), beside(9, 8)}));
  EXPECT_EQ(number, 2) << "it lies below";
}

}  // namespace plane_pruned_curves
}  // namespace findspace::plane
