// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/write_solids.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_surface.h"
#include "io/draw/draw_view.h"
#include "io/nesting/container_edges.h"

namespace findspace::io {
namespace {

std::string quoted_name(const std::string& text) { return nlohmann::json(text).dump(); }

/// Nothing where it turns nothing.
std::string rotation_json(const packing::SolidRotation& r) {
  if (r == packing::as_given()) return "";
  const auto entry = [](const packing::Fraction& f) {
    return f.denominator() == 1 ? f.text() : fmt::format("\"{}\"", f.text());
  };
  std::string rows;
  for (const auto& row : r)
    rows += fmt::format("{}[{}, {}, {}]", rows.empty() ? "" : ", ", entry(row[0]), entry(row[1]), entry(row[2]));
  return fmt::format("\"rotation\": [{}], ", rows);
}

std::string container_json(const packing::SolidProblem& problem, const packing::SolidLayout& layout) {
  if (!problem.in_containers())
    return fmt::format("{{\"size-x\": \"{}\", \"size-y\": \"{}\"}}", problem.width.text(), problem.depth.text());
  std::string names;
  for (const std::size_t kind : layout.containers)
    names += (names.empty() ? "" : ", ") + quoted_name(problem.containers[kind].name);
  return fmt::format("{{\"containers\": [{}]}}", names);
}

/// A container of the layout as it is drawn: they stand side by side along x.
struct DrawnContainer {
  double x = 0;
  std::vector<DrawnEdge> edges;
};

std::vector<DrawnContainer> drawn_containers(const packing::SolidProblem& problem, const packing::SolidLayout& layout) {
  constexpr double kBetween = 0.15;  // of the width
  if (!problem.in_containers())
    return {{0, edges_of_box(0, {problem.width.to_double(), problem.depth.to_double(), layout.height.to_double()})}};
  std::vector<DrawnContainer> result;
  double x = 0;
  for (const std::size_t kind : layout.containers) {
    const packing::SolidContainer& c = problem.containers[kind];
    result.push_back({x, edges_of_container(x, problem, c)});
    x += (1 + kBetween) * c.width.to_double();
  }
  return result;
}

/// Meridians and circles of latitude of the inscribed polyhedron that stands for a ball.
constexpr int kMeridians = 32, kCircles = 15;

void add_ball(const std::array<double, 3>& center, double radius, Surface& surface) {
  const int first = int(surface.vertices.size());
  const auto add = [&](double across, double up, double angle) {
    surface.vertices.push_back({center[0] + radius * across * std::cos(angle),
                                center[1] + radius * across * std::sin(angle), center[2] + radius * up});
  };
  add(0, -1, 0);
  add(0, 1, 0);
  for (int c = 1; c <= kCircles; ++c) {
    const double latitude = std::numbers::pi * (c / double(kCircles + 1) - 0.5);
    for (int m = 0; m < kMeridians; ++m)
      add(std::cos(latitude), std::sin(latitude), 2 * std::numbers::pi * m / kMeridians);
  }
  const auto at = [&](int circle, int m) { return first + 2 + (circle - 1) * kMeridians + m % kMeridians; };
  for (int m = 0; m < kMeridians; ++m) {
    surface.faces.push_back({first, at(1, m + 1), at(1, m)});
    surface.faces.push_back({first + 1, at(kCircles, m), at(kCircles, m + 1)});
    for (int c = 1; c < kCircles; ++c)
      surface.faces.push_back({at(c, m), at(c, m + 1), at(c + 1, m + 1), at(c + 1, m)});
  }
}

/// The surface of a form, or its convex parts.
Surface surface_of(const packing::SolidProblem& problem, const packing::SolidForm& form) {
  Surface surface;
  const auto scaled = [](const space::Point& p, double steps) {
    return std::array<double, 3>{double(p.x) / steps, double(p.y) / steps, double(p.z) / steps};
  };
  const auto add = [&](const auto& points, double steps) {
    const int first = int(surface.vertices.size());
    for (const space::Point& p : points) surface.vertices.push_back(scaled(p, steps));
    return first;
  };
  const auto add_face = [&](std::vector<int> face, int first) {
    for (int& v : face) v += first;
    surface.faces.push_back(std::move(face));
  };
  for (const space::RaySolid& solid : form.surface) {
    const int first = add(solid.surface.points, double(problem.steps()) * double(form.surface_scale));
    for (const auto& face : solid.surface.faces) add_face({face[0], face[1], face[2]}, first);
  }
  if (!form.surface.empty()) return surface;
  const double steps = double(problem.steps()) * double(form.body.scale);
  for (const space::BodyPart& piece : form.body.parts) {
    if (!piece.core) {
      add_ball(scaled(piece.center, steps), piece.radius.to_double() / steps, surface);
      continue;
    }
    const int first = add(piece.core->vertices(), steps);
    for (int f = 0; f < piece.core->facet_count(); ++f) add_face(piece.core->circuit(f), first);
  }
  return surface;
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
    for (DrawnContainer& c : drawn_containers(problem, layout))
      edges_.insert(edges_.end(), c.edges.begin(), c.edges.end());
    for (const DrawnEdge& e : edges_)
      for (const Point3d& p : {e.from, e.to}) {
        low_[0] = std::min(low_[0], dot(p, kRight));
        high_[0] = std::max(high_[0], dot(p, kRight));
        low_[1] = std::min(low_[1], dot(p, kUp));
        high_[1] = std::max(high_[1], dot(p, kUp));
      }
    if (!edges_.empty()) scale_ = kViewSize / std::max(high_[0] - low_[0], high_[1] - low_[1]);
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
    text += lines(false) + items() + lines(true);
    return text + "</g>\n</svg>\n";
  }

