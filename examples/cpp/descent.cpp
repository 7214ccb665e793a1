// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A Phi-function minimised by its gradient: two stars are pulled together until they touch.
#include <findspace/findspace.h>

#include <cmath>
#include <cstdio>

findspace::Shape star(double size) {
  std::vector<findspace::Position> ring;
  for (int k = 0; k < 10; ++k) {
    const double angle = M_PI * k / 5, r = k % 2 ? size / 2 : size;
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return findspace::Shape::polygon(ring);
}

int main() {
  using namespace findspace;
  const Phi phi(star(10), star(6));
  Position u{40, 25};
  int steps = 0;
  for (; steps < 100; ++steps) {
    const Phi::Value now = phi.at(Point{u[0], u[1]});
    if (std::abs(now.value) < 1e-9) break;
    for (int k = 0; k < 2; ++k) u[k] -= now.value * now.gradient[k];
  }
  std::printf("contact after %d steps, Phi %.1e, at least 1e-6 apart: %s\n", steps, phi.at(Point{u[0], u[1]}).value,
              phi.compare({u[0], u[1]}, "0.000001") >= 0 ? "yes" : "no");
}
