// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_arrows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace findspace::io {

using plane::Place;

namespace {

constexpr double kLength = 52, kGap = 9, kRotationRadius = 30;  // pixels
constexpr double kRotationFrom = 25, kRotationTo = 115;         // degrees, counter-clockwise

/// The open head of an arrow that ends at a point of the picture, going along (dx, dy).
std::string head(const Place& end, double dx, double dy) {
  const double length = std::hypot(dx, dy), u = dx / length, v = dy / length;
  constexpr double kBack = 8, kAside = 4;
  return fmt::format("M{} {}L{} {}L{} {}", pixels(end[0] - kBack * u - kAside * v),
                     pixels(end[1] - kBack * v + kAside * u), pixels(end[0]), pixels(end[1]),
                     pixels(end[0] - kBack * u + kAside * v), pixels(end[1] - kBack * v - kAside * u));
}

std::string line(const Place& from, const Place& to) {
  return fmt::format("M{} {}L{} {}", pixels(from[0]), pixels(from[1]), pixels(to[0]), pixels(to[1]));
}

std::string way(const std::vector<Place>& pixels_of) {
  std::string data;
  for (std::size_t k = 1; k < pixels_of.size(); ++k) {
    const Place &p = pixels_of[k - 1], &q = pixels_of[k];
    if (p == q) continue;
    data += line(p, q) + head(q, q[0] - p[0], q[1] - p[1]);
  }
  return data;
}

std::string straight(const Place& from, double dx, double dy) {
  const double length = std::hypot(dx, dy), u = dx / length, v = -dy / length;  // y down
  const Place start{from[0] + kGap * u, from[1] + kGap * v}, end{start[0] + kLength * u, start[1] + kLength * v};
  return line(start, end) + head(end, u, v);
}

std::string rotation(const Place& centre) {
  const auto at = [&](double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return Place{centre[0] + kRotationRadius * std::cos(a), centre[1] - kRotationRadius * std::sin(a)};
  };
  const Place from = at(kRotationFrom), to = at(kRotationTo);
  const double a = kRotationTo * std::numbers::pi / 180;
  return fmt::format("M{} {}A{} {} 0 0 0 {} {}", pixels(from[0]), pixels(from[1]), kRotationRadius, kRotationRadius,
                     pixels(to[0]), pixels(to[1])) +
         head(to, -std::sin(a), -std::cos(a));
}

}  // namespace

std::string arrows(const std::vector<Arrow>& all, const Frame& frame, const std::optional<Place>& position) {
  std::string out;
  for (const Arrow& a : all) {
    if (a.of_moving && !position) continue;
    const Place origin = a.of_moving ? *position : Place{};
    const auto seen = [&](const Place& p) { return Place{frame.x(origin[0] + p[0]), frame.y(origin[1] + p[1])}; };
    std::string data;
    if (a.kind == Arrow::Kind::kWay) {
      std::vector<Place> points;
      for (const Place& p : a.points) points.push_back(seen(p));
      data = way(points);
    } else if (a.kind == Arrow::Kind::kRotation) {
      data = rotation(seen(a.points.at(0)));
    } else {
      const Place& d = a.points.at(0);
      const double up = frame.y_down ? -d[1] : d[1];
      data = straight(seen({}), d[0], up);
      if (a.kind == Arrow::Kind::kBothWays) data += straight(seen({}), -d[0], -up);
    }
    if (!data.empty()) out += fmt::format("<path class=\"arrow\" d=\"{}\"/>\n", data);
  }
  return out;
}

std::vector<LegendEntry> arrow_entries(const std::vector<Arrow>& all) {
  const auto has = [&](Arrow::Kind kind) {
    return std::any_of(all.begin(), all.end(), [kind](const Arrow& a) { return a.kind == kind; });
  };
  std::vector<LegendEntry> out;
  using M = LegendEntry::Mark;
  if (has(Arrow::Kind::kWay)) out.push_back({M::kArrow, "way in time"});
  if (has(Arrow::Kind::kDirection) || has(Arrow::Kind::kBothWays))
    out.push_back({M::kArrow, "direction of the distance"});
  if (has(Arrow::Kind::kRotation)) out.push_back({M::kArrow, "rotation"});
  return out;
}

}  // namespace findspace::io
