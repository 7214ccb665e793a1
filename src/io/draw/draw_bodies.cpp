// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "io/draw/draw_canvas.h"
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
  std::vector<Place2> around;
  double radius = 0;
  std::vector<std::array<Place2, 2>> front, back;
  bool moving = false;
};

Shown part_seen(const space::BodyPart& part, const BodiesPicture::Drawn& drawn, double step) {
  Shown out;
  out.moving = drawn.moving;
  const double scale = step / static_cast<double>(drawn.body->scale);
  out.radius = part.radius.to_double() * scale;
  std::vector<Place2> points;
  for (const space::Point& v : part.vertices()) {
    points.push_back(
        seen({static_cast<double>(v.x) * scale + drawn.by[0], static_cast<double>(v.y) * scale + drawn.by[1],
              static_cast<double>(v.z) * scale + drawn.by[2]}));
  }
  out.around = outline(points);
  if (!part.core) return out;
  std::map<std::pair<int, int>, bool> edges;  // in front if one of its faces is
  for (int f = 0; f < part.core->facet_count(); ++f) {
    const auto n = exact::approx(part.core->planes()[static_cast<std::size_t>(f)].normal);
    const bool front = dot({n.x, n.y, n.z}, kTowards) > 0;
    const std::vector<int> ring = part.core->circuit(f);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      bool& edge = edges[std::minmax(ring[i], ring[(i + 1) % ring.size()])];
      edge = edge || front;
    }
  }
  for (const auto& [edge, front] : edges) {
    (front ? out.front : out.back)
        .push_back({points[static_cast<std::size_t>(edge.first)], points[static_cast<std::size_t>(edge.second)]});
  }
  return out;
}

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
    for (const Shown& part : parts_) put_outline(part);
    for (const Shown& part : parts_) {
      put_edges(part.back, part.moving ? "#9bd" : "#bbb", " stroke-dasharray=\"3 4\"");
      put_edges(part.front, part.moving ? "#15a" : "#555", "");
    }
    for (const auto& pair : picture_.pairs) {
      put_edges({{seen(pair[0]), seen(pair[1])}}, "#d22", " class=\"witness\"");
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
  void put_outline(const Shown& part) {
    std::string path;
    for (const Place2& p : part.around) path += fmt::format("{}{}", path.empty() ? "M" : "L", at(p));
    // A line twice as wide as the radius, and inside it a slightly thinner one: its rim is the outline.
    const char* fill = part.moving ? "#dcebfa" : "#eeeeec";
    const double wide = 2 * part.radius * scale_;
    if (wide > 0)
      put("<path d=\"{}z\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n", path, part.moving ? "#15a" : "#555", wide + 2);
    put("<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\" fill-opacity=\"0.7\"/>\n", path, fill, fill,
        wide);
  }
  void put_edges(const std::vector<std::array<Place2, 2>>& edges, const char* colour, const char* style) {
    if (edges.empty()) return;
    put("<path stroke=\"{}\"{} d=\"", colour, style);
    for (const auto& e : edges) put("M{}L{}", at(e[0]), at(e[1]));
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
