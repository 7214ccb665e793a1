// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/draw/draw_layout.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

constexpr double kTitleSize = 16, kEntryLine = 20, kSwatch = 26, kEntryGap = 24;
constexpr std::size_t kMostLines = 3;  // of the title, and of what stands below it
constexpr double kTickDistance = 80, kTickFont = 10.5;

/// The sign before an entry's text: a swatch of 18 by 12 pixels around the middle of a line at y.
std::string sign(const LegendEntry& entry, double x, double y) {
  using M = LegendEntry::Mark;
  auto box = [&](const char* fill, const char* line) {
    return fmt::format(
        "<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"18\" height=\"12\"/>"
        "<path class=\"{}\" d=\"M{} {}h18v12h-18Z\"/>\n",
        fill, pixels(x), pixels(y - 6), line, pixels(x), pixels(y - 6));
  };
  auto line = [&](const char* style) {
    return fmt::format("<path class=\"{}\" d=\"M{} {}h18\"/>\n", style, pixels(x), pixels(y));
  };
  auto dot = [&](const char* style, double r) {
    return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style, pixels(x + 9), pixels(y), r);
  };
  switch (entry.mark) {
    case M::kFace:
      return box("face", "closed");
    case M::kClosed:
      return line("closed");
    case M::kOpen:
      return line("open");
    case M::kFree:
      return line("free");
    case M::kPoint:
      return dot("point", 4.6);
    case M::kFull:
      return dot("full", 2.6);
    case M::kHollow:
      return dot("hollow", 2.6);
    case M::kCopper:
      return box(entry.style.c_str(), "copper-line");
    case M::kFixed:
      return box("fixed", "fixed-line");
    case M::kBehind:
      return box("behind", "behind-line");
    case M::kMoving:
      return entry.style.empty() ? box("moving", "moving-line")
                                 : box(entry.style.c_str(), (entry.style + "-line").c_str());
    case M::kAround:
      return box("around", "around-line");
    case M::kArrow:
      return fmt::format("<path class=\"arrow\" d=\"M{} {}h18m-7 -4l7 4l-7 4\"/>\n", pixels(x), pixels(y));
    case M::kDimension:
      return line("dimension");
    case M::kFails:
      return line("dimension fails");
    case M::kNearest:
      return box("nearest", "nearest-line");
    case M::kPole:
      break;
  }
  return fmt::format("<path class=\"pole\" d=\"M{} {}h10m-5 -5v10\"/>\n", pixels(x + 4), pixels(y));
}

}  // namespace

