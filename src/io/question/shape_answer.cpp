// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/shape_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "formula/solid/solve_region.h"
#include "io/mesh/space_surface.h"
#include "io/question/ray_map.h"
#include "io/question/space_shapes.h"
#include "io/scene/scene_regions.h"
#include "io/write/write_json_space.h"
#include "io/write/write_summary.h"
#include "space/body/shape_topology.h"

namespace findspace::io {
namespace {

using exact::Real;

/// A solid with all that its texts need.
struct DescribedSolid {
  AskedScene asked;
  std::string name;
  formula::SpaceShape shape;
  std::optional<space::ConvexSet> convex;  // else the shape has boxes
  Real step;                               // of its coordinates, in the scene's unit
  space::SpaceSummary summary{};

  std::string json() const {
    return convex ? space_json(*convex, summary, step, asked.unit())
                  : space_json(*shape.boxes, summary, step, asked.unit());
  }
  std::string surface(const char* ending) const {
    return surface_text(convex ? convex_surface(*convex, step) : box_surface(*shape.boxes, step), name, ending,
                        asked.unit());
  }
};

/// A convex body, with its frontier or without.
space::ConvexSet convex_set(const space::Body& body, bool frontier) {
  const space::BodyPart& part = body.parts[0];
  space::Body core = body;
  core.parts[0].radius = Real();
  const space::Bounds3 box = space::bounds(core);
  space::ConvexSet set{space::ConvexRegion(box.low, box.high), true, frontier, false, part.radius};
  for (const space::HalfSpace& plane : part.planes()) set.region.cut(plane);
  return set;
}

/// Whether a hull or a sum in the shape is neither open nor closed.
bool has_half_open(const plane::Shape& shape) {
  using Kind = plane::Shape::Kind;
  const bool grown = shape.kind == Kind::kHull || shape.kind == Kind::kMinkowskiSum;
  return (grown && !space::is_open(shape) && !space::is_closed(shape)) ||
         std::any_of(shape.children.begin(), shape.children.end(), [](const auto& c) { return has_half_open(*c); });
}

Answer::Data told_on_lines(const AskedScene& asked, const std::string& name, const RayChoice& choice) {
  if (has_half_open(*asked.scene().shape(name)))
    asked.note(
        fmt::format("shape {}: hulls and sums of sets that are neither open nor closed are told as closed", name));
  return shape_on_lines(asked, name, choice);
}

}  // namespace

Answer::Data described_in_plane(const AskedScene& asked, const std::string& name, const Shape& shape) {
  asked.stage(fmt::format("shape {}", name));
  const Shape::Rounded moved = shape.rotated_points();
  if (moved.points > 0) asked.note(rotated_note(asked.scene(), name, moved.points, moved.largest));
  const Region& set = shape.region();
  Answer::Data out;
  out.found = set.empty() ? Answer::Found::kNo : Answer::Found::kYes;
  out.text = [set, name](const Telling&) { return set.text(name); };
  out.json = [set](const Telling& telling) { return set.json(telling.exact); };
  out.files[".svg"] = [set, name, file = asked.scene().file](const Telling&) {
    return Region::Drawn{set.picture(name, file), {}};
  };
  for (const char* ending : {".dxf", ".geojson", ".wkt"})
    out.files[ending] = [set, name, ending](const Telling& telling) { return set.drawn(ending, name, telling.dxf); };
  out.region = [set] { return RegionBounds{set, set}; };
  return out;
}

Answer::Data described_in_space(AskedScene asked, const std::string& name, const ShapeQuestion& question) {
  asked.stage(fmt::format("shape {}", name));
  const plane::ShapePtr shape = asked.scene().shape(name);
  if (question.lines)
    return told_on_lines(asked, name, ray_choice(asked, *question.lines, question.before, question.listed));
  formula::ExactShape made = formula::exact_shape(*shape, question.surface);
  note_rounding(asked, name, made.shape);
  if (made.way == distance::Way::kLines)
    return told_on_lines(asked, name, usual_lines(asked, "shape", question.before, question.listed));
  const Real step = asked.step();
  auto solid = std::make_shared<DescribedSolid>(
      DescribedSolid{std::move(asked), name, std::move(made.shape), std::nullopt, step});
  if (made.way == distance::Way::kConvex) {
    const bool open = space::is_open(*shape);
    if (!open && !space::is_closed(*shape))
      solid->asked.note(
          fmt::format("shape {}: told as a closed set; which of its frontier belongs is not known", name));
    solid->convex = convex_set(*solid->shape.body, !open);
    solid->step = step / Real(solid->shape.body->scale);
    solid->summary = space::summarize(*solid->convex, solid->step);
  } else {
    solid->summary = space::summarize(*solid->shape.boxes, solid->step);
  }
  Answer::Data out;
  out.found = solid->summary.empty ? Answer::Found::kNo : Answer::Found::kYes;
  out.text = [solid](const Telling&) {
    return summary_text(solid->name, solid->summary, solid->asked.unit(), nullptr);
  };
  out.json = [solid](const Telling&) { return solid->json(); };
  for (const char* ending : kSurfaceEndings)
    out.files[ending] = [solid, ending](const Telling&) { return Region::Drawn{solid->surface(ending), {}}; };
  return out;
}

}  // namespace findspace::io
