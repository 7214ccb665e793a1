// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/write_layout.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/draw/draw_canvas.h"

namespace findspace::io {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string angle_text(const packing::Fraction& angle) {
  return angle.text().find('/') == std::string::npos ? angle.text() : quoted(angle.text());
}

std::string item_json(const packing::Problem& problem, const packing::Placed& item) {
  return fmt::format(
      "    {{\"part\": {}, \"copy\": {}, \"sheet\": 0, \"angle\": {}, \"mirrored\": {}, \"at\": [\"{}\", \"{}\"]}}",
      quoted(problem.parts[item.part].name), item.copy, angle_text(item.angle), item.mirrored, item.x.text(),
      item.y.text());
}

/// The outline where it stands, in doubles.
std::string path_of(const packing::Problem& problem, const packing::Placed& item) {
  const packing::Polygon shape = turned(problem.parts[item.part].shape, item.angle, item.mirrored);
  const double steps = double(problem.steps()), x = item.x.to_double(), y = item.y.to_double();
  std::string path;
  for (const packing::Ring& ring : shape.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      path += fmt::format("{}{:.9g},{:.9g}", i == 0 ? "M" : " ", x + double(ring[i].x) / steps,
                          y + double(ring[i].y) / steps);
    path += "z";
  }
  return path;
}

}  // namespace

std::string layout_json(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts) {
  std::string items, left_out, grid;
  for (const packing::Placed& item : layout.items) {
    items += (items.empty() ? "\n" : ",\n") + item_json(problem, item);
    if (!packing::is_quarter(item.angle))
      grid = fmt::format("\"grid\": \"{}\", ", packing::Fraction(1, problem.steps()).text());
  }
  for (const packing::LeftOut& out : layout.left_out)
    left_out += fmt::format("{}\n    {{\"part\": {}, \"copies\": {}, \"why\": {}}}", left_out.empty() ? "" : ",",
                            quoted(problem.parts[out.part].name), out.copies, quoted(out.why));
  return fmt::format(
      "{{\"findspace\": 1, \"layout\": {{\n"
      "  \"instance\": {}, \"container\": {{\"strip\": \"{}\"}}, \"gap\": \"{}\", \"edge\": \"{}\", \"length\": "
      "\"{}\", \"density\": {:.6f}, "
      "\"lower_bound\": \"{}\", \"proven\": {}, {}\n"
      "  \"seed\": {}, \"threads\": {}, \"seconds\": {:.2f},\n  \"items\": [{}],\n  \"left_out\": [{}]}}}}\n",
      quoted(problem.name), problem.height.text(), problem.gap.text(), problem.edge.text(), layout.length.text(),
      facts.density, facts.lower_bound.text(), facts.proven, grid, facts.seed, facts.threads, facts.seconds, items,
      left_out);
}

std::string layout_svg(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts) {
  const double length = layout.length.to_double(), height = problem.height.to_double(), room = 0.06 * height;
  const double size = 0.03 * height;
  std::string body;
  for (const packing::Placed& item : layout.items) {
    const double hue = 360.0 * double(item.part) / double(problem.parts.size());
    body +=
        fmt::format("<path d=\"{}\" fill=\"hsl({:.0f},45%,78%)\"><title>{}</title></path>\n", path_of(problem, item),
                    hue, xml_escaped(problem.parts[item.part].name + " #" + std::to_string(item.copy)));
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.9g} {:.9g} {:.9g} {:.9g}\" font-family=\"sans-serif\">\n"
      "<g transform=\"scale(1,-1)\" stroke=\"#333\" stroke-width=\"{:.6g}\" stroke-linejoin=\"round\" "
      "fill-rule=\"evenodd\">\n<rect width=\"{:.9g}\" height=\"{:.9g}\" fill=\"#f6f6f2\"/>\n{}</g>\n"
      "<text x=\"0\" y=\"{:.9g}\" font-size=\"{:.6g}\">length {}, density {:.3f} %, {} parts</text>\n</svg>\n",
      -room, -height - room, length + 2 * room, height + 3 * room, height / 600, length, height, body, 1.5 * room, size,
      layout.length.text(), 100 * facts.density, layout.items.size());
}

}  // namespace findspace::io
