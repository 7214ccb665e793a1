// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/field_samples.h"

#include <memory>

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

const FieldSamples::Box* FieldSamples::part_of(const Box& whole, const Vector& x, Vector& middle, double half) const {
  const auto beyond = [half](double& from, double to) {
    const bool upper = to > from;
    from += upper ? half : -half;
    return upper;
  };
  const std::size_t k =
      (beyond(middle.x, x.x) ? 1 : 0) + (beyond(middle.y, x.y) ? 2 : 0) + (beyond(middle.z, x.z) ? 4 : 0);
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

}  // namespace findspace::distance
