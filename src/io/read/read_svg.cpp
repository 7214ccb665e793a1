// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// SVG drawings: path, polygon, polyline, line, rect, circle, ellipse, use, in groups, with transforms and styles. SVG's
// y axis points down: a shape is read so that it stands as the picture shows it, (x, y) of the drawing becoming (x,
// -y). The drawing has a unit when its width or height has one (mm cm in pt pc Q; px and none count as no unit). Each
// element is the area it encloses (even-odd). Elements without a fill are outlines: where one lies in another, all of
// them nest. Or all elements nest, or none, where that is asked. What is open is joined over all elements, where ends
// meet or the gap is allowed. Layers are Inkscape's, groups by id, and colours. Clip-paths, masks, texts and images are
// left out with a note.
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

std::string_view local_name(const pugi::xml_node& node) { return svg_local_name(node.name()); }

/// An attribute of another namespace, which programs call differently.
pugi::xml_attribute foreign(const pugi::xml_node& node, const std::string& prefix, std::string_view name) {
  if (const pugi::xml_attribute usual = node.attribute((prefix + ':').append(name).c_str())) return usual;
  for (const pugi::xml_attribute& one : node.attributes()) {
    const std::string_view own = one.name();
    if (own.find(':') != std::string_view::npos && svg_local_name(own) == name) return one;
  }
  return {};
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
    walk_children(root, Affine::scaling(1, -1), inside_root(root), 0);
    add_elements();
    add_pooled();
    check_found();
    std::string left_out;
    for (const auto& [element, count] : left_out_) {
      const char* hint = element == "text" ? "; an editor turns text into paths" : "";
      context_.notes.push_back(fmt::format("{}: {} <{}> left out{}", name_, count, element, hint));
      left_out += fmt::format("; {} <{}> left out{}", count, element, hint);
    }
    if (parts_.empty()) throw Error(ErrorCode::kGeometry, "there is no shape in it" + left_out, name_);
    for (const auto& [element, count] : empty_)
      context_.notes.push_back(fmt::format("{}: {} <{}> of no size left out", name_, count, element));
    note_what_is_not_followed();
    return chosen(std::move(parts_), name_, choice_);
  }

 private:
  /// Whether what is met lies in the chosen element and layer, or in a part that is not drawn.
  struct Inside {
    bool id, layer, undrawn;
    std::uint64_t operations = 0;  // of the transforms on the way to it
    SvgLook look{};                // of the group around it
    SvgFrame frame{};              // of the view around it
    bool cut = false;              // by a clip-path or a mask
    std::string not_followed{};    // a property that would move it
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

  Inside inside_root(const pugi::xml_node& root) const try {
    Inside whole{!choice_.id, !choice_.layer, false};
    whole.look = styles_.look(root, {});
    whole.frame = svg_frame(root);
    whole.undrawn = whole.look.hidden;
    see_cut(whole);
    const std::string_view moved = root.attribute("transform").value();
    if (whole.look.transform ? !whole.look.transform->empty() : !moved.empty() && moved != "none")
      throw Error(ErrorCode::kUnsupported, "a transform of the whole drawing; one of a group in it is read");
    return whole;
  } catch (const Error& e) {
    throw e.within(place(root));
  }

  void walk_children(const pugi::xml_node& parent, const Affine& map, const Inside& inside, int depth) {
    if (depth > kMostGroupDepth) throw Error(ErrorCode::kUnsupported, "groups nested too deeply", name_);
    const bool chooses = local_name(parent) == "switch";  // the first that may be drawn
    bool found = false;
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      Inside own = inside;
      own.undrawn = own.undrawn || found;
      walk(node, node, map, std::move(own), depth);
      found = chooses && (found || is_choice(node));
    }
  }

  /// Drawn by programs of some kind, or for readers of some language.
  static bool is_conditional(const pugi::xml_node& node) {
    return node.attribute("requiredExtensions") || node.attribute("systemLanguage");
  }

  /// What a <switch> may choose: no title, style or element of another kind.
  static bool is_choice(const pugi::xml_node& node) {
    return one_of(local_name(node), {"g", "a", "svg", "switch", "use", "path", "polygon", "polyline", "line", "rect",
                                     "circle", "ellipse", "text", "flowRoot", "image", "foreignObject"}) &&
           !is_conditional(node);
  }

  static void see_cut(Inside& inside) {
    const SvgLook& look = inside.look;
    inside.cut = inside.cut || look.clipped || look.masked;
    if (!look.not_followed.empty()) inside.not_followed = look.not_followed;
  }

  /// The look of an element; what a style says of its size stands in its attributes from here on.
  void see_look(pugi::xml_node node, Inside& inside, int depth) const {
    context_.work.charge(styles_.comparisons(std::size_t(depth)) / kComparisonsAUnit,
                         "so many elements and rules of style");
    inside.look = styles_.look(node, inside.look);
    see_cut(inside);
    const std::string_view kind = local_name(node);
    for (const auto& [property, stated] : inside.look.size) {
      const bool of_a_view = property == "width" || property == "height" || (kind != "use" && property != "d");
      if (of_a_view && one_of(kind, {"svg", "symbol", "use"})) inside.not_followed = property;  // programs differ
      std::string_view value = stated;
      if (property == "d") value = svg_path_of_style(value);
      pugi::xml_attribute to = node.attribute(property.c_str());
      if (!to) to = node.append_attribute(property.c_str());
      to.set_value(std::string(value).c_str());
    }
  }

  /// `user`: the <use> that draws it, or itself.
  void walk(const pugi::xml_node& node, const pugi::xml_node& user, const Affine& map, Inside inside, int depth) {
    std::string_view kind = local_name(node);
    std::string id = node.attribute("id").value();
    if (!id.empty()) ids_.insert(id);
    inside.id = inside.id || (choice_.id && id == *choice_.id);
    see_look(node, inside, depth);
    see_condition(node, inside);
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
      Affine own = !inside.undrawn || choice_.id ? within(map, node, inside) : map;
      if (kind == "svg" && (!inside.undrawn || choice_.id)) own = own * enter_view(node, user, inside);
      if (group) return walk_children(node, own, inside, depth + 1);
      if (is_drawn(inside)) {
        charge(node, inside.operations);
        draw(node, own, inside);
      }
    } catch (const Error& e) {
      if (e.place().find(name_) != std::string::npos) throw;
      throw e.within(place(node));
    }
  }

  bool is_drawn(const Inside& inside) const {
    const bool asked = choice_.id && inside.id;
    return inside.id && inside.layer && !inside.undrawn && (asked || !inside.look.invisible);
  }

  void see_condition(const pugi::xml_node& node, Inside& inside) {
    if (inside.undrawn || !is_conditional(node)) return;
    inside.undrawn = true;
    if (node.attribute("systemLanguage")) ++for_a_language_;
  }

  /// The map around an element with its own transform, by an attribute or a style, about its origin.
  Affine within(const Affine& map, const pugi::xml_node& node, Inside& inside) {
    const SvgLook& look = inside.look;
    const std::string_view attribute = node.attribute("transform").value();
    const std::string_view stated = look.transform ? std::string_view(*look.transform) : attribute;
    if (stated.empty() || stated == "none") return map;
    const Affine own = look.transform ? read_svg_style_transform(stated, inside.operations, context_.work)
                                      : read_svg_transform(stated, inside.operations, context_.work);
    if (own.is_translation()) return map * own;  // the same about any origin
    if (!look.box.empty() && look.box != "view-box") inside.not_followed = "transform-box";
    if (look.origin.empty() || !inside.not_followed.empty()) return map * own;
    const plane::CurvePoint origin = read_svg_origin(look.origin, inside.frame);
    ++inside.operations;
    return map * Affine::translation(origin.x, origin.y) * own * Affine::translation(-origin.x, -origin.y);
  }

  /// The map of a nested <svg> or a <symbol>.
  static Affine enter_view(const pugi::xml_node& node, const pugi::xml_node& user, Inside& inside) {
    SvgView view = svg_view(node, user, inside.frame);
    inside.frame = std::move(view.frame);
    inside.operations += 2;
    inside.undrawn = inside.undrawn || view.empty;
    return view.map;
  }

  void see_layer(const pugi::xml_node& node, const std::string& id, Inside& inside) {
    std::string label = foreign(node, "inkscape", "label").value();
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
    if (is_drawn(inside) && one_of(kind, {"text", "flowRoot", "image", "foreignObject"}))
      ++left_out_[std::string(kind)];
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
    if (!link) link = foreign(node, "xlink", "href");
    const std::string_view target = link.value();
    const auto found = target.starts_with("#") ? by_id_.find(target.substr(1)) : by_id_.end();
    if (found == by_id_.end())
      throw Error(ErrorCode::kUnknownName, fmt::format("<use> of '{}', which is not in the drawing", target),
                  place(node));
    if (depth >= kMostUseDepth)
      throw Error(ErrorCode::kUnsupported, "<use> nested too deeply, or of what it stands in", place(node));
    context_.work.charge(kUse, "an element that is used so often");
    try {
      const Real x = svg_length(node, "x", 0, inside.frame), y = svg_length(node, "y", 0, inside.frame);
      const Affine own = within(map, node, inside) * Affine::translation(x, y);
      const pugi::xml_node drawn = found->second;
      if (local_name(drawn) != "symbol") return walk(drawn, node, own, inside, depth + 1);
      see_look(drawn, inside, depth);
      const Affine view = enter_view(drawn, node, inside);
      walk_children(drawn, own * view, inside, depth + 1);
    } catch (const Error& e) {
      if (e.place().find(name_) != std::string::npos) throw;
      throw e.within(place(node));
    }
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
    const std::string id = node.attribute("id").value(), label = foreign(node, "inkscape", "label").value();
    Outline outline(context_, scale_);
    outline.set_name(part_name(id, label, inside));
    draw_svg_element(node, local_name(node), map, inside.frame, outline);
    Drawing drawing = outline.take();
    std::erase_if(drawing.chains, is_point);
    if (!is_empty(drawing) && !inside.not_followed.empty())
      throw Error(ErrorCode::kUnsupported,
                  fmt::format("the property \"{}\" of a style is not read here", inside.not_followed));
    if (inside.cut && !is_empty(drawing)) ++cut_;
    const bool filled = inside.look.fill != "none";
    if (filled && !inside.look.even_odd && !encloses_alike(drawing, context_)) ++by_even_odd_;
    if (is_empty(drawing))
      ++empty_[std::string(local_name(node))];
    else
      elements_.push_back({std::move(drawing), id, place(node), filled});
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

  void note_what_is_not_followed() const {
    const auto several = [](std::size_t count, const char* one, const char* more) {
      return fmt::format("{} {}", count, count == 1 ? one : more);
    };
    if (cut_ > 0)
      context_.notes.push_back(fmt::format("{}: {} a clip-path or a mask, read whole", name_,
                                           several(cut_, "element has", "elements have")));
    if (by_even_odd_ > 0)
      context_.notes.push_back(fmt::format(
          "{}: {} holes that run the same way as the outline around, which programs fill (fill-rule nonzero)", name_,
          several(by_even_odd_, "element has", "elements have")));
    if (for_a_language_ > 0)
      context_.notes.push_back(fmt::format("{}: {} for readers of one language left out", name_,
                                           several(for_a_language_, "element", "elements")));
    if (styles_.unread() > 0)
      context_.notes.push_back(fmt::format("{}: {} of <style> not read, the first of '{}'", name_,
                                           several(styles_.unread(), "rule", "rules"), styles_.first_unread()));
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
  static constexpr std::size_t kComparisonsAUnit = 10;

  Real scale_;
  SvgStyles styles_{pugi::xml_node()};
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;
  std::string colour_;  // of the layer that is chosen
  std::vector<Element> elements_;
  Drawing pool_;  // open outlines, or all
  std::vector<ShapePtr> parts_;
  std::set<std::string> ids_, layers_;
  std::map<std::string, int> left_out_, empty_;  // elements of each kind
  std::size_t cut_ = 0, by_even_odd_ = 0, for_a_language_ = 0;
};

}  // namespace

ShapePtr read_svg(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  return SvgReader(text, name, choice, context).read();
}

}  // namespace findspace::io
