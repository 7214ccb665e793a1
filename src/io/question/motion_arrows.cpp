// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/motion_arrows.h"

#include <algorithm>

#include "plane/complex/extent.h"
#include "plane/query/topology.h"

namespace findspace::io {

using exact::RealPoint;
using plane::Place;

namespace {

Place rounded(const RealPoint& p) { return {p.x.to_double(), p.y.to_double()}; }

Place middle(const plane::Region& shape) {
  const auto box = plane::is_bounded(shape) ? plane::extent(shape) : std::nullopt;
  if (!box) return {};
  return {(box->x0 + box->x1) / 2, (box->y0 + box->y1) / 2};
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool speaks_of(const formula::Formula& formula, const std::string& name) {
  const auto& atoms = formula.atoms();
  return std::any_of(atoms.begin(), atoms.end(), [&](const formula::Atom& a) {
    return holds(a.distance.first, name) || holds(a.distance.second, name);
  });
}

void add_ways(std::vector<Arrow>& out, const formula::World& world, const formula::Formula* formula) {
  const double step = world.step.to_double();
  for (const auto& [name, trajectory] : world.motion.of) {
    const bool moving = holds(world.moving, name);
    if (!moving && formula != nullptr && !speaks_of(*formula, name)) continue;  // it is not drawn
    const Place start = middle(world.shapes.at(name));
    Arrow way{Arrow::Kind::kWay, {}, moving};
    for (const RealPoint& p : trajectory.path) {
      const Place at = rounded(p);
      way.points.push_back({(start[0] + at[0]) * step, (start[1] + at[1]) * step});
    }
    const bool stays =
        std::all_of(way.points.begin(), way.points.end(), [&](const Place& p) { return p == way.points[0]; });
    if (!stays) out.push_back(std::move(way));
    const Place first = rounded(trajectory.path.at(0));
    if (formula::rotations(trajectory))
      out.push_back({Arrow::Kind::kRotation, {{first[0] * step, first[1] * step}}, moving});
  }
}

void add_distance(std::vector<Arrow>& out, const formula::Distance& d) {
  if (d.mode == formula::Mode::kPlain) return;
  const Place vector{d.vector.at(0).to_double(), d.vector.at(1).to_double()};
  const bool rotating = d.mode == formula::Mode::kRotation;
  const Arrow::Kind kind = rotating                          ? Arrow::Kind::kRotation
                           : d.mode == formula::Mode::kAlong ? Arrow::Kind::kBothWays
                                                             : Arrow::Kind::kDirection;
  const Arrow arrow{kind, {vector}, !rotating};
  const auto same = [&](const Arrow& a) { return a.kind == arrow.kind && a.points == arrow.points; };
  if (std::none_of(out.begin(), out.end(), same)) out.push_back(arrow);
}

}  // namespace

std::vector<Arrow> motion_arrows(const Scene& scene, const formula::World& world, const formula::Formula* formula) {
  std::vector<Arrow> out;
  if (!world.instant) add_ways(out, world, formula);
  if (scene.free.kind == Free::Kind::kAngle) {
    const double step = world.step.to_double();
    out.push_back(
        {Arrow::Kind::kRotation, {{double(scene.free.about[0]) * step, double(scene.free.about[1]) * step}}, true});
  }
  if (formula != nullptr) {
    for (const formula::Atom& a : formula->atoms()) add_distance(out, a.distance);
  }
  return out;
}

}  // namespace findspace::io
