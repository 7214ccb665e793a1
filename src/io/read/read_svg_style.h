// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The colours of SVG elements and whether they are drawn: attributes, `style`, and rules of <style> for elements,
// classes and ids (one compound selector each; others are passed over). Colours serve as layers. Used by read_svg.cpp.
// Source: SVG 1.1, chapter 6; CSS 2.1. Keywords: stroke, fill, cascade.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::io {

/// "#rrggbb" in small letters where the text names a colour so, by rgb(..) or by one of the usual names, else the text.
std::string svg_colour(std::string_view text);

struct SvgLook {
  std::string stroke, fill;  // as svg_colour gives them; empty where nothing was said
  bool hidden = false;

  /// The colour that stands for a layer: of the stroke, or where there is none of the fill.
  const std::string& colour() const { return stroke.empty() || stroke == "none" ? fill : stroke; }
};

class SvgStyles {
 public:
  explicit SvgStyles(const pugi::xml_node& root);
  /// The look of an element in a group that looks like `outer`.
  SvgLook look(const pugi::xml_node& node, const SvgLook& outer) const;
  /// Rules that are tried for each element.
  std::size_t rules() const { return rules_.size(); }

 private:
  struct Rule {
    std::string element, id;
    std::vector<std::string> classes;
    std::string declarations;
    bool of(const pugi::xml_node& node) const;
  };

  void collect(const pugi::xml_node& node, int depth);
  void parse(std::string text);
  void add(std::string_view selector, const std::string& declarations);

  std::vector<Rule> rules_;
};

}  // namespace findspace::io
