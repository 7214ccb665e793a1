// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far solids protrude from a closed surface: protrusion_field.h.
#include <algorithm>
#include <cmath>

#include "distance/search/field_boxes.h"
#include "distance/search/protrusion_field.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"
#include "space/surface/surface_side.h"

namespace findspace::distance {
namespace {

using space::BoxTree;
using space::Vector;

/// Triangles whose distances bound a cell, at most.
constexpr std::size_t kFew = 8;
/// Of the octree about the surface.
constexpr int kDepth = 9;
/// Steps of a run, each as long as the point is clear.
constexpr int kMostSteps = 60;

struct Corners {
  Vector a, b, c;
};

/// The place of a triangle that is nearest to x (Ericson, Real-Time Collision Detection, 5.1.5).
Vector nearest_place(const Corners& t, const Vector& x) {
  const Vector ab = t.b - t.a, ac = t.c - t.a, ax = x - t.a, bx = x - t.b, cx = x - t.c;
  const double d1 = space::dot(ab, ax), d2 = space::dot(ac, ax), d3 = space::dot(ab, bx), d4 = space::dot(ac, bx),
               d5 = space::dot(ab, cx), d6 = space::dot(ac, cx);
  if (d1 <= 0 && d2 <= 0) return t.a;
  if (d3 >= 0 && d4 <= d3) return t.b;
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return space::plus(t.a, space::scaled(d1 / (d1 - d3), ab));
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return space::plus(t.a, space::scaled(d2 / (d2 - d6), ac));
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return space::plus(t.b, space::scaled((d4 - d3) / ((d4 - d3) + (d5 - d6)), t.c - t.b));
  const double complete = va + vb + vc;
  return space::plus(t.a, space::plus(space::scaled(vb / complete, ab), space::scaled(vc / complete, ac)));
}

struct FaceBox {
  Vector low, high;
};

FaceBox box_of(const space::GridBox& box) { return {exact::approx(box.low), exact::approx(box.high)}; }

/// The square of the distance.
double gap(const FaceBox& box, const Vector& x) {
  const double u = std::max({box.low.x - x.x, x.x - box.high.x, 0.0}),
               v = std::max({box.low.y - x.y, x.y - box.high.y, 0.0}),
               w = std::max({box.low.z - x.z, x.z - box.high.z, 0.0});
  return u * u + v * v + w * w;
}

class TriangleField : public ProtrusionField {
 public:
  explicit TriangleField(const space::Triangles& surface) : body_(surface), tree_(body_) {
    for (int f = 0; f < static_cast<int>(body_.faces.size()); ++f)
      triangles_.push_back(
          {exact::approx(body_.corner(f, 0)), exact::approx(body_.corner(f, 1)), exact::approx(body_.corner(f, 2))});
    for (const BoxTree::Node& node : tree_.nodes()) boxes_.push_back(box_of(node.box));
    for (int k = 0; k < static_cast<int>(body_.faces.size()); ++k) face_boxes_.push_back(box_of(tree_.box(k)));
    const Vector low = exact::approx(body_.low), high = exact::approx(body_.high);
    size_ = space::length(high - low);
    known_ = std::make_unique<const FieldBoxes>(space::scaled(0.5, space::plus(low, high)), size_, kDepth,
                                                [this](const Vector& x) { return signed_distance(x); });
  }
  double size() const override { return size_; }
  SolidMaxMin max_min(std::span<const Tetrahedron> solid, std::span<const RoundSolid> round, double slack,
                      double share) const override;
  double run(const Vector& x, const Vector& way, double cut, double size) const override {
    double at = 0;
    for (int count = 0; count < kMostSteps && at < 4 * size; ++count) {
      const double clear = nearest(space::plus(x, space::scaled(at, way))).distance - cut;
      if (!(clear > size * margin::kPlaceNoise)) break;
      at += clear;
    }
    return at;
  }

  /// Whether no place of the cell is farther out, by what searches before it saw.
  bool surely_within(const Tetrahedron& cell, double most) const { return known_->within(cell, most); }
  double least_known() const { return known_->least_half(); }

  double distance(int triangle, const Vector& x) const {
    return space::length(x - nearest_place(triangles_[static_cast<std::size_t>(triangle)], x));
  }
  struct Nearest {
    double distance = exact::kInfinity;
    int triangle = -1;
  };
  /// On the surface; where the distance is not more than `enough` any triangle that is so near. `likely`: tried first.
  Nearest nearest(const Vector& x, double enough = 0, std::span<const int> likely = {}) const {
    Nearest best;
    for (const int f : likely) {
      const double d = distance(f, x);
      if (d < best.distance) best = {d, f};
    }
    if (best.distance <= enough) return best;
    visit(x, best.distance, [&](int f) {
      const double d = distance(f, x);
      if (d < best.distance) best = {d, f};
      return best.distance > enough;
    });
    return best;
  }
  /// Of a point that is not on the surface.
  bool inside(const Vector& x) const {
    return space::side_of(body_, tree_, space::real(x), x) == space::SurfaceSide::kInside;
  }

