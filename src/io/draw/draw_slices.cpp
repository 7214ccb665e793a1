// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_legend.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

constexpr double kWidth = 900, kPanelGap = 18, kPanelLine = 16;

/// One layer: from the window's coordinates to those of its panel.
struct Panel {
  double left, top, scale, x0, y1, strip;
  double x(double v) const { return left + (v - x0) * scale; }
  double y(double v) const { return top + (y1 - v) * scale; }
};

void put_strip(std::string& strips, std::string& dots, const Panel& p, double from, double to, double y, bool point) {
  if (point)
    put(dots, "M{:.2f} {:.2f}h0", p.x(from), p.y(y));
  else
    put(strips, "M{:.2f} {:.2f}h{:.2f}v{:.2f}h{:.2f}z", p.x(from), p.y(y + p.strip / 2), (to - from) * p.scale,
        p.strip * p.scale, (from - to) * p.scale);
}

/// The intervals of line i, cut at the window.
void put_line(std::string& strips, std::string& dots, const Panel& panel, const space::RayRow& row, int i, double y,
              double scale, double low, double high) {
  bool in = row.before[static_cast<std::size_t>(i)] <= 0;
  double from = low;
  for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
    const space::RayEvent& event = row.events[static_cast<std::size_t>(e)];
    const double at = std::clamp(event.at.value * scale, low, high);
    const bool after = event.after <= 0;
    if (in && !after) put_strip(strips, dots, panel, from, at, y, false);
    if (!in && after) from = at;
    if (!in && !after && event.here <= 0) put_strip(strips, dots, panel, at, at, y, true);
    in = after;
  }
  if (in) put_strip(strips, dots, panel, from, high, y, false);
}

}  // namespace

space::RayGrid slice_grid(const space::Point& low, const space::Point& high, int layers, int n) {
  space::RayGrid grid = space::ray_grid(low, high, 0, n);
  const std::int64_t height = (high.z - low.z) * grid.parts;
  grid.nv = layers;
  grid.dv = std::max<std::int64_t>(1, height / layers);
  grid.v = low.z * grid.parts + grid.dv / 2;
  return grid;
}

namespace {

/// The window in the unit, and where its layers stand on the page: `across` beside each other, `down` below.
struct Page {
  Page(std::size_t layers, const space::Point& low, const space::Point& high, double step)
      : x0(static_cast<double>(low.x) * step),
        x1(static_cast<double>(high.x) * step),
        y0(static_cast<double>(low.y) * step),
        y1(static_cast<double>(high.y) * step),
        across(std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(layers)))))),
        down((static_cast<int>(layers) + across - 1) / across),
        per_unit(((kWidth - kPanelGap) / across - kPanelGap) / std::max(x1 - x0, y1 - y0)),
        width(std::max(kWidth * 0.6, kPanelGap + across * ((x1 - x0) * per_unit + kPanelGap))) {}
  double panel_width() const { return (x1 - x0) * per_unit; }
  double panel_height() const { return (y1 - y0) * per_unit; }
  double below(double top) const { return top + down * (panel_height() + kPanelLine + kPanelGap); }

  double x0, x1, y0, y1;
  int across, down;
  double per_unit, width;  // pixels
};

/// Layer k of the grid as a panel of the page; `points` becomes true where a line has a single point.
std::string layer_svg(const space::RayRow& row, const space::RayGrid& grid, int k, const Page& page, double top,
                      double part, std::string_view unit, bool& points) {
  const int below = k / page.across;  // rows of panels
  const Panel panel{kPanelGap + (k % page.across) * (page.panel_width() + kPanelGap),
                    top + below * (page.panel_height() + kPanelLine + kPanelGap),
                    page.per_unit,
                    page.x0,
                    page.y1,
                    static_cast<double>(grid.du) * part};
  std::string strips, dots;
  for (int i = 0; i < grid.nu; ++i)
    put_line(strips, dots, panel, row, i, static_cast<double>(grid.u_at(i)) * part, part, page.x0, page.x1);
  points = points || !dots.empty();
  std::string out = fmt::format(
      "<g class=\"layer\">\n<text class=\"note\" x=\"{:.2f}\" y=\"{:.2f}\">z = {}{}</text>\n"
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" stroke=\"#b9c0c6\"/>\n",
      panel.left, panel.top - 4, shown(static_cast<double>(grid.v_at(k)) * part), xml_escaped(unit), panel.left,
      panel.top, page.panel_width(), page.panel_height());
  if (!strips.empty()) out += fmt::format("<path class=\"face strips\" d=\"{}\"/>\n", strips);
  if (!dots.empty()) out += fmt::format("<path class=\"free dots\" d=\"{}\"/>\n", dots);
  return out + "</g>\n";
}

/// What the marks mean and which window is shown, from `top` on.
Block below_layers(const Page& page, const SlicesText& text, std::string_view unit, bool points, double top) {
  std::vector<LegendEntry> entries{{LegendEntry::Mark::kFace, text.meaning}};
  if (points) entries.push_back({LegendEntry::Mark::kPoint, "a single point of a line"});
  Block meanings = legend(entries, kPanelGap, top, page.width - 2 * kPanelGap);
  const std::string ranges =
      fmt::format("Each layer is seen from above: x from {} to {}{} to the right, y from {} to {}{} upward.",
                  shown(page.x0), shown(page.x1), unit, shown(page.y0), shown(page.y1), unit);
  const Block says = title_block("", ranges, kPanelGap, top + meanings.height, page.width - 2 * kPanelGap);
  return {meanings.svg + says.svg, meanings.height + says.height};
}

}  // namespace

std::string slices_svg(const std::vector<space::RayRow>& rows, const space::RayGrid& grid, const space::Point& low,
                       const space::Point& high, double step, const SlicesText& text) {
  const Page page(rows.size(), low, high, step);
  const Block title = title_block(text.title, text.subtitle, kPanelGap, kPanelLine, kWidth - 2 * kPanelGap);
  const double top = kPanelLine + title.height + kPanelLine, below = page.below(top);
  const double part = step / static_cast<double>(grid.parts);
  const std::string unit = text.unit.empty() ? "" : " " + text.unit;
  std::string panels;
  bool points = false;
  for (std::size_t j = 0; j < rows.size(); ++j)
    panels += layer_svg(rows[j], grid, static_cast<int>(j), page, top, part, unit, points);
  const Block says = below_layers(page, text, unit, points, below);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n"
      "<title>{2}</title>\n{3}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{4}{5}{6}</svg>\n",
      page.width, below + says.height, xml_escaped(text.title), style_sheet(), title.svg, panels, says.svg);
}

}  // namespace findspace::io
