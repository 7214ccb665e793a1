// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far solids protrude from a set given by its surfaces: surface_field.h, and on lines protrusion_rays.h.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "distance/rays/protrusion_rays.h"
#include "distance/search/tetrahedral_max_min.h"
#include "distance/surface/field_samples.h"
#include "distance/surface/place_tree.h"
#include "distance/surface/surface_field.h"
#include "distance/surface/void_places.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {
namespace {

using space::Vector;

/// Triangles whose distances bound a cell, at most.
constexpr std::size_t kFewTriangles = 8;
/// Triangles that may be nearest in a cell: more are not known by number, and fewer are not to be made fewer.
constexpr std::size_t kLongList = 24, kShortList = 3;
/// Of the distance: in larger cells they are many.
constexpr double kNearShare = 0.25;
/// Of the longest edge: the triangles near the middle of a wider cell do not bound it.
constexpr double kWideCell = 0.5;
/// Places that are asked one by one.
constexpr std::size_t kFewPlaces = 16;
/// Steps of a run, each as long as the point is clear.
constexpr int kMostSteps = 60;
/// Of the distance that is to be exceeded: what is looked at where a run is hardly clear.
constexpr double kWindowShare = 0.25;
constexpr int kMostMaxMinCells = 60000;
constexpr std::size_t kMostTangents = 256;

/// Of the parts of a surface, made when they are asked for. Safe to ask from many threads.
class InnerBalls {
 public:
  explicit InnerBalls(const SurfaceField& field) : field_(field), made_(field.parts()) {}
  ~InnerBalls() {
    for (auto& ball : made_) delete ball.load();
  }
  InnerBalls(const InnerBalls&) = delete;
  InnerBalls& operator=(const InnerBalls&) = delete;

  /// Null where none is known.
  const InnerBall* of(int part) const {
    std::atomic<const InnerBall*>& known = made_[static_cast<std::size_t>(part)];
    const InnerBall* ball = known.load(std::memory_order_acquire);
    if (!ball) {
      auto made = std::make_unique<const InnerBall>(field_.inner_ball(part).value_or(InnerBall{}));
      if (known.compare_exchange_strong(ball, made.get(), std::memory_order_acq_rel)) ball = made.release();
    }
    return ball->radius > 0 ? ball : nullptr;
  }

 private:
  const SurfaceField& field_;
  mutable std::vector<std::atomic<const InnerBall*>> made_;
};

/// A cell is bounded by a few triangles: any do.
class SurfaceTarget : public MaxMinTarget {
 public:
  SurfaceTarget(const SurfaceField& a, const SolidOfSurface* b, const FieldSamples* boxes, const InnerBalls* balls)
      : a_(a), b_(b), boxes_(boxes), balls_(balls) {
    for (const auto& sheet : a.set().sheets()) longest_ = std::max(longest_, sheet->longest);
    for (const auto& ball : a.set().balls()) longest_ = std::max(longest_, ball.radius.to_double());
  }

  double offer_in(const Vector& x, MaxMinBest& best) const override {
    const SurfaceField::Signed here = a_.at(x);
    best.offer(x, here.certain ? here.value : -here.distance);
    return here.value;
  }

