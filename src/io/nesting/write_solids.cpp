// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/write_solids.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_surface.h"
#include "io/draw/draw_view.h"

namespace findspace::io {
namespace {

std::string quoted_name(const std::string& text) { return nlohmann::json(text).dump(); }

/// Nothing where it turns nothing.
std::string rotation_json(const packing::AxisRotation& r) {
  if (r == packing::kAsGiven) return "";
  std::string rows;
  for (const auto& row : r) rows += fmt::format("{}[{}, {}, {}]", rows.empty() ? "" : ", ", row[0], row[1], row[2]);
  return fmt::format("\"rotation\": [{}], ", rows);
}

std::array<double, 3> placed(const packing::SolidPlaced& item, const space::Point& p, double steps) {
  return {item.at[0].to_double() + double(p.x) / steps, item.at[1].to_double() + double(p.y) / steps,
          item.at[2].to_double() + double(p.z) / steps};
}

/// Adds its surface, or its convex parts.
void add_item(const packing::SolidProblem& problem, const packing::SolidPlaced& item, Surface& surface) {
  const packing::SolidForm& form = form_of(problem, item);
  const std::string label = fmt::format("{}#{}", problem.parts[item.part].name, item.copy);
  const auto add = [&](const auto& points, double steps) {
    const int first = int(surface.vertices.size());
    for (const space::Point& p : points) surface.vertices.push_back(placed(item, p, steps));
    return first;
  };
  const auto add_face = [&](std::vector<int> face, int first) {
    for (int& v : face) v += first;
    surface.faces.push_back(std::move(face));
    surface.labels.push_back(label);
  };
  for (const space::RaySolid& solid : form.surface) {
    const int first = add(solid.surface.points, double(problem.steps()));
    for (const auto& face : solid.surface.faces) add_face({face[0], face[1], face[2]}, first);
  }
  if (!form.surface.empty()) return;
  for (const space::BodyPart& piece : form.body.parts) {
    const int first = add(piece.core->vertices(), double(problem.steps()) * double(form.body.scale));
    for (int f = 0; f < piece.core->facet_count(); ++f) add_face(piece.core->circuit(f), first);
  }
}

constexpr std::array<std::array<int, 3>, 8> kItemColours{{{143, 176, 214},
                                                          {222, 170, 130},
                                                          {150, 196, 150},
                                                          {206, 150, 178},
                                                          {214, 200, 130},
                                                          {160, 160, 206},
                                                          {130, 196, 196},
                                                          {190, 178, 166}}};

/// Lines of the picture from the back to the front.
class LayoutPicture {
 public:
  LayoutPicture(const packing::SolidProblem& problem, const packing::SolidLayout& layout)
      : problem_(problem), layout_(layout) {
    const double w = problem.width.to_double(), d = problem.depth.to_double(), h = layout.height.to_double();
    for (int k = 0; k < 8; ++k) corners_.push_back({k & 1 ? w : 0, k & 2 ? d : 0, k & 4 ? h : 0});
    for (const auto& p : corners_) {
      low_[0] = std::min(low_[0], dot(p, kRight));
      high_[0] = std::max(high_[0], dot(p, kRight));
      low_[1] = std::min(low_[1], dot(p, kUp));
      high_[1] = std::max(high_[1], dot(p, kUp));
    }
    scale_ = kViewSize / std::max(high_[0] - low_[0], high_[1] - low_[1]);
  }

  std::string svg(const std::string& title) const {
    constexpr double kMargin = 24, kTitle = 30;
    const double width = scale_ * (high_[0] - low_[0]) + 2 * kMargin;
    const double height = scale_ * (high_[1] - low_[1]) + 2 * kMargin + kTitle;
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:.1f} {:.1f} {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\">\n<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        "<text x=\"0\" y=\"-8\" font-size=\"15\">{}</text>\n<g stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
        -kMargin, -kMargin - kTitle, width, height, -kMargin, -kMargin - kTitle, xml_escaped(title));
    constexpr std::array<std::array<int, 2>, 9> kBehind{
        {{0, 1}, {0, 2}, {0, 4}, {1, 3}, {2, 3}, {1, 5}, {2, 6}, {4, 5}, {4, 6}}};
    constexpr std::array<std::array<int, 2>, 3> kFront{{{3, 7}, {5, 7}, {6, 7}}};
    for (const auto& edge : kBehind) text += line(edge, "#999");
    text += items();
    for (const auto& edge : kFront) text += line(edge, "#999");
    return text + "</g>\n</svg>\n";
  }

 private:
  std::string at(const std::array<double, 3>& p) const {
    return fmt::format("{:.2f},{:.2f}", scale_ * (dot(p, kRight) - low_[0]), scale_ * (high_[1] - dot(p, kUp)));
  }
  std::string line(const std::array<int, 2>& edge, const char* colour) const {
    return fmt::format("<path d=\"M{} {}\" stroke=\"{}\" fill=\"none\" stroke-width=\"1\"/>\n",
                       at(corners_[std::size_t(edge[0])]), at(corners_[std::size_t(edge[1])]), colour);
  }

