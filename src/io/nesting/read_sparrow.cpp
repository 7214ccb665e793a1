// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <string_view>

#include "io/nesting/read_nesting.h"
#include "io/nesting/unscaled_problem.h"

namespace findspace::io {
namespace {

using packing::Fraction;

/// The decimals of a text, whatever stands between them.
std::vector<Fraction> numbers(std::string_view text) {
  constexpr std::string_view kBegin = "+-.0123456789", kOf = "+-.0123456789eE";
  std::vector<Fraction> result;
  for (std::size_t at = text.find_first_of(kBegin); at != std::string_view::npos; at = text.find_first_of(kBegin, at)) {
    const std::size_t end = std::min(text.find_first_not_of(kOf, at), text.size());
    result.push_back(Fraction::parse(text.substr(at, end - at)));
    at = end;
  }
  return result;
}

/// "M0,0 L1,0 L1,1 z": closed polygons, all points absolute.
std::vector<UnscaledRing> rings_of(std::string_view path, const std::string& name) {
  std::vector<UnscaledRing> result;
  if (path.find_first_not_of("MLZz+-.,0123456789eE \n\t") != std::string_view::npos)
    throw Error(ErrorCode::kSyntax, "a path has more than M, L and z", name);
  for (std::size_t at = path.find('M'); at != std::string_view::npos;) {
    const std::size_t next = path.find('M', at + 1);
    std::string coordinates(path.substr(at + 1, next == std::string_view::npos ? next : next - at - 1));
    for (char& c : coordinates)
      if (c == 'L' || c == 'z' || c == 'Z') c = ' ';
    const std::vector<Fraction> values = numbers(coordinates);
    if (values.size() % 2 != 0) throw Error(ErrorCode::kSyntax, "a path has an odd number of coordinates", name);
    UnscaledRing& ring = result.emplace_back();
    for (std::size_t i = 0; i < values.size(); i += 2) ring.push_back({values[i], values[i + 1]});
    at = next;
  }
  return result;
}

pugi::xml_node child_with_id(const pugi::xml_node& node, const char* id, const std::string& name) {
  const pugi::xml_node found = node.find_child_by_attribute("id", id);
  if (!found) throw Error(ErrorCode::kSyntax, fmt::format("no element '{}': not a layout of sparrow", id), name);
  return found;
}

packing::Placed placed(const std::string& transform, std::size_t part, const std::string& name) {
  const std::size_t turn = transform.find("rotate(");
  const std::vector<Fraction> at = numbers(std::string_view(transform).substr(0, turn));
  const std::size_t begins = transform.find("translate(");
  if (begins != 0 || at.size() != 3 - 1) throw Error(ErrorCode::kSyntax, "a transform is not translate, rotate", name);
  packing::Placed item;
  item.part = part;
  item.x = at[0];
  item.y = at[1];
  if (turn == std::string::npos) return item;
  const std::vector<Fraction> angle = numbers(std::string_view(transform).substr(turn));
  if (angle.size() != 1) throw Error(ErrorCode::kSyntax, "a rotation is not one angle", name);
  item.angle = angle[0];
  return item;
}

}  // namespace

ProblemAndLayout read_sparrow_svg(const std::string& text, const std::string& name) {
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size())) throw Error(ErrorCode::kSyntax, "not an SVG file", name);
  const pugi::xml_node svg = document.child("svg");
  const pugi::xml_node older = svg.find_child_by_attribute("id", "bin_0");
  const pugi::xml_node container = older ? older : child_with_id(svg, "container_0", name);
  const auto strip = rings_of(container.child("path").attribute("d").as_string(), name);
  if (strip.size() != 1 || strip[0].size() != 4) throw Error(ErrorCode::kSyntax, "the strip is not a rectangle", name);
  const pugi::xml_node items = child_with_id(svg, "items", name);
  UnscaledProblem problem;
  problem.height = strip[0][2].second;
  std::map<std::string, std::size_t> parts;
  for (const pugi::xml_node& group : items.child("defs").children("g")) {
    parts.emplace(group.attribute("id").as_string(), problem.parts.size());
    const std::string id = group.attribute("id").as_string();
    problem.parts.push_back(
        {id.substr(id.find('_') + 1), 0, rings_of(group.child("path").attribute("d").as_string(), name), {}});
  }
  packing::Layout layout;
  layout.length = strip[0][2].first;
  for (const pugi::xml_node& use : items.children("use")) {
    const pugi::xml_attribute plain = use.attribute("href"), href = plain ? plain : use.attribute("xlink:href");
    const std::string target = href.as_string();
    const auto found = target.starts_with('#') ? parts.find(target.substr(1)) : parts.end();
    if (found == parts.end()) continue;  // outlines of another simplification
    layout.items.push_back(placed(use.attribute("transform").as_string(), found->second, name));
    UnscaledPart& part = problem.parts[found->second];
    layout.items.back().copy = ++part.demand;
    const Fraction& angle = layout.items.back().angle;
    if (std::find(part.angles.begin(), part.angles.end(), angle) == part.angles.end()) part.angles.push_back(angle);
  }
  return {std::move(problem).on_grid(name), std::move(layout)};
}

}  // namespace findspace::io