  /// In a tree: no place of a ball about a node is farther from the set than its middle by more than the radius.
  void offer_all(std::span<const Vector> places, MaxMinBest& best) const override {
    if (places.size() > kFewPlaces)
      offer_farthest(places, best);
    else
      MaxMinTarget::offer_all(places, best);
  }

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    double reach = 0;
    for (const Vector& v : cell.corner) reach = std::max(reach, space::length(v - middle));
    const double most = std::max(best.slack(), best.found().value);
    if (surely_within(cell, middle, reach, most)) return false;
    if (boxes_ && reach > 4 * boxes_->least_half()) {
      const double value = boxes_->most_at(middle, reach / 4);
      cell.bound = std::min(cell.bound, value + reach);
      if (!best.worth(cell.bound) || boxes_->within(cell.corner, most)) return false;
      if (value <= most && reach > kWideCell * longest_) return true;
    }
    if (cell.sets.empty()) {
      for (const Vector& v : cell.corner) cell.sets.push_back(a_.nearest(v, -exact::kInfinity, {}).part);
    }
    const SurfaceField::Nearest near =
        cell.near ? among(*cell.near, middle) : a_.nearest(middle, most - reach, cell.sets);
    if (!best.worth(near.distance + reach)) return false;
    cell.sets.push_back(near.part);
    find_columns(cell);
    if (!best.worth(cell.bound)) return false;
    find_near(cell, middle, near.distance, reach);
    const auto inside = cell.outside ? std::optional(false) : a_.inside(middle, near.distance);
    cell.outside = inside == std::optional(false) && near.distance > 2 * reach;
    const double value = inside.value_or(false) ? -std::fabs(near.distance) : near.distance;
    cell.bound = std::min(cell.bound, value + reach);
    if (!best.worth(cell.bound)) return false;
    if (b_ && !cell.round && !cell.inner && !meets_b(cell, middle, reach, best)) return false;
    if (inside && value > best.found().value) offer_near(middle, cell, value, best);
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    const SurfaceField::Nearest near =
        cell.near ? among(*cell.near, x) : a_.nearest(x, std::max(best.slack(), best.found().value), cell.sets);
    cell.sets.push_back(near.part);
    if (!(near.distance > best.found().value)) return;
    const auto inside = cell.outside ? std::optional(false) : a_.inside(x, near.distance);
    if (inside && !*inside) offer_near(x, cell, near.distance, best);
  }

  double distance(int set, const Vector& x) const override { return a_.distance_to_place(set, x); }

  std::optional<Column> beyond(const MaxMinCell& cell, const Vector& middle) const override {
    if (cell.round || !b_ || b_->hull.empty()) return MaxMinTarget::beyond(cell, middle);
    return beyond_hull(middle, cell.corner);
  }

  double shortest_share() const override { return 1; }

 private:
  void offer_farthest(std::span<const Vector> places, MaxMinBest& best) const {
    struct Task {
      double most;
      int node, part;  // of the surface, that is the nearest one in its middle
      bool operator<(const Task& o) const { return most < o.most; }
    };
    std::vector<PlaceTree::Place> all;
    double size = 0;
    for (const Vector& v : places) {
      all.push_back({v});
      size = std::max(size, space::size_of(v));
    }
    PlaceTree tree(std::move(all));
    double value = best.found().value;
    std::uint32_t number = 0;
    plane::Subdivision<Task> left;
    const auto look = [&](int k, int part) {
      const PlaceTree::Node& node = tree.node(k);
      const SurfaceField::Signed here = a_.at(node.leaf() ? tree.place(k).at : node.middle, {part});
      const double known = here.certain ? here.value : -here.distance;
      if (!node.leaf()) {
        left.push({std::max(known, here.value) + node.radius + margin::kPlaceNoise * size, k, here.part});
      } else if (known > value || (known == value && tree.place(k).number < number)) {  // no sign: of equal ones
        value = known;
        number = tree.place(k).number;
      }
    };
    look(0, -1);
    left.run([&](const Task& top) { return top.most < value; },
             [&](const Task& top) {
               for (const int part : tree.divided(top.node)) look(part, top.part);
             });
    best.offer(places[number], value);
  }

  /// By a triangle that is near to all of the cell, or by a ball within the body that touches it there.
  bool surely_within(const MaxMinCell& cell, const Vector& middle, double reach, double most) const {
    return std::any_of(cell.sets.begin(), cell.sets.end(), [&](int part) {
      if (a_.distance_to_place(part, middle) <= most - reach) return true;
      const InnerBall* const ball = balls_ ? balls_->of(part) : nullptr;
      if (!ball) return false;
      const double far = ball->radius + most;
      return std::all_of(cell.corner.begin(), cell.corner.end(),
                         [&](const Vector& v) { return space::length(v - ball->center) <= far; });
    });
  }

  SurfaceField::Nearest among(const std::vector<int>& parts, const Vector& x) const {
    SurfaceField::Nearest best;
    for (const int part : parts) {
      const double d = a_.distance(part, x);
      if (d < best.distance) best = {d, part};
    }
    return best;
  }

