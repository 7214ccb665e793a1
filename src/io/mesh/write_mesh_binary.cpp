// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/write_mesh_binary.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/text/units.h"

namespace findspace::io {
namespace {

/// In little-endian order.
template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

void put_chunk(std::string& bytes, const char* type, const std::string& content) {
  put(bytes, static_cast<std::uint32_t>(content.size()));
  bytes.append(type, 4);
  bytes += content;
}

/// Triangles of a mesh in the binary chunk: corners as indices, then places, in metres and with y upwards.
struct GlbMesh {
  std::size_t begin = 0, places = 0, end = 0;  // in the chunk
  std::uint32_t corners = 0;
  std::array<float, 3> low{}, high{};
};

std::array<double, 3> with_y_up(const std::array<double, 3>& v, double metre) {
  return {v[0] * metre, v[2] * metre, -v[1] * metre};
}

GlbMesh put_mesh(std::string& bytes, const Surface& s, double metre) {
  GlbMesh out;
  out.begin = bytes.size();
  for (const auto& face : s.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      for (const int v : {face[0], face[i], face[i + 1]}) put(bytes, static_cast<std::uint32_t>(v));
      out.corners += 3;
    }
  }
  out.places = bytes.size();
  for (std::size_t k = 0; k < s.vertices.size(); ++k) {
    const std::array<double, 3> p = with_y_up(s.vertices[k], metre);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto rounded = static_cast<float>(p[c]);
      put(bytes, rounded);
      out.low[c] = k == 0 ? rounded : std::min(out.low[c], rounded);
      out.high[c] = k == 0 ? rounded : std::max(out.high[c], rounded);
    }
  }
  out.end = bytes.size();
  return out;
}

/// Column by column, y upwards on both sides.
std::array<double, 16> glb_matrix(const Assembly::Copy& copy, double metre) {
  // The axes of the file are x, z and -y of the copy.
  constexpr std::array<std::size_t, 3> kAxis{0, 2, 1};
  constexpr std::array<int, 3> kSign{1, 1, -1};
  std::array<double, 16> m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[4 * j + i] = kSign[i] * kSign[j] * copy.rotation[kAxis[i]][kAxis[j]];
  const std::array<double, 3> at = with_y_up(copy.at, metre);
  std::copy(at.begin(), at.end(), m.begin() + 12);
  m[15] = 1;
  return m;
}

void add_mesh(nlohmann::json& root, const GlbMesh& m, const Assembly::Kind& kind) {
  using nlohmann::json;
  const std::size_t first = root["bufferViews"].size();
  json mesh{
      {"primitives", json::array({{{"attributes", {{"POSITION", first + 1}}}, {"indices", first}, {"mode", 4}}})}};
  if (!kind.name.empty()) mesh["name"] = kind.name;
  root["meshes"].push_back(std::move(mesh));
  root["accessors"].push_back(
      {{"bufferView", first}, {"componentType", 5125}, {"count", m.corners}, {"type", "SCALAR"}});
  root["accessors"].push_back({{"bufferView", first + 1},
                               {"componentType", 5126},
                               {"count", kind.surface.vertices.size()},
                               {"type", "VEC3"},
                               {"min", m.low},
                               {"max", m.high}});
  root["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", m.begin}, {"byteLength", m.places - m.begin}, {"target", 34963}});
  root["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", m.places}, {"byteLength", m.end - m.places}, {"target", 34962}});
}

/// The JSON chunk; glTF forbids lists without elements, so an assembly without triangles is a scene without nodes.
/// Fills the binary chunk.
nlohmann::json glb_json(const Assembly& assembly, double metre, std::string_view title, std::string& bytes) {
  using nlohmann::json;
  json root{{"asset", {{"version", "2.0"}, {"generator", "findspace"}}}, {"scene", 0}};
  root["scenes"] = json::array({{{"name", title}}});
  std::vector<std::size_t> number(assembly.kinds.size());  // of the mesh, from 1; 0 for one without triangles
  for (std::size_t k = 0; k < number.size(); ++k) {
    const auto& faces = assembly.kinds[k].surface.faces;
    if (std::none_of(faces.begin(), faces.end(), [](const auto& face) { return face.size() > 2; })) continue;
    add_mesh(root, put_mesh(bytes, assembly.kinds[k].surface, metre), assembly.kinds[k]);
    number[k] = root["meshes"].size();
  }
  for (const Assembly::Copy& copy : assembly.copies) {
    if (number[copy.kind] == 0) continue;
    json node{{"mesh", number[copy.kind] - 1}};
    if (!copy.name.empty()) node["name"] = copy.name;
    if (copy.is_moved()) node["matrix"] = glb_matrix(copy, metre);
    root["scenes"][0]["nodes"].push_back(root["nodes"].size());
    root["nodes"].push_back(std::move(node));
  }
  if (!bytes.empty()) root["buffers"] = json::array({{{"byteLength", bytes.size()}}});
  return root;
}

}  // namespace

std::string ply_text(const Surface& s, std::string_view title) {
  std::string comment(title);
  std::replace_if(
      comment.begin(), comment.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uint int vertex_indices\nend_header\n",
      comment, s.vertices.size(), s.faces.size());
  for (const auto& v : s.vertices) {
    for (const double c : v) put(out, c);
  }
  for (const auto& face : s.faces) {
    put(out, static_cast<std::uint32_t>(face.size()));
    for (const int v : face) put(out, static_cast<std::int32_t>(v));
  }
  return out;
}

std::string glb_text(const Assembly& assembly, std::string_view title, std::string_view unit) {
  const double metre = unit.empty() ? 1 : formula::factor(*formula::find_unit(unit), Unit::kMetre).to_double();
  std::string bytes;
  std::string text =
      glb_json(assembly, metre, title, bytes).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  pad(text, ' ');
  pad(bytes, '\0');
  std::string out = "glTF";
  put(out, std::uint32_t{2});
  put(out, static_cast<std::uint32_t>(12 + 8 + text.size() + (bytes.empty() ? 0 : 8 + bytes.size())));
  put_chunk(out, "JSON", text);
  if (!bytes.empty()) put_chunk(out, "BIN", bytes);  // its fourth letter is the zero at the end
  return out;
}

}  // namespace findspace::io
