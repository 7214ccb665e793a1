// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/draw/draw_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"

namespace findspace::io {

using plane::Bounds;
using plane::Place;

void include(std::optional<Bounds>& bounds, const Bounds& added) {
  if (!bounds) bounds = added;
  for (int i : {0, 1}) {
    bounds->low[i] = std::min(bounds->low[i], added.low[i]);
    bounds->high[i] = std::max(bounds->high[i], added.high[i]);
  }
}

Frame fit(const Bounds& bounds, double margin, double left, double top) {
  const double width = bounds.high[0] - bounds.low[0], height = bounds.high[1] - bounds.low[1];
  const double size = std::max(width, height);
  const double away =
      std::max({std::abs(bounds.low[0]), std::abs(bounds.high[0]), std::abs(bounds.low[1]), std::abs(bounds.high[1])});
  // Far away as much is shown as doubles need to tell ticks apart.
  const double padding = std::max(size > 0 ? size * margin : 1, away * margin::kRoundings512);
  // A picture that is a line would have no height: it is given a sixth of its length.
  const double extra_x = std::max(padding, (size / 6 - width) / 2),
               extra_y = std::max(padding, (size / 6 - height) / 2);
  Frame f;
  f.world = {{bounds.low[0] - extra_x, bounds.low[1] - extra_y}, {bounds.high[0] + extra_x, bounds.high[1] + extra_y}};
  f.scale = std::min(kMapWidth / (f.world.high[0] - f.world.low[0]), kMapHeight / (f.world.high[1] - f.world.low[1]));
  f.left = left;
  f.top = top;
  return f;
}

double round_length(double about) {
  const double power = std::pow(10, std::floor(std::log10(about)));
  for (double digit : {5.0, 2.0}) {
    if (digit * power <= about) return digit * power;
  }
  return power;
}

std::vector<double> ticks(double low, double high, double spacing) {
  std::vector<double> out;
  for (double k = std::ceil(low / spacing); k * spacing <= high; ++k) out.push_back(k * spacing);
  return out;
}

double text_width(std::string_view text, double font_size) {
  // Letters of one byte; of several bytes only the first counts.
  double units = 0;
  for (const unsigned char c : text) {
    if (c >= 0x80 && c < 0xC0) continue;
    if (std::string_view(" ,.:;'|!()[]ijl-").find(char(c)) != std::string_view::npos)
      units += 0.36;
    else if (std::string_view("<=>+mwMW%@").find(char(c)) != std::string_view::npos)
      units += 0.88;
    else
      units += c >= 'A' && c <= 'Z' ? 0.7 : 0.6;
  }
  return units * font_size;
}

Bounds text_box(const Place& middle, std::string_view text, double font_size) {
  const double w = text_width(text, font_size) / 2 + 1, h = font_size * 0.6;
  return {{middle[0] - w, middle[1] - h}, {middle[0] + w, middle[1] + h}};
}

bool boxes_meet(const Bounds& a, const Bounds& b) {
  return a.low[0] < b.high[0] && b.low[0] < a.high[0] && a.low[1] < b.high[1] && b.low[1] < a.high[1];
}

std::vector<std::string> wrapped(std::string_view text, double width, double font_size) {
  std::vector<std::string> lines{""};
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size() - 1) + 1;
    const std::string_view word = text.substr(0, blank);
    if (!lines.back().empty() && text_width(lines.back() + std::string(word), font_size) > width) lines.emplace_back();
    lines.back() += word;
    text.remove_prefix(blank);
  }
  return lines;
}

std::string shown(double value) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  return size >= 1e6 && size < 1e15 ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

}  // namespace findspace::io