Block title_block(std::string_view title, std::string_view subtitle, double left, double top, double width) {
  Block b;
  double y = top;
  auto lines = [&](std::string_view text, const char* style, double size) {
    if (text.empty()) return;
    std::vector<std::string> all = wrapped(text, width, size);
    if (all.size() > kMostLines) {
      all.resize(kMostLines);
      all.back() += "…";
    }
    for (const std::string& line : all) {
      y += size * 1.4;
      put(b.svg, "<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style, pixels(left), pixels(y), xml_escaped(line));
    }
  };
  lines(title, "title", kTitleSize);
  lines(subtitle, "subtitle", kFontSize);
  b.height = y - top + 12;
  return b;
}

std::string axes(const Frame& f) {
  // A picture of one point has no length to divide.
  const double spacing = std::max(round_length(kTickDistance / f.scale), std::numeric_limits<double>::min());
  const double right = f.left + f.width(), bottom = f.top + f.height();
  std::string grid, numbers;
  for (double t : ticks(f.world.low[0], f.world.high[0], spacing)) {
    put(grid, "M{} {}v5", pixels(f.x(t)), pixels(bottom));
    put(numbers, "<text class=\"tick\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{}</text>\n", pixels(f.x(t)),
        pixels(bottom + 6 + kTickFont), shown(t));
  }
  for (double t : ticks(f.world.low[1], f.world.high[1], spacing)) {
    put(grid, "M{} {}h-5", pixels(f.left), pixels(f.y(t)));
    put(numbers, "<text class=\"tick\" text-anchor=\"end\" x=\"{}\" y=\"{}\">{}</text>\n", pixels(f.left - 8),
        pixels(f.y(t) + kTickFont * 0.36), shown(t));
  }
  return fmt::format("<path class=\"axis\" d=\"M{0} {1}H{2}V{3}H{0}Z{4}\"/>\n{5}", pixels(f.left), pixels(f.top),
                     pixels(right), pixels(bottom), grid, numbers);
}

Block scale_bar(const Frame& f, std::string_view unit, double left, double top) {
  const double length = round_length(kMapWidth / 6 / f.scale), y = top + 8;
  Block b;
  put(b.svg, "<path class=\"bar\" d=\"M{} {}v8h{}v-8\"/>\n", pixels(left), pixels(y - 4), pixels(length * f.scale));
  put(b.svg, "<text class=\"note\" x=\"{}\" y=\"{}\">{}{}{}</text>\n", pixels(left + length * f.scale + 8),
      pixels(y + kFontSize * 0.36), shown(length), unit.empty() ? "" : " ", xml_escaped(unit));
  b.height = kEntryLine + 4;
  return b;
}

Block legend(const std::vector<LegendEntry>& entries, double left, double top, double width) {
  Block b;
  double x = left, y = top + kEntryLine / 2;
  for (const LegendEntry& e : entries) {
    const double needed = kSwatch + text_width(e.text);
    if (x > left && x + needed > left + width) {
      x = left;
      y += kEntryLine;
    }
    b.svg += sign(e, x, y);
    put(b.svg, "<text class=\"note\" x=\"{}\" y=\"{}\">{}</text>\n", pixels(x + kSwatch), pixels(y + kFontSize * 0.36),
        xml_escaped(e.text));
    x += needed + kEntryGap;
  }
  b.height = entries.empty() ? 0 : y + kEntryLine / 2 - top;
  return b;
}

std::string style_sheet(bool board) {
  // As layout programs colour the layers.
  constexpr const char* kBoard = R"(.copper-front { fill: #c83434; fill-opacity: .5; stroke: none }
.copper-back { fill: #4d7fc4; fill-opacity: .5; stroke: none }
.copper-inner { fill: #5f9f5f; fill-opacity: .45; stroke: none }
.copper-through { fill: #b8862f; fill-opacity: .75; stroke: none }
.hole { fill: #fff; stroke: #7a5a20; stroke-width: .4 }
.copper-line { stroke: none }
.behind { fill: #4d7fc4; fill-opacity: .08; fill-rule: evenodd; stroke: none }
.broken { fill: #f6b73c; fill-opacity: .3; fill-rule: evenodd; stroke: none }
.broken-line { stroke: #a86c00; stroke-width: 1.1 }
.behind-line { stroke: #35609c; stroke-width: 1; stroke-dasharray: 4 2 }
)";
  return fmt::format(R"(<style>
text {{ font-family: Inter, "Helvetica Neue", Arial, "DejaVu Sans", sans-serif; font-size: {}px; fill: #33383d }}
path, circle {{ fill: none; stroke-linejoin: round }}
.title {{ font-size: {}px; font-weight: 600; fill: #1d2125 }}
.subtitle {{ fill: #5d656d }}
.tick {{ font-size: {}px; fill: #7a828a }}
.axis {{ stroke: #b9c0c6; stroke-width: 1 }}
.bar {{ stroke: #33383d; stroke-width: 1.4 }}
.label {{ text-anchor: middle; fill: #33383d; stroke: #fff; stroke-width: 3.5; stroke-opacity: .85; paint-order: stroke }}
{}.fixed {{ fill: #5b6873; fill-opacity: .13; fill-rule: evenodd; stroke: none }}
.fixed-line {{ stroke: #5b6873; stroke-width: 1.1 }}
.fixed-dot {{ fill: #5b6873 }}
.moving {{ fill: #f6b73c; fill-opacity: .78; fill-rule: evenodd; stroke: none }}
.moving-line {{ stroke: #a86c00; stroke-width: 1.3 }}
.moving-dot {{ fill: #a86c00 }}
.around {{ fill: #2a9d8f; fill-opacity: .16; fill-rule: evenodd; stroke: none }}
.around-line {{ stroke: #14665c; stroke-opacity: .5; stroke-width: 1 }}
.around-dot {{ fill: #14665c; fill-opacity: .5 }}
.face {{ fill: #2a9d8f; fill-opacity: .38; fill-rule: evenodd; stroke: none }}
.closed {{ stroke: #14665c; stroke-width: 1.5 }}
.underlay {{ stroke: #fff; stroke-width: 1.6 }}
.open {{ stroke: #14665c; stroke-width: 1.5; stroke-dasharray: 5 4 }}
.free {{ stroke: #c1273b; stroke-width: 2.8; stroke-linecap: round }}
.point {{ fill: #c1273b; stroke: #fff; stroke-width: 1.4 }}
.full {{ fill: #14665c; stroke: #fff; stroke-width: .8 }}
.hollow {{ fill: #fff; stroke: #14665c; stroke-width: 1.3 }}
.arrow {{ stroke: #7a3fa0; stroke-width: 1.6; stroke-linecap: round }}
.dimension {{ stroke: #2f5d9b; stroke-width: 1.3 }}
.fails {{ stroke: #c1273b; stroke-width: 1.9 }}
.end {{ fill: #2f5d9b; stroke: none }}
.end.fails {{ fill: #c1273b }}
.nearest {{ fill: none; stroke: none }}
.nearest-line {{ stroke: #a86c00; stroke-width: 1.3; stroke-dasharray: 4 3 }}
.nearest-dot {{ fill: #a86c00 }}
.pole {{ stroke: #5c3b00; stroke-width: 1.6; stroke-linecap: round }}
</style>
)",
                     kFontSize, kTitleSize, kTickFont, board ? kBoard : "");
}

}  // namespace findspace::io
