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

/// The binary chunk: corners of triangles as indices, then places, in metres and with y upwards.
struct GlbBuffer {
  std::string bytes;
  std::size_t indices = 0;  // bytes of the first
  std::uint32_t corners = 0;
  std::array<float, 3> low{}, high{};
};

void put_triangles(GlbBuffer& out, const Surface& s) {
  for (const auto& face : s.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      for (const int v : {face[0], face[i], face[i + 1]}) put(out.bytes, static_cast<std::uint32_t>(v));
      out.corners += 3;
    }
  }
  out.indices = out.bytes.size();
}

void put_places(GlbBuffer& out, const Surface& s, double metre) {
  for (std::size_t k = 0; k < s.vertices.size(); ++k) {
    const auto& v = s.vertices[k];
    const std::array<float, 3> p{static_cast<float>(v[0] * metre), static_cast<float>(v[2] * metre),
                                 static_cast<float>(-v[1] * metre)};
    for (std::size_t c = 0; c < 3; ++c) {
      put(out.bytes, p[c]);
      out.low[c] = k == 0 ? p[c] : std::min(out.low[c], p[c]);
      out.high[c] = k == 0 ? p[c] : std::max(out.high[c], p[c]);
    }
  }
}

/// The JSON chunk; glTF forbids lists without elements, so a surface without faces is a scene without nodes.
nlohmann::json glb_json(const GlbBuffer& b, std::size_t vertices, std::string_view title) {
  using nlohmann::json;
  json root{{"asset", {{"version", "2.0"}, {"generator", "findspace"}}}, {"scene", 0}};
  root["scenes"] = json::array({{{"name", title}}});
  if (b.corners == 0) return root;
  root["scenes"][0]["nodes"] = {0};
  root["nodes"] = json::array({{{"mesh", 0}}});
  root["meshes"] =
      json::array({{{"primitives", json::array({{{"attributes", {{"POSITION", 1}}}, {"indices", 0}, {"mode", 4}}})}}});
  root["accessors"] =
      json::array({{{"bufferView", 0}, {"componentType", 5125}, {"count", b.corners}, {"type", "SCALAR"}},
                   {{"bufferView", 1},
                    {"componentType", 5126},
                    {"count", vertices},
                    {"type", "VEC3"},
                    {"min", b.low},
                    {"max", b.high}}});
  root["bufferViews"] = json::array(
      {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", b.indices}, {"target", 34963}},
       {{"buffer", 0}, {"byteOffset", b.indices}, {"byteLength", b.bytes.size() - b.indices}, {"target", 34962}}});
  root["buffers"] = json::array({{{"byteLength", b.bytes.size()}}});
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

std::string glb_text(const Surface& s, std::string_view title, std::string_view unit) {
  const double metre = unit.empty() ? 1 : formula::factor(*formula::find_unit(unit), Unit::kMetre).to_double();
  GlbBuffer buffer;
  put_triangles(buffer, s);
  put_places(buffer, s, metre);
  std::string text =
      glb_json(buffer, s.vertices.size(), title).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  pad(text, ' ');
  pad(buffer.bytes, '\0');
  const bool empty = buffer.corners == 0;
  std::string out = "glTF";
  put(out, std::uint32_t{2});
  put(out, static_cast<std::uint32_t>(12 + 8 + text.size() + (empty ? 0 : 8 + buffer.bytes.size())));
  put_chunk(out, "JSON", text);
  if (!empty) put_chunk(out, "BIN", buffer.bytes);  // its fourth letter is the zero at the end
  return out;
}

}  // namespace findspace::io
