// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb convert for 3D shapes: the boundary of a shape as a mesh, in every format of meshes and as a scene that
// states it. Guarantee: exact, faces outward. Of what one closed surface bounds (a mesh, a prism, moved or mirrored),
// of shapes with axis-parallel faces and of convex polytopes; others are refused, describe gives theirs as found on
// lines.

#include <fmt/format.h>

#include "formula/solid/solve_region.h"
#include "io/mesh/space_surface.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_json.h"
#include "io/write/write_json_space.h"
#include "space_commands.h"

namespace findspace::app {
namespace {

using exact::Real;

io::Surface surface(std::span<const space::Point> points, const Real& step) {
  io::Surface out;
  for (const space::Point& p : points)
    out.vertices.push_back(
        {(Real(p.x) * step).to_double(), (Real(p.y) * step).to_double(), (Real(p.z) * step).to_double()});
  return out;
}

io::Surface surface(const space::Polytope& polytope, const Real& step) {
  io::Surface out = surface(polytope.vertices(), step);
  for (int f = 0; f < polytope.facet_count(); ++f) out.faces.push_back(polytope.circuit(f));
  return out;
}

io::Surface surface(const space::Triangles& triangles, const Real& step) {
  io::Surface out = surface(triangles.points, step);
  for (const auto& face : triangles.faces) out.faces.emplace_back(face.begin(), face.end());
  return out;
}

/// Of what a surface bounds; the rest is lost.
io::Surface box_surface(const Session& session, const plane::Shape& shape, const space::BoxComplex& boxes) {
  const space::SpaceSummary set = space::summarize(boxes, session.step());
  if (!set.bounded) throw Error(ErrorCode::kGeometry, "a mesh cannot hold an unbounded set", shape.place);
  io::Surface found = io::box_surface(boxes, session.step());
  if (found.faces.empty()) throw Error(ErrorCode::kGeometry, "a mesh cannot hold a set without volume", shape.place);
  if (set.dangling_area > 0 || set.dangling_length > 0 || !set.isolated.empty())
    session.reporter().note("a mesh cannot hold sheets, lines and points: lost");
  return found;
}

}  // namespace

io::Surface boundary_of(const Session& session, const plane::Shape& shape) {
  const std::optional<formula::ShapeBoundary> found = formula::shape_boundary(shape);
  if (!found)
    throw Error(ErrorCode::kUnsupported,
                "this is not bounded by one surface of flat faces; describe -o writes its surface as found on lines",
                shape.place);
  if (const auto* boxes = std::get_if<space::BoxComplex>(&*found)) return box_surface(session, shape, *boxes);
  return surface_of(*found, session.step());
}

io::Surface surface_of(const formula::ShapeBoundary& boundary, const Real& step) {
  if (const auto* boxes = std::get_if<space::BoxComplex>(&boundary)) return io::box_surface(*boxes, step);
  if (const auto* triangles = std::get_if<space::Triangles>(&boundary)) return surface(*triangles, step);
  const space::Body& body = *std::get<formula::LazyBody::Pointer>(boundary);
  return surface(*body.parts[0].core, step / Real(body.scale));
}

namespace {

std::string scene_text(const io::Surface& surface, const std::string& name, const std::string& unit) {
  std::vector<std::string> vertices, faces;
  for (const auto& v : surface.vertices)
    vertices.push_back(
        fmt::format("[{}, {}, {}]", io::json_number(v[0]), io::json_number(v[1]), io::json_number(v[2])));
  for (const auto& f : surface.faces) faces.push_back(fmt::format("[{}]", fmt::join(f, ", ")));
  return fmt::format(
      "{{\"findspace\": 1, {}\"shapes\": {{{}: {{\"mesh\": {{\"vertices\": [{}],\n \"faces\": [{}]}}}}}}}}\n",
      unit.empty() ? "" : fmt::format("\"unit\": {}, ", io::json_string(unit)), io::json_string(name),
      fmt::join(vertices, ", "), fmt::join(faces, ", "));
}

}  // namespace

Outcome convert_space(const Session& session, const std::string& name) {
  std::vector<std::string> endings{".json"};
  endings.insert(endings.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(session.options(), endings);
  session.reporter().stage(fmt::format("shape {}", name));
  const io::Surface found = boundary_of(session, *session.scene().shape(name));
  const auto json = [&] { return scene_text(found, name, session.unit()); };
  Writers writers{{".json", json}};
  for (const char* ending : io::kSurfaceEndings)
    writers.emplace(ending, [&, ending] { return io::surface_text(found, name, ending, session.unit()); });
  write_outputs(session.options(), writers);
  return {session.options().json || session.options().outputs.empty() ? json() : "", kDone};
}

}  // namespace findspace::app
