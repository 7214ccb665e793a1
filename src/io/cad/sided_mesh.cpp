// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/cad/sided_mesh.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>

#include "plane/base/parallel.h"
#include "space/convolution/mesh_crossing.h"
#include "space/convolution/ray_overlap.h"
#include "space/mesh/mesh.h"
#include "space/polytope/polytope.h"
#include "space/polytope/vector.h"
#include "space/surface/real_overlap.h"
#include "space/surface/surface_side.h"

namespace findspace::io {
namespace {

using exact::Refusal;
using exact::Tried;
using space::Point;
using space::RayBody;
using space::Triangles;
using space::Vector;
using Sheet = space::SurfaceSet::Sheet;

std::int64_t at(const Point& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
double at(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
void put(Vector& v, int axis, double value) { (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value; }

/// What a corner's vector must do: along the unit normal, at least that much.
struct Demand {
  Vector normal;
  double least;
};

class Sides {
  using Reach = std::array<std::int64_t, 3>;

 public:
  Sides(const NearMesh& near, bool outside) : near_(near), outside_(outside) {
    kept_axes();
    const std::size_t corners = near.surface.points.size();
    demands_.resize(corners);
    fixed_.resize(corners);
    spread_reach();
    spread_reach();
    for (std::size_t t = 0; t < near.surface.faces.size(); ++t) demand(t);
  }

  Tried<SidedMesh> moved() const {
    SidedMesh out{near_.surface, 0};
    for (std::size_t v = 0; v < demands_.size(); ++v) {
      const std::optional<Vector> way = way_of(v);
      const Point& from = near_.surface.points[v];
      if (!way) return Refusal(fmt::format("no vector leads beyond all faces that meet at a corner{}", place_of(v)));
      Point& to = out.surface.points[v];
      to = {from.x + std::llround(way->x), from.y + std::llround(way->y), from.z + std::llround(way->z)};
      out.most_moved = std::max(out.most_moved, space::length(exact::approx(to - from)));
    }
    return out;
  }

 private:
  /// The axis that an exact face of the solid is perpendicular to, where it can stay: the curved faces that meet it
  /// have no error along that axis.
  void kept_axes() {
    std::map<int, int> axis;
    for (std::size_t t = 0; t < near_.faces.size(); ++t) {
      const int found = exact_axis(t);
      const auto [at, fresh] = axis.emplace(near_.faces[t].face, found);
      if (!fresh && at->second != found) at->second = -1;
    }
    std::map<int, std::set<int>> faces_at;  // of each corner, those kept
    for (std::size_t t = 0; t < near_.faces.size(); ++t)
      if (axis[near_.faces[t].face] >= 0)
        for (const int v : near_.surface.faces[t]) faces_at[v].insert(near_.faces[t].face);
    for (std::size_t t = 0; t < near_.faces.size(); ++t) {
      const NearFace& face = near_.faces[t];
      if (face.flat || face.off == 0) continue;
      for (const int v : near_.surface.faces[t])
        if (const auto found = faces_at.find(v); found != faces_at.end())
          for (const int f : found->second)
            if (axis[f] != face.even) axis[f] = -1;
    }
    kept_.resize(near_.faces.size());
    for (std::size_t t = 0; t < near_.faces.size(); ++t) kept_[t] = axis[near_.faces[t].face];
  }

  int exact_axis(std::size_t t) const {
    if (!near_.faces[t].flat || near_.faces[t].off > 0) return -1;
    const auto& face = near_.surface.faces[t];
    for (int axis = 0; axis < 3; ++axis) {
      bool same = true;
      for (const int v : face) {
        same = same &&
               at(near_.surface.points[std::size_t(v)], axis) == at(near_.surface.points[std::size_t(face[0])], axis) &&
               near_.moved[std::size_t(v)][std::size_t(axis)] == 0;
      }
      if (same) return axis;
    }
    return -1;
  }

  /// How far K of the triangles at a corner goes in each axis; called again, of those at its neighbours too: K of a
  /// triangle reaches over those beside it.
  void spread_reach() {
    std::vector<Reach> next(near_.surface.points.size());
    for (std::size_t t = 0; t < near_.surface.faces.size(); ++t)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t off = near_.faces[t].even == int(axis) ? 0 : near_.faces[t].off;
        std::int64_t most = 0;
        for (const int v : near_.surface.faces[t])
          most = std::max(
              {most, near_.moved[std::size_t(v)][axis] + off, reach_.empty() ? 0 : reach_[std::size_t(v)][axis]});
        for (const int v : near_.surface.faces[t])
          next[std::size_t(v)][axis] = std::max(next[std::size_t(v)][axis], most);
      }
    reach_ = std::move(next);
  }

  void demand(std::size_t t) {
    const auto& face = near_.surface.faces[t];
    if (kept_[t] >= 0) {
      for (const int v : face) fixed_[std::size_t(v)][std::size_t(kept_[t])] = true;
      return;
    }
    const auto corner = [&](std::size_t k) { return near_.surface.points[std::size_t(face[k])]; };
    Vector normal = space::cross(exact::approx(corner(1) - corner(0)), exact::approx(corner(2) - corner(0)));
    normal = space::scaled((outside_ ? 1 : -1) / space::length(normal), normal);
    for (const int v : face) {
      double least = 0;
      for (int axis = 0; axis < 3; ++axis)
        least += double(reach_[std::size_t(v)][std::size_t(axis)] + kSpare) * std::abs(at(normal, axis));
      demands_[std::size_t(v)].push_back({normal, least});
    }
  }

  /// By projections onto the half space that is farthest off, then scaled to reach all of them.
  std::optional<Vector> way_of(std::size_t v) const {
    std::vector<Demand> demands = demands_[v];
    if (demands.empty()) return Vector{};
    for (Demand& d : demands)
      for (int axis = 0; axis < 3; ++axis)
        if (fixed_[v][std::size_t(axis)]) put(d.normal, axis, 0);
    Vector way{};
    for (int k = 0; k < kProjections; ++k) {
      const Demand* worst = nullptr;
      double most = kNearly;
      for (const Demand& d : demands) {
        const double size = space::length(d.normal);
        if (size <= 0) return std::nullopt;
        const double lack = (d.least - space::dot(way, d.normal)) / size;
        if (lack <= most) continue;
        most = lack;
        worst = &d;
      }
      if (worst == nullptr) break;
      way = space::plus(way, space::scaled(most / space::length(worst->normal), worst->normal));
    }
    double factor = 1;
    for (const Demand& d : demands) {
      const double reached = space::dot(way, d.normal);
      if (reached <= 0) return std::nullopt;
      factor = std::max(factor, d.least / reached);
    }
    return factor > kMostScaled ? std::nullopt : std::optional(space::scaled(factor, way));
  }

  std::string place_of(std::size_t v) const {
    const Point& p = near_.surface.points[v];
    return ", at " + space::places_text({&p, 1}, near_.surface.step);
  }

  static constexpr std::int64_t kSpare = 1;  // for the rounding of the vector to the grid
  static constexpr int kProjections = 400;
  static constexpr double kNearly = 0.25, kMostScaled = 4;

  const NearMesh& near_;
  bool outside_;
  std::vector<Reach> reach_;  // of each corner
  std::vector<int> kept_;     // of each triangle: the axis, or -1
  std::vector<std::vector<Demand>> demands_;
  std::vector<std::array<bool, 3>> fixed_;
};

/// The proof that a mesh is on its side.
class SideProof {
 public:
  SideProof(const NearMesh& near, const Sheet& from, const Sheet& to, bool outside)
      : near_(near), from_(from), to_(to), outside_(outside) {
    for (const int f : to.body.first_face) pieces_.push_back(to.body.corner(f, 0));
  }

  bool holds() const {
    const space::RealVector here{};
    const bool nested = outside_ ? !space::RealOverlap(to_, from_, true).interiors_meet(here)
                                 : !space::RealOverlap(from_, to_, true).interiors_meet(here);
    if (!nested) return false;
    if (outside_) beyond_ = std::make_unique<const RayBody>(space::inside_out({to_.body.points, to_.body.faces}));
    constexpr std::size_t kAtOnce = 64;
    std::atomic<bool> all = true;
    const std::size_t count = near_.faces.size();
    plane::parallel_for((count + kAtOnce - 1) / kAtOnce, [&](std::size_t block) {
      for (std::size_t t = block * kAtOnce; all && t < std::min(count, (block + 1) * kAtOnce); ++t)
        if (!clear_of(t)) all = false;
    });
    return all;
  }

 private:
  /// The corners of K(t); empty where it is flat.
  std::vector<Point> reach_of(std::size_t t) const {
    std::vector<Point> out;
    bool any = false;
    for (const int v : near_.surface.faces[t]) {
      const Point& p = near_.surface.points[std::size_t(v)];
      std::array<std::int64_t, 3> by{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        by[axis] = near_.moved[std::size_t(v)][axis] + (near_.faces[t].even == int(axis) ? 0 : near_.faces[t].off);
        any = any || by[axis] > 0;
      }
      for (int k = 0; k < 8; ++k)
        out.push_back({p.x + (k & 1 ? by[0] : -by[0]), p.y + (k & 2 ? by[1] : -by[1]), p.z + (k & 4 ? by[2] : -by[2])});
    }
    if (!any) out.clear();
    return out;
  }

  /// K(t) does not meet what it must not: what is beyond the new mesh, or the new mesh. It holds its triangle, which is
  /// on the right side, so it is not beyond as a whole; what is beyond may have a piece within it.
  bool clear_of(std::size_t t) const {
    const std::vector<Point> reach = reach_of(t);
    if (reach.empty()) return true;
    const Tried<space::Polytope> hull = space::Polytope::try_hull(reach);
    if (!hull) return hull.refusal().error.code() == ErrorCode::kGeometry;  // it is flat: without volume
    const Sheet sheet(space::triangles(*hull));
    const RayBody& against = outside_ ? *beyond_ : to_.body;
    const bool meets = to_.tree.any_meeting({sheet.body.low, sheet.body.high}, [&](int f) {
      for (std::size_t g = 0; g < sheet.body.faces.size(); ++g)
        if (space::faces_overlap(against, f, sheet.body, int(g), {{}, {0, 1}})) return true;
      return false;
    });
    if (meets) return false;
    return std::none_of(pieces_.begin(), pieces_.end(), [&](const Point& p) {
      return space::side_of(sheet.body, sheet.tree, space::real(p), exact::approx(p)) == space::SurfaceSide::kInside;
    });
  }

  const NearMesh& near_;
  const Sheet &from_, &to_;
  bool outside_;
  std::vector<Point> pieces_;  // a corner of each piece of the new surface
  mutable std::unique_ptr<const RayBody> beyond_;
};

}  // namespace

Tried<SidedMesh> sided_mesh(const NearMesh& near, bool outside) {
  constexpr std::int64_t kMost = exact::kRayLimit / 2;
  for (const Point& p : near.surface.points)
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kMost)
      return Refusal("its coordinates have too many grid steps for the proof");
  const auto sound = [](const Triangles& surface) {
    Tried<RayBody> body = RayBody::of(surface);
    if (!body) return false;
    const space::SelfContact contact = space::self_contact(Sheet(*std::move(body)));
    return !contact.crossing && !contact.inner_walls;
  };
  if (!sound(near.surface)) return Refusal("the mesh near the solid meets itself");
  Tried<SidedMesh> out = Sides(near, outside).moved();
  if (!out) return out;
  if (!sound(out->surface)) return Refusal("the mesh on that side meets itself");
  const Sheet from(near.surface), to(out->surface);
  if (!SideProof(near, from, to, outside).holds()) return Refusal("that the mesh is on that side could not be proved");
  return out;
}

}  // namespace findspace::io
