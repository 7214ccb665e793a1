// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/fitting_places.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "exact/margins/rounding.h"
#include "space/body/body_boxes.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/extent_tree.h"

namespace findspace::distance {

using space::Body;
using space::BodyPart;
using space::Extent;

namespace {

constexpr std::size_t kMostPlaces = 1024;

/// A hair wider, for coordinates of that size.
Extent widened(const Extent& box, double size) {
  const double by = margin::kWiderBox * (1 + size);
  return {box.low - space::Vector{by, by, by}, space::plus(box.high, {by, by, by})};
}

double size_of(const Extent& box) { return std::max(space::size_of(box.low), space::size_of(box.high)); }

/// Whether they have a place in common; of parts with a radius, and of points, whether their boxes do.
bool meet(const BodyPart& s, const BodyPart& t) {
  const space::Bounds3 box = space::in_both(bounds(s), bounds(t));
  if (!space::holds_places(box)) return false;
  if (s.radius.sign() > 0 || t.radius.sign() > 0) return true;
  space::ConvexRegion common(box.low, box.high);
  for (const BodyPart* part : {&s, &t}) {
    for (const space::HalfSpace& h : part->planes()) {
      common.cut(h);
      if (common.empty()) return false;
    }
  }
  return true;
}

/// Which parts are of one piece.
class Pieces {
 public:
  explicit Pieces(std::size_t parts) : of_(parts) { std::iota(of_.begin(), of_.end(), std::size_t{0}); }

  std::size_t of(std::size_t k) {
    while (of_[k] != k) k = of_[k] = of_[of_[k]];
    return k;
  }
  void join(std::size_t k, std::size_t n) { of_[of(k)] = of(n); }

 private:
  std::vector<std::size_t> of_;
};

/// The boxes of the connected pieces.
std::vector<Extent> boxes_of_pieces(const Body& body) {
  std::vector<Extent> of_parts;
  for (const BodyPart& part : body.parts) of_parts.push_back(space::rounded(bounds(part)));
  const space::ExtentTree tree(of_parts);
  Pieces pieces(of_parts.size());
  for (std::size_t k = 0; k < of_parts.size(); ++k) {
    const Extent around = widened(of_parts[k], size_of(of_parts[k]));
    tree.each([&](const Extent& e) { return e.meets(around); },
              [&](std::size_t n) {
                if (n < k && pieces.of(n) != pieces.of(k) && meet(body.parts[k], body.parts[n])) pieces.join(n, k);
              });
  }
  std::vector<std::optional<Extent>> whole(of_parts.size());
  for (std::size_t k = 0; k < of_parts.size(); ++k) {
    std::optional<Extent>& box = whole[pieces.of(k)];
    if (box)
      box->add(of_parts[k]);
    else
      box = of_parts[k];
  }
  std::vector<Extent> out;
  for (const auto& box : whole)
    if (box) out.push_back(*box);
  return out;
}

bool holds_places(const Extent& box) {
  return box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z;
}

/// The positions at which the box lies in one of the others.
std::vector<Extent> places_in(const Extent& box, const std::vector<Extent>& containers) {
  std::vector<Extent> out;
  for (const Extent& c : containers) {
    const Extent places = widened({c.low - box.low, c.high - box.high}, size_of(c) + size_of(box));
    if (holds_places(places)) out.push_back(places);
  }
  return out;
}

}  // namespace

std::optional<std::vector<Extent>> fitting_places(const Body& b, const Body& a) {
  if (a.rounded > 0) return std::nullopt;
  const std::vector<Extent> containers = boxes_of_pieces(a);
  if (containers.size() == 1) return std::nullopt;
  std::vector<std::vector<Extent>> all;
  for (const Extent& piece : boxes_of_pieces(b)) all.push_back(places_in(piece, containers));
  std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.size() < y.size(); });
  std::vector<Extent> left = all[0];
  for (std::size_t k = 1; k < all.size() && left.size() <= kMostPlaces; ++k) {
    const space::ExtentTree tree(all[k]);
    std::vector<Extent> next;
    for (const Extent& box : left) {
      tree.each(
          [&](const Extent& e) { return e.meets(box); },
          [&](std::size_t n) {
            const Extent& e = all[k][n];
            next.push_back(
                {{std::max(e.low.x, box.low.x), std::max(e.low.y, box.low.y), std::max(e.low.z, box.low.z)},
                 {std::min(e.high.x, box.high.x), std::min(e.high.y, box.high.y), std::min(e.high.z, box.high.z)}});
          });
    }
    left.swap(next);
  }
  return left;
}

}  // namespace findspace::distance
