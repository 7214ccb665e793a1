// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "io/draw/draw_layout.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using plane::CellComplex;
using plane::Index;
using plane::Mark;

constexpr double kAround = 0.06, kTitleHeight = 30, kKeyHeight = 24, kKeyWidth = 90;
constexpr std::size_t kMostKeys = 8;
constexpr std::array<const char*, 7> kColours{"#4c84c4", "#e08a3c", "#5fa55a", "#c25b56",
                                              "#8d6cab", "#c9a227", "#5aa6a6"};

class MarkColours {
 public:
  explicit MarkColours(Mark outside) : outside_(outside) {}
  /// Grey, of lines, or white, of faces, where the mark is that of the unbounded face.
  std::string line(Mark mark) const { return mark == outside_ ? "#b8bdc4" : colour(mark); }
  std::string face(Mark mark) const { return mark == outside_ ? "#ffffff" : colour(mark); }

 private:
  static const char* colour(Mark mark) { return kColours[static_cast<std::size_t>(mark + 128) % kColours.size()]; }
  Mark outside_;
};

/// The picture around what was drawn.
std::string framed(const std::string& title, const Frame& frame, const std::string& drawn, double below) {
  const double width = std::max(frame.left + frame.width(), text_width(title) + 20);
  const double height = frame.top + frame.height() + below;
  std::string out;
  put(out,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"{2}\">\n<title>{3}</title>\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"#ffffff\"/>\n<text x=\"10\" y=\"20\">{3}</text>\n{4}</svg>\n",
      width, height, kFontSize, xml_escaped(title), drawn);
  return out;
}

std::set<Mark> marks_of(const CellComplex& cells) {
  std::set<Mark> marks;
  for (const auto& f : cells.faces) marks.insert(f.mark);
  for (const auto& e : cells.edges) marks.insert(e.mark);
  for (const auto& v : cells.vertices) marks.insert(v.mark);
  return marks;
}

/// Which colour is which mark.
std::string key(const CellComplex& cells, const MarkColours& colours, const Frame& frame) {
  std::string out;
  double x = 10;
  const double y = frame.top + frame.height() + 8;
  const std::set<Mark> marks = marks_of(cells);
  std::size_t shown = 0;
  for (const Mark mark : marks) {
    if (++shown > kMostKeys) break;
    put(out, "<rect x=\"{0}\" y=\"{1}\" width=\"12\" height=\"10\" fill=\"{2}\" stroke=\"{3}\"/>", pixels(x), pixels(y),
        colours.face(mark), colours.line(mark));
    put(out, "<text x=\"{}\" y=\"{}\">mark {}</text>\n", pixels(x + 18), pixels(y + 10), int(mark));
    x += kKeyWidth;
  }
  return out;
}

std::string faces_of(const CurveNet& net, const Frame& frame, const MarkColours& colours) {
  std::string out;
  for (const plane::Face& face : net.complex().faces) {
    if (face.mark == net.complex().faces[0].mark) continue;
    PathWriter path(net, frame);
    path.add_face(face);
    put(out, "<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.35\" fill-rule=\"evenodd\"/>\n", path.data(),
        colours.face(face.mark));
  }
  return out;
}

std::string lines_of(const CurveNet& net, const Frame& frame, const MarkColours& colours) {
  std::string out;
  for (const Curve& curve : net.curves()) {
    PathWriter path(net, frame);
    path.add_curve(curve);
    put(out, "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n", path.data(),
        colours.line(curve.mark));
  }
  for (const Index v : net.vertices()) {
    const plane::Place at = net.at(v);
    put(out, "<circle cx=\"{}\" cy=\"{}\" r=\"2\" fill=\"{}\"/>\n", pixels(frame.x(at[0])), pixels(frame.y(at[1])),
        colours.line(net.complex().vertices[v].mark));
  }
  return out;
}

}  // namespace

std::string stage_svg(const std::string& title, const CellComplex& cells) {
  const CurveNet net(cells, exact::Real(1));
  std::optional<plane::Bounds> bounds;
  for (const Curve& curve : net.curves()) include(bounds, net.bounds(curve));
  for (const Index v : net.vertices()) include(bounds, {net.at(v), net.at(v)});
  const Frame frame = fit(bounds.value_or(plane::Bounds{}), kAround, 0, kTitleHeight);
  const MarkColours colours(cells.faces[0].mark);
  return framed(title, frame,
                faces_of(net, frame, colours) + lines_of(net, frame, colours) + key(cells, colours, frame), kKeyHeight);
}

std::string stage_svg(const std::string& title, const plane::StageDrawing& drawing) {
  std::optional<plane::Bounds> bounds;
  for (const auto& c : drawing.corners) include(bounds, {{c[0], c[1]}, {c[0], c[1]}});
  const Frame frame = fit(bounds.value_or(plane::Bounds{}), kAround, 0, kTitleHeight);
  std::string out = "<g fill=\"#4c84c4\" fill-opacity=\"0.08\" stroke=\"#1f3d63\" stroke-width=\"0.8\">\n";
  for (const std::vector<int>& face : drawing.faces) {
    std::string data;
    for (const int v : face) {
      const auto& c = drawing.corners[static_cast<std::size_t>(v)];
      put(data, "{}{} {}", data.empty() ? 'M' : 'L', pixels(frame.x(c[0])), pixels(frame.y(c[1])));
    }
    put(out, "<path d=\"{}{}\"/>\n", data, face.size() > 2 ? "Z" : "");
  }
  return framed(title, frame, out + "</g>\n", 0);
}

}  // namespace findspace::io