 private:
  /// Calls take(face) for the faces of leaves whose boxes are not farther than `most`, which it may lower, near ones
  /// first; stops where it returns false.
  template <class Take>
  void visit(const Vector& x, double& most, Take take) const {
    struct Task {
      int node;
      double gap;
    };
    Task stack[128];
    int depth = 0;
    stack[depth++] = {0, 0};
    while (depth > 0) {
      const Task top = stack[--depth];
      if (top.gap > most * most) continue;
      const BoxTree::Node& node = tree_.nodes()[static_cast<std::size_t>(top.node)];
      for (int k = node.first; k < node.first + node.count; ++k) {
        if (gap(face_boxes_[static_cast<std::size_t>(k)], x) > most * most) continue;
        if (!take(tree_.face(k))) return;
      }
      if (node.count > 0) continue;
      Task one{node.first, gap(boxes_[static_cast<std::size_t>(node.first)], x)},
          two{node.first + 1, gap(boxes_[static_cast<std::size_t>(node.first) + 1], x)};
      if (one.gap < two.gap) std::swap(one, two);
      stack[depth++] = one;
      stack[depth++] = two;
    }
  }

  double signed_distance(const Vector& x) const {
    const double d = nearest(x).distance;
    return inside(x) ? -d : d;
  }

  space::RayBody body_;
  BoxTree tree_;
  std::vector<Corners> triangles_;
  std::vector<FaceBox> boxes_, face_boxes_;  // of the nodes; of the faces, as the tree has them
  double size_;
  std::unique_ptr<const FieldBoxes> known_;
};

/// A cell is bounded by a few triangles: any do.
class TriangleTarget : public MaxMinTarget {
 public:
  explicit TriangleTarget(const TriangleField& field) : field_(field) {}

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    double radius = 0;
    for (const Vector& v : cell.corner) radius = std::max(radius, space::length(v - middle));
    const double most = std::max(best.slack(), best.found().value);
    if (radius > 4 * field_.least_known() && field_.surely_within(cell.corner, most)) return false;
    if (cell.sets.empty()) {
      for (const Vector& v : cell.corner) cell.sets.push_back(field_.nearest(v).triangle);
    }
    const TriangleField::Nearest near = field_.nearest(middle, most - radius, cell.sets);
    if (!best.worth(near.distance + radius)) return false;
    cell.sets.push_back(near.triangle);
    find_columns(cell);
    if (!best.worth(cell.bound)) return false;
    const bool inside = field_.inside(middle);
    const double value = inside ? -near.distance : near.distance;
    cell.bound = std::min(cell.bound, value + radius);
    if (!best.worth(cell.bound)) return false;
    if (!inside) best.offer(middle, value);
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    const TriangleField::Nearest near = field_.nearest(x, 0, cell.sets);
    cell.sets.push_back(near.triangle);
    if (near.distance > best.found().value && !field_.inside(x)) best.offer(x, near.distance);
  }

  double distance(int set, const Vector& x) const override { return field_.distance(set, x); }
  double shortest_share() const override { return 1; }

 private:
  /// The distances of the cell's triangles from its corners; keeps those that bound it best.
  void find_columns(MaxMinCell& cell) const {
    struct Bounding {
      double most;
      int triangle;
      Column column;
    };
    std::sort(cell.sets.begin(), cell.sets.end());
    cell.sets.erase(std::unique(cell.sets.begin(), cell.sets.end()), cell.sets.end());
    std::vector<Bounding> order;
    for (const int f : cell.sets) {
      Bounding& next = order.emplace_back(Bounding{0, f, {}});
      for (std::size_t v = 0; v < 4; ++v) next.column[v] = field_.distance(f, cell.corner[v]);
      next.most = *std::max_element(next.column.begin(), next.column.end());
    }
    std::sort(order.begin(), order.end(), [](const Bounding& p, const Bounding& q) {
      return std::pair(p.most, p.triangle) < std::pair(q.most, q.triangle);
    });
    cell.bound = std::min(cell.bound, order[0].most);
    order.resize(std::min(order.size(), kFew));
    cell.sets.clear();
    for (const Bounding& b : order) {
      cell.sets.push_back(b.triangle);
      cell.distances.push_back(b.column);
    }
  }

  const TriangleField& field_;
};

SolidMaxMin TriangleField::max_min(std::span<const Tetrahedron> solid, std::span<const RoundSolid> /*round*/,
                                   double slack, double share) const {
  const TriangleTarget target(*this);
  TetrahedralMaxMin search(target, MaxMinBest(std::min(0.0, slack), slack, share, 0));
  for (const Tetrahedron& t : solid) {
    if (!surely_within(t, slack)) search.add(t, nullptr, exact::kInfinity, {});
  }
  return search.run(kMostCells);
}

}  // namespace

std::unique_ptr<ProtrusionField> field_of_surface(const space::Triangles& surface) {
  return std::make_unique<TriangleField>(surface);
}

}  // namespace findspace::distance
