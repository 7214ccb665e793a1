// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rotated 3D shapes: rotating both bodies and the position changes no Phi-function; exactly for multiples of 90
// degrees, to the rounding of vertices for others. Nodes of every kind below the rotation, about every axis and a
// centre.
#include <findspace/error.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/scene/scene.h"
#include "space/body/rounded_phi.h"

namespace findspace::io {
namespace io_rotated {

using exact::Real;

const char* const kShapes[] = {
    R"({"box": {"min": [0, 0, 0], "max": [4, 2, 1]}})",
    R"({"ball": {"center": [1, 2, 3], "radius": 2}})",
    R"({"prism": {"polygon": [[0, 0], [5, 0], [5, 1], [1, 1], [1, 4], [0, 4]], "z": [0, 2]}})",
    R"({"mesh": {"vertices": [[0,0,0],[4,0,0],[0,4,0],[0,0,4]], "faces": [[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}})",
    R"({"union": [{"translate": [3, 1, -1], "of": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}, {"ball": {"center": [0, 0, 0], "radius": 1}}]})",
    R"({"mirror": {"translate": [1, 2, 3], "of": {"polytope": [[0,0,0],[3,0,1],[0,3,1],[1,1,4]]}}})",
    R"({"minkowski_sum": [{"box": {"min": [0, 0, 0], "max": [2, 1, 1]}}, {"translate": [1, 0, 5], "of": {"box": {"min": [0, 0, 0], "max": [1, 3, 1]}}}]})",
    R"({"difference": [{"box": {"min": [0, 0, 0], "max": [4, 4, 4]}}, {"box": {"min": [1, 1, 1], "max": [3, 3, 5]}}]})",
};

std::string rotated(const std::string& shape, double degrees, char axis, const char* about) {
  return fmt::format(R"({{"rotate": {}, "axis": "{}", "about": {}, "of": {}}})", degrees, axis, about, shape);
}

space::RoundedPhi phi_of(const std::string& a, const std::string& b) {
  const std::string text = fmt::format(R"({{"findspace": 1, "grid": 1e-6, "shapes": {{"A": {}, "B": {}}}}})", a, b);
  const Scene scene = read_scene_text(text, ".", "test");
  const space::Body p = space::body(*scene.shape("A")), q = space::body(*scene.shape("B"));
  EXPECT_EQ(p.scale, 1);
  EXPECT_EQ(q.scale, 1);
  return space::RoundedPhi(p.parts, q.parts);
}

/// The position rotated about the axis through the origin: a relative position knows no centre.
std::array<double, 3> rotated(const std::array<double, 3>& u, double degrees, int axis) {
  const double t = degrees * std::acos(-1.0) / 180, c = std::cos(t), s = std::sin(t);
  const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
  std::array<double, 3> v = u;
  v[i] = c * u[i] - s * u[j];
  v[j] = s * u[i] + c * u[j];
  return v;
}

space::RealVector steps(const std::array<double, 3>& u, bool whole) {
  space::RealVector v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = whole ? Real(std::llround(u[k] * 1e6)) : Real::from_double(u[k] * 1e6);
  return v;
}

TEST(Rotated, PhiIsTheSame) {
  const std::array<double, 3> places[] = {{0, 0, 0}, {4, 1, 0}, {-3, 2, 1}, {6, 5, 4}, {1, -1, 2}};
  int index = 0;
  for (const std::string a : kShapes) {
    const std::string b = kShapes[static_cast<std::size_t>(index + 1) % std::size(kShapes)];
    for (const double degrees : {90.0, 180.0, -90.0, 450.0, 30.0, 117.5}) {
      const int axis = index++ % 3;
      const char* about = index % 2 ? "[1, 2, 3]" : "[0, 0, 0]";
      const bool quarters = std::fmod(degrees, 90) == 0;
      // A cut of rounded surfaces would leave the grid: only bodies of convex parts are rotated by odd angles here.
      if (!quarters && (a.find("difference") != a.npos || b.find("difference") != b.npos || a.find("prism") != a.npos ||
                        b.find("prism") != b.npos))
        continue;
      const space::RoundedPhi phi = phi_of(a, b);
      const space::RoundedPhi other =
          phi_of(rotated(a, degrees, "xyz"[axis], about), rotated(b, degrees, "xyz"[axis], about));
      for (const auto& u : places) {
        const auto x = phi.at(steps(u, true)).at, y = other.at(steps(rotated(u, degrees, axis), quarters)).at;
        ASSERT_NEAR(x.normalised, y.normalised, quarters ? 1e-6 : 20) << a << b << degrees << "xyz"[axis];
        if (quarters) {
          ASSERT_EQ(x.state, y.state);
        }
      }
    }
  }
}

TEST(Rotated, ANonConvexPrismStaysClosed) {
  const std::string prism = rotated(kShapes[2], 33, 'x', "[0, 0, 0]");
  const Scene scene = read_scene_text(R"({"findspace": 1, "grid": 1e-3, "shapes": {"A": )" + prism + "}}", ".", "test");
  EXPECT_EQ(space::solid_of(*scene.shape("A"))->form, space::Solid::Form::kMesh);
  EXPECT_FALSE(scene.notes.empty());
}

TEST(Rotated, RefusesOtherAxes) {
  const auto read = [](const std::string& shape) {
    return read_scene_text(R"({"findspace": 1, "shapes": {"A": )" + shape + "}}", ".", "test");
  };
  EXPECT_THROW(read(rotated(kShapes[0], 30, 'w', "[0, 0, 0]")), Error);
  EXPECT_THROW(read(R"({"rotate": 30, "axis": "z", "of": {"box": {"min": [0, 0], "max": [1, 1]}}})"), Error);
}

}  // namespace io_rotated
}  // namespace findspace::io
