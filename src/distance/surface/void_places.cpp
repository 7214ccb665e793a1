// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/void_places.h"

#include <algorithm>
#include <cmath>

#include "distance/surface/field_samples.h"
#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

namespace {

using space::Vector;

constexpr long kMostVoidBoxes = 100'000;
/// Of the size of the body: boxes are divided until they are so small, and not below the least.
constexpr double kVoidBox = 0x1p-6, kLeastVoidBox = 0x1p-14;  // no sign: where boxes are left
/// Of their sizes: boxes of one grid, which are off by roundings, touch.
constexpr double kVoidsApart = 0x1p-20;  // no sign: others are no nearer than a box
constexpr std::size_t kMostNear = 256;
constexpr int kMostTurns = 32;

struct VoidBox {
  Vector middle;
  double half = 0;
  double reach() const { return kRootOfThree * half; }
  bool operator<(const VoidBox& other) const { return half > other.half; }  // a small one ends the search
};

class VoidSearch {
 public:
  VoidSearch(const SurfaceField& body, double least, double most) : body_(body), least_(least), most_(most) {}

  std::optional<std::vector<VoidPlace>> run() {
    const space::Extent box = body_.box();
    const Vector side = box.high - box.low;
    size_ = space::length(side);
    plane::Subdivision<VoidBox> queue;
    queue.push({box.middle(), std::max({side.x, side.y, side.z}) * (1 + kVoidsApart) / 2});
    bool small = false;
    const auto end = queue.run(
        kMostVoidBoxes, [&](const VoidBox&) { return small; },
        [&](const VoidBox& next) {
          if (!look(next)) return;
          small = next.half < size_ * kLeastVoidBox;
          divide(next, queue);
        });
    if (end != plane::SubdivisionEnd::kEmpty) return std::nullopt;
    return one_of_each();
  }

 private:
  static void divide(const VoidBox& box, plane::Subdivision<VoidBox>& queue) {
    const double by = box.half / 2;
    const auto step = [&](int k, int bit) { return (k & bit) != 0 ? by : -by; };
    for (int k = 0; k < 8; ++k) queue.push({space::plus(box.middle, {step(k, 1), step(k, 2), step(k, 4)}), by});
  }

  /// Whether it is to be divided.
  bool look(const VoidBox& box) {
    const SurfaceField::Signed here = body_.at(box.middle);
    const double reach = box.reach() + size_ * margin::kRayNoise;
    if (here.value + reach <= least_ || leads_off(box.middle, here.distance, reach)) return false;
    if (!(here.certain && here.value - reach > most_ && box.half <= size_ * kVoidBox)) return true;
    found_.push_back(box);
    return false;
  }

  /// Whether some way leads off the nearest triangles from all places within `reach`, or into the solid behind all of
  /// them in the opposite direction: the way from the nearest place of a solid makes no acute angle with one into it.
  bool leads_off(const Vector& x, double distance, double reach) const {
    const auto near = body_.near(x, distance + 2 * reach, kMostNear);
    if (!near) return false;
    std::vector<Vector> ways, normals;
    for (const int part : *near) {
      ways.push_back(x - body_.place(part, x));
      if (const auto normal = body_.normal(part)) normals.push_back(*normal);
    }
    // The nearest places of a triangle are no farther apart than the places that they are the nearest to.
    return (normals.size() == ways.size() && any_along(normals, margin::kEndPivot)) || any_along(ways, 2 * reach);
  }

  /// Whether some direction goes farther than `least` along each of them.
  static bool any_along(const std::vector<Vector>& all, double least) {
    Vector way{};
    const auto add = [&](const Vector& v) { way = space::plus(way, space::scaled(1 / space::length(v), v)); };
    for (const Vector& v : all) add(v);
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const auto worst = std::min_element(all.begin(), all.end(), [&](const Vector& a, const Vector& b) {
        return space::dot(a, way) < space::dot(b, way);
      });
      if (space::dot(*worst, way) > least * space::length(way)) return true;
      way = space::scaled(1 / space::length(way), way);
      add(*worst);
    }
    return false;
  }

  /// Of boxes that touch each other: they are in one part of space.
  std::vector<VoidPlace> one_of_each() const {
    std::vector<VoidPlace> out;
    std::vector<char> seen(found_.size(), 0);
    for (std::size_t first = 0; first < found_.size(); ++first) {
      if (seen[first] != 0) continue;
      out.push_back({found_[first].middle, found_[first].half});
      std::vector<std::size_t> left{first};
      seen[first] = 1;
      while (!left.empty()) {
        const VoidBox& box = found_[left.back()];
        left.pop_back();
        for (std::size_t k = 0; k < found_.size(); ++k) {
          if (seen[k] != 0 || !touch(box, found_[k])) continue;
          seen[k] = 1;
          left.push_back(k);
        }
      }
    }
    return out;
  }

  static bool touch(const VoidBox& a, const VoidBox& b) {
    const Vector way = a.middle - b.middle;
    return std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)}) <= (a.half + b.half) * (1 + kVoidsApart);
  }

  const SurfaceField& body_;
  double least_, most_, size_ = 0;
  std::vector<VoidBox> found_;
};

}  // namespace

std::optional<std::vector<VoidPlace>> void_places(const SurfaceField& body, double least, double most) {
  return VoidSearch(body, least, most).run();
}

}  // namespace findspace::distance
