// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A bumpy mesh and a gripper in space: how far the gripper can come down, and what touches it first.
#include <findspace/findspace.h>

#include <cmath>
#include <cstdio>

int main() {
  using namespace findspace;
  constexpr int kRound = 24, kHigh = 12;
  std::vector<Position3> vertices{{0, 0, -20}, {0, 0, 20}};
  std::vector<std::array<std::int32_t, 3>> faces;
  for (int j = 1; j < kHigh; ++j)
    for (int i = 0; i < kRound; ++i) {
      const double u = 2 * M_PI * i / kRound, v = M_PI * j / kHigh, r = 20 + 2 * std::cos(3 * u) * std::sin(v);
      vertices.push_back({r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), -r * std::cos(v)});
    }
  const auto at = [](int i, int j) { return 2 + (j - 1) * kRound + i % kRound; };
  for (int i = 0; i < kRound; ++i) {
    faces.push_back({0, at(i + 1, 1), at(i, 1)});
    faces.push_back({1, at(i, kHigh - 1), at(i + 1, kHigh - 1)});
    for (int j = 1; j + 1 < kHigh; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const Shape finger = Shape::box({-2, -2, 0}, {2, 2, 30});
  const Shape gripper = Shape::unite({finger.translated(Point3{-28, 0, 0}), finger.translated(Point3{28, 0, 0})});
  const World world({{"stone", Shape::mesh(vertices, faces)}, {"gripper", gripper}}, "gripper", {.unit = "mm"});
  const OnLine free = world.on_line("clear(gripper, stone)", {9, 0, 0}, {0, 0, 1});
  const DistanceValue gap = world.distance("gap(gripper, stone)", Point3{0, 0, 0});
  std::printf("%zu free stretches beside the middle, gap %.6f there\n", free.intervals.size(), *gap.value);
}
