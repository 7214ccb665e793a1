// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/field_samples.h"

#include <algorithm>
#include <memory>

#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Interval;
using space::Vector;

namespace {

/// Boxes that are kept: some 50 MB.
constexpr int kMostSamples = 500000;

}  // namespace

FieldSamples::FieldSamples(const space::SurfaceSet& set) : field_(set, {}), about_(field_.box()) {
  const Vector wide = about_.high - about_.low;
  middle_ = about_.middle();
  half_ = std::max({wide.x, wide.y, wide.z});  // twice as wide as the surface: most places that are asked
  sample(middle_, {}, root_);
}

Interval FieldSamples::beside(const Vector& x) const {
  const double away = about_.distance(x);
  return {away > 0 ? away : -exact::kInfinity, exact::kInfinity};
}

Interval FieldSamples::itself(const Vector& x, const Interval& known, const Box& box) const {
  const SurfaceField::Signed at = field_.at(x, known_of(known, box));
  return at.certain ? Interval{at.value, at.value} : Interval{-at.distance, at.distance};
}

void FieldSamples::sample(const Vector& x, const SurfaceField::Known& known, Box& box) const {
  const SurfaceField::Signed at = field_.at(x, known);
  box.nearest = at.part;
  box.value = at.value;
  box.certain = at.certain;
}

const FieldSamples::Box* FieldSamples::part_of(const Box& whole, std::size_t k, const Vector& middle,
                                               double half) const {
  std::atomic<Box*>& part = whole.parts[k];
  if (const Box* const known = part.load(std::memory_order_acquire)) return known;
  if (made_.load(std::memory_order_relaxed) >= kMostSamples) return nullptr;
  auto made = std::make_unique<Box>();
  sample(middle, known_of(around(whole, space::length({half, half, half})), whole), *made);
  Box* expected = nullptr;
  if (!part.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) return expected;
  made_.fetch_add(1, std::memory_order_relaxed);
  return made.release();
}

double FieldSamples::most_at(const Vector& x, double off) const {
  double most = exact::kInfinity;
  ask(x, least_half(), [&](const Interval& known) {
    most = known.hi;
    return known.hi - known.lo <= 2 * kRootOfThree * off;
  });
  return most;
}

/// A box, or a tetrahedron: the box about it, and the planes of its faces.
struct FieldSamples::Asked {
  space::Extent box;
  struct Plane {
    Vector normal;  // outward
    double offset = 0, spread = 0;
  };
  std::array<Plane, 4> planes{};
  bool flat_sided = false;  // the planes count
  double most = 0, least_half = 0;

  Asked(const space::Extent& b, double most_, double smallest)
      : box(b), most(most_), least_half(std::max(smallest, space::length(b.high - b.low) / 64)) {}
  Asked(const Tetrahedron& t, double most_, double smallest) : Asked(box_of(t), most_, smallest) {
    flat_sided = true;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector &a = t[(k + 1) % 4], e = t[(k + 2) % 4] - a, g = t[(k + 3) % 4] - a, f = t[k] - a;
      Vector n = space::cross(e, g);
      if (space::dot(n, f) > 0) n = space::scaled(-1, n);
      // Of a flat one the planes say nothing that is known for certain.
      const double tolerance =
          margin::kFacePlane * space::size_of(n) * (space::size_of(box.low) + space::size_of(box.high));
      planes[k] = {n, space::dot(n, a) + tolerance, space::size_of(n)};
    }
  }
  static space::Extent box_of(const Tetrahedron& t) {
    space::Extent out{t[0], t[0]};
    for (const Vector& v : t) out.add({v, v});
    return out;
  }
  bool misses(const Vector& middle, double half) const {
    if (!box.holds(middle, half)) return true;
    return flat_sided && std::any_of(planes.begin(), planes.end(), [&](const Plane& p) {
             return space::dot(p.normal, middle) - half * p.spread > p.offset;
           });
  }
};

bool FieldSamples::within(const Box& box, const Vector& middle, double half, const Asked& asked) const {
  const double reach = half * kRootOfThree;
  if (box.value + reach <= asked.most || asked.misses(middle, half)) return true;
  if (box.value - reach > asked.most || half < 2 * asked.least_half) return false;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vector at = middle_of(k, middle, half / 2);
    if (asked.misses(at, half / 2)) continue;
    const Box* const part = part_of(box, k, at, half / 2);
    if (part == nullptr || !within(*part, at, half / 2, asked)) return false;
  }
  return true;
}

bool FieldSamples::within(const Tetrahedron& corners, double most) const {
  return within(Asked(corners, most, least_half()));
}

bool FieldSamples::within(const space::Extent& box, double most) const {
  return within(Asked(box, most, least_half()));
}

bool FieldSamples::within(const Asked& asked) const {
  const space::Extent all = grown({middle_, middle_}, half_);
  if (!all.holds(asked.box.low, 0) || !all.holds(asked.box.high, 0)) return false;
  // First down to the smallest box that holds it.
  const Box* box = &root_;
  Vector middle = middle_;
  double half = half_;
  while (!(box->value + half * kRootOfThree <= asked.most) && half >= 2 * asked.least_half) {
    const std::size_t k = part_at(asked.box.low, middle);
    if (part_at(asked.box.high, middle) != k) break;
    half /= 2;
    middle = middle_of(k, middle, half);
    box = part_of(*box, k, middle, half);
    if (box == nullptr) return false;
  }
  return within(*box, middle, half, asked);
}

}  // namespace findspace::distance
