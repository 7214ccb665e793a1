// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The side of a plane by its normal (moved_sign.h) is that which the volume of four corners tells, also where they lie
// in one plane.
#include <gtest/gtest.h>

#include <random>

#include "exact/solid/moved_sign.h"

namespace findspace::exact {
namespace exact_spot_sides {

/// Three corners of a body and one more place, as spots.
struct Four {
  std::array<Grid3, 4> at;
  Wide3 normal;
  Approx3 near;
  Four(std::mt19937_64& rng, std::int64_t most) {
    const auto number = [&] { return std::int64_t(rng() % std::uint64_t(2 * most + 1)) - most; };
    for (Grid3& p : at) p = {number(), number(), number()};
    normal = cross(at[1] - at[0], at[2] - at[0]);
    near = approx(normal);
  }
};

/// What sign_side and sign_volume tell of the place, which is of the same body or of the other one.
template <class Spot, class By>
void expect_same(const Four& four, const By& by, bool of_plane, bool of_place, std::array<int, 3>& seen) {
  const Spot a{four.at[0], of_plane}, b{four.at[1], of_plane}, c{four.at[2], of_plane}, d{four.at[3], of_place};
  const int side = sign_side(SpotPlane<Spot>{a, four.normal, four.near}, d, by);
  EXPECT_EQ(side, sign_volume(a, b, c, d, by));
  ++seen[std::size_t(side + 1)];
}

TEST(SpotSides, AreThoseOfVolumes) {
  std::mt19937_64 rng(7);
  std::array<int, 3> moved{}, raised{};
  for (const int bits : {0, 2, 10, 20, 37}) {
    const std::int64_t most = std::int64_t{1} << bits;
    for (int k = 0; k < 300; ++k) {
      const Four four(rng, most);
      const auto third = [&] { return Real::ratio(std::int64_t(rng() % std::uint64_t(6 * most + 1)) - 3 * most, 3); };
      const Real root = k % 4 == 0 ? sqrt(Real(2)) : Real(0);
      const Movement movement({third() + root, third() - root, third()});
      const Fraction by{int128(rng() % 6), 6};
      for (const bool of_plane : {false, true}) {
        for (const bool of_place : {false, true}) {
          expect_same<MovedPoint>(four, movement, of_plane, of_place, moved);
          expect_same<RaisedPoint>(four, by, of_plane, of_place, raised);
        }
      }
    }
  }
  for (const auto& seen : {moved, raised}) {
    for (const int count : seen) EXPECT_GT(count, 100);
  }
}

TEST(SpotSides, OfPlacesNearAPlane) {
  // A face in the plane x + y + z = 1 of great coordinates: places that doubles do not tell from it.
  const std::int64_t n = std::int64_t{1} << 36;
  const MovedPoint a{{n, 1 - n, 0}}, b{{0, n, 1 - n}}, c{{1 - n, 0, n}};
  const Wide3 normal = cross(b.at - a.at, c.at - a.at);
  const Approx3 near = approx(normal);
  const int front = sign(normal.x);
  for (const int offset : {-1, 0, 1}) {
    const Real tiny = Real::ratio(offset, std::int64_t{1} << 60);
    const Movement movement({Real::ratio(1, 3), Real::ratio(1, 3), Real::ratio(1, 3) + tiny});
    const MovedPoint d{{5, -5, 0}, true};
    EXPECT_EQ(sign_side({a, normal, near}, d, movement), front * offset);
    EXPECT_EQ(sign_volume(a, b, c, d, movement), front * offset);
  }
}

}  // namespace exact_spot_sides
}  // namespace findspace::exact
