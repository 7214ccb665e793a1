// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb describe for 3D shapes: exact where the shape is made of boxes or one convex set, else on lines; with
// --resolution or --step always on lines, with --side as a bound of the shape from within or without.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "common/line_choice.h"
#include "common/told.h"
#include "formula/solid/solve_region.h"
#include "in_space/space_commands.h"
#include "in_space/space_outcome.h"
#include "io/mesh/space_surface.h"
#include "io/question/ray_map.h"
#include "io/write/write_json_space.h"
#include "io/write/write_summary.h"

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

Outcome describe_rays(const Session& session, const std::string& name, const io::RayChoice& lines) {
  const Answer answer(std::make_shared<const Answer::Data>(io::shape_on_lines(session, name, lines)));
  session.reporter().stage("writing");
  return told(session, answer);
}

/// Whether JSON is wanted, which has the lines.
bool wants_json(const Options& options) {
  return options.json || std::any_of(options.outputs.begin(), options.outputs.end(),
                                     [](const auto& file) { return file.extension() == ".json"; });
}

}  // namespace

Outcome describe_space(const Session& session, const std::string& name) {
  const Options& options = session.options();
  check_outputs(options, space_formats());
  session.reporter().stage(fmt::format("shape {}", name));
  if (const auto lines = asked_lines(session)) {
    check_lines_outputs(session, *lines);
    return describe_rays(session, name, io::ray_choice(session, *lines, wants_json(options)));
  }
  const formula::ExactShape made = formula::exact_shape(*session.scene().shape(name), wants_surface(session));
  const formula::SpaceShape& shape = made.shape;
  note_rounding(session, name, shape);
  if (made.way == distance::Way::kLines)
    return describe_rays(session, name, io::usual_lines(session, "shape", "--", wants_json(options)));
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