  /// All places of the cell are within `reach` of the middle, and so nearer to the surface than the distance and that.
  void find_near(MaxMinCell& cell, const Vector& middle, double distance, double reach) const {
    if (cell.near && (cell.near->size() <= kShortList || cell.near_reach < 2 * reach)) return;
    if (!cell.near && reach > kNearShare * distance) return;
    const double within = (distance + 2 * reach) * (1 + margin::kRayNoise);
    if (!cell.near) {
      auto found = a_.near(middle, within, kLongList);
      if (!found) return;
      cell.near = std::make_shared<const std::vector<int>>(*std::move(found));
    } else {
      std::vector<int> some;
      for (const int part : *cell.near) {
        if (a_.distance(part, middle) <= within) some.push_back(part);
      }
      cell.near = std::make_shared<const std::vector<int>>(std::move(some));
    }
    cell.near_reach = reach;
  }

  /// A place of the cell, if it is one of B's, or the place of a ball that is nearest to it.
  void offer_near(const Vector& x, const MaxMinCell& cell, double value, MaxMinBest& best) const {
    if (cell.round && cell.round->beyond(x) > 0)
      offer_in(cell.round->pulled_in(x), best);
    else if (in_b(x))
      best.offer(x, value);
  }

  bool in_b(const Vector& x) const {
    if (!b_) return true;
    const SurfaceField::Signed of_b = b_->field->at(x);
    return of_b.certain && of_b.value <= 0;
  }

  /// Whether the cell meets B: where the surface is not near by the side of the middle. Where it is, by a plane that B
  /// is on one side of in the cell.
  bool meets_b(MaxMinCell& cell, const Vector& middle, double reach, MaxMinBest& best) const {
    const SurfaceField::Signed of_b = b_->field->at(middle);
    if (of_b.value > reach + best.noise()) return false;
    cell.inner = of_b.certain && of_b.value < -reach;
    if (of_b.distance > reach) return true;
    const auto plane = b_->field->bounding_plane(middle, reach);
    if (!plane) return true;
    const Column here = beyond_plane(*plane, cell.corner);
    if (!cell.beyond || mean_of(here) > mean_of(*cell.beyond)) cell.beyond = here;
    return !(*std::min_element(here.begin(), here.end()) > best.near());
  }

  static double mean_of(const Column& c) { return (c[0] + c[1] + c[2] + c[3]) / 4; }

  static Column beyond_plane(const space::PlaneTree::Plane& plane, const Tetrahedron& corners) {
    Column out{};
    for (std::size_t v = 0; v < 4; ++v) out[v] = plane.beyond(corners[v]);
    return out;
  }

  /// How far the corners are beyond the plane of B's hull that the place is farthest beyond.
  Column beyond_hull(const Vector& x, const Tetrahedron& corners) const {
    const Vector& by = b_->field->by();
    space::PlaneTree::Plane most = b_->hull.farthest_beyond(x - by);
    most.shift -= space::dot(most.unit, by);
    return beyond_plane(most, corners);
  }

  /// The distances of the cell's triangles from its corners; keeps those that bound it best.
  void find_columns(MaxMinCell& cell) const {
    struct Bounding {
      double most;
      int triangle;
      Column column;
    };
    if (cell.near && cell.near->size() <= kFewTriangles) cell.sets = *cell.near;  // others tell no more
    std::sort(cell.sets.begin(), cell.sets.end());
    cell.sets.erase(std::unique(cell.sets.begin(), cell.sets.end()), cell.sets.end());
    std::vector<Bounding> order;
    for (const int f : cell.sets) {
      Bounding& next = order.emplace_back(Bounding{0, f, {}});
      for (std::size_t v = 0; v < 4; ++v) next.column[v] = distance(f, cell.corner[v]);
      next.most = *std::max_element(next.column.begin(), next.column.end());
    }
    std::sort(order.begin(), order.end(), [](const Bounding& p, const Bounding& q) {
      return std::pair(p.most, p.triangle) < std::pair(q.most, q.triangle);
    });
    cell.bound = std::min(cell.bound, order[0].most);
    cell.sets.clear();
    for (const Bounding& b : order) {
      if (known(cell.distances, b.column)) continue;
      cell.sets.push_back(b.triangle);
      cell.distances.push_back(b.column);
      if (cell.sets.size() == kFewTriangles) break;
    }
  }

  /// Whether one of the columns is the same: the triangles have a corner or an edge in common, which is the nearest.
  static bool known(const std::vector<Column>& columns, const Column& next) {
    return std::any_of(columns.begin(), columns.end(), [&](const Column& c) {
      double apart = 0;
      for (std::size_t v = 0; v < 4; ++v) apart = std::max(apart, std::fabs(c[v] - next[v]));
      return apart <= margin::kPlaceNoise * next[0];
    });
  }

