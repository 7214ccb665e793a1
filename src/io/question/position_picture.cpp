// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/position_picture.h"

#include <fmt/format.h>

#include <cmath>

#include "io/draw/draw_layout.h"
#include "io/question/scenery.h"
#include "plane/build/transform.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {
namespace {

/// The shapes where they are at the instant, if one is asked for: their places rounded to the grid, for a picture.
formula::World at_instant(formula::World world) {
  if (!world.instant) return world;
  plane::Rounding rounding;
  for (const auto& [name, path] : world.motion.of) {
    plane::SharedRegion& shape = world.shapes.at(name);
    const exact::Real angle = formula::angle_at(path, *world.instant);
    if (angle.sign() != 0) shape = plane::rotated(shape, {0, 0}, angle, world.step.to_double(), rounding);
    const exact::RealPoint by = formula::position_at(path, *world.instant);
    shape = plane::translated(std::move(shape), {std::llround(by.x.to_double()), std::llround(by.y.to_double())});
  }
  return world;
}

plane::Place place(const distance::Coordinates& p) {
  return {plane::Twofold(p[0]).value(), plane::Twofold(p[1]).value()};
}

/// The scene with the moving shape at the position, without a region: of what is in `p`, in words and numbers.
std::string picture(const AskedScene& asked, const formula::World& world, const formula::Formula* formula,
                    const exact::RealPoint& at, Picture p) {
  const formula::World there = at_instant(world);
  if (world.instant) p.title += fmt::format(", at time {}", shown(world.instant->to_double()));
  p.position = place(distance::coordinates(at));
  add_scenery(asked, p, there, formula);
  p.dimensions = without_repetition(std::move(p.dimensions));
  return picture_svg(p);
}

/// Nothing where no two places attain the distance, and in motions, whose places are those of some instant.
void add_dimension(Picture& p, const formula::World& world, const formula::DistanceAt& d, bool fails) {
  if (!d.answer || d.answer->witness.size() != 2 || !world.motion.of.empty()) return;
  const auto& points = d.answer->witness;
  const char* unit = d.in_degrees ? "°" : "";
  p.dimensions.push_back({place(points[0].at), place(points[1].at), shown(*d.value()) + unit, fails});
}

}  // namespace

std::string check_picture(const AskedScene& asked, const formula::World& world, const formula::Formula& formula,
                          const exact::RealPoint& at, const formula::Check& check,
                          const formula::NearestFeasible* nearest) {
  Picture p;
  p.title = check.holds ? "Feasible" : "Not feasible";
  p.subtitle = asked.scene().where.text;
  for (const formula::AtomAt& a : check.atoms) add_dimension(p, world, a.distance, !a.holds);
  if (nearest != nullptr) {
    p.nearest = place(nearest->at);
    p.nearest_text = fmt::format("nearest feasible position{}, {} away",
                                 nearest->attained ? "" : " (not feasible itself: open there)",
                                 shown(nearest->distance.to_double()));
  }
  return picture(asked, world, &formula, at, std::move(p));
}

std::string measure_picture(const AskedScene& asked, const formula::World& world, const exact::RealPoint& at,
                            const std::vector<formula::DistanceAt>& distances) {
  Picture p;
  p.title = "Measured";
  p.subtitle = "gamma1 of every pair: the clearance, or the depth of an overlap as a negative number";
  for (const formula::DistanceAt& d : distances) {
    if (d.text.starts_with("gamma1(")) add_dimension(p, world, d, false);
  }
  return picture(asked, world, nullptr, at, std::move(p));
}

}  // namespace findspace::io
