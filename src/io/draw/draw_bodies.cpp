// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_surface.h"
#include "io/draw/draw_view.h"
#include "io/draw/space_names.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using plane::Place;
using space::Place3;
using Role = BodiesPicture::Role;

constexpr double kBodiesMargin = 30, kBodiesLine = 18;

/// A convex part, or a surface, as it is seen.
struct Shown {
  std::vector<Place3> places;
  SeenSurface core;
  double radius = 0;
  double depth = 0;             // of the middle
  std::array<Place3, 2> box{};  // of all
  Role role = Role::kFixed;
  bool glass = false;  // about what moves
};

struct ShownBody {
  const BodiesPicture::Drawn* drawn;
  std::vector<Shown> parts;
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

Shown points_seen(std::vector<Place3> places, Role role, double radius = 0) {
  Shown out;
  out.role = role;
  out.radius = radius;
  out.box = {places.front(), places.front()};
  for (const Place3& p : places) {
    out.depth += dot(p, kTowards) / static_cast<double>(places.size());
    add_box(out.box, {p, p});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    out.box[0][k] -= radius;
    out.box[1][k] += radius;
  }
  out.places = std::move(places);
  return out;
}

Shown surface_seen(const std::vector<Place3>& places, const std::vector<std::vector<int>>& rings, Role role) {
  Shown out = points_seen(places, role);
  out.core = seen_surface(places, rings);
  return out;
}

/// A mesh shows its surface, not the cuts between its convex parts.
Shown mesh_seen(const space::PlacedSurroundings& mesh, const BodiesPicture::Drawn& drawn, double step) {
  std::vector<space::Point> vertices;
  for (const space::Point& v : mesh.of->surface.vertices) vertices.push_back(mesh.at(v));
  std::vector<std::vector<int>> rings = mesh.of->surface.faces;
  if (mesh.factor < 0)  // a reflection through a point turns them over
    for (std::vector<int>& ring : rings) std::reverse(ring.begin(), ring.end());
  return surface_seen(places_of(vertices, drawn, step), rings, drawn.role);
}

Shown part_seen(const space::BodyPart& part, const BodiesPicture::Drawn& drawn, double step) {
  const std::vector<Place3> places = places_of(part.vertices(), drawn, step);
  Shown out = points_seen(places, drawn.role, part.radius.to_double() * step / static_cast<double>(drawn.body->scale));
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
std::vector<Shown> parts_seen(const BodiesPicture::Drawn& drawn, double step) {
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

Shown solid_seen(const space::RaySolid& solid, const BodiesPicture::Drawn& drawn, double step) {
  const auto place = [&](const space::Point& p) {
    return Place3{static_cast<double>(p.x) * step + drawn.by[0], static_cast<double>(p.y) * step + drawn.by[1],
                  static_cast<double>(p.z) * step + drawn.by[2]};
  };
  if (solid.ball()) return points_seen({place(solid.center)}, drawn.role, solid.radius.to_double() * step);
  std::vector<Place3> places;
  for (const space::Point& p : solid.surface.points) places.push_back(place(p));
  std::vector<std::vector<int>> rings;
  for (const auto& f : solid.surface.faces) rings.push_back({f[0], f[1], f[2]});
  return surface_seen(places, rings, drawn.role);
}

ShownBody body_seen(const BodiesPicture::Drawn& drawn, double step) {
  ShownBody out{&drawn, {}};
  if (drawn.body != nullptr) out.parts = parts_seen(drawn, step);
  if (drawn.solids != nullptr)
    for (const space::RaySolid& solid : *drawn.solids) out.parts.push_back(solid_seen(solid, drawn, step));
  if (drawn.surface != nullptr && !drawn.surface->vertices.empty())
    out.parts.push_back(surface_seen(drawn.surface->vertices, drawn.surface->faces, drawn.role));
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

/// A fixed body whose box holds that of a moving one is glass: it must not hide it. A region is glass about what it
/// holds as well.
std::vector<ShownBody> all_seen(const BodiesPicture& picture) {
  std::vector<ShownBody> out;
  for (const auto& drawn : picture.bodies) {
    ShownBody body = body_seen(drawn, picture.step);
    if (!body.parts.empty()) out.push_back(std::move(body));
  }
  for (ShownBody& body : out) {
    const Role own = body.drawn->role;
    const auto inside = [&](const ShownBody& other) {
      return own < other.drawn->role && within(box_of(other.parts), box_of(body.parts));
    };
    const bool glass = own == Role::kRegion || std::any_of(out.begin(), out.end(), inside);
    for (Shown& part : body.parts) part.glass = glass;
  }
  return out;
}

constexpr double kGlass = 0.2;

/// How a body of each role is painted.
struct Paint {
  std::array<int, 3> fill;
  const char *line, *hidden, *name;
};
const Paint& paint_of(Role role) {
  static constexpr Paint kFixed{{232, 232, 228}, "#555", "#bbb", "#33383d"};
  static constexpr Paint kMoving{{206, 226, 248}, "#15a", "#9bd", "#15a"};
  static constexpr Paint kRegion{{140, 192, 184}, "#23605a", "#9cc", "#23605a"};
  return role == Role::kFixed ? kFixed : role == Role::kMoving ? kMoving : kRegion;
}

constexpr int kRound = 24;                // corners that stand for a circle where names are placed
constexpr std::size_t kMostMiddles = 6;   // faces of a body that may carry its name
constexpr const char* kGood = "#2f5d9b";  // of a pair whose condition holds
constexpr const char* kBad = "#c1273b";
constexpr const char* kWay = "#7a3fa0";

/// What stands below the title, with what arrows mean where there are any.
std::vector<std::string> header_lines(const BodiesPicture& picture) {
  std::vector<std::string> lines = picture.lines;
  const auto& pairs = picture.pairs;
  if (std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.arrow; }))
    lines.emplace_back("arrow: the shortest move to a touching, red where the condition fails");
  return lines;
}

class BodiesDrawing {
 public:
  explicit BodiesDrawing(const BodiesPicture& picture) : picture_(picture), bodies_(all_seen(picture)) {
    for (const ShownBody& body : bodies_)
      for (const Shown& part : body.parts)
        for (const Place3& p : part.places) view_.include(p, part.radius);
    for (const auto& pair : picture.pairs)
      for (const Place3& end : pair.ends) view_.include(end);
    const std::vector<std::string> lines = header_lines(picture);
    view_.fit(kBodiesLine * static_cast<double>(lines.size() + 1) + kBodiesMargin);
    width_ = std::max(view_.width(), text_width(picture.title, kFont) * 1.1 + 24);
    for (const std::string& line : lines) width_ = std::max(width_, text_width(line, kFont) + 24);
  }

  std::string run() {
    const double height = view_.bottom();
    put(out_,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" "
        "font-size=\"{3}\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{2}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        width_, height, xml_escaped(picture_.title), kFont);
    put_header();
    SpaceNames names({{2, view_.top() - 4}, {width_ - 2, height - 2}});
    const SpaceAxes axes = space_axes(view_, picture_.unit);
    out_ += axes.svg;
    for (const plane::Bounds& box : axes.texts) names.avoid(box);
    put_parts();
    for (const ShownBody& body : bodies_)
      for (const Shown& part : body.parts)
        put_edges(part, part.core.hidden, paint_of(part.role).hidden, " stroke-dasharray=\"3 4\"");
    for (const auto& pair : picture_.pairs) put_pair(pair, names);
    std::vector<NamedSolid> named;
    for (const ShownBody& body : bodies_) named.push_back(named_solid(body));
    names.name(std::move(named));
    return out_ + names.svg() + "</svg>\n";
  }

 private:
  static constexpr double kFont = 13;

  void put_header() {
    double y = kBodiesLine;
    put(out_, "<text x=\"12\" y=\"{}\" fill=\"#123\" font-weight=\"bold\">{}</text>\n", y, xml_escaped(picture_.title));
    for (const std::string& line : header_lines(picture_))
      put(out_, "<text x=\"12\" y=\"{}\" fill=\"#345\">{}</text>\n", y += kBodiesLine, xml_escaped(line));
  }
  std::string at(const Place3& p, const char* between = " ") const {
    const Place on = view_.at(p);
    return fmt::format("{:.2f}{}{:.2f}", on[0], between, on[1]);
  }
  static const Place3& place(const Shown& part, int v) { return part.places[static_cast<std::size_t>(v)]; }

  /// From back to front: the faces of sharp parts, and whole parts with a radius.
  void put_parts() {
    struct Piece {
      double depth;
      const Shown* part;
      const SeenFace* face;  // none: the whole part
    };
    std::vector<Piece> pieces;
    for (const ShownBody& body : bodies_)
      for (const Shown& part : body.parts) {
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
    for (const int v : face.ring) path += fmt::format("{}{}", path.empty() ? "M" : "L", at(place(part, v)));
    const std::string fill = shaded(paint_of(part.role).fill, face.light);
    const double opacity = part.role == Role::kRegion ? 0.7 : part.glass ? kGlass : 0.93;
    put(out_, "<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\".5\" fill-opacity=\"{}\"/>\n", path, fill,
        part.glass ? "none" : fill, opacity);
    put_edges(part, face.edges, paint_of(part.role).line, "");
  }
  void put_outline(const Shown& part) {
    std::vector<Place> points;
    for (const Place3& p : part.places) points.push_back(view_.at(p));
    std::string path;
    for (const Place& p : hull_on_page(points))
      path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", p[0], p[1]);
    // A line twice as wide as the radius, and inside it a slightly thinner one: its rim is the outline.
    const std::string fill = shaded(paint_of(part.role).fill, 1);
    const double wide = 2 * part.radius * view_.scale();
    const char* line = paint_of(part.role).line;
    put(out_, "<path d=\"{}z\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n", path, line, wide > 0 ? wide + 2 : 1);
    put(out_, "<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.2f}\" opacity=\"{}\"/>\n", path, fill, fill,
        wide, part.glass ? kGlass : 0.8);
    for (const SeenFace& face : part.core.faces) put_edges(part, face.edges, line, "");
  }
  void put_edges(const Shown& part, const std::vector<Edge3>& edges, const char* colour, const char* style) {
    if (edges.empty()) return;
    put(out_, "<path stroke=\"{}\"{} d=\"", colour, style);
    for (const Edge3& e : edges) put(out_, "M{}L{}", at(place(part, e[0])), at(place(part, e[1])));
    put(out_, "\"/>\n");
  }

  /// A line with dots at its ends, or an arrow; its value beside its middle.
  void put_pair(const BodiesPicture::Pair& pair, SpaceNames& names) {
    const char* colour = pair.fails ? kBad : pair.arrow ? kWay : kGood;
    const Place a = view_.at(pair.ends[0]), b = view_.at(pair.ends[1]);
    put(out_, "<path stroke=\"{}\" stroke-width=\"1.6\" class=\"{}\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}{}\"/>\n", colour,
        pair.arrow ? "arrow" : "witness", a[0], a[1], b[0], b[1], pair.arrow ? arrow_head(a, b) : "");
    if (!pair.arrow)
      for (const Place& p : {a, b})
        put(out_, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>\n", p[0], p[1], colour);
    if (pair.text.empty()) return;
    const Place m{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    const double length = std::max(std::hypot(b[0] - a[0], b[1] - a[1]), 1.0);
    const Place across{(b[1] - a[1]) / length, (a[0] - b[0]) / length};
    const double away = std::abs(across[0]) * text_width(pair.text) / 2 + std::abs(across[1]) * kFont / 2 + 6;
    std::vector<Place> places;
    for (const double far : {1.0, -1.0, 1.8, -1.8, 3.0, -3.0})
      places.push_back({m[0] + across[0] * away * far, m[1] + across[1] * away * far});
    names.put_text(pair.text, places, colour);
  }
  static std::string arrow_head(const Place& a, const Place& b) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 1)) return "";
    const double x = (b[0] - a[0]) / length * 8, y = (b[1] - a[1]) / length * 8;
    return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}L{:.2f} {:.2f}", b[0] - x - y / 2, b[1] - y + x / 2, b[0], b[1],
                       b[0] - x + y / 2, b[1] - y - x / 2);
  }

  NamedSolid named_solid(const ShownBody& body) const {
    NamedSolid out;
    out.name = body.drawn->name;
    out.colour = paint_of(body.drawn->role).name;
    out.glass = body.parts.front().glass;
    std::vector<Place> points;
    struct Middle {
      double size;
      Place at;
    };
    std::vector<Middle> middles;
    for (const Shown& part : body.parts) {
      out.depth += part.depth / static_cast<double>(body.parts.size());
      add_points(part, points);
      for (const SeenFace& face : part.core.faces) {
        std::vector<Place> ring;
        Place middle{};
        for (const int v : face.ring) {
          ring.push_back(view_.at(place(part, v)));
          for (std::size_t k = 0; k < 2; ++k) middle[k] += ring.back()[k] / static_cast<double>(face.ring.size());
        }
        middles.push_back({area_on_page(ring), middle});
      }
    }
    out.around = hull_on_page(std::move(points));
    std::stable_sort(middles.begin(), middles.end(), [](const Middle& a, const Middle& b) { return a.size > b.size; });
    for (std::size_t k = 0; k < std::min(middles.size(), kMostMiddles); ++k) out.faces.push_back(middles[k].at);
    return out;
  }
  void add_points(const Shown& part, std::vector<Place>& points) const {
    const double radius = part.radius * view_.scale();
    for (const Place3& place3 : part.places) {
      const Place p = view_.at(place3);
      points.push_back(p);
      for (int k = 0; radius > 0 && k < kRound; ++k)
        points.push_back(
            {p[0] + radius * std::cos(2 * M_PI * k / kRound), p[1] + radius * std::sin(2 * M_PI * k / kRound)});
    }
  }

  const BodiesPicture& picture_;
  std::vector<ShownBody> bodies_;
  SpaceView view_;
  double width_ = 0;
  std::string out_;
};

}  // namespace

Place3 middle_of(const BodiesPicture::Drawn& drawn, double step) {
  const ShownBody body = body_seen(drawn, step);
  if (body.parts.empty()) return drawn.by;
  const std::array<Place3, 2> box = box_of(body.parts);
  Place3 out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = (box[0][k] + box[1][k]) / 2;
  return out;
}

std::string bodies_svg(const BodiesPicture& picture) { return BodiesDrawing(picture).run(); }

}  // namespace findspace::io
