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

/// A length attribute in user units, 96 to the inch; `missing` where it is absent. Throws Error for percentages.
exact::Real svg_length(const pugi::xml_node& node, const char* name, const exact::Real& missing);
/// `translate scale rotate matrix skewX skewY`, in any sequence.
/// The transform that an attribute states. `operations` counts those on the way from the root: numbers grow with each,
/// so each costs as many units as the square of how many there are.
Affine read_svg_transform(std::string_view text, std::uint64_t& operations, plane::WorkBudget& work);
/// How many millimetres one user unit of the drawing is, if its width or height states a unit.
std::optional<exact::Real> svg_millimetres(const pugi::xml_node& root);
/// The map of a `viewBox` into the width and height of `frame`, by `preserveAspectRatio`.
Affine svg_view(const pugi::xml_node& node, const pugi::xml_node& frame);
/// Draws a path, polygon, polyline, line, rect, circle or ellipse: nothing where its path or points are empty, or its
/// width, height or radius is 0.
void draw_svg_element(const pugi::xml_node& node, std::string_view kind, const Affine& map, Outline& outline);

}  // namespace findspace::io
