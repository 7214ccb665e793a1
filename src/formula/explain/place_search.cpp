// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/explain/place_search.h"

#include <algorithm>
#include <utility>

#include "exact/margins/space_distance.h"
#include "plane/base/parallel.h"
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
        kMostPlaces, kAtOnce, [&](const Box& top) { return settled(top.bound); }, [&](const Box& top) { divide(top); },
        [&] { take(); });
    // Boxes that were dropped hold nothing below the least value.
    found_.bound = queue_.empty() ? found_.least : std::min(queue_.best().bound, found_.least);
    return found_;
  }

 private:
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

  void take() {
    std::vector<Box> boxes = std::exchange(parts_, {});
    std::vector<PlaceSeen> seen(boxes.size());
    plane::parallel_for(boxes.size(),
                        [&](std::size_t k) { seen[k] = asked_.look(space::real(boxes[k].place.center)); });
    for (std::size_t k = 0; k < boxes.size(); ++k) note(space::real(boxes[k].place.center), seen[k]);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const double r = radius(boxes[k].place);
      boxes[k].bound = std::max(boxes[k].bound, seen[k].value.lo - r);
      if (seen[k].inside + r < 0 || boxes[k].bound > std::min(asked_.beyond, found_.least)) continue;
      if (longest(boxes[k]) > 0) queue_.push(boxes[k]);
    }
  }
  static double longest(const Box& box) { return std::max({box.place.half.x, box.place.half.y, box.place.half.z}); }

  void note(const space::RealVector& at, const PlaceSeen& seen) {
    if (seen.inside > most_inside_) {
      most_inside_ = seen.inside;
      found_.nearly = at;
    }
    if (!seen.belongs || !(seen.value.hi < found_.least)) return;
    found_.least = seen.value.hi;
    found_.at = at;
  }

  const PlaceSearch& asked_;
  plane::Subdivision<Box> queue_{"boxes of positions in which the explanation looks"};
  std::vector<Box> parts_;
  PlaceFound found_;
  double most_inside_ = -exact::kInfinity;
};

}  // namespace

PlaceFound find_place(const PlaceSearch& search, const std::vector<PlaceBox>& boxes) {
  return Search(search).run(boxes);
}

}  // namespace findspace::formula
