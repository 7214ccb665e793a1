// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/field_boxes.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_cells.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;

struct FieldBoxes::Box {
  double value = 0;  // in the middle
  mutable std::atomic<std::array<Box, 8>*> children{nullptr};
  ~Box() { delete children.load(); }
};

/// A box, or a tetrahedron: the box about it, and the planes of its faces.
struct FieldBoxes::Asked {
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
      Vector n{e.y * g.z - e.z * g.y, e.z * g.x - e.x * g.z, e.x * g.y - e.y * g.x};
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

FieldBoxes::FieldBoxes(const Vector& middle, double half, int depth, Value value)
    : middle_(middle),
      half_(half),
      least_half_(std::ldexp(half, -depth)),
      value_(std::move(value)),
      root_(std::make_unique<Box>()) {
  root_->value = value_(middle);
}

FieldBoxes::~FieldBoxes() = default;

namespace {

constexpr double kRootOfThree = 1.7320508075688774;

/// The part of a box that x is in.
std::size_t above(const Vector& x, const Vector& middle) {
  return (x.x > middle.x ? 1U : 0U) | (x.y > middle.y ? 2U : 0U) | (x.z > middle.z ? 4U : 0U);
}

Vector part(const Vector& middle, double half, std::size_t k) {
  const double by = half / 2;
  return {middle.x + ((k & 1) != 0 ? by : -by), middle.y + ((k & 2) != 0 ? by : -by),
          middle.z + ((k & 4) != 0 ? by : -by)};
}

}  // namespace

const std::array<FieldBoxes::Box, 8>& FieldBoxes::children(const Box& box, const Vector& middle, double half) const {
  if (const auto* known = box.children.load(std::memory_order_acquire)) return *known;
  auto made = std::make_unique<std::array<Box, 8>>();
  for (std::size_t k = 0; k < 8; ++k) (*made)[k].value = value_(part(middle, half, k));
  std::array<Box, 8>* expected = nullptr;
  if (box.children.compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel)) return *made.release();
  return *expected;
}

bool FieldBoxes::within(const Box& box, const Vector& middle, double half, const Asked& asked) const {
  const double reach = half * kRootOfThree;
  if (box.value + reach <= asked.most || asked.misses(middle, half)) return true;
  if (box.value - reach > asked.most || half < 2 * asked.least_half) return false;
  const std::array<Box, 8>& all = children(box, middle, half);
  for (std::size_t k = 0; k < 8; ++k) {
    if (!within(all[k], part(middle, half, k), half / 2, asked)) return false;
  }
  return true;
}

bool FieldBoxes::within(const Tetrahedron& corners, double most) const {
  return within(Asked(corners, most, least_half_));
}

bool FieldBoxes::within(const space::Extent& box, double most) const { return within(Asked(box, most, least_half_)); }

double FieldBoxes::most_at(const Vector& x, double off) const {
  if (!grown({middle_, middle_}, half_).holds(x, 0)) return exact::kInfinity;
  const Box* box = root_.get();
  Vector middle = middle_;
  double half = half_;
  while (half > off && half > least_half_) {
    const std::size_t k = above(x, middle);
    box = &children(*box, middle, half)[k];
    middle = part(middle, half, k);
    half /= 2;
  }
  return box->value + space::length(x - middle);
}

bool FieldBoxes::within(const Asked& asked) const {
  const space::Extent all = grown({middle_, middle_}, half_);
  if (!all.holds(asked.box.low, 0) || !all.holds(asked.box.high, 0)) return false;
  // First down to the smallest box that holds it.
  const Box* box = root_.get();
  Vector middle = middle_;
  double half = half_;
  while (!(box->value + half * kRootOfThree <= asked.most) && half >= 2 * asked.least_half) {
    const std::size_t k = above(asked.box.low, middle);
    if (above(asked.box.high, middle) != k) break;
    box = &children(*box, middle, half)[k];
    middle = part(middle, half, k);
    half /= 2;
  }
  return within(*box, middle, half, asked);
}

}  // namespace findspace::distance
