// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/near_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/union_find.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/complex/side_by_side.h"
#include "plane/complex/simplify.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using plane::Cell;
using plane::CellComplex;
using plane::Index;
using plane::Mark;
using plane::PieceBox;
using plane::Region;

PlacedWindow::PlacedWindow(const PieceBox& box)
    : x(box.x0 + (box.x1 - box.x0) / 2),
      y(box.y0 + (box.y1 - box.y0) / 2),
      radius(plain_length(box.x1 - box.x0, box.y1 - box.y0) / 2 * margin::kUpward + margin::kUpwardSteps) {}

double PlacedWindow::noise(double distance) const {
  return (std::abs(x) + std::abs(y) + radius + distance) * margin::kMaxMinNoise + margin::kUpwardSteps;
}

CellComplex boundary_alone(const CellComplex& c, std::span<const Cell> chosen, Mark in, Mark out) {
  CellComplex alone = c;
  for (auto& f : alone.faces) f.mark = out;
  for (auto& e : alone.edges) e.mark = out;
  for (auto& v : alone.vertices) v.mark = out;
  for (const Cell& k : chosen) {
    if (k.dimension == 0) {
      alone.vertices[k.index].mark = in;
      continue;
    }
    auto& e = alone.edges[k.index];
    e.mark = in;
    for (const Index v : {e.v0, e.v1}) alone.vertices[v].mark = in;
  }
  return plane::simplify(std::move(alone));
}

double reach(const FeatureTree& set) {
  double most = 0;
  for (const BoundaryFeature& s : set.features()) most = std::max(most, s.farthest(0, 0));
  return most * margin::kUpward + margin::kUpwardSteps;
}

/// In rounds: joined boxes may meet others, and of a heap not all pairs are seen at once. Whatever the order, the same
/// boxes are left.
std::vector<PieceBox> boxes_apart(std::vector<PieceBox> boxes) {
  for (bool joined = true; joined;) {
    joined = false;
    plane::UnionFind same(boxes.size());
    std::size_t pairs = 16 * boxes.size();
    plane::meeting_boxes(boxes, [&](plane::Index i, plane::Index k) {
      same.unite(i, k);
      joined = true;
      return --pairs > 0;
    });
    if (!joined) break;
    std::vector<PieceBox> apart;
    std::vector<std::size_t> place(boxes.size());
    for (plane::Index k = 0; k < boxes.size(); ++k) {
      const plane::Index first = same.find(k);  // the least of its set
      if (first == k) {
        place[k] = apart.size();
        apart.push_back(boxes[k]);
      } else {
        PieceBox& all = apart[place[first]];
        all = plane::joined(all, boxes[k]);
      }
    }
    boxes = std::move(apart);
  }
  std::sort(boxes.begin(), boxes.end(), [](const PieceBox& a, const PieceBox& b) {
    return std::array{a.x0, a.y0, a.x1, a.y1} < std::array{b.x0, b.y0, b.x1, b.y1};
  });
  return boxes;
}

Region region_of_boxes(std::span<const PieceBox> boxes) {
  std::vector<plane::Contour> rings;
  for (const PieceBox& b : boxes) {
    const auto x0 = std::int64_t(b.x0), y0 = std::int64_t(b.y0), x1 = std::int64_t(b.x1), y1 = std::int64_t(b.y1);
    plane::Contour& ring = rings.emplace_back();
    for (const plane::GridPoint p : {plane::GridPoint{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) ring.push_back({p});
  }
  std::vector<std::span<const plane::Contour>> polygons;
  for (const plane::Contour& ring : rings) polygons.push_back({&ring, 1});
  return plane::region_of_polygons(polygons);
}

namespace {

constexpr std::size_t kMostLooks = 20'000, kMostBoxes = 64;

/// The boxes of the plane that hold every place of B as far from A as wanted.
class FarPlaces {
 public:
  FarPlaces(const FeatureTree& b, const FeatureTree& a, const PlacedWindow& window, double low)
      : b_(b), a_(a), window_(window), low_(low) {}

  /// Nothing where they are too many.
  std::optional<std::vector<PieceBox>> boxes() {
    double half = 1;
    while (half < b_.scale()) half *= 2;
    todo_.push_back({0, 0, half});
    for (std::size_t looks = 0; !todo_.empty(); ++looks) {
      if (looks > kMostLooks) return std::nullopt;
      const Square s = todo_.back();
      todo_.pop_back();
      if (matters(s)) split(s);
    }
    auto out = boxes_apart(std::move(found_));
    return out.size() <= kMostBoxes ? std::optional(std::move(out)) : std::nullopt;
  }

 private:
  struct Square {
    double x, y, half;
    double radius() const { return half * std::sqrt(2.0) * margin::kUpward; }
  };

  bool matters(const Square& s) const {
    const auto own = b_.nearest(s.x, s.y);
    if (own.distance > s.radius() + noise() && b_.contains(s.x, s.y, own) == false) return false;
    const double x = s.x + window_.x, y = s.y + window_.y;
    const auto near = a_.nearest(x, y);
    const double far = a_.contains(x, y, near) == true ? 0 : near.distance;
    return far + s.radius() + window_.radius + noise() >= low_;
  }

  void split(const Square& s) {
    if (s.half <= 1 || s.radius() <= window_.radius) {
      found_.push_back({s.x - s.half, s.y - s.half, s.x + s.half, s.y + s.half});
      return;
    }
    const double h = s.half / 2;
    for (const double dx : {-h, h})
      for (const double dy : {-h, h}) todo_.push_back({s.x + dx, s.y + dy, h});
  }

  double noise() const { return window_.noise(a_.scale() + b_.scale()); }

  const FeatureTree &b_, &a_;
  const PlacedWindow& window_;
  double low_;
  std::vector<Square> todo_;
  std::vector<PieceBox> found_;
};

/// The edges of A that count beside these boxes; nothing where a box may reach into A.
std::optional<std::vector<Cell>> edges_beside(const FeatureTree& a, std::span<const PieceBox> boxes,
                                              const PlacedWindow& window, double high) {
  std::vector<Cell> out;
  for (const PieceBox& b : boxes) {
    PlacedWindow at(b);
    at.x += window.x;
    at.y += window.y;
    const double reach = at.radius + window.radius + window.noise(a.scale());
    const auto near = a.nearest(at.x, at.y);
    if (near.distance <= reach || a.contains(at.x, at.y, near) != false) return std::nullopt;
    a.for_near(at.x, at.y, reach + high, [&](Index k) {
      out.push_back(a.features()[k].cell);
      return true;
    });
  }
  return out;
}

}  // namespace

std::optional<NearParts> near_parts(const FeatureTree& b, const FeatureTree& a, const PlacedWindow& window, double low,
                                    double high) {
  if (b.has_arcs() || a.has_arcs()) return std::nullopt;
  const auto boxes = FarPlaces(b, a, window, low).boxes();
  if (!boxes) return std::nullopt;
  if (boxes->empty()) return NearParts{CellComplex::uniform(0), a.region()};
  const Region places = region_of_boxes(*boxes);
  const std::array<const Region*, 2> both{&b.region(), &places};
  NearParts out{plane::intersect(both), {}};
  const auto edges = edges_beside(a, *boxes, window, high);
  out.a = edges ? boundary_alone(a.region(), *edges, 1, 0) : a.region();
  return out;
}

}  // namespace findspace::distance
