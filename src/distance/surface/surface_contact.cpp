// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_contact.h"

#include <algorithm>

#include "distance/search/plane_projections.h"
#include "distance/surface/contact_boxes.h"
#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;
using space::SurfaceSet;
using space::TouchSide;
using space::Vector;
using Box = ContactBoxes::Box;

namespace {

/// Of a box that many planes pass: points in which some of them meet, at most.
constexpr std::size_t kMostCorners = 2000000;
constexpr int kMostContactBoxes = 200000;
/// Kept for later searches, which takes a kilobyte each, more or less.
constexpr std::size_t kMostKept = 200000;

class ContactSearch {
 public:
  ContactSearch(ContactBoxes& boxes, const RealVector& p, bool farthest)
      : boxes_(boxes),
        p_(p),
        near_(space::rounded(p)),
        farthest_(farthest),
        size_(boxes.size() + space::length(near_)) {
    push(0);
  }

  SurfaceContact run() {
    const auto end = queue_.run(
        kMostContactBoxes, [&](const Task& top) { return beyond(top.key); }, [&](const Task& top) { look(top); });
    if (end == plane::SubdivisionEnd::kSpent) return {};
    const double off = std::max(best_ - bound_, 0.0);
    if (off > margin::kMostContactOff * size_) return {};
    return {true, place_, off};
  }

 private:
  struct Task {
    double key;  // nothing in it is nearer; or minus that nothing is farther
    int box;
    bool operator<(const Task& o) const { return key != o.key ? key > o.key : box > o.box; }
  };

  bool beyond(double key) const { return key > best_ + margin::kContactSlack * size_; }

  void push(int k) {
    const space::Extent& of = boxes_.box(k).of;
    const double key = farthest_ ? -of.farthest(near_) : of.distance(near_);
    if (!beyond(key)) queue_.push({key, k});
  }

  void look(const Task& task) {
    const Box& box = boxes_.look(task.box);
    if (box.state == ContactBoxes::State::kPlanes) test(box);
    if (box.state == ContactBoxes::State::kMany && !test_many(task.box)) {
      if (boxes_.tiny(box))
        bound_ = std::min(bound_, task.key);
      else
        boxes_.divide(task.box);
    }
    if (box.state != ContactBoxes::State::kDivided) return;
    for (int part = 0; part < 8; ++part) push(box.first + part);
  }

  /// All candidates of a box that few planes pass.
  void test(const Box& box) {
    if (box.planes.empty()) {
      no_frontier(box);
      return;
    }
    const PlaneProjections projections(box.planes, p_, size_);
    test(projections, projections.all(box.of.middle() - near_, reach_of(box), farthest_));
  }

  static Vector reach_of(const Box& box) { return space::scaled(1.0625, box.half()); }

  void test(const PlaneProjections& projections, std::vector<PlaneProjections::Projection> found) {
    // The least they may be, or minus the greatest.
    for (PlaneProjections::Projection& f : found) f.key = (farthest_ ? -f.key : f.key) - 2 * f.error;
    std::sort(found.begin(), found.end(),
              [](const auto& f, const auto& g) { return std::tie(f.key, f.planes) < std::tie(g.key, g.planes); });
    for (const PlaneProjections::Projection& f : found) {
      if (beyond(f.key)) break;
      if (!boxes_.surely_overlap(space::plus(near_, f.at), 2 * f.error)) offer(projections.exact(f));
    }
  }

  /// The same of many planes, of which most pass through one place; false where there are too many others.
  bool test_many(int k) {
    const auto planes = boxes_.many_planes(k);
    if (!planes) return false;
    const PlaneProjections projections(*planes, p_, size_);
    const Box& box = boxes_.box(k);
    const Vector middle = box.of.middle() - near_, reach = reach_of(box);
    test(projections, projections.some_corners(middle, reach));
    const std::vector<bool> through = place_ ? projections.through(*place_) : std::vector<bool>(planes->size());
    const auto others = static_cast<std::size_t>(std::count(through.begin(), through.end(), false));
    if (others * planes->size() * planes->size() > kMostCorners) return false;
    test(projections, projections.all(middle, reach, farthest_, through));
    return true;
  }

  /// A box that is all on one side: where it is in C, its place nearest to p bounds what is looked for.
  void no_frontier(const Box& box) {
    const auto pick = [&](double c, double lo, double hi) {
      return farthest_ ? (c - lo > hi - c ? lo : hi) : std::clamp(c, lo, hi);
    };
    const Vector &low = box.of.low, &high = box.of.high;
    offer(
        space::real(Vector{pick(near_.x, low.x, high.x), pick(near_.y, low.y, high.y), pick(near_.z, low.z, high.z)}));
  }

  void offer(const RealVector& q) {
    const RealVector way = space::minus(q, p_);
    const Real square = space::dot(way, way);
    if (place_) {
      const int order = compare(square, square_) * (farthest_ ? -1 : 1);
      if (order > 0 || (order == 0 && !(q < *place_))) return;
    }
    if (boxes_.overlap(q)) return;
    place_ = q;
    square_ = square;
    best_ = std::sqrt(square.to_double()) * (farthest_ ? -1 : 1);
  }

  ContactBoxes& boxes_;
  RealVector p_;
  Vector near_;
  bool farthest_;
  double size_;
  plane::Subdivision<Task> queue_;
  std::optional<RealVector> place_;
  Real square_;
  double best_ = exact::kInfinity, bound_ = exact::kInfinity;
};

}  // namespace

SurfaceContacts::SurfaceContacts(const SurfaceSet& b, const SurfaceSet& a, TouchSide side)
    : b_(b), a_(a), side_(side) {}
SurfaceContacts::~SurfaceContacts() = default;

SurfaceContact SurfaceContacts::search(const RealVector& p, bool farthest) const {
  std::unique_ptr<ContactBoxes> boxes;
  {
    const std::lock_guard lock(guard_);
    if (!free_.empty()) {
      boxes = std::move(free_.back());
      free_.pop_back();
    }
  }
  if (!boxes) boxes = std::make_unique<ContactBoxes>(b_, a_, side_);
  SurfaceContact found = ContactSearch(*boxes, p, farthest).run();
  if (boxes->count() > kMostKept) return found;
  const std::lock_guard lock(guard_);
  free_.push_back(std::move(boxes));
  return found;
}

SurfaceContact SurfaceContacts::nearest(const RealVector& p) const { return search(p, false); }
SurfaceContact SurfaceContacts::farthest(const RealVector& p) const { return search(p, true); }

}  // namespace findspace::distance
