// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb describe for 3D shapes: exact where the shape is made of boxes or one convex set, else on lines; with
// --resolution or --step always on lines, with --side as a bound of the shape from within or without.
#include <fmt/format.h>

#include <algorithm>

#include "findspace/error.h"
#include "io/mesh/space_surface.h"
#include "io/write/write_json_space.h"
#include "ray_outcome.h"
#include "space/convolution/ray_solids.h"
#include "space/shape/box_shape.h"
#include "space/shape/shape_rays.h"
#include "space_commands.h"
#include "space_outcome.h"
#include "space_report.h"

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

/// Whether its surface says that the shape is not convex; its convex parts may take long.
bool seen_not_convex(const plane::Shape& shape) {
  try {
    const std::vector<space::RaySolid> solids = space::ray_solids(shape);
    if (solids.size() != 1 || solids[0].ball()) return false;
    const space::RayBody body(solids[0].surface);
    return std::any_of(body.edges.begin(), body.edges.end(), [](const space::RayEdge& e) { return e.bend < 0; });
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported && e.code() != ErrorCode::kGeometry) throw;
    return false;
  }
}

/// The shape, if it is made of boxes or one convex set.
std::optional<formula::SpaceShape> exact_shape(const Session& session, const std::string& name) {
  try {
    const plane::Shape& stated = *session.scene().shape(name);
    if (seen_not_convex(stated)) {
      auto boxes = space::box_complex(stated);
      return boxes ? std::optional(formula::SpaceShape{std::move(boxes), nullptr, {}}) : std::nullopt;
    }
    formula::SpaceShape shape = formula::space_shape(*session.scene().shape(name));
    note_rounding(session, name, shape);
    const bool waits = shape.surfaces && !shape.convex;  // not convex, then
    if (shape.boxes ||
        (!waits && shape.body && shape.body->convex() && (!shape.body->round() || !wants_surface(session))))
      return shape;
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
  }
  return std::nullopt;
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
  set.source = [&shape, by](const space::RayGrid& grid) { return space::shape_rays(shape, grid, by); };
  return rays_outcome(session, set);
}

}  // namespace

Outcome describe_space(const Session& session, const std::string& name) {
  const Options& options = session.options();
  check_outputs(options, space_formats());
  session.reporter().stage(fmt::format("shape {}", name));
  if (const auto lines = asked_lines(session)) return describe_rays(session, name, *lines);
  const auto made = exact_shape(session, name);
  if (!made) return describe_rays(session, name, lines_unasked(session, "shape"));
  const formula::SpaceShape& shape = *made;
  if (!shape.boxes)
    return polytope_outcome(session, whole(*shape.body), session.step() / Real(shape.body->scale), name, nullptr);
  const space::SpaceSummary summary = space::summarize(*shape.boxes, session.step());
  const auto json = [&] { return io::space_json(*shape.boxes, summary, session.step(), session.unit()); };
  write_outputs(options,
                space_writers(
                    json, [&] { return io::box_surface(*shape.boxes, session.step()); }, name, session.unit()));
  return {options.json ? json() : space_summary_text(name, summary, session.unit(), nullptr),
          summary.empty ? kEmpty : kDone};
}

}  // namespace findspace::app
