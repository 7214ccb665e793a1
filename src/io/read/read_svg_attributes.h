// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Single elements of SVG and their attributes. Used by read_svg.cpp only.
#pragma once

#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "io/text/read_outline.h"
#include "io/text/read_transform.h"

namespace findspace::io {

/// The width and height of which percentages are parts, in user units; none where they depend on the page.
struct SvgFrame {
  std::optional<exact::Real> width, height;
};

/// Where an element draws: its frame, and the map from its coordinates to those around it.
struct SvgView {
  Affine map;
  SvgFrame frame;
  bool empty = false;  // of no width or height: nothing is drawn
};

/// A length attribute in user units, 96 to the inch; `missing` where it is absent. Throws Error for what depends on the
/// page.
exact::Real svg_length(const pugi::xml_node& node, const char* name, const exact::Real& missing, const SvgFrame& frame);
/// `translate scale rotate matrix skewX skewY`, in any sequence.
/// The transform that an attribute states. `operations` counts those on the way from the root: numbers grow with each,
/// so each costs as many units as the square of how many there are.
Affine read_svg_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work);
/// The same of a style: lengths and angles have units there.
Affine read_svg_style_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work);
/// The place that `transform-origin` states, in small letters.
plane::CurvePoint read_svg_origin(std::string_view text, const SvgFrame& frame);
/// How many millimetres one user unit of the drawing is, if its width or height states a unit.
std::optional<exact::Real> svg_millimetres(const pugi::xml_node& root);
/// The frame of the outermost <svg>.
SvgFrame svg_frame(const pugi::xml_node& root);
/// The view of a nested <svg> or a <symbol>, by its `viewBox` and `preserveAspectRatio`; `user`: the <use> that draws
/// it, or itself.
SvgView svg_view(const pugi::xml_node& node, const pugi::xml_node& user, const SvgFrame& around);
/// Draws a path, polygon, polyline, line, rect, circle or ellipse: nothing where its path or points are empty, or its
/// width, height or radius is 0.
void draw_svg_element(const pugi::xml_node& node, std::string_view kind, const Affine& map, const SvgFrame& frame,
                      Outline& outline);

}  // namespace findspace::io