  const SurfaceField& a_;
  const SolidOfSurface* b_;
  const FieldSamples* boxes_;
  const InnerBalls* balls_;
  double longest_ = 0;  // edge of the surface
};

class FieldOfSurfaces : public ProtrusionField {
 public:
  explicit FieldOfSurfaces(const std::vector<space::RaySolid>& solids)
      : set_(made(solids)), boxes_(set_), balls_(field_) {
    const space::Extent box = field_.box();
    size_ = space::length(box.high - box.low);
  }
  double size() const override { return size_; }
  SolidMaxMin max_min(const Solids& solids, double slack, double share) const override {
    Solids some = solids;
    std::erase_if(some.cells, [&](const Tetrahedron& t) { return boxes_.within(t, slack); });
    return tetrahedral_max_min(some, SurfaceTarget(field_, nullptr, &boxes_, &balls_),
                               MaxMinBest(std::min(0.0, slack), slack, share, 0), plane::allowed(kMostCells));
  }
  bool outside(const Vector& x) const override {
    return field_.inside(x, field_.nearest(x, -exact::kInfinity, {}).distance) == std::optional(false);
  }
  bool within(const space::Extent& box, double most) const override { return boxes_.within(box, most); }
  std::vector<Tangent> tangents(const Vector& x, double least, double most) const override {
    std::vector<Tangent> out;
    const auto near = field_.near(x, most, kMostTangents);
    if (!near) return out;
    for (const int part : *near) {
      const Vector way = x - field_.place(part, x);
      const double d = space::length(way);
      if (least <= d && d <= most) out.push_back({d, space::scaled(1 / d, way)});
    }
    return out;
  }
  std::optional<std::vector<VoidPlace>> voids(double least, double most) const override {
    return void_places(field_, least, most);
  }
  /// By steps as long as the place is clear. Where that is little, by those of the triangles nearby, whose distances
  /// are convex: what is farther off than the window is not met within it.
  double run(const Vector& x, const Vector& way, double cut, double size, double farthest) const override {
    double at = 0;
    std::vector<int> likely;
    const double window = std::max(cut * kWindowShare, size * margin::kPlaceNoise);
    for (int count = 0; count < kMostSteps && at < farthest; ++count) {
      const Vector there = space::plus(x, space::scaled(at, way));
      const SurfaceField::Nearest near = field_.nearest(there, cut, likely);
      double clear = near.distance - cut;
      if (!(clear > size * margin::kPlaceNoise)) break;
      likely.assign(1, near.part);
      if (clear < window / 2) clear = std::max(clear, run_within(there, way, cut, size, window));
      at += clear;
    }
    return at;
  }

 private:
  static space::SurfaceSet made(const std::vector<space::RaySolid>& solids) {
    space::SurfaceSet out;
    out.add(solids, 1);
    return out;
  }

  double run_within(const Vector& x, const Vector& way, double cut, double size, double window) const {
    const auto near = field_.near(x, cut + window, kMostTangents);
    if (!near) return 0;
    double least = window;
    for (const int part : *near) {
      const auto beyond = [&](double s) { return field_.distance(part, space::plus(x, space::scaled(s, way))) - cut; };
      least = std::min(least, convex_run(beyond, size, window));
    }
    return least;
  }

  space::SurfaceSet set_;
  FieldSamples boxes_;
  const SurfaceField& field_ = boxes_.field();
  InnerBalls balls_;
  double size_;
};

}  // namespace

SolidMaxMin surface_max_min(const Solids& solids, const SolidOfSurface* b, const SurfaceField& a) {
  double size = 0;
  for (const Vector& v : solids.corners) size = std::max(size, space::size_of(v));
  return tetrahedral_max_min(solids, SurfaceTarget(a, b, nullptr, nullptr),
                             MaxMinBest(-exact::kInfinity, -exact::kInfinity, 0, margin::kPlaceNoise * size),
                             kMostMaxMinCells);
}

std::shared_ptr<ProtrusionField> field_of_surfaces(const std::vector<space::RaySolid>& solids) {
  return std::make_shared<FieldOfSurfaces>(solids);
}

}  // namespace findspace::distance
