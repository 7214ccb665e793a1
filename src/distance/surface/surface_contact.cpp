// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_contact.h"

#include <algorithm>
#include <deque>

#include "distance/search/boundary_cells.h"
#include "distance/search/plane_projections.h"
#include "distance/surface/surface_depths.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"
#include "space/polytope/extent.h"
#include "space/surface/contact_planes.h"
#include "space/surface/real_overlap.h"

namespace findspace::distance {

using exact::Real;
using space::HalfSpace;
using space::Plane;
using space::RealVector;
using space::SurfaceSet;
using space::TouchSide;
using space::Vector;

/// Boxes of positions of B about a solid A, divided where more has to be known: those at all of whose positions the
/// interiors meet, surely, those that few planes of contact pass, of which none is missed, and those to be divided.
/// What one search finds the next one knows.
class ContactBoxes {
 public:
  /// Of one sheet each. Inside: in the complement of A. Keeps references.
  ContactBoxes(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side);

  enum class State { kNew, kOverlap, kPlanes, kMany, kDivided };
  struct Box {
    space::Extent of;
    int level = 0;
    State state = State::kNew;
    int first = -1;                        // of eight
    int likely = SurfaceDepths::kNone;     // where depths are looked for first
    std::vector<space::HalfSpace> planes;  // that pass it; none: it is all on one side of the frontier

    space::Vector half() const { return space::scaled(0.5, of.high - of.low); }
  };
  /// Whether a place tells that the interiors meet in all of the box.
  bool overlaps(int k);
  /// At all positions of the box that are nearer to p than that they do; at least `known`, which is known; infinite
  /// where they do in all of the box.
  double overlap(int k, const space::Vector& p, double known);
  /// The box number k, looked at; the first one holds all of the frontier. One that many planes pass is divided, but
  /// where these may all pass through one place, which is asked now and then: its state is `many`.
  const Box& look(int k);
  /// The same without looking.
  const Box& box(int k) const { return boxes_[static_cast<std::size_t>(k)]; }
  /// Those of a box that many pass; nothing where they are too many.
  std::optional<std::vector<space::HalfSpace>> many_planes(int k) const;
  bool tiny(const Box& box) const { return space::length(box.half()) < margin::kSmallestContactBox * size_; }
  /// One that is not tiny, in eight.
  void divide(int k);

  /// Whether the interiors meet.
  bool overlap(const space::RealVector& p) { return overlap_.interiors_meet(p, recent_); }
  /// Whether they do for sure at a position that is off by no more.
  bool surely_overlap(const space::Vector& p, double off) const { return overlap_.surely_meet(p, off, recent_); }
  /// That were made.
  std::size_t count() const { return boxes_.size(); }
  /// Of the coordinates and the boxes.
  double size() const { return size_; }

 private:
  space::RealOverlap overlap_;
  space::ContactPlanes planes_;
  SurfaceDepths depths_;
  double size_ = 0;
  std::deque<Box> boxes_;
  space::RealOverlap::Recent recent_;
};

namespace {

/// Planes of a box, and pairs of triangles looked through for them.
constexpr std::size_t kFewPlanes = 100, kFewPairs = 5000;
/// The same where they may pass through one place, as in an exact fit, which is tried every so many divisions.
constexpr std::size_t kManyPlanes = 2000, kManyPairs = 400000, kPairsEarly = 20000;
constexpr int kOften = 7, kEarly = 12;

std::vector<HalfSpace> half_spaces(const std::vector<Plane>& planes) { return {planes.begin(), planes.end()}; }

}  // namespace

ContactBoxes::ContactBoxes(const space::SurfaceSet& b, const space::SurfaceSet& a, space::TouchSide side)
    : overlap_(*a.sheets()[0], *b.sheets()[0], side == space::TouchSide::kInside),
      planes_(overlap_.a(), a.sheets()[0]->tree, overlap_.b(), b.sheets()[0]->tree),
      depths_(b, a, side) {
  const auto approx = [](const space::Point& v) { return exact::approx(v); };
  const bool inside = side == space::TouchSide::kInside;
  const space::RayBody &of_a = overlap_.a(), &of_b = overlap_.b();
  const Vector low = approx(inside ? of_a.low - of_b.low : of_a.low - of_b.high),
               high = approx(inside ? of_a.high - of_b.high : of_a.high - of_b.low);
  // The bodies may be as large as each other: some more room for rounding.
  const double tolerance = margin::kAroundContacts * space::length(approx(of_b.high - of_b.low));
  const space::Extent complete = askew(grown({low, high}, tolerance));
  size_ = space::length(complete.low) + space::length(complete.high) + depths_.size();
  // B's box may be larger than A's: then B lies in A nowhere.
  const Vector wide = complete.high - complete.low;
  const bool none = wide.x < 0 || wide.y < 0 || wide.z < 0;
  boxes_.push_back({complete, 0, none ? State::kOverlap : State::kNew, -1, SurfaceDepths::kNone, {}});
}

bool ContactBoxes::overlaps(int k) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  if (box.state == State::kNew && depths_.overlap(box.of, box.likely)) box.state = State::kOverlap;
  return box.state == State::kOverlap;
}

