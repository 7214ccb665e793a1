// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/body/observe_body.h"

#include <fmt/format.h>

#include <algorithm>

#include "plane/base/stage_observer.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

using plane::StageDrawing;
using Corner = StageDrawing::Corner;

namespace {

constexpr std::size_t kMostSets = 500;

Corner corner(const Vector& v) { return {v.x, v.y, v.z}; }

/// The corners of an octahedron, and its faces by them.
void add_ball(const Vector& centre, double radius, StageDrawing& out) {
  const int first = static_cast<int>(out.corners.size());
  for (const double sign : {-1.0, 1.0}) {
    for (std::size_t k = 0; k < 3; ++k) {
      Corner c = corner(centre);
      c[k] += sign * radius;
      out.corners.push_back(c);
    }
  }
  for (int k = 0; k < 8; ++k) {
    const int x = first + (k & 1 ? 3 : 0), y = first + (k & 2 ? 4 : 1), z = first + (k & 4 ? 5 : 2);
    out.faces.push_back({x, y, z});
  }
}

void add_part(const BodyPart& part, StageDrawing& out) {
  if (part.point()) return add_ball(exact::approx(part.center), part.radius.to_double(), out);
  if (!part.core) {
    std::vector<Corner> face;
    for (const Point& p : part.flat) face.push_back(corner(exact::approx(p)));
    return out.add_face(face);
  }
  const int first = static_cast<int>(out.corners.size());
  for (const Point& p : part.core->vertices()) out.corners.push_back(corner(exact::approx(p)));
  for (int f = 0; f < part.core->facet_count(); ++f) {
    std::vector<int> face = part.core->circuit(f);
    for (int& v : face) v += first;
    out.faces.push_back(std::move(face));
  }
}

void add_region(const ConvexRegion& region, StageDrawing& out) {
  const int first = static_cast<int>(out.corners.size());
  for (const ConvexRegion::Vertex& v : region.vertices()) out.corners.push_back(corner(v.near));
  for (const int k : region.facets()) {
    std::vector<int> face = region.circuit(k);
    for (int& v : face) v += first;
    out.faces.push_back(std::move(face));
  }
}

/// Both ends of each side, where it has them.
std::optional<std::pair<Corner, Corner>> ends(const IntervalBox& box) {
  std::pair<Corner, Corner> out;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!box[k].from || !box[k].to) return std::nullopt;
    out.first[k] = box[k].from->to_double();
    out.second[k] = box[k].to->to_double();
  }
  return out;
}

std::string shown_of(std::size_t count) { return count > kMostSets ? fmt::format(", the first {}", kMostSets) : ""; }

}  // namespace

void observe_body(const std::string& title, const Body& body) {
  plane::StageObserver* observer = plane::stage_observer();
  if (observer == nullptr) return;
  StageDrawing drawing;
  for (const BodyPart& part : body.parts) add_part(part, drawing);
  const char* what = body.outside ? "convex parts of the complement" : "convex parts";
  observer->drawing("parts", fmt::format("{}: {} {}", title, body.parts.size(), what), drawing);
}

void observe_union(const std::string& title, const OpenUnion& sets) {
  plane::StageObserver* observer = plane::stage_observer();
  if (observer == nullptr) return;
  StageDrawing drawing;
  for (std::size_t k = 0; k < std::min(sets.size(), kMostSets); ++k) {
    const Extent& extent = sets.extent(k);
    if (!extent.bounded()) continue;
    ConvexRegion region(real(extent.low), real(extent.high));
    for (const HalfSpace& plane : sets.planes(k)) region.cut(plane);
    add_region(region, drawing);
  }
  observer->drawing("sum", fmt::format("{}: {} convex sets{}", title, sets.size(), shown_of(sets.size())), drawing);
}

void observe_boxes(const char* stage, const std::string& title, const BoxComplex& set) {
  plane::StageObserver* observer = plane::stage_observer();
  if (observer == nullptr) return;
  const Mark outside = set.mark(0, 0, 0);
  StageDrawing drawing;
  for (const IntervalBox& box : set.remarked([&](Mark m) { return Mark(m != outside); }).boxes()) {
    if (const auto corners = ends(box)) drawing.add_box(corners->first, corners->second);
  }
  observer->drawing(stage, title, drawing);
}

}  // namespace findspace::space