 private:
  std::string at(const std::array<double, 3>& p) const {
    return fmt::format("{:.2f},{:.2f}", scale_ * (dot(p, kRight) - low_[0]), scale_ * (high_[1] - dot(p, kUp)));
  }
  std::string lines(bool in_front) const {
    std::string text;
    for (const DrawnEdge& e : edges_)
      if (e.is_in_front == in_front)
        text += fmt::format("<path d=\"M{} {}\" stroke=\"#999\" fill=\"none\" stroke-width=\"1\"/>\n", at(e.from),
                            at(e.to));
    return text;
  }

  /// Faces of all items at once, so that they are laid by their depth.
  std::string items() const {
    const Surface surface = united(layout_assembly(problem_, layout_));
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
  std::vector<DrawnEdge> edges_;  // of containers
  std::array<double, 2> low_{}, high_{};
  double scale_ = 1;
};

}  // namespace

std::string layout_json(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                        const LayoutFacts& facts) {
  std::string items;
  for (const packing::SolidPlaced& item : layout.items)
    items += fmt::format("{}    {{\"part\": {}, \"copy\": {}, {}{}\"at\": [\"{}\", \"{}\", \"{}\"]}}",
                         items.empty() ? "\n" : ",\n", quoted_name(problem.parts[item.part].name), item.copy,
                         problem.in_containers() ? fmt::format("\"container\": {}, ", item.container) : "",
                         rotation_json(form_of(problem, item).rotation), item.at[0].text(), item.at[1].text(),
                         item.at[2].text());
  return fmt::format(
      "{{\"findspace\": 1, \"layout\": {{\n"
      "  \"instance\": {}, \"container\": {}, \"gap\": \"{}\", \"edge\": "
      "\"{}\", "
      "\"height\": \"{}\", \"density\": {:.6f}, \"lower_bound\": \"{}\", \"proven\": {},\n"
      "  \"seed\": {}, \"threads\": {}, \"seconds\": {:.2f},\n  \"items\": [{}],\n  \"left_out\": {}}}}}\n",
      quoted_name(problem.name), container_json(problem, layout), problem.gap.text(), problem.edge.text(),
      layout.height.text(), facts.density, facts.lower_bound.text(), facts.proven, facts.seed, facts.threads,
      facts.seconds, items, left_out_json(problem.parts, layout.left_out));
}

Surface part_surface(const packing::SolidProblem& problem, std::size_t part) {
  const packing::SolidForm& form = problem.parts[part].forms[0];
  Surface surface = surface_of(problem, form);
  if (form.rotation == packing::as_given()) return surface;
  for (auto& vertex : surface.vertices) {
    std::array<double, 3> back{};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) back[c] += form.rotation[r][c].to_double() * vertex[r];
    vertex = back;
  }
  return surface;
}

