// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_region.h"

#include <fmt/format.h>

#include <array>

#include "io/text/put.h"

namespace findspace::io {
namespace {

using plane::Index;
using plane::kNone;
using plane::Place;
using plane::Region;

enum EdgeKind { kClosedEdge, kOpenEdge, kFreeCurve, kHidden };
constexpr std::array<const char*, 3> kEdgeClass{"closed", "open", "free"};

EdgeKind kind_of_edge(const Region& s, Index e) {
  const bool beside = s.faces[s.face(2 * e)].mark != 0 || s.faces[s.face(2 * e + 1)].mark != 0;
  if (s.edges[e].mark != 0) return beside ? kClosedEdge : kFreeCurve;
  return beside ? kOpenEdge : kHidden;
}

enum VertexKind { kPlain, kPoint, kFull, kHollow };
constexpr std::array<const char*, 4> kVertexClass{"", "point", "full", "hollow"};
constexpr std::array<double, 4> kVertexRadius{0, 4.6, 2.6, 2.6};

/// A vertex is shown where it is not like every curve that ends there.
VertexKind kind_of_vertex(const Region& s, Index v) {
  const plane::Vertex& vertex = s.vertices[v];
  if (vertex.out == kNone) return vertex.mark == 0 ? kHollow : kPoint;
  bool differs = false;
  Index h = vertex.out;
  do {
    differs |= s.edges[h / 2].mark != vertex.mark;
    h = s.clockwise(h);
  } while (h != vertex.out);
  return !differs ? kPlain : vertex.mark != 0 ? kFull : kHollow;
}

std::string vertex_dot(const Frame& frame, const Place& p, VertexKind kind) {
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", kVertexClass[kind], pixels(frame.x(p[0])),
                     pixels(frame.y(p[1])), kVertexRadius[kind]);
}

std::string path(std::string_view style, const std::string& data) {
  return data.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, data);
}

}  // namespace

RegionParts parts_of(const Region& s) {
  RegionParts parts;
  for (const plane::Face& f : s.faces) parts.faces |= f.mark != 0;
  parts.unbounded = s.faces[0].mark != 0;
  for (Index e = 0; e < s.edges.size(); ++e) {
    const EdgeKind kind = kind_of_edge(s, e);
    parts.closed_edges |= kind == kClosedEdge;
    parts.open_edges |= kind == kOpenEdge;
    parts.curves |= kind == kFreeCurve;
  }
  for (Index v = 0; v < s.vertices.size(); ++v) {
    const VertexKind kind = kind_of_vertex(s, v);
    parts.points |= kind == kPoint;
    parts.full_dots |= kind == kFull;
    parts.hollow_dots |= kind == kHollow;
  }
  return parts;
}

std::string region_faces(const CurveNet& net, const Frame& frame) {
  PathWriter faces(net, frame);
  faces.add_faces();
  return path("face", faces.data());
}

std::string region_lines(const CurveNet& net, const Frame& frame) {
  const Region& s = net.complex();
  std::array<PathWriter, 3> paths{PathWriter(net, frame), PathWriter(net, frame), PathWriter(net, frame)};
  for (const Curve& k : net.curves()) {
    const EdgeKind kind = kind_of_edge(s, k.first / 2);
    if (kind != kHidden) paths[kind].add_curve(k);
  }
  std::string out;
  for (EdgeKind kind : {kClosedEdge, kOpenEdge, kFreeCurve}) {
    if (kind == kOpenEdge) out += path("underlay", paths[kind].data());
    out += path(kEdgeClass[kind], paths[kind].data());
  }
  for (Index v : net.vertices()) {
    const VertexKind kind = kind_of_vertex(s, v);
    if (kind != kPlain) out += vertex_dot(frame, net.at(v), kind);
  }
  return out;
}

RegionDrawing region_drawing(const CurveNet& net, const Frame& frame) {
  const Region& s = net.complex();
  RegionDrawing out;
  PathWriter faces(net, frame, {}, PathWriter::Digits::kAll);
  faces.add_faces();
  out.faces = faces.data();
  const std::array<std::string*, 3> texts{&out.closed, &out.open, &out.free};
  std::array<std::vector<const Curve*>, 3> curves;
  for (const Curve& k : net.curves()) {
    const EdgeKind kind = kind_of_edge(s, k.first / 2);
    if (kind != kHidden) curves[kind].push_back(&k);
  }
  for (std::size_t kind = 0; kind < curves.size(); ++kind) {
    PathWriter lines(net, frame, {}, PathWriter::Digits::kAll);
    lines.add_curves(curves[kind]);
    *texts[kind] = lines.data();
  }
  const std::array<std::vector<Place>*, 4> places{nullptr, &out.points, &out.full, &out.hollow};
  for (Index v : net.vertices()) {
    const VertexKind kind = kind_of_vertex(s, v);
    if (kind != kPlain) places[kind]->push_back({frame.x(net.at(v)[0]), frame.y(net.at(v)[1])});
  }
  return out;
}

std::string outline(const CurveNet& net, const Frame& frame, std::string_view style, const Place& offset) {
  const Region& s = net.complex();
  PathWriter faces(net, frame, offset), curves(net, frame, offset);
  faces.add_faces();
  for (const Curve& k : net.curves()) {
    if (kind_of_edge(s, k.first / 2) != kHidden) curves.add_curve(k);
  }
  std::string out = path(style, faces.data()) + path(fmt::format("{}-line", style), curves.data());
  for (Index v = 0; v < s.vertices.size(); ++v) {
    if (s.vertices[v].out != kNone || s.vertices[v].mark == 0) continue;
    const Place p = net.at(v);
    put(out, "<circle class=\"{}-dot\" cx=\"{}\" cy=\"{}\" r=\"2.5\"/>\n", style, pixels(frame.x(p[0] + offset[0])),
        pixels(frame.y(p[1] + offset[1])));
  }
  return out;
}

std::string filled(const std::vector<Region>& shapes, const exact::Real& step, const Frame& frame,
                   std::string_view style) {
  std::string data;
  for (const Region& shape : shapes) {
    const CurveNet net(shape, step);
    PathWriter faces(net, frame);
    faces.add_faces();
    data += faces.data();
  }
  return path(style, data);
}

}  // namespace findspace::io
