// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_surface.h"
#include "io/draw/draw_view.h"

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
  double depth = 0;  // of the middle
  bool moving = false;
};

Shown part_seen(const space::BodyPart& part, const BodiesPicture::Drawn& drawn, double step) {
  Shown out;
  out.moving = drawn.moving;
  const double scale = step / static_cast<double>(drawn.body->scale);
  out.radius = part.radius.to_double() * scale;
  std::vector<Place3> places;
  for (const space::Point& v : part.vertices()) {
    places.push_back({static_cast<double>(v.x) * scale + drawn.by[0], static_cast<double>(v.y) * scale + drawn.by[1],
                      static_cast<double>(v.z) * scale + drawn.by[2]});
    out.points.push_back(seen(places.back()));
    out.depth += dot(places.back(), kTowards);
  }
  if (!places.empty()) out.depth /= static_cast<double>(places.size());
  out.around = outline(out.points);
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

constexpr std::array<int, 3> kStone{232, 232, 228}, kSky{206, 226, 248};

class BodiesDrawing {
 public:
  explicit BodiesDrawing(const BodiesPicture& picture) : picture_(picture) {
    for (const auto& drawn : picture.bodies) {
      for (const space::BodyPart& part : drawn.body->parts) parts_.push_back(part_seen(part, drawn, picture.step));
    }
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
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"sans-serif\" "
        "font-size=\"13\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{}</title>\n",
        kViewSize, (high_[1] - low_[1]) * scale_ + 2 * kBodiesMargin + header_, xml_escaped(picture_.title));
    double y = kBodiesLine;
    put("<text x=\"12\" y=\"{}\" fill=\"#123\" font-weight=\"bold\">{}</text>\n", y, xml_escaped(picture_.title));
    for (const std::string& line : picture_.lines)
      put("<text x=\"12\" y=\"{}\" fill=\"#345\">{}</text>\n", y += kBodiesLine, xml_escaped(line));
    put_parts();
    for (const Shown& part : parts_) put_edges(part, part.core.hidden, part.moving ? "#9bd" : "#bbb", kDashed);
    for (const auto& pair : picture_.pairs) {
      put("<path stroke=\"#d22\" class=\"witness\" d=\"M{}L{}\"/>\n", at(seen(pair[0])), at(seen(pair[1])));
      for (const Place3& p : pair) put("<circle cx=\"{}\" r=\"3\" fill=\"#d22\"/>\n", at(seen(p), "\" cy=\""));
    }
    return out_ + "</svg>\n";
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }
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
    put("<path d=\"{0}z\" fill=\"{1}\" stroke=\"{1}\" stroke-width=\".5\" fill-opacity=\".93\"/>\n", path,
        shaded(part.moving ? kSky : kStone, face.light));
    put_edges(part, face.edges, part.moving ? "#15a" : "#555", "");
  }
  void put_outline(const Shown& part) {
    std::string path;
    for (const Place2& p : part.around) path += fmt::format("{}{}", path.empty() ? "M" : "L", at(p));
    // A line twice as wide as the radius, and inside it a slightly thinner one: its rim is the outline.
    const std::string fill = shaded(part.moving ? kSky : kStone, 1);
    const double wide = 2 * part.radius * scale_;
    const char* line = part.moving ? "#15a" : "#555";
    put("<path d=\"{}z\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n", path, line, wide > 0 ? wide + 2 : 1);
    put("<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\" fill-opacity=\"0.8\"/>\n", path, fill, fill,
        wide);
    for (const SeenFace& face : part.core.faces) put_edges(part, face.edges, line, "");
  }
  void put_edges(const Shown& part, const std::vector<Edge3>& edges, const char* colour, const char* style) {
    if (edges.empty()) return;
    put("<path stroke=\"{}\"{} d=\"", colour, style);
    for (const Edge3& e : edges)
      put("M{}L{}", at(part.points[static_cast<std::size_t>(e[0])]), at(part.points[static_cast<std::size_t>(e[1])]));
    put("\"/>\n");
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
