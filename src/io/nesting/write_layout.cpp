// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/write_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/draw/draw_canvas.h"
#include "io/draw/face_rings.h"
#include "packing/problem/round_part.h"

namespace findspace::io {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string angle_text(const packing::Fraction& angle) {
  return angle.text().find('/') == std::string::npos ? angle.text() : quoted(angle.text());
}

std::string item_json(const packing::Problem& problem, const packing::Placed& item) {
  return fmt::format(
      "    {{\"part\": {}, \"copy\": {}, \"sheet\": {}, \"angle\": {}, \"mirrored\": {}, \"at\": [\"{}\", \"{}\"]}}",
      quoted(problem.parts[item.part].name), item.copy, item.sheet, angle_text(item.angle), item.mirrored,
      item.x.text(), item.y.text());
}

std::string container_json(const packing::Problem& problem, const packing::Layout& layout) {
  if (!problem.on_sheets())
    return fmt::format("{{\"{}\": \"{}\"}}", problem.box ? "box" : "strip", height_of(problem, layout).text());
  std::string names;
  for (const std::size_t kind : layout.sheets) names += (names.empty() ? "" : ", ") + quoted(problem.sheets[kind].name);
  return fmt::format("{{\"sheets\": [{}]}}", names);
}

std::string remnant_json(const std::optional<packing::Remnant>& remnant) {
  if (!remnant) return "";
  return fmt::format(
      "\"remnant\": {{\"sheet\": {}, \"x\": \"{}\", \"y\": \"{}\", \"width\": \"{}\", \"height\": \"{}\"}}, ",
      remnant->sheet, remnant->x.text(), remnant->y.text(), remnant->width.text(), remnant->height.text());
}

using Outlines = std::vector<std::vector<DrawnCorner>>;

/// A page of the drawing: the strip, or one sheet.
struct Page {
  std::string title;
  double width, height;
  Outlines outline, zones;
};

Outlines outlines_of(const packing::Polygon& shape, packing::int128 grid, double x, double y) {
  Outlines result;
  const double steps = double(grid);
  for (const packing::Ring& ring : shape.rings) {
    auto& out = result.emplace_back();
    for (const packing::LatticePoint& p : ring) out.push_back({x + double(p.x) / steps, y + double(p.y) / steps});
  }
  return result;
}

Outlines outlines_of(const plane::Region& region, packing::int128 steps, double x, double y) {
  Outlines result;
  const plane::CurveNet net(region, exact::Real(1) / exact::Real(steps));
  const FaceRings rings(net);
  const auto add_ring = [&](const plane::CurveNet::Ring& ring) {
    auto& out = result.emplace_back();
    for (const plane::CurveNet::Side& side : ring) {
      const plane::CurveNet::Curve& curve = net.curves()[side.curve];
      const double way = side.forward ? 1 : -1, angle = curve.arc ? net.angle(curve) : 0;
      const bool whole = curve.from == curve.to;  // a circle, from its leftmost point
      const plane::Place from = net.at(side.forward ? curve.from : curve.to);
      out.push_back({x + from[0], y + from[1], way * std::tan(angle / (whole ? 8 : 4))});
      if (whole) out.push_back({x + curve.center[0] + curve.radius, y + curve.center[1], way});
    }
  };
  for (const plane::Face& face : region.faces)
    if (face.mark != 0)
      for (const plane::CurveNet::Ring& ring : rings.of(face)) add_ring(ring);
  return result;
}

/// The outline of an item where it stands, in doubles.
Outlines outlines_of(const packing::Problem& problem, const packing::Placed& item) {
  const packing::Part& part = problem.parts[item.part];
  const double x = item.x.to_double(), y = item.y.to_double();
  if (part.round) return outlines_of(part.round->at(item.angle, item.mirrored).region, problem.steps(), x, y);
  return outlines_of(rotated(part, item.angle, item.mirrored), problem.steps(), x, y);
}

/// Of a sheet or a zone.
template <class Outlined>
Outlines outlines_of(const Outlined& outlined, packing::int128 steps) {
  if (outlined.round) return outlines_of(outlined.round->at(0, false).region, steps, 0, 0);
  return outlines_of(outlined.shape, steps, 0, 0);
}

Outlines zones_of(const packing::Problem& problem, const packing::Sheet& sheet) {
  Outlines result;
  for (const packing::Zone& zone : sheet.zones)
    for (auto& ring : outlines_of(zone, problem.steps())) result.push_back(std::move(ring));
  return result;
}

std::vector<Page> pages_of(const packing::Problem& problem, const packing::Layout& layout) {
  std::vector<Page> pages;
  const double length = layout.length.to_double(), height = height_of(problem, layout).to_double();
  if (!problem.on_sheets()) return {{"", length, height, {{{0, 0}, {length, 0}, {length, height}, {0, height}}}, {}}};
  for (std::size_t k = 0; k < layout.sheets.size(); ++k) {
    const packing::Sheet& sheet = problem.sheets[layout.sheets[k]];
    const packing::LatticeBox box = box_of(sheet);
    Page& page = pages.emplace_back();
    page.title = fmt::format("sheet {}: {}", k + 1, sheet.name);
    page.width = double(box.high.x) / double(problem.steps());
    page.height = double(box.high.y) / double(problem.steps());
    page.outline = outlines_of(sheet, problem.steps());
    page.zones = zones_of(problem, sheet);
  }
  return pages;
}

/// In a drawing with y upwards. Arcs in parts of less than half a circle, which no viewer can mistake.
void add_arc(std::string& path, const DrawnCorner& from, const DrawnCorner& to) {
  const double b = from.bulge, dx = to.x - from.x, dy = to.y - from.y;
  if (std::abs(b) > 0.5) {
    const double half = std::tan(std::atan(b) / 2);
    const DrawnCorner middle{(from.x + to.x + b * dy) / 2, (from.y + to.y - b * dx) / 2, half};
    add_arc(path, {from.x, from.y, half}, middle);
    return add_arc(path, middle, to);
  }
  const double radius = std::hypot(dx, dy) * (1 + b * b) / (4 * std::abs(b));
  path += fmt::format("A{0:.9g} {0:.9g} 0 0 {1} {2:.9g},{3:.9g}", radius, b > 0 ? 1 : 0, to.x, to.y);
}

std::string path_of(const Outlines& outlines) {
  std::string path;
  for (const auto& ring : outlines) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const bool after_arc = i > 0 && ring[i - 1].bulge != 0;
      if (!after_arc) path += fmt::format("{}{:.9g},{:.9g}", i == 0 ? "M" : "L", ring[i].x, ring[i].y);
      if (ring[i].bulge != 0) add_arc(path, ring[i], ring[(i + 1) % ring.size()]);
    }
    path += "z";
  }
  return path;
}

