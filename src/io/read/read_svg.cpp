// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SVG drawings: path, polygon, polyline, line, rect, circle, ellipse, use, in groups, with transforms. SVG's y axis
// points down: a shape is read so that it stands as the picture shows it, (x, y) of the drawing becoming (x, -y).
// The drawing has a unit when its width or height has one (mm cm in pt pc Q; px and none count as no unit). Each
// element is the area it encloses (even-odd). Elements without a fill are outlines: where one lies in another, all of
// them nest. Or all elements nest, or none, where that is asked. What is open is joined over all elements, where ends
// meet or the gap is allowed. Layers are Inkscape's, groups by id, and colours.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <new>
#include <pugixml.hpp>
#include <set>

#include "findspace/error.h"
#include "io/read/read_file.h"
#include "io/read/read_svg_attributes.h"
#include "io/read/read_svg_style.h"
#include "io/text/outline_shapes.h"
#include "io/text/quantity.h"
#include "io/text/read_transform.h"
#include "io/text/scene_reader.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;

constexpr int kMostGroupDepth = 200;

std::string_view local_name(const pugi::xml_node& node) {
  std::string_view name = node.name();
  std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context)
      : text_(text), places_(text, name), name_(name), choice_(choice), context_(context) {}

  ShapePtr read() {
    pugi::xml_document document;
    pugi::xml_parse_result result = document.load_buffer(text_.data(), text_.size());
    if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
    if (!result) {
      throw Error(ErrorCode::kSyntax, fmt::format("this is not proper XML: {}", result.description()),
                  places_.at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))));
    }
    pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg") throw Error(ErrorCode::kSyntax, "its first element is not <svg>", name_);
    scale_ = file_scale(stated_unit(root), name_, choice_, context_);
    styles_ = SvgStyles(root);
    find_ids(root, 0);
    if (choice_.layer) colour_ = svg_colour(*choice_.layer);
    Inside whole{!choice_.id, !choice_.layer, false};
    whole.look = styles_.look(root, {});
    walk_children(root, Affine::scaling(1, -1), whole, 0);
    add_elements();
    add_pooled();
    check_found();
    for (const auto& [element, count] : left_out_) {
      const char* hint = element == "text" ? "; an editor turns text into paths" : "";
      context_.notes.push_back(fmt::format("{}: {} <{}> left out{}", name_, count, element, hint));
    }
    for (const auto& [element, count] : empty_)
      context_.notes.push_back(fmt::format("{}: {} <{}> of no size left out", name_, count, element));
    return chosen(std::move(parts_), name_, choice_);
  }

 private:
  /// Whether what is met lies in the chosen element and layer, or in a part that is not drawn.
  struct Inside {
    bool id, layer, undrawn;
    std::uint64_t operations = 0;  // of the transforms on the way to it
    SvgLook look{};                // of the group around it
    std::string name{};            // of the nearest group whose name says how many
  };

  /// What an element draws.
  struct Element {
    Drawing drawing;
    std::string id, place;
    bool filled;
  };

  std::string place(const pugi::xml_node& node) const {
    std::string_view id = node.attribute("id").value();
    std::string words =
        id.empty() ? fmt::format("<{}>", local_name(node)) : fmt::format("<{} id='{}'>", local_name(node), id);
    std::ptrdiff_t offset = node.offset_debug();
    return offset < 0 ? fmt::format("{}: {}", name_, words)
                      : fmt::format("{} ({})", words, places_.at(static_cast<std::size_t>(offset)));
  }

  std::optional<Real> stated_unit(const pugi::xml_node& root) const {
    if (choice_.unit) return std::nullopt;
    try {
      return svg_millimetres(root);
    } catch (const Error& e) {
      throw e.within(place(root));
    }
  }

  void walk_children(const pugi::xml_node& parent, const Affine& map, Inside inside, int depth) {
    if (depth > kMostGroupDepth) throw Error(ErrorCode::kUnsupported, "groups nested too deeply", name_);
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() == pugi::node_element) walk(node, map, inside, depth);
    }
  }

  void walk(const pugi::xml_node& node, const Affine& map, Inside inside, int depth) {
    std::string_view kind = local_name(node);
    std::string id = node.attribute("id").value();
    if (!id.empty()) ids_.insert(id);
    inside.id = inside.id || (choice_.id && id == *choice_.id);
    context_.work.charge(styles_.rules() / kRulesAUnit, "so many elements and rules of style");
    inside.look = styles_.look(node, inside.look);
    inside.undrawn = (inside.undrawn || inside.look.hidden ||
                      one_of(kind, {"defs", "symbol", "clipPath", "mask", "marker", "pattern"})) &&
                     !(choice_.id && inside.id);
    bool group = one_of(kind, {"g", "a", "svg", "switch", "defs", "symbol", "clipPath", "mask", "marker", "pattern"});
    bool leaf = one_of(kind, {"path", "polygon", "polyline", "line", "rect", "circle", "ellipse"});
    if (group) see_layer(node, id, inside);
    if (kind == "use") return use(node, map, inside, depth);
    if (!group && !leaf) return skip(kind, inside);
    if (leaf) see_colour(inside);
    try {
      Affine own = map * read_svg_transform(node.attribute("transform").value(), inside.operations, context_.work);
      if (kind == "svg") own = own * nested_view(node, node);
      if (group) return walk_children(node, own, inside, depth + 1);
      if (inside.id && inside.layer && !inside.undrawn) {
        charge(node, inside.operations);
        draw(node, own, inside);
      }
    } catch (const Error& e) {
      if (group || e.place().find(name_) != std::string::npos) throw;
      throw e.within(place(node));
    }
  }

  void see_layer(const pugi::xml_node& node, const std::string& id, Inside& inside) {
    std::string label = node.attribute("inkscape:label").value();
    for (const std::string& name : {label, id}) {
      if (!name.empty()) layers_.insert(name);
      if (quantity_in(name)) inside.name = name;
    }
    if (choice_.layer && (label == *choice_.layer || id == *choice_.layer)) inside.layer = true;
  }

  void see_colour(Inside& inside) {
    const std::string& colour = inside.look.colour();
    if (colour.empty() || colour == "none") return;
    layers_.insert(colour);
    if (choice_.layer && colour == colour_) inside.layer = true;
  }

  /// Elements that draw what is not read must not vanish unnoticed.
  void skip(std::string_view kind, const Inside& inside) {
    const bool drawn = inside.id && inside.layer && !inside.undrawn;
    if (drawn && one_of(kind, {"text", "image", "foreignObject"})) ++left_out_[std::string(kind)];
  }

  void find_ids(const pugi::xml_node& node, int depth) {
    if (depth > kMostGroupDepth) throw Error(ErrorCode::kUnsupported, "groups nested too deeply", name_);
    if (const pugi::xml_attribute id = node.attribute("id")) by_id_.emplace(id.value(), node);
    for (const pugi::xml_node& child : node.children()) find_ids(child, depth + 1);
  }

  /// What it refers to, in its place.
  void use(const pugi::xml_node& node, const Affine& map, Inside inside, int depth) {
    if (inside.undrawn) return;
    pugi::xml_attribute link = node.attribute("href");
    if (!link) link = node.attribute("xlink:href");
    const std::string_view target = link.value();
    const auto found = target.starts_with("#") ? by_id_.find(target.substr(1)) : by_id_.end();
    if (found == by_id_.end())
      throw Error(ErrorCode::kUnknownName, fmt::format("<use> of '{}', which is not in the drawing", target),
                  place(node));
    if (depth >= kMostUseDepth)
      throw Error(ErrorCode::kUnsupported, "<use> nested too deeply, or of what it stands in", place(node));
    context_.work.charge(kUse, "an element that is used so often");
    Affine own = map * read_svg_transform(node.attribute("transform").value(), inside.operations, context_.work) *
                 Affine::translation(svg_length(node, "x", 0), svg_length(node, "y", 0));
    if (local_name(found->second) != "symbol") return walk(found->second, own, inside, depth + 1);
    inside.look = styles_.look(found->second, inside.look);
    walk_children(found->second, own * nested_view(found->second, node), inside, depth + 1);
  }

  /// The view of a nested <svg> or a <symbol>: `frame` has its width and height.
  Affine nested_view(const pugi::xml_node& node, const pugi::xml_node& frame) const {
    Affine origin;
    if (local_name(node) == "svg") origin = Affine::translation(svg_length(node, "x", 0), svg_length(node, "y", 0));
    if (!node.attribute("viewBox")) return origin;
    return origin * svg_view(node, frame);
  }

  /// Many transforms make long numbers, and every point of the element costs as much as they are long.
  void charge(const pugi::xml_node& node, std::uint64_t operations) {
    constexpr std::uint64_t kUsual = 8, kPoint = 8;  // operations, and letters
    if (operations <= kUsual) return;
    for (const char* name : {"d", "points"}) {
      const std::string_view text = node.attribute(name).value();
      context_.work.charge(operations * text.size() / kPoint, "an element under so many transforms");
    }
  }

  void draw(const pugi::xml_node& node, const Affine& map, const Inside& inside) {
    const std::string id = node.attribute("id").value(), label = node.attribute("inkscape:label").value();
    Outline outline(context_, scale_);
    outline.set_name(part_name(id, label, inside));
    draw_svg_element(node, local_name(node), map, outline);
    Drawing drawing = outline.take();
    if (is_empty(drawing))
      ++empty_[std::string(local_name(node))];
    else
      elements_.push_back({std::move(drawing), id, place(node), inside.look.fill != "none"});
  }

  /// The label or the id, or the name of a group where that says how many.
  static std::string part_name(const std::string& id, const std::string& label, const Inside& inside) {
    for (const std::string* name : {&label, &id, &inside.name})
      if (quantity_in(*name)) return *name;
    return label.empty() ? id : label;
  }

  void add_elements() {
    const bool stated = context_.drawing.parts.has_value() || nests(choice_, context_) || choice_.index;
    const bool nested = !stated && add_nested_outlines();
    for (Element& element : elements_) {
      if (nested && !element.filled) continue;
      if (nests(choice_, context_)) {
        append(pool_, element.drawing);
      } else {
        add(std::move(element));
      }
    }
  }

  /// The outlines of elements without a fill, where one lies in another and none cross.
  bool add_nested_outlines() {
    std::vector<Drawing> outlines;
    for (const Element& element : elements_)
      if (!element.filled) outlines.push_back(element.drawing);
    if (outlines.size() < 2 || !any_within_another(outlines, context_)) return false;
    Drawing all;
    for (const Drawing& outline : outlines) append(all, outline);
    ReadContext after = context_;
    try {
      std::vector<ShapePtr> nested = closed_parts(std::move(all), after, name_);
      std::move(nested.begin(), nested.end(), std::back_inserter(parts_));
    } catch (const Error& crossing) {
      if (crossing.code() != ErrorCode::kGeometry) throw;
      context_.notes.push_back(fmt::format(
          "{}: outlines without a fill cross or are open, so each is the area that it encloses (\"parts\": \"one\": "
          "those within others are holes)",
          name_));
      return false;
    }
    context_ = std::move(after);
    context_.notes.push_back(fmt::format(
        "{}: outlines without a fill that lie in others are holes (\"parts\": \"elements\": areas)", name_));
    return true;
  }

  static bool is_empty(const Drawing& drawing) { return drawing.chains.empty() && drawing.discs.empty(); }

  void add(Element element) try {
    Drawing& drawing = element.drawing;
    if (!context_.drawing.open_lines || context_.drawing.join > 0) {
      for (Chain& chain : drawing.chains)
        if (!chain.closed) pool_.chains.push_back(std::move(chain));
      std::erase_if(drawing.chains, [](const Chain& c) { return c.edges.empty(); });
      if (is_empty(drawing)) return;
    }
    Shape shape = *shape_of(std::move(drawing), context_, element.place);
    shape.name = element.id;
    parts_.push_back(std::make_shared<const Shape>(std::move(shape)));
  } catch (const Error& e) {
    if (e.place().find(name_) != std::string::npos) throw;
    throw e.within(element.place);
  }

  /// Open outlines of all elements, joined; or all outlines, nested.
  void add_pooled() {
    if (pool_.chains.empty() && pool_.discs.empty()) return;
    for (ShapePtr& part : closed_parts(std::move(pool_), context_, name_)) parts_.push_back(std::move(part));
  }

  void check_found() const {
    if (!parts_.empty()) return;
    auto refuse = [&](const char* key, const std::string& wanted, const std::set<std::string>& known) {
      std::string hint = choice(key + std::string("s"), wanted, {known.begin(), known.end()});
      throw Error(ErrorCode::kUnknownName, fmt::format("there is no {} '{}' with a shape in it{}", key, wanted, hint),
                  name_);
    };
    if (choice_.id) refuse("id", *choice_.id, ids_);
    if (choice_.layer) refuse("layer", *choice_.layer, layers_);
  }

  std::string_view text_;
  TextPlaces places_;
  const std::string& name_;
  const FileChoice& choice_;
  ReadContext& context_;
  static constexpr int kMostUseDepth = 40;
  static constexpr std::uint64_t kUse = 10;  // units of work
  static constexpr std::size_t kRulesAUnit = 10;

  Real scale_;
  SvgStyles styles_{pugi::xml_node()};
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;
  std::string colour_;  // of the layer that is chosen
  std::vector<Element> elements_;
  Drawing pool_;  // open outlines, or all
  std::vector<ShapePtr> parts_;
  std::set<std::string> ids_, layers_;
  std::map<std::string, int> left_out_, empty_;  // elements of each kind
};

}  // namespace

ShapePtr read_svg(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  return SvgReader(text, name, choice, context).read();
}

}  // namespace findspace::io
