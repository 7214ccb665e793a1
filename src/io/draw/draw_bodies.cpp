// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_surface.h"
#include "io/draw/draw_view.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using Place3 = std::array<double, 3>;
using Place2 = std::array<double, 2>;

constexpr double kBodiesMargin = 30, kBodiesLine = 18;

Place2 seen(const Place3& p) { return {dot(p, kRight), -dot(p, kUp)}; }

/// Counter-clockwise about the points.
std::vector<Place2> outline(std::vector<Place2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Place2> chain;
  const auto rotations = [](const Place2& a, const Place2& b, const Place2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = chain.size();
    for (const Place2& p : points) {
      while (chain.size() >= start + 2 && rotations(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

/// A convex part as it is seen.
struct Shown {
  std::vector<Place2> points;
  std::vector<Place2> around;
  SeenSurface core;
  double radius = 0;
  double depth = 0;             // of the middle
  std::array<Place3, 2> box{};  // of the core
  bool moving = false;
  bool glass = false;  // about what moves
};

/// Of a body's vertices, in the scene's unit.
std::vector<Place3> places_of(std::span<const space::Point> vertices, const BodiesPicture::Drawn& drawn, double step) {
  const double scale = step / static_cast<double>(drawn.body->scale);
  std::vector<Place3> out;
  for (const space::Point& v : vertices) {
    out.push_back({static_cast<double>(v.x) * scale + drawn.by[0], static_cast<double>(v.y) * scale + drawn.by[1],
                   static_cast<double>(v.z) * scale + drawn.by[2]});
  }
  return out;
}

/// Larger, so as to hold the other too.
void add_box(std::array<Place3, 2>& box, const std::array<Place3, 2>& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    box[0][k] = std::min(box[0][k], other[0][k]);
    box[1][k] = std::max(box[1][k], other[1][k]);
  }
}

Shown points_seen(const std::vector<Place3>& places, bool moving) {
  Shown out;
  out.moving = moving;
  out.box = {places.front(), places.front()};
  for (const Place3& p : places) {
    out.points.push_back(seen(p));
    out.depth += dot(p, kTowards) / static_cast<double>(places.size());
    add_box(out.box, {p, p});
  }
  out.around = outline(out.points);
  return out;
}

/// A mesh shows its surface, not the cuts between its convex parts.
Shown mesh_seen(const space::PlacedSurroundings& mesh, const BodiesPicture::Drawn& drawn, double step) {
  std::vector<space::Point> vertices;
  for (const space::Point& v : mesh.of->surface.vertices) vertices.push_back(mesh.at(v));
  const std::vector<Place3> places = places_of(vertices, drawn, step);
  Shown out = points_seen(places, drawn.moving);
  std::vector<std::vector<int>> rings = mesh.of->surface.faces;
  if (mesh.factor < 0)  // a reflection through a point turns them over
    for (std::vector<int>& ring : rings) std::reverse(ring.begin(), ring.end());
  out.core = seen_surface(places, rings);
  return out;
}

Shown part_seen(const space::BodyPart& part, const BodiesPicture::Drawn& drawn, double step) {
  const std::vector<Place3> places = places_of(part.vertices(), drawn, step);
  Shown out = points_seen(places, drawn.moving);
  out.radius = part.radius.to_double() * step / static_cast<double>(drawn.body->scale);
  if (!part.core) return out;
  std::vector<std::vector<int>> rings;
  for (int f = 0; f < part.core->facet_count(); ++f) {
    const auto n = exact::approx(part.core->planes()[static_cast<std::size_t>(f)].normal);
    std::vector<int> ring = part.core->circuit(f);
    Place3 around{};  // circuits may run either way: their planes' normals point outwards
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const auto at = [&](std::size_t k) { return places[static_cast<std::size_t>(ring[k])]; };
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
        around[k] +=
            (at(i)[u] - at(0)[u]) * (at(i + 1)[v] - at(0)[v]) - (at(i)[v] - at(0)[v]) * (at(i + 1)[u] - at(0)[u]);
      }
    }
    if (dot(around, {n.x, n.y, n.z}) < 0) std::reverse(ring.begin(), ring.end());
    rings.push_back(std::move(ring));
  }
  out.core = seen_surface(places, rings);
  return out;
}

/// The parts of a body: those of a mesh without a radius as one.
std::vector<Shown> body_seen(const BodiesPicture::Drawn& drawn, double step) {
  const auto& parts = drawn.body->parts;
  std::vector<bool> done(parts.size());
  std::vector<Shown> out;
  for (const space::PlacedSurroundings& mesh : drawn.body->around) {
    const auto sharp = [&](std::size_t k) { return parts[k].radius.sign() == 0; };
    bool all = !mesh.of->surface.faces.empty();
    for (std::size_t k = mesh.first; k < mesh.first + mesh.count; ++k) all = all && sharp(k);
    if (!all) continue;
    for (std::size_t k = mesh.first; k < mesh.first + mesh.count; ++k) done[k] = true;
    out.push_back(mesh_seen(mesh, drawn, step));
  }
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!done[k]) out.push_back(part_seen(parts[k], drawn, step));
  return out;
}

std::array<Place3, 2> box_of(const std::vector<Shown>& parts) {
  std::array<Place3, 2> box = parts.front().box;
  for (const Shown& part : parts) add_box(box, part.box);
  return box;
}

bool within(const std::array<Place3, 2>& inner, const std::array<Place3, 2>& outer) {
  std::array<Place3, 2> both = outer;
  add_box(both, inner);
  return both == outer;
}

/// The parts of all bodies. A fixed body whose box holds that of a moving one is glass: it must not hide it.
std::vector<Shown> all_seen(const BodiesPicture& picture) {
  std::vector<std::vector<Shown>> bodies;
  for (const auto& drawn : picture.bodies)
    if (!drawn.body->parts.empty()) bodies.push_back(body_seen(drawn, picture.step));
  std::vector<Shown> out;
  for (std::vector<Shown>& body : bodies) {
    const auto inside = [&](const std::vector<Shown>& other) {
      return other.front().moving && within(box_of(other), box_of(body));
    };
    const bool glass = !body.front().moving && std::any_of(bodies.begin(), bodies.end(), inside);
    for (Shown& part : body) {
      part.glass = glass;
      out.push_back(part);
    }
  }
  return out;
}

constexpr double kGlass = 0.2;

constexpr std::array<int, 3> kStone{232, 232, 228}, kSky{206, 226, 248};

class BodiesDrawing {
 public:
  explicit BodiesDrawing(const BodiesPicture& picture) : picture_(picture) {
    parts_ = all_seen(picture);
    for (const Shown& part : parts_) {
      for (const Place2& p : part.around) extend(p, part.radius);
    }
    for (const auto& pair : picture.pairs) {
      extend(seen(pair[0]), 0);
      extend(seen(pair[1]), 0);
    }
    const double size = std::max(high_[0] - low_[0], high_[1] - low_[1]);
    scale_ = size > 0 ? (kViewSize - 2 * kBodiesMargin) / size : 1;
    header_ = kBodiesLine * static_cast<double>(picture.lines.size() + 1);
  }

  std::string run() {
    put(out_,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
        "font-size=\"13\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{}</title>\n",
        kViewSize, (high_[1] - low_[1]) * scale_ + 2 * kBodiesMargin + header_, xml_escaped(picture_.title));
    double y = kBodiesLine;
    put(out_, "<text x=\"12\" y=\"{}\" fill=\"#123\" font-weight=\"bold\">{}</text>\n", y, xml_escaped(picture_.title));
    for (const std::string& line : picture_.lines)
      put(out_, "<text x=\"12\" y=\"{}\" fill=\"#345\">{}</text>\n", y += kBodiesLine, xml_escaped(line));
    put_parts();
    for (const Shown& part : parts_) put_edges(part, part.core.hidden, part.moving ? "#9bd" : "#bbb", kDashed);
    for (const auto& pair : picture_.pairs) {
      put(out_, "<path stroke=\"#d22\" class=\"witness\" d=\"M{}L{}\"/>\n", at(seen(pair[0])), at(seen(pair[1])));
      for (const Place3& p : pair) put(out_, "<circle cx=\"{}\" r=\"3\" fill=\"#d22\"/>\n", at(seen(p), "\" cy=\""));
    }
    return out_ + "</svg>\n";
  }

 private:
  void extend(const Place2& p, double by) {
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = any_ ? std::min(low_[k], p[k] - by) : p[k] - by;
      high_[k] = any_ ? std::max(high_[k], p[k] + by) : p[k] + by;
    }
    any_ = true;
  }
  std::string at(const Place2& p, const char* between = " ") const {
    return fmt::format("{:.2f}{}{:.2f}", (p[0] - low_[0]) * scale_ + kBodiesMargin, between,
                       (p[1] - low_[1]) * scale_ + kBodiesMargin + header_);
  }
  static constexpr const char* kDashed = " stroke-dasharray=\"3 4\"";

  /// From back to front: the faces of sharp parts, and whole parts with a radius.
  void put_parts() {
    struct Piece {
      double depth;
      const Shown* part;
      const SeenFace* face;  // none: the whole part
    };
    std::vector<Piece> pieces;
    for (const Shown& part : parts_) {
      if (part.radius > 0 || part.core.faces.empty())
        pieces.push_back({part.depth, &part, nullptr});
      else
        for (const SeenFace& face : part.core.faces) pieces.push_back({face.depth, &part, &face});
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
    for (const Piece& p : pieces) {
      if (p.face != nullptr)
        put_face(*p.part, *p.face);
      else
        put_outline(*p.part);
    }
  }
  void put_face(const Shown& part, const SeenFace& face) {
    std::string path;
    for (const int v : face.ring)
      path += fmt::format("{}{}", path.empty() ? "M" : "L", at(part.points[static_cast<std::size_t>(v)]));
    const std::string fill = shaded(part.moving ? kSky : kStone, face.light);
    put(out_, "<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\".5\" fill-opacity=\"{}\"/>\n", path, fill,
        part.glass ? "none" : fill, part.glass ? kGlass : 0.93);
    put_edges(part, face.edges, part.moving ? "#15a" : "#555", "");
  }
  void put_outline(const Shown& part) {
    std::string path;
    for (const Place2& p : part.around) path += fmt::format("{}{}", path.empty() ? "M" : "L", at(p));
    // A line twice as wide as the radius, and inside it a slightly thinner one: its rim is the outline.
    const std::string fill = shaded(part.moving ? kSky : kStone, 1);
    const double wide = 2 * part.radius * scale_;
    const char* line = part.moving ? "#15a" : "#555";
    put(out_, "<path d=\"{}z\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n", path, line, wide > 0 ? wide + 2 : 1);
    put(out_, "<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\" opacity=\"{}\"/>\n", path, fill, fill,
        wide, part.glass ? kGlass : 0.8);
    for (const SeenFace& face : part.core.faces) put_edges(part, face.edges, line, "");
  }
  void put_edges(const Shown& part, const std::vector<Edge3>& edges, const char* colour, const char* style) {
    if (edges.empty()) return;
    put(out_, "<path stroke=\"{}\"{} d=\"", colour, style);
    for (const Edge3& e : edges)
      put(out_, "M{}L{}", at(part.points[static_cast<std::size_t>(e[0])]),
          at(part.points[static_cast<std::size_t>(e[1])]));
    put(out_, "\"/>\n");
  }

  const BodiesPicture& picture_;
  std::vector<Shown> parts_;
  Place2 low_{}, high_{};
  bool any_ = false;
  double scale_ = 1, header_ = 0;
  std::string out_;
};

}  // namespace

std::string bodies_svg(const BodiesPicture& picture) { return BodiesDrawing(picture).run(); }

}  // namespace findspace::io
