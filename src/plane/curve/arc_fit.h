// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which arcs between two points may follow samples of a curve: the search behind curve_arcs.h, in doubles. It proposes;
// arc_proof.h decides. Keywords: pencil of circles, bulge, feasible interval.
#pragma once

#include <optional>
#include <vector>

namespace findspace::plane {

struct Sample {
  double x, y;
};

/// Distances to the left of the arc that samples may have.
struct FitWindow {
  double low, high;
};

struct BulgeRange {
  double low, high;  // positive: counter-clockwise
};

/// Bulges of the arcs from `from` to `to` that keep all samples in the window; `turn`: the largest angle of an arc,
/// below pi. `tangent`: a direction of the curve at its first (last) point, where the arc begins (ends) there and must
/// leave to the side that the window allows.
struct FitQuestion {
  Sample from, to;
  std::vector<Sample> samples;
  FitWindow window;
  double turn;
  std::optional<Sample> first_tangent, last_tangent;
};
std::optional<BulgeRange> bulges(const FitQuestion& question);

/// The dyadic number of fewest digits in the middle half between two numbers.
double simplest_between(double low, double high);

}  // namespace findspace::plane
