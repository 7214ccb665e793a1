// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "inputs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

namespace bench {
namespace {

constexpr double kRotation = 6.283185307179586;
constexpr double kSize = 1 << 20;

double area_twice(const Polygon& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    sum += double(a.x) * double(b.y) - double(b.x) * double(a.y);
  }
  return sum;
}

bool straight(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

// Counter-clockwise, without repeated and collinear vertices.
Polygon normalised(Polygon p) {
  for (bool changed = true; changed && p.size() > 3;) {
    changed = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (!straight(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()])) continue;
      p.erase(p.begin() + std::ptrdiff_t((i + 1) % p.size()));
      changed = true;
      break;
    }
  }
  if (area_twice(p) < 0) std::reverse(p.begin(), p.end());
  return p;
}

Point at(double x, double y) { return {std::llround(x), std::llround(y)}; }

}  // namespace

Polygon star(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> outer(0.9, 1.0), shift(-0.2, 0.2);
  Polygon p;
  for (int i = 0; i < n; ++i) {
    double radius = kSize * (i % 2 ? 0.8 : outer(random)), angle = kRotation * (i + shift(random)) / n;
    p.push_back(at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return normalised(p);
}

Polygon comb(int n, unsigned seed, double degrees) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> length(0.25, 0.5), jitter(-0.2, 0.2);
  int teeth = std::max(1, (n - 2) / 4);
  double width = 2 * kSize / (2 * teeth), angle = degrees / 360 * kRotation;
  // The valleys lie on a flat arch, so that the spine is convex.
  auto valley = [](double x) { return std::pair{x, 0.05 * kSize * (1 - x * x / kSize / kSize)}; };
  std::vector<std::pair<double, double>> points{{-kSize, -0.2 * kSize}, {kSize, -0.2 * kSize}};
  for (int i = teeth; i-- > 0;) {
    double x = -kSize + 2 * width * i, top = kSize * length(random), lean = width * jitter(random);
    points.insert(points.end(), {valley(x + width * 1.5),
                                 {x + width * 1.2 + lean, top},
                                 {x + width * 0.8 + lean, top * 0.97},
                                 valley(x + width * 0.5)});
  }
  Polygon p;
  for (auto [x, y] : points) {
    p.push_back(at(x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)));
  }
  return normalised(p);
}

Polygon smooth(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, kRotation), shift(-0.2, 0.2);
  double p2 = phase(random), p3 = phase(random), p7 = phase(random), p12 = phase(random);
  Polygon p;
  for (int i = 0; i < n; ++i) {
    double a = kRotation * (i + shift(random)) / n;
    double r = kSize * (0.65 + 0.12 * std::cos(2 * a + p2) + 0.08 * std::cos(3 * a + p3) + 0.05 * std::cos(7 * a + p7) +
                        0.03 * std::cos(12 * a + p12));
    p.push_back(at(r * std::cos(a), r * std::sin(a)));
  }
  return normalised(p);
}

std::vector<Polygon> litter(int count, double depth, unsigned seed) {
  std::mt19937 random(seed);
  double radius = kSize * std::sqrt(depth / count);
  std::uniform_real_distribution<double> place(-kSize, kSize);
  std::vector<Polygon> all;
  for (int i = 0; i < count; ++i) {
    Polygon p = star(10, seed + 1 + unsigned(i));
    double x = place(random), y = place(random);
    for (Point& q : p) q = at(double(q.x) / kSize * radius + x, double(q.y) / kSize * radius + y);
    all.push_back(p);
  }
  return all;
}

std::vector<Polygon> nesting(const std::string& instance) {
  std::ifstream file(FINDSPACE_SOURCE "/tests/data/nesting/" + instance + ".json");
  if (!file) throw std::runtime_error("no nesting instance " + instance);
  nlohmann::json data = nlohmann::json::parse(file);
  std::vector<Polygon> all;
  for (const auto& item : data.at("items")) {
    const auto& shape = item.at("shape");
    const auto& ring = shape.at("type") == "simple_polygon" ? shape.at("data") : shape.at("data").at("outer");
    Polygon p;
    for (const auto& point : ring) p.push_back(at(point[0].get<double>() * 1000, point[1].get<double>() * 1000));
    all.push_back(normalised(p));
  }
  return all;
}

Polygon mirrored(const Polygon& polygon) {
  Polygon p;
  for (const Point& q : polygon) p.push_back({-q.x, -q.y});
  return p;
}

}  // namespace bench