std::string downward_path(Outlines outlines) {
  for (auto& ring : outlines)
    for (DrawnCorner& c : ring) c = {c.x, -c.y, -c.bulge};
  return path_of(outlines);
}

}  // namespace

std::string left_out_json(const std::string& part, const packing::LeftOut& out) {
  return fmt::format("\n    {{\"part\": {}, \"copies\": {}, \"why\": {}}}", quoted(part), out.copies, quoted(out.why));
}

std::string layout_json(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts) {
  std::string items, grid;
  for (const packing::Placed& item : layout.items) {
    items += (items.empty() ? "\n" : ",\n") + item_json(problem, item);
    if (!packing::is_quarter(item.angle))
      grid = fmt::format("\"grid\": \"{}\", ", packing::Fraction(1, problem.steps()).text());
  }
  return fmt::format(
      "{{\"findspace\": 1, \"layout\": {{\n"
      "  \"instance\": {}, \"container\": {}, \"gap\": \"{}\", \"edge\": \"{}\", \"length\": "
      "\"{}\", \"density\": {:.6f}, "
      "\"lower_bound\": \"{}\", \"proven\": {}, {}{}\n"
      "  \"seed\": {}, \"threads\": {}, \"seconds\": {:.2f},\n  \"items\": [{}],\n  \"left_out\": {}}}}}\n",
      quoted(problem.name), container_json(problem, layout), problem.gap.text(), problem.edge.text(),
      layout.length.text(), facts.density, facts.lower_bound.text(), facts.proven, grid, remnant_json(facts.remnant),
      facts.seed, facts.threads, facts.seconds, items, left_out_json(problem.parts, layout.left_out));
}

