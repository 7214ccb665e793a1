// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/explain/place_search.h"

#include <algorithm>
#include <utility>

#include "exact/margins/space_distance.h"
#include "plane/base/parallel.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::formula {

using space::Vector;

namespace {

constexpr std::size_t kAtOnce = 16;
constexpr double kAlmostLongest = 0.6;  // no sign: sides this long are divided too, so that boxes stay compact

struct Box {
  PlaceBox place;
  double bound = -exact::kInfinity;
  bool operator<(const Box& other) const { return bound > other.bound; }  // the least is on top
  void draw(plane::ObservedCells& seen) const {
    const Vector low = place.center - place.half, high = space::plus(place.center, place.half);
    seen.add_box({low.x, low.y, low.z}, {high.x, high.y, high.z});
  }
};

/// Not less than the distance of any place of the box from its centre, with room for the rounding of both.
double radius(const PlaceBox& box) {
  const double half = space::length(box.half);
  return half + margin::kPlaceNoise * (half + space::size_of(box.center));
}

class Search {
 public:
  explicit Search(const PlaceSearch& asked) : asked_(asked) {}

  PlaceFound run(const std::vector<PlaceBox>& boxes) {
    for (const space::RealVector& p : asked_.first) note(p, asked_.look(p));
    for (const PlaceBox& b : boxes) parts_.push_back({b});
    take();
    queue_.run(
        kMostDivisions, kAtOnce, [&](const Box& top) { return spent() || settled(top.bound); },
        [&](const Box& top) { divide(top); }, [&] { take(); });
    // Boxes that were dropped hold nothing below the least value.
    found_.bound = queue_.empty() ? found_.least : std::min(queue_.best().bound, found_.least);
    return found_;
  }

 private:
  /// Values that are searched may take as many cells together as those of one question.
  bool spent() const { return cells_ >= plane::allowed(plane::kMostCellsOfQuestion); }
  bool settled(double bound) const { return found_.least <= asked_.enough || found_.least - bound <= asked_.tolerance; }

  void divide(const Box& box) {
    const std::array<double, 3> half{box.place.half.x, box.place.half.y, box.place.half.z};
    const double longest = std::max({half[0], half[1], half[2]});
    std::array<double, 3> by{};
    for (std::size_t k = 0; k < 3; ++k) by[k] = half[k] >= kAlmostLongest * longest ? half[k] / 2 : 0;
    const Vector part{half[0] - by[0], half[1] - by[1], half[2] - by[2]};
    for (unsigned k = 0; k < 8; ++k) {
      const std::array<bool, 3> up{(k & 1U) != 0, (k & 2U) != 0, (k & 4U) != 0};
      if ((up[0] && by[0] == 0) || (up[1] && by[1] == 0) || (up[2] && by[2] == 0)) continue;
      const Vector off{up[0] ? by[0] : -by[0], up[1] ? by[1] : -by[1], up[2] ? by[2] : -by[2]};
      parts_.push_back({{space::plus(box.place.center, off), part}, box.bound});
    }
  }

  /// A box, what is known of its centre, and how many cells searches looked at for that.
  struct Glance {
    PlaceSeen seen;
    bool exact = false;
    long cells = 0;
  };

  void take() {
    std::vector<Box> boxes = std::exchange(parts_, {});
    std::vector<Glance> seen(boxes.size());
    plane::in_ranges(boxes.size(), kAtOnce, [&](const plane::IndexRange& range) {
      for (std::size_t k = range.first; k < range.end; ++k) seen[k] = counted(boxes[k]);
    });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      cells_ += seen[k].cells;
      const Vector& center = boxes[k].place.center;
      if (!seen[k].exact && perhaps_best(seen[k].seen)) seen[k] = {asked_.look(space::real(center)), true};
      note(boxes[k], seen[k]);
    }
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      boxes[k].bound = bound(boxes[k], seen[k].seen);
      if (!is_needless(boxes[k], seen[k].seen) && longest(boxes[k]) > 0) queue_.push(boxes[k]);
    }
  }
  Glance counted(const Box& box) const {
    plane::SearchWork work;
    const long all = work.left;
    const plane::ScopedSearchWork here(&work);
    Glance out = glance(box);
    out.cells = all - work.left;
    return out;
  }
  /// Exact where numbers say too little. Does not change what was found.
  Glance glance(const Box& box) const {
    const auto is_needless_now = [&](const PlaceSeen& s) { return is_needless(box, s); };
    const PlaceSeen near = asked_.glance(box.place.center, is_needless_now);
    const bool is_open = near.open || near.value.lo == -exact::kInfinity;
    if (!is_open || is_needless_now(near)) return {near, false};
    return {asked_.look(space::real(box.place.center)), true};
  }
  static double bound(const Box& box, const PlaceSeen& seen) {
    return std::max(box.bound, seen.value.lo - radius(box.place));
  }
  /// No place of the box belongs and is better than what was found.
  bool is_needless(const Box& box, const PlaceSeen& seen) const {
    const double least = bound(box, seen);
    return seen.inside + radius(box.place) < 0 || least > std::min(asked_.beyond, found_.least) ||
           least == exact::kInfinity;
  }
  /// Its numbers leave that open, and it would be better by more than they may be off.
  bool perhaps_best(const PlaceSeen& seen) const {
    const bool bounded = seen.value.hi < exact::kInfinity;
    return seen.inside >= 0 && (bounded ? seen.value.hi : seen.value.lo) < found_.least;
  }
  static double longest(const Box& box) { return std::max({box.place.half.x, box.place.half.y, box.place.half.z}); }

  void note(const Box& box, const Glance& glance) {
    if (glance.exact) {
      note(space::real(box.place.center), glance.seen);
    } else if (glance.seen.inside > most_inside_ && !is_needless(box, glance.seen)) {
      note_inside(space::real(box.place.center), glance.seen.inside);
    }
  }
  void note_inside(const space::RealVector& at, double inside) {
    most_inside_ = inside;
    found_.nearly = at;
  }
  void note(const space::RealVector& at, const PlaceSeen& seen) {
    if (seen.inside > most_inside_) note_inside(at, seen.inside);
    if (!seen.belongs || !(seen.value.hi < found_.least)) return;
    found_.least = seen.value.hi;
    found_.at = at;
  }

  const PlaceSearch& asked_;
  plane::Subdivision<Box> queue_{"boxes of positions in which the explanation looks"};
  std::vector<Box> parts_;
  PlaceFound found_;
  long cells_ = 0;
  double most_inside_ = -exact::kInfinity;
};

}  // namespace

PlaceFound find_place(const PlaceSearch& search, const std::vector<PlaceBox>& boxes) {
  return Search(search).run(boxes);
}

}  // namespace findspace::formula
