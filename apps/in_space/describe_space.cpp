// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb describe for 3D shapes: exact where the shape is made of boxes or one convex set, else on lines; with
// --resolution or --step always on lines, with --side as a bound of the shape from within or without.
#include <fmt/format.h>

#include "findspace/error.h"
#include "formula/solid/solve_region.h"
#include "in_space/ray_outcome.h"
#include "in_space/space_commands.h"
#include "in_space/space_outcome.h"
#include "io/mesh/space_surface.h"
#include "io/write/write_json_space.h"
#include "io/write/write_summary.h"
#include "space/shape/shape_rays.h"

namespace findspace::app {

using exact::Real;

namespace {

/// A convex body as a closed set.
space::ConvexSet whole(const space::Body& body) {
  const space::BodyPart& part = body.parts[0];
  space::Body core = body;
  core.parts[0].radius = Real();
  const space::Bounds3 box = space::bounds(core);
  space::ConvexSet set{space::ConvexRegion(box.low, box.high), true, true, false, part.radius};
  for (const space::HalfSpace& plane : part.planes()) set.region.cut(plane);
  return set;
}

Outcome describe_rays(const Session& session, const std::string& name, const LineChoice& lines) {
  const plane::Shape& shape = *session.scene().shape(name);
  const space::ShapeBox box = space::shape_box(shape);
  RaySet set;
  set.title = name;
  set.subtitle = session.scene().file;
  set.meaning = "the shape";
  set.lines = lines;
  set.low = box.low;
  set.high = box.high;
  set.unbounded = box.unbounded;
  take_side(session, set);
  const Real by = set.side == formula::Side::kOuter   ? cell_radius(set)
                  : set.side == formula::Side::kInner ? -cell_radius(set)
                                                      : Real();
  set.source = [&shape, by](const space::RayGrid& grid) {
    return formula::RegionOnLines{space::shape_rays(shape, grid, by)};
  };
  return rays_outcome(session, set);
}

}  // namespace

Outcome describe_space(const Session& session, const std::string& name) {
  const Options& options = session.options();
  check_outputs(options, space_formats());
  session.reporter().stage(fmt::format("shape {}", name));
  if (const auto lines = asked_lines(session)) return describe_rays(session, name, *lines);
  const formula::ExactShape made = formula::exact_shape(*session.scene().shape(name), wants_surface(session));
  const formula::SpaceShape& shape = made.shape;
  note_rounding(session, name, shape);
  if (made.way == distance::Way::kLines) return describe_rays(session, name, lines_unasked(session, "shape"));
  if (made.way == distance::Way::kConvex)
    return polytope_outcome(session, whole(*shape.body), session.step() / Real(shape.body->scale), name, nullptr);
  const space::SpaceSummary summary = space::summarize(*shape.boxes, session.step());
  const auto json = [&] { return io::space_json(*shape.boxes, summary, session.step(), session.unit()); };
  write_outputs(options,
                space_writers(
                    json, [&] { return io::box_surface(*shape.boxes, session.step()); }, name, session.unit()));
  return {options.json ? json() : io::summary_text(name, summary, session.unit(), nullptr),
          summary.empty ? kEmpty : kDone};
}

}  // namespace findspace::app