Surface container_surface(const packing::SolidProblem& problem, std::size_t kind) {
  const packing::SolidContainer& c = problem.containers[kind];
  if (c.inside) return surface_of(problem, *c.inside);
  Surface box;
  for (int k = 0; k < 8; ++k)
    box.vertices.push_back({(k & 1) != 0 ? c.width.to_double() : 0, (k & 2) != 0 ? c.depth.to_double() : 0,
                            (k & 4) != 0 ? c.height.to_double() : 0});
  box.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return box;
}

Assembly layout_assembly(const packing::SolidProblem& problem, const packing::SolidLayout& layout) {
  Assembly result;
  const std::vector<DrawnContainer> containers = drawn_containers(problem, layout);
  for (const packing::SolidPart& part : problem.parts) {
    const packing::SolidForm& form = part.forms[0];
    result.kinds.push_back({part.name, surface_of(problem, form)});
  }
  for (std::size_t i = 0; i < layout.items.size(); ++i) {
    const packing::SolidPlaced& item = layout.items[i];
    Assembly::Copy& copy = result.copies.emplace_back();
    copy.kind = item.part;
    copy.name = item_name(problem, layout, i);
    const packing::SolidRotation of_first = problem.parts[item.part].forms[0].rotation,
                                 of_item = form_of(problem, item).rotation;
    // The kind is drawn in its first form: back from that, then on to the item's.
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) {
        copy.rotation[r][c] = 0;
        for (std::size_t k = 0; k < 3; ++k)
          copy.rotation[r][c] += of_item[r][k].to_double() * of_first[c][k].to_double();
      }
    for (std::size_t k = 0; k < 3; ++k) copy.at[k] = item.at[k].to_double();
    copy.at[0] += containers[item.container].x;
  }
  return result;
}

std::string layout_svg(const packing::SolidProblem& problem, const packing::SolidLayout& layout,
                       const LayoutFacts& facts) {
  return LayoutPicture(problem, layout)
      .svg(fmt::format("{}, density {:.3f} %, {} parts",
                       problem.in_containers()
                           ? fmt::format("{} container{}, {} of the last", layout.containers.size(),
                                         layout.containers.size() == 1 ? "" : "s", layout.height.text())
                           : "height " + layout.height.text(),
                       100 * facts.density, layout.items.size()));
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
  if (fault.kind == Kind::kContainers)
    return fmt::format("container {}: {} too many", problem.containers[fault.first].name, fault.depth);
  const std::string place = fmt::format("({:.6g}, {:.6g}, {:.6g})", fault.at[0], fault.at[1], fault.at[2]);
  if (fault.kind == Kind::kFixed)
    return fmt::format("a fixed {} does not stand at {}", problem.parts[fault.first].name, place);
  const std::string where = " near " + place;
  const std::string first = item_name(problem, layout, fault.first);
  // Where edges alone cross, and of surfaces, no depth is measured.
  const auto by = [&](const char* words) { return fault.depth > 0 ? fmt::format("{}{:.6g}", words, fault.depth) : ""; };
  if (fault.kind == Kind::kOutside) return first + " is outside" + by(" by ") + where;
  const std::string second = item_name(problem, layout, fault.second);
  if (fault.kind == Kind::kGap) return fmt::format("{} and {} are nearer than the gap", first, second) + where;
  if (fault.kind == Kind::kCondition)
    return fmt::format("a condition of {} and {} does not hold", first, second) + where;
  return first + " and " + second + " overlap" + by(", depth ") + where;
}

}  // namespace findspace::io