std::string outline_path(const packing::Problem& problem, std::size_t part) {
  packing::Placed item;
  item.part = part;
  return downward_path(outlines_of(problem, item));
}

std::string sheet_path(const packing::Problem& problem, std::size_t sheet) {
  return downward_path(outlines_of(problem.sheets[sheet], problem.steps()));
}

std::string zones_path(const packing::Problem& problem, std::size_t sheet) {
  return downward_path(zones_of(problem, problem.sheets[sheet]));
}

std::string layout_svg(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts) {
  const std::vector<Page> pages = pages_of(problem, layout);
  double width = 0, high = 0, down = 0;
  for (const Page& page : pages) {
    width = std::max(width, page.width);
    high = std::max(high, page.height);
  }
  const double room = 0.06 * high;
  std::string body;
  for (std::size_t k = 0; k < pages.size(); ++k) {
    const Page& page = pages[k];
    body +=
        fmt::format("<g id=\"sheet-{}\" transform=\"translate(0,{:.9g}) scale(1,-1)\">\n", k + 1, down + page.height);
    body += fmt::format("<path d=\"{}\" fill=\"#f6f6f2\"/>\n", path_of(page.outline));
    if (!page.zones.empty())
      body += fmt::format("<path d=\"{}\" fill=\"#e8c7a8\" stroke=\"none\"/>\n", path_of(page.zones));
    for (const packing::Placed& item : layout.items) {
      if (item.sheet != k) continue;
      const double hue = 360.0 * double(item.part) / double(problem.parts.size());
      body += fmt::format("<path d=\"{}\" fill=\"hsl({:.0f},45%,78%)\"><title>{}</title></path>\n",
                          path_of(outlines_of(problem, item)), hue,
                          xml_escaped(problem.parts[item.part].name + " #" + std::to_string(item.copy)));
    }
    body += "</g>\n";
    down += page.height + 1.5 * room;
    if (!page.title.empty())
      body += fmt::format("<text x=\"0\" y=\"{:.9g}\" font-size=\"{:.6g}\" stroke=\"none\">{}</text>\n",
                          down - 0.5 * room, 0.5 * room, xml_escaped(page.title));
  }
  const std::string what = problem.on_sheets() ? fmt::format("{} sheet{}, {} of the last", pages.size(),
                                                             pages.size() == 1 ? "" : "s", layout.length.text())
                                               : "length " + layout.length.text();
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.9g} {:.9g} {:.9g} {:.9g}\" font-family=\"sans-serif\">\n"
      "<g stroke=\"#333\" stroke-width=\"{:.6g}\" stroke-linejoin=\"round\" fill-rule=\"evenodd\">\n{}</g>\n"
      "<text x=\"0\" y=\"{:.9g}\" font-size=\"{:.6g}\">{}, density {:.3f} %, {} parts</text>\n</svg>\n",
      -room, -room, width + 2 * room, down + 1.5 * room, high / 600, body, down, 0.5 * room, what, 100 * facts.density,
      layout.items.size());
}

std::string layout_dxf(const packing::Problem& problem, const packing::Layout& layout, DxfVersion version) {
  const std::array<std::string, 2> layers{"sheet", "cut"};
  DxfWriter dxf(version, std::nullopt, layers);
  double down = 0;
  const auto add = [&](const std::string& layer, const Outlines& outlines) {
    for (std::vector<DrawnCorner> ring : outlines) {
      for (DrawnCorner& c : ring) c.y -= down;
      dxf.polyline(layer, ring, true);
    }
  };
  const std::vector<Page> pages = pages_of(problem, layout);
  for (std::size_t k = 0; k < pages.size(); ++k) {
    add("sheet", pages[k].outline);
    for (const packing::Placed& item : layout.items)
      if (item.sheet == k) add("cut", outlines_of(problem, item));
    if (k + 1 < pages.size()) down += 1.1 * pages[k + 1].height;
  }
  return dxf.take();
}

}  // namespace findspace::io
