// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using plane::Place;
using space::Place3;

constexpr double kSpaceTickFont = 10.5, kSpaceTick = 5, kSpaceTickDistance = 64;

Place on_page(const Place3& p) { return {dot(p, kRight), -dot(p, kUp)}; }

/// An edge of the box about the picture along one axis, and where its numbers stand.
struct AxisEdge {
  std::size_t axis;
  Place3 from;
  Place away;  // on the page, off the box
  const char* anchor;
  double name_at;  // 0 at its lower end, 1 at its upper
  Place name_by;   // in pixels
};

/// The edges that nothing in the box hides: two below and one on the left.
std::array<AxisEdge, 3> axis_edges(const Place3& low, const Place3& high) {
  const double down = 0.8660254037844386, aside = 0.5;
  return {{{0, {low[0], high[1], low[2]}, {aside, down}, "start", 0.5, {18, 31}},
           {1, {high[0], low[1], low[2]}, {-aside, down}, "end", 0.5, {-18, 31}},
           {2, {high[0], low[1], low[2]}, {-1, 0}, "end", 1, {0, -12}}}};
}

class AxisWriter {
 public:
  AxisWriter(const SpaceView& view, std::string_view unit) : view_(view), unit_(unit) {}

  SpaceAxes run() {
    const std::array<AxisEdge, 3> edges = axis_edges(view_.low(), view_.high());
    for (const std::size_t axis : {0, 2, 1}) put_edge(edges[axis]);
    out_.svg = fmt::format("<path class=\"axes\" stroke=\"#b9c0c6\" fill=\"none\" d=\"{}\"/>\n{}", lines_, out_.svg);
    return std::move(out_);
  }

 private:
  Place at(const AxisEdge& edge, double value, double away) const {
    Place3 p = edge.from;
    p[edge.axis] = value;
    const Place on = view_.at(p);
    return {on[0] + edge.away[0] * away, on[1] + edge.away[1] * away};
  }
  void put_edge(const AxisEdge& edge) {
    const double low = view_.low()[edge.axis], high = view_.high()[edge.axis];
    const Place a = at(edge, low, 0), b = at(edge, high, 0);
    put(lines_, "M{:.2f} {:.2f}L{:.2f} {:.2f}", a[0], a[1], b[0], b[1]);
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (!(length > 1)) return;  // a flat picture has no ticks across it
    for (const double t : ticks(low, high, round_length(kSpaceTickDistance * (high - low) / length))) {
      const Place on = at(edge, t, 0), tip = at(edge, t, kSpaceTick);
      put(lines_, "M{:.2f} {:.2f}L{:.2f} {:.2f}", on[0], on[1], tip[0], tip[1]);
      put_text(at(edge, t, kSpaceTick + 4), shown(t), edge.anchor, "#7a828a", "");
    }
    const Place name = at(edge, low + (high - low) * edge.name_at, 0);
    put_text({name[0] + edge.name_by[0], name[1] + edge.name_by[1]},
             std::string(1, "xyz"[edge.axis]) + (unit_.empty() ? "" : ", " + std::string(unit_)), edge.anchor,
             "#33383d", " font-style=\"italic\"");
  }
  void put_text(const Place& p, const std::string& text, std::string_view anchor, const char* colour,
                const char* style) {
    const double y = p[1] + kSpaceTickFont * 0.36, width = text_width(text, kSpaceTickFont);
    const double left = anchor == "end" ? p[0] - width : p[0];
    const plane::Bounds box{{left, y - kSpaceTickFont * 0.8}, {left + width, y}};
    if (std::any_of(out_.texts.begin(), out_.texts.end(), [&](const auto& t) { return boxes_meet(t, box); })) return;
    out_.texts.push_back(box);
    put(out_.svg, "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", p[0],
        y, kSpaceTickFont, anchor, colour, style, xml_escaped(text));
  }

  const SpaceView& view_;
  std::string_view unit_;
  std::string lines_;
  SpaceAxes out_;
};

}  // namespace

void SpaceView::include(const Place3& p, double radius) {
  if (!any_) box_ = {p, p};
  for (std::size_t k = 0; k < 3; ++k) {
    box_[0][k] = std::min(box_[0][k], p[k] - radius);
    box_[1][k] = std::max(box_[1][k], p[k] + radius);
  }
  const Place on = on_page(p);
  for (std::size_t k = 0; k < 2; ++k) {
    low_[k] = any_ ? std::min(low_[k], on[k] - radius) : on[k] - radius;
    high_[k] = any_ ? std::max(high_[k], on[k] + radius) : on[k] + radius;
  }
  any_ = true;
}

void SpaceView::fit(double top) {
  top_ = top;
  double away = 0;
  for (const Place3& p : box_)
    for (const double c : p) away = std::max(away, std::abs(c));
  for (std::size_t k = 0; k < 3; ++k) {  // far away as much is shown as doubles need to tell ticks apart
    const double thin = away * margin::kRoundings512;
    if (box_[1][k] - box_[0][k] > 0 && box_[1][k] - box_[0][k] < thin) box_[1][k] = box_[0][k];
  }
  const std::array<Place3, 2> box = box_;
  for (const AxisEdge& edge : axis_edges(box[0], box[1])) {
    Place3 end = edge.from;
    end[edge.axis] = box[1][edge.axis];
    include(end);
    end[edge.axis] = box[0][edge.axis];
    include(end);
  }
  const double size = std::max(high_[0] - low_[0], high_[1] - low_[1]);
  scale_ = size > 0 ? kViewSize / size : 1;
}

Place SpaceView::at(const Place3& p) const {
  const Place on = on_page(p);
  return {(on[0] - low_[0]) * scale_ + kLeft, (on[1] - low_[1]) * scale_ + top_};
}

SpaceAxes space_axes(const SpaceView& view, std::string_view unit) { return AxisWriter(view, unit).run(); }

}  // namespace findspace::io
