// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/draw_slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/draw/draw_legend.h"
#include "io/draw/slice_names.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

constexpr double kWidth = 900, kPanelGap = 18, kPanelLine = 16;

// Opaque, so that the line below shows at the rim alone and not between strips.
constexpr const char* kSection = "fill:#e9ebec;stroke:#7d8891;stroke-width:1.6;paint-order:stroke";
constexpr double kTicksLeft = 38, kTicksBelow = 20;  // room for the numbers of a panel

/// One layer: where it stands on the page, and how wide its strips are.
struct Panel {
  Frame frame;
  double strip;
};

/// The intervals of line i, cut at the window.
void add_line(std::vector<Strip>& out, const space::RayRow& row, int i, double y, double scale, double low,
              double high) {
  bool in = row.before[static_cast<std::size_t>(i)] <= 0;
  double from = low;
  for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
    const space::RayEvent& event = row.events[static_cast<std::size_t>(e)];
    const double at = std::clamp(event.at.value * scale, low, high);
    const bool after = event.after <= 0;
    if (in && !after) out.push_back({from, at, y, false});
    if (!in && after) from = at;
    if (!in && !after && event.here <= 0) out.push_back({at, at, y, true});
    in = after;
  }
  if (in) out.push_back({from, high, y, false});
}

/// What a set's lines give to draw in a layer.
std::vector<Strip> strips_of(const space::RayRow& row, const space::RayGrid& grid, const Panel& panel, double part) {
  const plane::Bounds& shown = panel.frame.world;
  std::vector<Strip> out;
  for (int i = 0; i < grid.nu; ++i)
    add_line(out, row, i, static_cast<double>(grid.u_at(i)) * part, part, shown.low[0], shown.high[0]);
  return out;
}

std::string strip_path(const std::vector<Strip>& strips, const Panel& p) {
  std::string out;
  for (const Strip& s : strips)
    if (!s.point)
      put(out, "M{:.2f} {:.2f}h{:.2f}v{:.2f}h{:.2f}z", p.frame.x(s.from), p.frame.y(s.y + p.strip / 2),
          (s.to - s.from) * p.frame.scale, p.strip * p.frame.scale, (s.from - s.to) * p.frame.scale);
  return out;
}

std::string dot_path(const std::vector<Strip>& strips, const Panel& p) {
  std::string out;
  for (const Strip& s : strips)
    if (s.point) put(out, "M{:.2f} {:.2f}h0", p.frame.x(s.from), p.frame.y(s.y));
  return out;
}

double length_of(const std::vector<Strip>& strips) {
  double sum = 0;
  for (const Strip& s : strips) sum += s.to - s.from;
  return sum;
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

/// The unit as it stands after a number, fit for XML.
std::string unit_after(const SlicesPicture& picture) {
  return picture.unit.empty() ? "" : " " + xml_escaped(picture.unit);
}

/// The window in the unit, and where its layers stand on the page: `across` beside each other, `down` below.
struct Page {
  Page(std::size_t layers, const space::Point& low, const space::Point& high, double step)
      : x0(static_cast<double>(low.x) * step),
        x1(static_cast<double>(high.x) * step),
        y0(static_cast<double>(low.y) * step),
        y1(static_cast<double>(high.y) * step),
        across(std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(layers)))))),
        down((static_cast<int>(layers) + across - 1) / across),
        per_unit(((kWidth - kPanelGap) / across - kPanelGap - kTicksLeft) / std::max(x1 - x0, y1 - y0)),
        width(std::max(kWidth * 0.6, kPanelGap + across * across_one())) {}
  double across_one() const { return kTicksLeft + (x1 - x0) * per_unit + kPanelGap; }
  double below_one() const { return kPanelLine + (y1 - y0) * per_unit + kTicksBelow + kPanelGap; }
  double below(double top) const { return top + down * below_one(); }
  /// Of layer k; the first row of layers begins at `top`.
  Frame frame(int k, double top) const {
    const int column = k % across, row = k / across;
    return {{{x0, y0}, {x1, y1}}, per_unit, kPanelGap + kTicksLeft + column * across_one(), top + row * below_one()};
  }

  double x0, x1, y0, y1;
  int across, down;
  double per_unit, width;  // pixels
};

