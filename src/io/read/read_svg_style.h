// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How SVG elements look, and whether and where they are drawn: attributes, `style`, and the rules of <style> by their
// specificity, for elements, classes and ids, in others (`g .cut`, `g > path`). Rules with other selectors are counted
// where they state something that is read. Colours serve as layers. Used by read_svg.cpp.
// Source: SVG 2, chapter 6; CSS 2.1, chapters 5 and 6. Keywords: stroke, fill, cascade.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::io {

/// "#rrggbb" in small letters where the text names a colour so, by rgb(..) or by one of the usual names, else the text.
std::string svg_colour(std::string_view text);

/// The name of an element or attribute without its namespace.
std::string_view svg_local_name(std::string_view name);

/// Of the property `d`: the path in path("..."), nothing of `none`.
std::string_view svg_path_of_style(std::string_view value);

struct SvgLook {
  std::string stroke, fill;  // as svg_colour gives them; empty where nothing was said
  bool invisible = false;    // by `visibility`
  bool even_odd = false;     // by `fill-rule`

  // What follows is said of the element itself; what is in it does not inherit it.
  bool hidden = false;  // by `display`
  bool clipped = false, masked = false;
  std::optional<std::string> transform{};     // where a style states it
  std::string origin{}, box{};                // transform-origin and transform-box
  std::string not_followed{};                 // a property that would move it
  std::map<std::string, std::string> size{};  // x, width, r, d and others, where a style states them

  /// The colour that stands for a layer: of the stroke, or where there is none of the fill.
  const std::string& colour() const { return stroke.empty() || stroke == "none" ? fill : stroke; }
};

class SvgStyles {
 public:
  explicit SvgStyles(const pugi::xml_node& root);
  /// The look of an element in a group that looks like `outer`.
  SvgLook look(const pugi::xml_node& node, const SvgLook& outer) const;
  /// How often parts of rules are compared for an element that lies so deep.
  std::size_t comparisons(std::size_t depth) const { return single_ + nested_ * (1 + depth); }
  /// Rules that state something but whose selector is not read, and the first of these selectors.
  std::size_t unread() const { return unread_; }
  const std::string& first_unread() const { return first_unread_; }

 private:
  /// What is said of one element of a selector.
  struct Compound {
    std::string element{}, id{};
    std::vector<std::string> classes{};
    bool child = false;  // of the one before, not anywhere in it
    bool of(const pugi::xml_node& node) const;
  };
  struct Rule {
    std::vector<Compound> path;
    std::array<std::size_t, 3> specificity{};             // ids, classes, elements
    std::map<std::string, std::string> usual, important;  // what it declares, by the property
    bool of(const pugi::xml_node& node) const;
    pugi::xml_node top_of(std::size_t begin, std::size_t end, pugi::xml_node node) const;
  };
  enum class Reach { kKnown, kUnknown, kNone };

  void collect(const pugi::xml_node& node, int depth);
  void parse(std::string_view text, bool known, int depth);
  void add(std::string_view selector, std::string_view declarations, bool known);
  static Reach read_selector(std::string_view text, std::vector<Compound>& path);

  std::vector<Rule> rules_;  // the weakest first
  std::size_t single_ = 0, nested_ = 0, unread_ = 0;
  std::string first_unread_;
  bool important_ = false;  // some rule
};

}  // namespace findspace::io
