// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/open_union.h"

#include <algorithm>
#include <limits>

#include "exact/margins/rounding.h"
#include "plane/base/search_work.h"
#include "space/body/complement_search.h"

namespace findspace::space {

using exact::Real;

exact::Tried<std::optional<RealVector>> NearestOutside::settled() const {
  if (spent) return plane::search_spent("the nearest place outside a union of convex sets was not found");
  return at;
}

void OpenUnion::add(const Extent& extent, std::function<Planes()> make) { add(extent, std::move(make), nullptr); }

void OpenUnion::add(const Extent& extent, std::function<Planes()> make,
                    std::function<std::optional<RoundedPlanes>()> rounded) {
  index_ = std::make_unique<Index>();  // of all sets
  parts_.push_back(std::make_unique<Part>());
  parts_.back()->extent = extent;
  parts_.back()->make = std::move(make);
  parts_.back()->round = std::move(rounded);
}

void OpenUnion::add(const Extent& extent, Planes planes) {
  add(extent, [planes = std::move(planes)] { return planes; });
}

const OpenUnion::Planes& OpenUnion::planes(std::size_t k) const {
  const Part& part = *parts_[k];
  std::call_once(part.made, [&] { part.planes = part.make(); });
  return part.planes;
}

std::span<const OpenUnion::RoundedPlane> OpenUnion::rounded_planes(std::size_t k) const {
  const Part& part = *parts_[k];
  std::call_once(part.made_rounded, [&] {
    if (part.round) {
      if (std::optional<RoundedPlanes> known = part.round()) {
        part.rounded = *std::move(known);
        return;
      }
    }
    const Planes& all = planes(k);
    part.rounded.reserve(all.size());
    for (const HalfSpace& h : all) part.rounded.push_back({h.unit, h.shift});
  });
  return part.rounded;
}

const ExtentTree& OpenUnion::tree() const {
  std::call_once(index_->made, [&] {
    std::vector<Extent> extents;
    for (const auto& part : parts_) extents.push_back(part->extent);
    index_->tree = ExtentTree(std::move(extents));
  });
  return index_->tree;
}

int OpenUnion::covering(const RealVector& p) const {
  const Vector near = space::rounded(p);
  const double tolerance = margin::kWiderBox * size_of(near);
  const auto holds = [&](std::size_t k) {
    const Planes& all = planes(k);
    return std::all_of(all.begin(), all.end(), [&](const HalfSpace& h) { return h.sign(p, near) < 0; });
  };
  // Sets without bounds that come first are looked at without a tree.
  for (std::size_t k = 0; k < parts_.size() && !parts_[k]->extent.bounded(); ++k) {
    if (holds(k)) return static_cast<int>(k);
  }
  int found = -1;
  tree().each([&](const Extent& e) { return found < 0 && e.holds(near, tolerance); },
              [&](std::size_t k) {
                if (holds(k)) found = static_cast<int>(k);
              });
  return found;
}

NearestOutside OpenUnion::nearest_in_complement(const RealVector& p, std::span<const Extent> within) const {
  return ComplementSearch(*this, p, within).run();
}

std::optional<RealVector> OpenUnion::nearest_touching(const RealVector& p) const {
  const Vector near = space::rounded(p);
  const double slack = margin::kWiderBox * size_of(near);
  std::optional<RealVector> best;
  std::optional<Real> least;
  double bound = std::numeric_limits<double>::infinity();
  tree().nearest_first(near, [&](std::size_t k, double floor) {
    if (floor > bound + slack) return false;
    double highest = 0;
    for (const HalfSpace& h : planes(k)) highest = std::max(highest, h.approx_value(near) - h.error(near));
    if (highest > bound + slack) return true;
    std::optional<RealVector> q = nearest_in(planes(k), p);
    if (!q) return true;
    const RealVector off = minus(*q, p);
    const Real square = dot(off, off);
    if (least && !(square < *least)) return true;
    least = square;
    best = std::move(q);
    bound = std::sqrt(least->to_double());
    return least->sign() != 0;
  });
  return best;
}

// A closed convex set is what the open half spaces beyond its planes do not cover.
std::optional<RealVector> nearest_in(std::span<const HalfSpace> planes, const RealVector& p) {
  OpenUnion beyond;
  for (const HalfSpace& h : planes) beyond.add(everywhere(), OpenUnion::Planes{h.opposite()});
  const plane::ScopedSearchWork of_no_question(nullptr);
  return beyond.nearest_in_complement(p).settled().or_throw();
}

}  // namespace findspace::space