/// Layer k of the grid.
SliceLayer layer_of(const SlicesPicture& picture, int k, const Frame& frame, double part) {
  const space::RayGrid& grid = picture.grid;
  const Panel panel{frame, static_cast<double>(grid.du) * part};
  const auto row = static_cast<std::size_t>(k);
  SliceLayer out{frame, panel.strip, {}, strips_of(picture.rows[row], grid, panel, part)};
  for (std::size_t n = 0; n < picture.fixed.size(); ++n)
    out.sections.push_back({n, strips_of(picture.fixed[n].rows[row], grid, panel, part)});
  std::stable_sort(out.sections.begin(), out.sections.end(), [](const SliceSection& a, const SliceSection& b) {
    return length_of(a.strips) > length_of(b.strips);
  });
  return out;
}

/// The fixed shapes below the region, and their names above it.
std::string layer_svg(const SliceLayer& layer, const std::string& height, const std::string& names) {
  const Panel panel{layer.frame, layer.width};
  std::string out = fmt::format("<g class=\"layer\">\n<text class=\"note\" x=\"{:.2f}\" y=\"{:.2f}\">z = {}</text>\n{}",
                                layer.frame.left, layer.frame.top - 4, height, axes(layer.frame));
  for (const SliceSection& section : layer.sections)
    if (const std::string path = strip_path(section.strips, panel); !path.empty())
      out += fmt::format("<path class=\"section\" style=\"{}\" d=\"{}\"/>\n", kSection, path);
  const std::string strips = strip_path(layer.region, panel), dots = dot_path(layer.region, panel);
  if (!strips.empty()) out += fmt::format("<path class=\"face strips\" d=\"{}\"/>\n", strips);
  if (!dots.empty()) out += fmt::format("<path class=\"free dots\" d=\"{}\"/>\n", dots);
  return out + names + "</g>\n";
}

/// What the marks mean and which window is shown, from `top` on.
Block below_layers(const Page& page, const SlicesPicture& picture, bool points, double top) {
  std::vector<LegendEntry> entries{{LegendEntry::Mark::kFace, picture.meaning}};
  if (points) entries.push_back({LegendEntry::Mark::kPoint, "a single point of a line"});
  if (!picture.fixed.empty()) entries.push_back({LegendEntry::Mark::kFixed, "fixed shapes, cut at this height"});
  Block meanings = legend(entries, kPanelGap, top, page.width - 2 * kPanelGap);
  const std::string unit = unit_after(picture);
  const std::string ranges =
      fmt::format("Each layer is seen from above: x from {} to {}{} to the right, y from {} to {}{} upward.",
                  shown(page.x0), shown(page.x1), unit, shown(page.y0), shown(page.y1), unit);
  const Block says = title_block("", ranges, kPanelGap, top + meanings.height, page.width - 2 * kPanelGap);
  return {meanings.svg + says.svg, meanings.height + says.height};
}

}  // namespace

std::string slices_svg(const SlicesPicture& picture) {
  const Page page(picture.rows.size(), picture.low, picture.high, picture.step);
  const Block title = title_block(picture.title, picture.subtitle, kPanelGap, kPanelLine, kWidth - 2 * kPanelGap);
  const double top = kPanelLine + title.height + kPanelLine, below = page.below(top);
  const double part = picture.step / static_cast<double>(picture.grid.parts);
  std::vector<SliceLayer> layers;
  for (int k = 0; k < static_cast<int>(picture.rows.size()); ++k)
    layers.push_back(layer_of(picture, k, page.frame(k, top), part));
  std::vector<std::string> shapes;
  for (const SlicesPicture::Fixed& shape : picture.fixed) shapes.push_back(shape.name);
  const std::vector<std::string> names = slice_names(layers, shapes);
  std::string panels;
  bool points = false;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const std::string height = shown(static_cast<double>(picture.grid.v_at(static_cast<int>(k))) * part);
    panels += layer_svg(layers[k], height + unit_after(picture), names[k]);
    for (const Strip& s : layers[k].region) points = points || s.point;
  }
  const Block says = below_layers(page, picture, points, below);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n"
      "<title>{2}</title>\n{3}<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{4}{5}{6}</svg>\n",
      page.width, below + says.height, xml_escaped(picture.title), style_sheet(), title.svg, panels, says.svg);
}

}  // namespace findspace::io
