// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What `findspace map` answers for a scene of tools/findspace_scenes.py, by Clipper 6 (libpolyclipping): the container
// eroded by the moving shape's box, minus the union of the sums of all obstacles with the mirrored moving shape.
// Coordinates are rounded to a millionth; clearances are left out, so Clipper has less to do. Reads the scene from
// standard input, prints the area of the result.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <polyclipping/clipper.hpp>

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;
using nlohmann::json;

constexpr double kGrid = 1e6;

Path path(const json& polygon, int sign) {
  Path out;
  for (const json& p : polygon)
    out.emplace_back(ClipperLib::cInt(sign * p[0].get<double>() * kGrid),
                     ClipperLib::cInt(sign * p[1].get<double>() * kGrid));
  if (!ClipperLib::Orientation(out)) std::reverse(out.begin(), out.end());
  return out;
}

Path box(const json& of, const Path& mirrored) {
  const auto [x0, x1] =
      std::minmax_element(mirrored.begin(), mirrored.end(), [](auto& p, auto& q) { return p.X < q.X; });
  const auto [y0, y1] =
      std::minmax_element(mirrored.begin(), mirrored.end(), [](auto& p, auto& q) { return p.Y < q.Y; });
  const auto at = [&](const char* end, int k) { return ClipperLib::cInt(of[end][k].get<double>() * kGrid); };
  const auto left = at("min", 0) + x1->X, right = at("max", 0) + x0->X, low = at("min", 1) + y1->Y,
             high = at("max", 1) + y0->Y;
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

void add_sums(const json& shape, const Path& mirrored, ClipperLib::Clipper& clipper) {
  if (shape.is_array()) {
    for (const json& part : shape) add_sums(part, mirrored, clipper);
    return;
  }
  Paths sum;
  ClipperLib::MinkowskiSum(mirrored, path(shape["polygon"], 1), sum, true);
  Path filled = sum.front();  // the outer boundary: what is within counts as overlap
  for (const Path& p : sum)
    if (ClipperLib::Area(p) > ClipperLib::Area(filled)) filled = p;
  clipper.AddPath(filled, ClipperLib::ptClip, true);
}

}  // namespace

int main() {
  const json scene = json::parse(std::cin);
  const Path mirrored = path(scene["shapes"]["chip"]["polygon"], -1);
  ClipperLib::Clipper clipper;
  clipper.AddPath(box(scene["shapes"]["container"]["box"], mirrored), ClipperLib::ptSubject, true);
  for (const auto& [name, shape] : scene["shapes"].items()) {
    if (name.starts_with("obstacle")) add_sums(shape, mirrored, clipper);
  }
  Paths result;
  clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  double area = 0;
  for (const Path& p : result) area += ClipperLib::Area(p);
  std::printf("%zu rings, area %.6f\n", result.size(), area / kGrid / kGrid);
}
