// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_view.h"
#include "io/draw/space_names.h"
#include "io/text/put.h"
#include "space/box/box_topology.h"

namespace findspace::io {
namespace {

using space::BoxComplex;
using space::Place3;
using CellIndex = std::array<int, 3>;

constexpr double kSpaceMargin = 36, kHeader = 84, kLegendLine = 20, kNarrowest = 432;
constexpr const char* kShades[3] = {"#6fa8a0", "#8cc0b8", "#b4dcd5"};
constexpr const char* kSheet = "fill=\"#f2a33a\" fill-opacity=\"0.75\"";
constexpr const char* kFixed = "stroke=\"#8a8f98\" stroke-width=\"1\"";
constexpr const char* kMoving = "stroke=\"#2f62c8\" stroke-width=\"2\"";
constexpr const char* kHeavy = "stroke=\"#c8452c\" stroke-width=\"4\"";

struct Polygon {
  std::vector<Place3> corners;
  std::string style;
  double depth = 0;
};

/// What a set gives to draw, in the scene's unit.
class Parts {
 public:
  Parts(const BoxComplex& set, const exact::Real& step)
      : set_(set), solid_(closure(interior(set))), boundary_(boundary(set)), step_(step) {}

  /// Faces between a solid cell and an empty one, and sheets.
  void add_faces(std::vector<Polygon>& out) const {
    each([&](const CellIndex& c) {
      const int k = flat_axis(c);
      if (k < 0 || !bounded(c)) return;
      CellIndex below = c, above = c;
      --below[std::size_t(k)];
      ++above[std::size_t(k)];
      const bool a = in(below), b = in(above);
      if (a != b)
        out.push_back(face(c, k, fmt::format("fill=\"{}\" fill-opacity=\"0.82\"", kShades[k])));
      else if (!a && in(c))
        out.push_back(face(c, k, kSheet));
    });
  }

  /// Edges where the faces around are not one plane; and lines of the set itself, if `own`.
  template <class Line>
  void add_lines(bool own, Line line) const {
    each([&](const CellIndex& c) {
      const int k = long_axis(c);
      if (k < 0 || !bounded(c)) return;
      const bool dangling = own && in(c) && solid_.mark(c[0], c[1], c[2]) == 0 && alone(c, k);
      if (!dangling && !crease(c, k)) return;
      CellIndex from = c, to = c;
      --from[std::size_t(k)];
      ++to[std::size_t(k)];
      line(corner(from), corner(to), dangling);
    });
  }

  template <class Point>
  void add_points(Point point) const {
    each([&](const CellIndex& c) {
      if (c[0] % 2 == 0 || c[1] % 2 == 0 || c[2] % 2 == 0 || !in(c)) return;
      bool single = true;
      for (std::size_t k = 0; k < 3; ++k) {
        for (const int d : {-1, 1}) {
          CellIndex n = c;
          n[k] += d;
          single = single && !in(n);
        }
      }
      if (single) point(corner(c));
    });
  }

 private:
  /// What is drawn are cells of the boundary.
  template <class Visit>
  void each(Visit visit) const {
    boundary_.in().each([&](int x, int y, int z) { visit(CellIndex{x, y, z}); });
  }
  bool in(const CellIndex& c) const { return set_.mark(c[0], c[1], c[2]) != 0; }
  bool bounded(const CellIndex& c) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[k] == 0 || c[k] == set_.cells(int(k)) - 1) return false;
    }
    return true;
  }
  /// The axis across an open face, or along an open edge; -1 for another cell.
  static int flat_axis(const CellIndex& c) {
    if (c[0] % 2 + c[1] % 2 + c[2] % 2 != 1) return -1;
    return c[0] % 2 ? 0 : c[1] % 2 ? 1 : 2;
  }
  static int long_axis(const CellIndex& c) {
    if (c[0] % 2 + c[1] % 2 + c[2] % 2 != 2) return -1;
    return c[0] % 2 == 0 ? 0 : c[1] % 2 == 0 ? 1 : 2;
  }
  /// The four faces about an edge.
  std::array<CellIndex, 4> faces_about(const CellIndex& c, int k) const {
    const auto i = std::size_t((k + 1) % 3), j = std::size_t((k + 2) % 3);
    std::array<CellIndex, 4> out{c, c, c, c};
    --out[0][i];
    ++out[1][i];
    --out[2][j];
    ++out[3][j];
    return out;
  }
  bool alone(const CellIndex& c, int k) const {
    for (const CellIndex& f : faces_about(c, k)) {
      if (in(f)) return false;
    }
    return true;
  }
  /// Whether a face of the picture ends or turns here.
  bool crease(const CellIndex& c, int k) const {
    std::array<bool, 4> drawn{};
    const auto about = faces_about(c, k);
    for (std::size_t f = 0; f < 4; ++f) {
      const auto axis = std::size_t(flat_axis(about[f]));
      CellIndex below = about[f], above = about[f];
      --below[axis];
      ++above[axis];
      drawn[f] = in(below) != in(above) || (in(about[f]) && !in(below));
    }
    return drawn[0] != drawn[1] || drawn[2] != drawn[3] || (drawn[0] && drawn[2]);
  }
  Place3 corner(const CellIndex& c) const {
    Place3 p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = (set_.at()[k][std::size_t(c[k] / 2)] * step_).to_double();
    return p;
  }
  Polygon face(const CellIndex& c, int k, std::string style) const {
    const auto i = std::size_t((k + 1) % 3), j = std::size_t((k + 2) % 3);
    Polygon out{{}, std::move(style), 0};
    for (const auto& [di, dj] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
      CellIndex at = c;
      at[i] += di;
      at[j] += dj;
      out.corners.push_back(corner(at));
      out.depth += dot(out.corners.back(), kTowards) / 4;
    }
    return out;
  }

  const BoxComplex& set_;
  BoxComplex solid_, boundary_;
  const exact::Real& step_;
};

