// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/write_mesh.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/draw/draw_bodies.h"
#include "io/draw/draw_view.h"
#include "io/mesh/mesh_3mf.h"
#include "io/mesh/mesh_step.h"
#include "io/mesh/write_mesh_binary.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using Vec = std::array<double, 3>;

Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec face_normal(const Surface& s, const std::vector<int>& face) {
  Vec sum{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Vec n =
        cross(minus(s.vertices[face[i]], s.vertices[face[0]]), minus(s.vertices[face[i + 1]], s.vertices[face[0]]));
    for (int k = 0; k < 3; ++k) sum[k] += n[k];
  }
  const double size = std::sqrt(dot(sum, sum));
  if (size > 0) {
    for (double& c : sum) c /= size;
  }
  return sum;
}

std::string one_line(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return out;
}

}  // namespace

Assembly assembly_of(Surface surface) { return {{{"", std::move(surface)}}, {Assembly::Copy{}}}; }

Surface united(const Assembly& assembly) {
  Surface all;
  for (const Assembly::Copy& copy : assembly.copies) {
    const Surface& one = assembly.kinds[copy.kind].surface;
    const int first = static_cast<int>(all.vertices.size());
    for (const Vec& v : one.vertices) {
      Vec& to = all.vertices.emplace_back(copy.at);
      for (std::size_t k = 0; k < 3; ++k) to[k] += dot(copy.rotation[k], v);
    }
    for (std::vector<int> face : one.faces) {
      for (int& v : face) v += first;
      all.faces.push_back(std::move(face));
      all.labels.push_back(copy.name);
    }
  }
  return all;
}

std::string obj_text(const Surface& s, std::string_view title) {
  std::string out;
  put(out, "# {}\n", one_line(title));
  for (const Vec& v : s.vertices) put(out, "v {} {} {}\n", v[0], v[1], v[2]);
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    if (!s.labels.empty() && (f == 0 || s.labels[f] != s.labels[f - 1])) put(out, "g {}\n", one_line(s.labels[f]));
    const std::size_t corners = s.faces[f].size();
    out.push_back(corners > 2 ? 'f' : corners == 2 ? 'l' : 'p');
    for (const int v : s.faces[f]) put(out, " {}", v + 1);
    out.push_back('\n');
  }
  return out;
}

std::string off_text(const Surface& s) {
  std::string out;
  std::size_t corners = 0;
  for (const auto& face : s.faces) corners += face.size();
  put(out, "OFF\n{} {} {}\n", s.vertices.size(), s.faces.size(), corners / 2);
  for (const Vec& v : s.vertices) put(out, "{} {} {}\n", v[0], v[1], v[2]);
  for (const auto& face : s.faces) put(out, "{} {}\n", face.size(), fmt::join(face, " "));
  return out;
}

std::string stl_text(const Surface& s, std::string_view title) {
  std::string out;
  put(out, "solid {}\n", one_line(title));
  for (const auto& face : s.faces) {
    const Vec n = face_normal(s, face);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      put(out, "facet normal {} {} {}\n outer loop\n", n[0], n[1], n[2]);
      for (const int v : {face[0], face[i], face[i + 1]}) {
        const Vec& p = s.vertices[v];
        put(out, "  vertex {} {} {}\n", p[0], p[1], p[2]);
      }
      put(out, " endloop\nendfacet\n");
    }
  }
  put(out, "endsolid {}\n", one_line(title));
  return out;
}

std::string svg_text(const Surface& s, std::string_view title, std::string_view unit) {
  const DrawnSurface drawn{s.vertices, s.faces};
  BodiesPicture picture{std::string(title), std::string(unit), {}, {}, {}};
  picture.bodies.emplace_back().surface = &drawn;
  return bodies_svg(picture);
}

std::string surface_text(const Surface& surface, std::string_view title, std::string_view ending,
                         std::string_view unit) {
  if (ending == ".obj") return obj_text(surface, title);
  if (ending == ".off") return off_text(surface);
  if (ending == ".stl") return stl_text(surface, title);
  if (ending == ".ply") return ply_text(surface, title);
  if (ending == ".glb") return glb_text(assembly_of(surface), title, unit);
  if (ending == ".step") return step_text(surface, title, unit);
  if (ending == ".3mf") return text_3mf(assembly_of(surface), title, unit);
  if (ending == ".svg") return svg_text(surface, title, unit);
  throw Error(ErrorCode::kUnsupported,
              fmt::format("a surface is written as {}, not '{}'", fmt::join(kSurfaceEndings, " "), ending));
}

std::string assembly_text(const Assembly& assembly, std::string_view title, std::string_view ending,
                          std::string_view unit) {
  if (ending == ".glb") return glb_text(assembly, title, unit);
  if (ending == ".3mf") return text_3mf(assembly, title, unit);
  return surface_text(united(assembly), title, ending, unit);
}

}  // namespace findspace::io