  /// Faces of all items at once, so that they are laid by their depth.
  std::string items() const {
    const Surface surface = layout_surface(problem_, layout_);
    std::vector<std::size_t> colour_of_vertex(surface.vertices.size());
    std::size_t face = 0;
    for (const packing::SolidPlaced& item : layout_.items) {
      const std::string label = fmt::format("{}#{}", problem_.parts[item.part].name, item.copy);
      for (; face < surface.faces.size() && surface.labels[face] == label; ++face)
        for (const int v : surface.faces[face]) colour_of_vertex[std::size_t(v)] = item.part % kItemColours.size();
    }
    std::string text;
    for (const SeenFace& seen : seen_surface(surface.vertices, surface.faces).faces) {
      std::string ring;
      for (const int v : seen.ring) ring += (ring.empty() ? "M" : " ") + at(surface.vertices[std::size_t(v)]);
      const std::string fill = shaded(kItemColours[colour_of_vertex[std::size_t(seen.ring[0])]], seen.light);
      text += fmt::format("<path d=\"{}z\" fill=\"{}\" stroke=\"{}\" stroke-width=\"0.4\"/>\n", ring, fill, fill);
      for (const Edge3& e : seen.edges)
        text += fmt::format("<path d=\"M{} {}\" stroke=\"#333\" stroke-width=\"0.8\"/>\n",
                            at(surface.vertices[std::size_t(e[0])]), at(surface.vertices[std::size_t(e[1])]));
    }
    return text;
  }

  const packing::SolidProblem& problem_;
  const packing::SolidLayout& layout_;
  std::vector<std::array<double, 3>> corners_;
  std::array<double, 2> low_{}, high_{};
  double scale_ = 1;
};

}  // namespace

std::string layout_json(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                        const LayoutFacts& facts) {
  std::string items;
  for (const packing::SolidPlaced& item : layout.items)
    items += fmt::format("{}    {{\"part\": {}, \"copy\": {}, {}\"at\": [\"{}\", \"{}\", \"{}\"]}}",
                         items.empty() ? "\n" : ",\n", quoted_name(problem.parts[item.part].name), item.copy,
                         rotation_json(form_of(problem, item).rotation), item.at[0].text(), item.at[1].text(),
                         item.at[2].text());
  return fmt::format(
      "{{\"findspace\": 1, \"layout\": {{\n"
      "  \"instance\": {}, \"container\": {{\"size-x\": \"{}\", \"size-y\": \"{}\"}}, \"gap\": \"{}\", \"edge\": "
      "\"{}\", "
      "\"height\": \"{}\", \"density\": {:.6f}, \"lower_bound\": \"{}\", \"proven\": {},\n"
      "  \"seed\": {}, \"threads\": {}, \"seconds\": {:.2f},\n  \"items\": [{}]}}}}\n",
      quoted_name(problem.name), problem.width.text(), problem.depth.text(), problem.gap.text(), problem.edge.text(),
      layout.height.text(), facts.density, facts.lower_bound.text(), facts.proven, facts.seed, facts.threads,
      facts.seconds, items);
}

Surface layout_surface(const packing::SolidProblem& problem, const packing::SolidLayout& layout) {
  Surface surface;
  for (const packing::SolidPlaced& item : layout.items) add_item(problem, item, surface);
  return surface;
}

std::string layout_svg(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                       const LayoutFacts& facts) {
  return LayoutPicture(problem, layout)
      .svg(fmt::format("height {}, density {:.3f} %, {} parts", layout.height.text(), 100 * facts.density,
                       layout.items.size()));
}

std::string item_name(const packing::SolidProblem& problem, const packing::SolidLayout& layout, std::size_t item) {
  return fmt::format("{}#{}", problem.parts[layout.items[item].part].name, layout.items[item].copy);
}

std::string fault_text(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                       const packing::SolidFault& fault) {
  using Kind = packing::SolidFault::Kind;
  if (fault.kind == Kind::kCount)
    return fmt::format("{} {} copies of {}", std::abs(fault.depth), fault.depth > 0 ? "extra" : "missing",
                       problem.parts[fault.first].name);
  const std::string where = fmt::format(" near ({:.6g}, {:.6g}, {:.6g})", fault.at[0], fault.at[1], fault.at[2]);
  const std::string first = item_name(problem, layout, fault.first);
  if (fault.kind == Kind::kOutside) return fmt::format("{} is outside by {:.6g}", first, fault.depth) + where;
  const std::string second = item_name(problem, layout, fault.second);
  if (fault.kind == Kind::kGap) return fmt::format("{} and {} are nearer than the gap", first, second) + where;
  return fmt::format("{} and {} overlap, depth {:.6g}", first, second, fault.depth) + where;
}

}  // namespace findspace::io