struct Stroke {
  Place3 from, to;
  std::string style;
};

/// All that is to be seen, in the scene's unit; faces from back to front.
struct SpaceDrawing {
  std::vector<Polygon> faces;
  std::vector<Stroke> strokes;
  std::vector<Place3> points;
  struct Outlined {
    std::string name;
    std::vector<Place3> ends;  // of its creases
    bool moving;
  };
  std::vector<Outlined> shapes;
};

SpaceDrawing drawing(const SpacePicture& picture) {
  SpaceDrawing out;
  const auto add_creases = [&](const SpacePicture::Named& shape, bool moving) {
    auto& outlined = out.shapes.emplace_back(SpaceDrawing::Outlined{shape.name, {}, moving});
    Parts(shape.set, picture.step).add_lines(false, [&](const Place3& a, const Place3& b, bool) {
      out.strokes.push_back({a, b, moving ? kMoving : kFixed});
      outlined.ends.insert(outlined.ends.end(), {a, b});
    });
  };
  for (const auto& shape : picture.fixed) add_creases(shape, false);
  const Parts region(*picture.region, picture.step);
  region.add_faces(out.faces);
  region.add_lines(true, [&](const Place3& a, const Place3& b, bool heavy) {
    out.strokes.push_back({a, b, heavy ? kHeavy : "stroke=\"#23605a\" stroke-width=\"1.2\""});
  });
  region.add_points([&](const Place3& p) { out.points.push_back(p); });
  for (const auto& shape : picture.moving) add_creases(shape, true);
  std::stable_sort(out.faces.begin(), out.faces.end(),
                   [](const Polygon& a, const Polygon& b) { return a.depth < b.depth; });
  return out;
}

SpaceView view_of(const SpaceDrawing& d) {
  SpaceView view;
  for (const Polygon& f : d.faces) {
    for (const Place3& p : f.corners) view.include(p);
  }
  for (const Stroke& s : d.strokes) {
    view.include(s.from);
    view.include(s.to);
  }
  for (const Place3& p : d.points) view.include(p);
  view.fit(kHeader);
  return view;
}

std::string elements(const SpaceDrawing& d, const SpaceView& view) {
  std::string out;
  for (const Polygon& f : d.faces) {
    std::string corners;
    for (const Place3& p : f.corners) corners += fmt::format("{:.1f},{:.1f} ", view.at(p)[0], view.at(p)[1]);
    put(out, "<polygon points=\"{}\" {}/>\n", corners, f.style);
  }
  for (const Stroke& s : d.strokes) {
    const plane::Place from = view.at(s.from), to = view.at(s.to);
    put(out, "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke-linecap=\"round\" {}/>\n", from[0],
        from[1], to[0], to[1], s.style);
  }
  for (const Place3& p : d.points)
    put(out, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"#c8452c\"/>\n", view.at(p)[0], view.at(p)[1]);
  return out;
}

/// On the longest lines; two of the places are the ends of each.
std::vector<plane::Place> on_longest(const std::vector<plane::Place>& ends) {
  constexpr std::size_t kLongest = 8;
  struct Line {
    double length;
    plane::Place from, to;
  };
  std::vector<Line> lines;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    lines.push_back({std::hypot(ends[i + 1][0] - ends[i][0], ends[i + 1][1] - ends[i][1]), ends[i], ends[i + 1]});
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.length > b.length; });
  lines.resize(std::min(lines.size(), kLongest));
  std::vector<plane::Place> out;
  for (const double part : {0.5, 0.25, 0.75})
    for (const Line& line : lines)
      out.push_back(
          {line.from[0] + (line.to[0] - line.from[0]) * part, line.from[1] + (line.to[1] - line.from[1]) * part});
  return out;
}

