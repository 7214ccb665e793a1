// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_dimensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/draw/draw_labels.h"
#include "io/draw/draw_layout.h"

namespace findspace::io {

using plane::Place;

namespace {

constexpr double kRing = 6, kDot = 2.2, kAside = 11;  // pixels

bool same_places(const DimensionLine& a, const DimensionLine& b) {
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

/// Beside the line at a part of its length, above it or right of an upright one; with -1 on the other side.
Place beside(const DimensionLine& line, const Frame& frame, double part, double side) {
  const Place p{frame.x(line.from[0]), frame.y(line.from[1])}, q{frame.x(line.to[0]), frame.y(line.to[1])};
  const Place at{p[0] + (q[0] - p[0]) * part, p[1] + (q[1] - p[1]) * part};
  const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
  if (length < 1) return {at[0], at[1] - side * (kAside + kRing)};
  if (q[0] < p[0]) side = -side;
  const double away =
      kAside * line.font / kFontSize + text_width(line.text, line.font) / 2 * std::abs(q[1] - p[1]) / length;
  return {at[0] + side * away * (q[1] - p[1]) / length, at[1] - side * away * (q[0] - p[0]) / length};
}

/// A text by its middle.
struct PlacedText {
  Place at;
  double width, font;
};

bool meet(const PlacedText& s, const PlacedText& t) {
  const double height = std::max(s.font, t.font), apart = height / kFontSize;
  return std::abs(s.at[0] - t.at[0]) < (s.width + t.width) / 2 + 6 * apart &&
         std::abs(s.at[1] - t.at[1]) < height + 3 * apart;
}

bool in_frame(const PlacedText& s, const Frame& frame) {
  const double w = s.width / 2, h = s.font / 2;
  return s.at[0] - w >= frame.left && s.at[0] + w <= frame.left + frame.width() && s.at[1] - h >= frame.top &&
         s.at[1] + h <= frame.top + frame.height();
}

}  // namespace

std::vector<DimensionLine> without_repetition(std::vector<DimensionLine> all) {
  std::vector<DimensionLine> out;
  for (DimensionLine& line : all) {
    const auto same = std::find_if(out.begin(), out.end(),
                                   [&](const DimensionLine& o) { return o.text == line.text && same_places(o, line); });
    if (same == out.end())
      out.push_back(std::move(line));
    else
      same->fails = same->fails || line.fails;
  }
  return out;
}

std::vector<Place> text_places(const std::vector<DimensionLine>& all, const Frame& frame) {
  std::vector<PlacedText> placed;
  const auto is_free = [&](const PlacedText& text) {
    return in_frame(text, frame) &&
           std::none_of(placed.begin(), placed.end(), [&](const PlacedText& other) { return meet(text, other); });
  };
  for (const DimensionLine& line : all) {
    PlacedText text{{}, text_width(line.text, line.font), line.font};
    bool free = false;
    for (const double part : {0.5, 0.3, 0.7, 0.1, 0.9}) {
      for (const double side : {1.0, -1.0}) {
        if (free) break;
        text.at = beside(line, frame, part, side);
        free = is_free(text);
      }
    }
    placed.push_back(text);
  }
  std::vector<Place> out;
  for (const PlacedText& text : placed) out.push_back(text.at);
  return out;
}

std::string dimension_lines(const std::vector<DimensionLine>& all, const Frame& frame) {
  std::string lines, texts;
  const std::vector<Place> places = text_places(all, frame);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const DimensionLine& d = all[i];
    const std::string style = d.fails ? "dimension fails" : "dimension";
    const double x0 = frame.x(d.from[0]), y0 = frame.y(d.from[1]), x1 = frame.x(d.to[0]), y1 = frame.y(d.to[1]);
    const auto circle = [&](double x, double y, double r, std::string_view suffix) {
      return fmt::format("<circle class=\"{}{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style, suffix, pixels(x), pixels(y),
                         r);
    };
    if (std::hypot(x1 - x0, y1 - y0) < 1)
      lines += circle(x0, y0, kRing, "");
    else
      lines += fmt::format("<path class=\"{}\" d=\"M{} {}L{} {}\"/>\n", style, pixels(x0), pixels(y0), pixels(x1),
                           pixels(y1)) +
               circle(x0, y0, kDot, " end") + circle(x1, y1, kDot, " end");
    texts += label_text(places[i][0], places[i][1], d.text, d.font, false);
  }
  return lines + texts;
}

std::vector<LegendEntry> dimension_entries(const std::vector<DimensionLine>& all) {
  const auto has = [&](bool fails) {
    return std::any_of(all.begin(), all.end(), [fails](const DimensionLine& d) { return d.fails == fails; });
  };
  std::vector<LegendEntry> out;
  if (has(false)) out.push_back({LegendEntry::Mark::kDimension, has(true) ? "distance that holds" : "distance"});
  if (has(true)) out.push_back({LegendEntry::Mark::kFails, "distance that fails"});
  return out;
}

}  // namespace findspace::io
