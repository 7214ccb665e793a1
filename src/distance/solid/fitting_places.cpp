// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/fitting_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "distance/search/boundary_cells.h"
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

/// The positions at which the box lies in the other, and a hair more.
Extent box_of_places(const Extent& box, const Extent& c) {
  return widened({c.low - box.low, c.high - box.high}, size_of(c) + size_of(box));
}

/// The positions at which the box lies in one of the others.
std::vector<Extent> places_in(const Extent& box, const std::vector<Extent>& containers) {
  std::vector<Extent> out;
  for (const Extent& c : containers) {
    const Extent places = box_of_places(box, c);
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
      tree.each([&](const Extent& e) { return e.meets(box); },
                [&](std::size_t n) { next.push_back(in_both(all[k][n], box)); });
    }
    left.swap(next);
  }
  return left;
}

namespace {

/// Those of the points that are farthest in one of the 26 directions to the neighbours of a lattice point.
std::vector<space::Vector> farthest_corners(const Body& b) {
  std::vector<space::Vector> out;
  for (int k = 0; k < 27; ++k) {
    const int x = k % 3 - 1, y = k / 3 % 3 - 1, z = k / 9 - 1;
    const space::Vector way{double(x), double(y), double(z)};
    std::optional<space::Vector> best;
    for (const BodyPart& part : b.parts) {
      for (const space::Point& v : part.vertices()) {
        const space::Vector at = exact::approx(v);
        if (!best || space::dot(way, *best) < space::dot(way, at)) best = at;
      }
    }
    const bool listed =
        std::any_of(out.begin(), out.end(), [&](const space::Vector& v) { return space::length(v - *best) <= 0; });
    if (!listed) out.push_back(*best);
  }
  return out;
}

}  // namespace

CornersOut::CornersOut(const Body& b, const Body& a)
    : around_(box_of_places(space::rounded(bounds(b)), space::rounded(bounds(a)))), corners_(farthest_corners(b)) {
  std::vector<Extent> boxes;
  for (const BodyPart& part : a.parts) {
    const Extent box = space::rounded(bounds(part));
    boxes.push_back(widened(box, size_of(box)));
    std::vector<NearPlane>& planes = planes_.emplace_back();
    for (const space::HalfSpace& h : part.planes()) planes.push_back({h.unit, h.shift});
  }
  parts_ = space::ExtentTree(std::move(boxes));
}

bool CornersOut::at(const Extent& positions) const {
  return std::any_of(corners_.begin(), corners_.end(), [&](const space::Vector& v) {
    return out({space::plus(positions.low, v), space::plus(positions.high, v)});
  });
}

/// Whether the places meet no part.
bool CornersOut::out(const Extent& places) const {
  const Extent around = widened(places, size_of(places));
  const space::Vector middle = around.middle(), half = space::scaled(0.5, around.high - around.low);
  const double size = space::size_of(middle) + space::size_of(half);
  bool met = false;
  parts_.each([&](const Extent& e) { return !met && e.meets(around); },
              [&](std::size_t k) {
                met = std::none_of(planes_[k].begin(), planes_[k].end(), [&](const NearPlane& h) {
                  const double error = margin::kRoundings32 * (size + 2 * std::fabs(h.shift));
                  const double spread =
                      std::fabs(h.unit.x) * half.x + std::fabs(h.unit.y) * half.y + std::fabs(h.unit.z) * half.z;
                  return h.approx_value(middle) - spread > error;
                });
              });
  return !met;
}

}  // namespace findspace::distance