/// The faces of the region, which names keep off; none where they are too many to look at.
void add_region(const SpaceDrawing& d, const SpaceView& view, std::vector<NamedSolid>& named) {
  constexpr std::size_t kMostFaces = 2000;
  if (d.faces.size() > kMostFaces) return;
  for (const Polygon& f : d.faces) {
    std::vector<plane::Place> corners;
    for (const Place3& p : f.corners) corners.push_back(view.at(p));
    named.push_back({"", hull_on_page(std::move(corners)), {}, std::numeric_limits<double>::max()});
  }
}

/// Names keep off the axes' numbers. All shapes are wires, which hide nothing.
std::string names_of(const SpaceDrawing& d, const SpaceView& view, const SpaceAxes& axes) {
  SpaceNames names({{2, view.top() - 18}, {view.width() - 2, view.bottom() - 2}});
  for (const plane::Bounds& box : axes.texts) names.avoid(box);
  for (const Stroke& s : d.strokes) names.shun(view.at(s.from), view.at(s.to));
  std::vector<NamedSolid> named;
  add_region(d, view, named);
  for (const auto& shape : d.shapes) {
    std::vector<plane::Place> ends;
    for (const Place3& p : shape.ends) ends.push_back(view.at(p));
    std::vector<plane::Place> on = on_longest(ends);
    named.push_back({shape.name, hull_on_page(std::move(ends)), std::move(on), 0, true, true,
                     shape.moving ? "#2f62c8" : "#33383d"});
  }
  names.name(std::move(named));
  return names.svg();
}

/// What the colours mean, of those that are to be seen: a column of swatches.
std::string legend(const SpacePicture& picture, const SpaceDrawing& d, double top) {
  std::string out;
  const auto row = [&](bool seen, const std::string& swatch, const char* meaning) {
    if (!seen) return;
    put(out,
        "<g transform=\"translate({} {:.1f})\">{}<text x=\"26\" y=\"4.5\" font-size=\"12.5\" "
        "fill=\"#333\">{}</text></g>\n",
        kSpaceMargin, top, swatch, meaning);
    top += kLegendLine;
  };
  const auto box = [](const std::string& style) {
    return fmt::format("<rect y=\"-6\" width=\"18\" height=\"12\" {}/>", style);
  };
  const auto line = [](const char* style) { return fmt::format("<line x2=\"18\" {}/>", style); };
  const auto sheet = [](const Polygon& f) { return f.style == kSheet; };
  row(!std::all_of(d.faces.begin(), d.faces.end(), sheet), box(fmt::format("fill=\"{}\"", kShades[1])),
      "positions: the border of solid parts");
  row(std::any_of(d.faces.begin(), d.faces.end(), sheet), box(kSheet), "positions in a plane only");
  row(std::any_of(d.strokes.begin(), d.strokes.end(), [](const Stroke& s) { return s.style == kHeavy; }), line(kHeavy),
      "positions on a line only");
  row(!d.points.empty(), "<circle cx=\"9\" r=\"6\" fill=\"#c8452c\"/>", "single positions");
  row(!picture.fixed.empty(), line(kFixed), "fixed shapes");
  row(!picture.moving.empty(), line(kMoving), "the moving shape at a sample position");
  return out;
}

}  // namespace

std::string space_svg(const SpacePicture& picture) {
  const SpaceDrawing d = drawing(picture);
  const SpaceView view = view_of(d);
  const SpaceAxes axes = space_axes(view, picture.unit);
  const std::string meanings = legend(picture, d, view.bottom() + kLegendLine / 2);
  const double below = kLegendLine * double(std::count(meanings.begin(), meanings.end(), '\n')) + kSpaceMargin;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
             "{1:.0f}\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
             std::max(view.width(), kNarrowest), view.bottom() + below) +
         fmt::format(
             "<text x=\"{0}\" y=\"28\" font-size=\"17\">{1}</text>\n<text x=\"{0}\" y=\"48\" "
             "font-size=\"12.5\" fill=\"#555\">{2}</text>\n",
             kSpaceMargin, xml_escaped(picture.title), xml_escaped(picture.subtitle)) +
         axes.svg + elements(d, view) + names_of(d, view, axes) + meanings + "</svg>\n";
}

}  // namespace findspace::io
