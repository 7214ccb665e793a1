// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/draw/draw_view.h"

namespace findspace::io {
namespace {

using Place3 = std::array<double, 3>;

constexpr double kFlat = 0.906;          // cosine of 25 degrees
constexpr std::size_t kMostHidden = 60;  // more hidden lines say nothing
constexpr Place3 kLight{0.48, 0.28, 0.83};
constexpr double kShadow = 0.55;  // of the colour, where no light falls

/// Of length 1, or zero for a face without area (Newell).
Place3 normal_of(const std::vector<Place3>& vertices, const std::vector<int>& ring) {
  Place3 n{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place3& p = vertices[static_cast<std::size_t>(ring[i])];
    const Place3& q = vertices[static_cast<std::size_t>(ring[(i + 1) % ring.size()])];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      n[k] += (p[a] - q[a]) * (p[b] + q[b]);
    }
  }
  const double size = std::sqrt(dot(n, n));
  if (size > 0)
    for (double& c : n) c /= size;
  return n;
}

double depth_of(const std::vector<Place3>& vertices, const std::vector<int>& ring) {
  double sum = 0;
  for (const int v : ring) sum += dot(vertices[static_cast<std::size_t>(v)], kTowards);
  return sum / static_cast<double>(ring.size());
}

class SurfaceSeer {
 public:
  SurfaceSeer(const std::vector<Place3>& vertices, const std::vector<std::vector<int>>& faces)
      : vertices_(vertices), faces_(faces), shown_(faces.size(), -1) {}

  SeenSurface run() {
    for (std::size_t f = 0; f < faces_.size(); ++f) add_face(f);
    for (const auto& [edge, about] : edges_) add_edge(edge, about);
    if (out_.hidden.size() > kMostHidden) out_.hidden.clear();
    std::stable_sort(out_.faces.begin(), out_.faces.end(),
                     [](const SeenFace& a, const SeenFace& b) { return a.depth < b.depth; });
    return std::move(out_);
  }

 private:
  void add_face(std::size_t f) {
    const std::vector<int>& ring = faces_[f];
    normals_.push_back(normal_of(vertices_, ring));
    if (ring.empty()) return;
    const bool line = ring.size() < 3;
    if (line || dot(normals_[f], kTowards) > 0) {
      shown_[f] = static_cast<int>(out_.faces.size());
      out_.faces.push_back({ring, std::max(0.0, dot(normals_[f], kLight)), depth_of(vertices_, ring), {}});
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto [a, b] = std::minmax(ring[i], ring[(i + 1) % ring.size()]);
      if (a != b) edges_[{a, b}].push_back(f);
    }
  }

  void add_edge(const Edge3& edge, const std::vector<std::size_t>& about) {
    int nearest = -1, seen = 0;
    for (const std::size_t f : about) {
      if (shown_[f] < 0) continue;
      ++seen;
      if (nearest < 0 || out_.faces[std::size_t(nearest)].depth < out_.faces[std::size_t(shown_[f])].depth)
        nearest = shown_[f];
    }
    const bool crease = about.size() != 2 || dot(normals_[about[0]], normals_[about[1]]) < kFlat;
    if (seen > 0 && (crease || seen < static_cast<int>(about.size())))
      out_.faces[std::size_t(nearest)].edges.push_back(edge);
    else if (seen == 0 && crease)
      out_.hidden.push_back(edge);
  }

  const std::vector<Place3>& vertices_;
  const std::vector<std::vector<int>>& faces_;
  std::vector<int> shown_;  // the index in out_.faces of a face that is seen
  std::vector<Place3> normals_;
  std::map<Edge3, std::vector<std::size_t>> edges_;
  SeenSurface out_;
};

}  // namespace

SeenSurface seen_surface(const std::vector<Place3>& vertices, const std::vector<std::vector<int>>& faces) {
  return SurfaceSeer(vertices, faces).run();
}

std::string shaded(const std::array<int, 3>& colour, double light) {
  const double part = kShadow + (1 - kShadow) * light;
  const auto of = [&](std::size_t k) { return static_cast<int>(std::lround(colour[k] * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", of(0), of(1), of(2));
}

}  // namespace findspace::io
