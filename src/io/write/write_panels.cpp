// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/draw/draw_labels.h"
#include "io/draw/draw_layout.h"

namespace findspace::io {

std::string panels_svg(const std::string& title, const std::vector<SvgDrawing>& panels) {
  double width = 0, height = 0;
  for (const SvgDrawing& p : panels) {
    width = std::max(width, p.width);
    height = std::max(height, p.height);
  }
  const double count = double(panels.size());
  const double wanted = std::ceil(std::sqrt(count * height / std::max(width, 1.0)));
  const auto columns = std::size_t(std::clamp(wanted, 1.0, std::max(count, 1.0)));
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  std::string all;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const std::size_t column = k % columns, row = k / columns;
    all += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", pixels(double(column) * width),
                       pixels(double(row) * height), panels[k].svg);
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
      pixels(double(columns) * width), pixels(double(rows) * height), xml_escaped(title), all);
}

}  // namespace findspace::io