double ContactBoxes::overlap(int k, const Vector& p, double known) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  if (box.state == State::kOverlap) return exact::kInfinity;
  if (box.state != State::kNew) return known;
  const double out = depths_.overlap(box.of, p, known, box.likely);
  if (out == exact::kInfinity) box.state = State::kOverlap;
  return out;
}

const ContactBoxes::Box& ContactBoxes::look(int k) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  if (box.state != State::kNew) return box;
  const Vector middle = box.of.middle();
  const double half = space::length(box.half());
  if (const auto planes = planes_.near(middle, half, kFewPlanes, kFewPairs)) {
    box.state = State::kPlanes;
    box.planes = half_spaces(*planes);
  } else if (tiny(box) || box.level % kOften == kOften - 1) {
    box.state = State::kMany;
  } else {
    divide(k);
  }
  return box;
}

std::optional<std::vector<HalfSpace>> ContactBoxes::many_planes(int k) const {
  const Box& box = boxes_[static_cast<std::size_t>(k)];
  const std::size_t pairs = box.level > kEarly ? kManyPairs : kPairsEarly;
  const auto planes = planes_.near(box.of.middle(), space::length(box.half()), kManyPlanes, pairs);
  if (!planes) return std::nullopt;
  return half_spaces(*planes);
}

void ContactBoxes::divide(int k) {
  Box& box = boxes_[static_cast<std::size_t>(k)];
  box.state = State::kDivided;
  box.first = static_cast<int>(boxes_.size());
  for (int part = 0; part < 8; ++part)
    boxes_.push_back({box.of.eighth(part), box.level + 1, State::kNew, -1, box.likely, {}});
}

namespace {

using Box = ContactBoxes::Box;

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
    push(0, -exact::kInfinity);
  }

  SurfaceContact run() {
    bool spent = false;
    const auto end = queue_.run(
        plane::allowed(kMostContactBoxes),
        [&](const Task& top) { return beyond(top.key) || (spent = plane::cells_left() <= 0); },
        [&](const Task& top) {
          plane::count_cell();
          look(top);
        });
    if (spent || end == plane::SubdivisionEnd::kSpent) return {};
    const double off = std::max(best_ - bound_, 0.0);
    if (off > margin::kMostContactOff * size_) return {};
    return {true, place_, off};
  }

 private:
  struct Task {
    double key;  // nothing in it is nearer; or minus that nothing is farther
    int box;
    bool told = false;  // how near its positions do not overlap
    bool operator<(const Task& o) const { return key != o.key ? key > o.key : box > o.box; }
  };

  bool beyond(double key) const { return key > best_ + margin::kContactSlack * size_; }

  void push(int k, double least) {
    const space::Extent& of = boxes_.box(k).of;
    push(Task{std::max(least, farthest_ ? -of.farthest(near_) : of.distance(near_)), k});
  }

  /// Not where all of the box is known to overlap.
  void push(const Task& task) {
    const double most = farthest_ ? exact::kInfinity : boxes_.box(task.box).of.farthest(near_);
    if (!beyond(task.key) && task.key <= most + margin::kContactSlack * size_) queue_.push(task);
  }

  /// Whether nothing in the box is so near as its key says: then it waits, if it has something.
  bool waits(const Task& task) {
    if (farthest_) return boxes_.overlaps(task.box);
    if (task.told) return false;
    const double least = boxes_.overlap(task.box, near_, task.key);
    if (!(least > task.key)) return false;
    push(Task{least, task.box, true});
    return true;
  }

  void look(const Task& task) {
    if (waits(task)) return;
    const Box& box = boxes_.look(task.box);
    if (box.state == ContactBoxes::State::kPlanes) test(box);
    if (box.state == ContactBoxes::State::kMany && !test_many(task.box)) {
      if (boxes_.tiny(box))
        bound_ = std::min(bound_, task.key);
      else
        boxes_.divide(task.box);
    }
    if (box.state != ContactBoxes::State::kDivided) return;
    for (int part = 0; part < 8; ++part) push(box.first + part, task.key);
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
