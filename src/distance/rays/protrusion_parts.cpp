// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a ProtrusionRays works on (protrusion_rays.h): a fixed body by its convex parts, and what moves by its parts or
// by its surface.
#include <algorithm>
#include <cmath>
#include <functional>

#include "distance/rays/protrusion_rays.h"
#include "distance/search/grown_set.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

namespace {

using space::Body;
using space::BodyPart;
using space::Vector;

double size_of(const Body& body) {
  const space::Bounds3 box = bounds(body);
  return space::length(space::rounded(space::minus(box.high, box.low)));
}

class PartsField : public ProtrusionField {
 public:
  PartsField(const space::Body& body, std::span<const space::WallBridge> further) : size_(size_of(body)) {
    // Less than 0 inside: at small levels what is deep in A counts.
    for (const space::BodyPart& part : body.parts) nearest_.push_back(grown_distance(grown_set(part)));
    for (const space::WallBridge& set : further) nearest_.push_back(grown_distance({set.planes, {}, {}}));
  }
  double size() const override { return size_; }
  SolidMaxMin max_min(const Solids& solids, double slack, double share) const override {
    return solid_max_min(solids, nearest_, slack, share);
  }
  double run(const Vector& x, const Vector& way, double cut, double size, double farthest) const override {
    double least = exact::kInfinity;
    for (const ConvexDistance& d : nearest_)
      least = std::min(
          least, convex_run([&](double s) { return d(space::plus(x, space::scaled(s, way))) - cut; }, size, farthest));
    return least;
  }
  bool outside(const Vector&) const override { return true; }  // distances are less than 0 inside
  std::vector<Tangent> tangents(const Vector& x, double least, double most) const override {
    const double step = size_ * margin::kSlopeStep;
    std::vector<Tangent> out;
    for (const ConvexDistance& d : nearest_) {
      const double here = d(x);
      if (!(least <= here && here <= most)) continue;
      const auto slope = [&](const Vector& way) {
        return (d(space::plus(x, space::scaled(step, way))) - d(x - space::scaled(step, way))) / (2 * step);
      };
      out.push_back({here, {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})}});
    }
    return out;
  }

 private:
  std::vector<ConvexDistance> nearest_;
  double size_;
};

/// Of the angle at a corner: that of a sharper one is cut off, for the edges beside it meet far out.
constexpr double kSharp = 0.96;  // no sign: how much the triangle is thickened
/// What a thick triangle reaches out at its corners.
constexpr double kThickReach = 16;  // no sign: above 1 over the sine of half that angle, with both sides

/// The triangle as a thin set: above and below it, and beside its edges. All that is `room` from it is in the set, and
/// all of the set within kThickReach times that.
ProtrusionPart flat_part(const std::array<Vector, 3>& corners, double room) {
  const auto unit = [](const Vector& v) { return space::scaled(1 / space::length(v), v); };
  ProtrusionPart out;
  const Vector normal = unit(space::cross(corners[1] - corners[0], corners[2] - corners[0]));
  out.faces.push_back(corners);
  out.normals.push_back(normal);
  for (const double side : {1.0, -1.0})
    out.planes.push_back({space::scaled(side, normal), -side * space::dot(normal, corners[0]) - room});
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector beside = unit(space::cross(corners[(k + 1) % 3] - corners[k], normal));
    out.planes.push_back({beside, -space::dot(beside, corners[k]) - room});
    const Vector next = unit(corners[(k + 1) % 3] - corners[k]), before = unit(corners[(k + 2) % 3] - corners[k]);
    if (space::dot(next, before) < kSharp) continue;
    const Vector ahead = space::scaled(-1, unit(space::plus(next, before)));
    out.planes.push_back({ahead, -space::dot(ahead, corners[k]) - room});
  }
  return out;
}

/// To the end of a run.
constexpr int kMostRootSteps = 60;

}  // namespace

/// A secant through places before lies below the function beyond, so its zero comes no later.
double convex_run(const std::function<double(double)>& f, double size, double farthest) {
  double before = -size * margin::kSecantStart, at = 0;
  double value_before = f(before), value = f(at);
  for (int count = 0; count < kMostRootSteps && value > size * margin::kDistanceNoise; ++count) {
    // With a margin for rounding, so that steps are rather too short.
    const double slope = (value - value_before - size * margin::kDistanceNoise) / (at - before);
    if (slope >= 0 || value > -slope * (farthest - at)) return farthest;
    const double next = at - value / slope;
    if (!(next > at)) break;
    before = at;
    value_before = value;
    at = next;
    value = f(at);
  }
  return at;
}

std::shared_ptr<ProtrusionField> field_of_parts(const space::Body& body, std::span<const space::WallBridge> further) {
  return std::make_shared<PartsField>(body, further);
}

ProtrusionParts protrusion_parts(const Body& body, double factor) {
  ProtrusionParts out;
  out.size = size_of(body) * factor;
  for (const BodyPart& part : body.parts) {
    if (part.point() && part.radius.sign() == 0) continue;  // a point is its vertex
    ProtrusionPart& made = out.parts.emplace_back();
    if (part.point()) {
      made.center = space::scaled(factor, exact::approx(part.center));
      made.radius = part.radius.to_double() * factor;
      continue;
    }
    made.solid = tetrahedra(*part.core);
    for (Tetrahedron& t : made.solid) {
      for (Vector& v : t) v = space::scaled(factor, v);
    }
    for (int f = 0; f < part.core->facet_count(); ++f) {
      const auto corner = [&](int v) {
        return space::scaled(factor, exact::approx(part.core->vertices()[static_cast<std::size_t>(v)]));
      };
      const std::vector<int> ring = part.core->circuit(f);
      const space::HalfSpace plane(part.core->planes()[static_cast<std::size_t>(f)]);
      made.planes.push_back({plane.unit, plane.shift * factor});
      for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        made.faces.push_back({corner(ring[0]), corner(ring[k]), corner(ring[k + 1])});
        made.normals.push_back(plane.unit);
      }
    }
  }
  return out;
}

std::optional<ProtrusionParts> protrusion_parts(const std::vector<space::RaySolid>& solids, const ProtrusionField& a,
                                                double level) {
  ProtrusionParts out;
  space::Point low, high;
  bool any = false;
  space::extend_box(solids, low, high, any);
  out.size = space::length(exact::approx(high - low));
  // So that lines do not pass between two triangles, however flat they meet them.
  out.room = (out.size + a.size() + level) * margin::kRayNoise;
  out.moved = kThickReach * out.room;
  out.flat = true;
  const double blur = (out.size + a.size() + level) * ProtrusionRays::kCertain;
  std::optional<std::vector<VoidPlace>> voids = a.voids(level - 2 * blur, level + 2 * blur);
  if (!voids) return std::nullopt;
  out.voids = *std::move(voids);
  int surface = 0;
  for (const space::RaySolid& s : solids) {
    const auto corner = [&](int v) { return exact::approx(s.surface.points[static_cast<std::size_t>(v)]); };
    for (const auto& face : s.surface.faces) {
      out.parts.push_back(flat_part({corner(face[0]), corner(face[1]), corner(face[2])}, out.room));
      out.parts.back().surface = surface;
    }
    ++surface;
  }
  return out;
}

}  // namespace findspace::distance
