// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/hausdorff.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "distance/planar/farthest_corner.h"
#include "distance/planar_features/near_parts.h"
#include "exact/margins/planar_distance.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::Region;
using plane::SignMap;

namespace {

// Where a whole shape has so many times as many edges as its parts, these make the cheaper maps, with corners that are
// not on the grid.
constexpr std::size_t kGain = 4;
constexpr MaxMinEffort kToFindLevelCurves{margin::kMaxMinGuess, 3000};  // a place near the max-min place tells them

}  // namespace

DirectedHausdorff::DirectedHausdorff(plane::SharedRegion b, plane::SharedRegion a)
    : b_(std::move(b)), a_(std::move(a)) {}

const SignedDistance& DirectedHausdorff::containment() const {
  std::call_once(made_, [this] { containment_ = std::make_unique<SignedDistance>(SignedDistance::eta1(*b_, *a_)); });
  return *containment_;
}

const DirectedHausdorff::Trees& DirectedHausdorff::trees() const {
  std::call_once(trees_made_, [this] { trees_ = std::make_unique<const Trees>(*b_, *a_); });
  return *trees_;
}

const FarthestFromSet& DirectedHausdorff::search() const {
  std::call_once(search_made_, [this] { search_ = std::make_unique<const FarthestFromSet>(*b_, *a_); });
  return *search_;
}

/// The size of the numbers at p.
double DirectedHausdorff::scale(double px, double py) const {
  if (trees().b.has_arcs() || trees().a.has_arcs()) return search().scale(px, py);
  return std::max(trees().b.scale(), trees().a.scale()) + std::abs(px) + std::abs(py);
}

std::optional<FarthestPlace> DirectedHausdorff::greatest(const RealPoint& p, double least_value) const {
  if (trees().b.has_arcs() || trees().a.has_arcs()) return search().greatest(p, least_value);
  return farthest_place(trees().b, trees().a, trees().boxes, p, least_value);
}

SignMap DirectedHausdorff::sign_map(const Real& level) const {
  if (!defined()) return CellComplex::uniform(1);
  if (level.sign() <= 0) return containment().sign_map(level);
  SignMap around = plane::distance_map(*a_, level);
  const bool thin = std::none_of(around.faces.begin(), around.faces.end(), [](const auto& f) { return f.mark == 0; });
  Region closed = plane::remark(around, [](Mark m) { return Mark(m <= 0); });
  Region outside = plane::remark(std::move(around), [](Mark m) { return Mark(m >= 0); });
  // Where the level is the common boundary of both sides, B+p leaves the closed set where it meets the open outside.
  if (thin && plane::is_regular(closed) && plane::is_regular(outside)) {
    closed = Region{};
    return plane::negated(contact_map(std::move(outside), *b_));
  }
  // B+p leaves the closed set; B+p meets the complement of the open one.
  SignMap in_closed = containment_map(closed, *b_), leaves_open = contact_map(outside, *b_);
  std::array<const CellComplex*, 2> both{&in_closed, &leaves_open};
  return plane::overlay(both, [](std::span<const Mark> m) { return Mark(m[1] > 0 ? -1 : m[0] <= 0 ? 0 : 1); });
}

std::optional<PlanarAnswer> DirectedHausdorff::value(const RealPoint& p) const {
  if (!defined() || plane::is_empty(*a_)) return std::nullopt;
  const double scale = this->scale(near_value(p.x), near_value(p.y));
  if (auto h = greatest(p, scale * margin::kClearlyOut)) return h->answer();
  // B+p lies in A, or all but: containment decides.
  auto margin = containment().value(p);
  if (margin && (margin->minus_infinity || margin->value.sign() <= 0)) return margin;
  if (auto h = greatest(p, scale * margin::kHardlyOut)) return h->answer();
  return farthest_corner(b_, a_, p, scale * margin::kHardlyOut).answer();
}

RealPoint DirectedHausdorff::seed() const {
  if (a_->vertices.empty() || b_->vertices.empty()) return {Real(), Real()};
  RealPoint p = a_->geometry.exact(a_->vertices[0].point), q = b_->geometry.exact(b_->vertices[0].point);
  return {p.x - q.x, p.y - q.y};
}

std::optional<TDistance::Size> DirectedHausdorff::size() const {
  if (!defined() || plane::is_empty(*a_) || plane::is_empty(*b_)) return std::nullopt;
  if (trees().a.has_arcs() || trees().b.has_arcs()) return std::nullopt;  // values cost as much as maps
  Size out{a_->edges.size() + b_->edges.size(), std::nullopt};
  if (a_->faces[0].mark <= 0) out.reach = reach(trees().a) + reach(trees().b);
  return out;
}

TDistancePointer DirectedHausdorff::near(const plane::PieceBox& window, double low, double high) const {
  if (high < 0) return containment().near(window, low, high);
  if (low <= 0) return nullptr;
  auto parts = near_parts(trees().b, trees().a, PlacedWindow(window), low, high);
  if (!parts || kGain * (parts->a.edges.size() + parts->b.edges.size()) > a_->edges.size() + b_->edges.size())
    return nullptr;
  return std::make_shared<DirectedHausdorff>(std::move(parts->b), std::move(parts->a));
}

std::vector<NearLevelCurve> DirectedHausdorff::level_curves(const RealPoint& p, double tolerance) const {
  double x = near_value(p.x), y = near_value(p.y);
  tolerance = std::max(tolerance, scale(x, y) * margin::kGuessedPlace);
  auto max_mins = search().max_mins(x, y, tolerance, scale(x, y) * margin::kClearlyOut, kToFindLevelCurves);
  std::vector<NearLevelCurve> out;
  if (max_mins.empty() || max_mins[0].value < tolerance)
    out = containment().defined() ? containment().level_curves(p, tolerance) : out;
  for (const MaxMinPlace& k : max_mins) {
    std::size_t first = out.size();
    search().add_level_curves(k, p, tolerance, out);
    for (std::size_t i = first; i < out.size(); ++i) out[i].gap = std::max(out[i].gap, max_mins[0].value - k.value);
  }
  return out;
}

}  // namespace findspace::distance
