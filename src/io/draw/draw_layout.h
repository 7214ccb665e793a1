// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sizes in a picture: the frame that shows given bounds, round lengths for ticks and the scale bar, how long a text is.
// Keywords: axis ticks, nice numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/draw/draw_canvas.h"

namespace findspace::io {

inline constexpr double kMapWidth = 880, kMapHeight = 620;  // pixels, at most
inline constexpr double kFontSize = 12.5;

/// Grows to hold `added`, or becomes it.
void include(std::optional<plane::Bounds>& bounds, const plane::Bounds& added);

/// The frame for these bounds with a margin of `margin` times its size; its upper left corner at (left, top).
Frame fit(const plane::Bounds& bounds, double margin, double left, double top);

/// The greatest of 1, 2, 5 times a power of ten that is at most `about`.
double round_length(double about);

/// Multiples of `spacing` in [low, high].
std::vector<double> ticks(double low, double high, double spacing);

/// How wide a text is in pixels, about, in a common sans-serif face.
double text_width(std::string_view text, double font_size = kFontSize);

/// About where a text stands whose middle is there.
plane::Bounds text_box(const plane::Place& middle, std::string_view text, double font_size);
bool boxes_meet(const plane::Bounds& a, const plane::Bounds& b);

/// The text in lines of at most `width` pixels, broken at blanks.
std::vector<std::string> wrapped(std::string_view text, double width, double font_size = kFontSize);

/// A number for people: six digits, more only in large whole ones.
std::string shown(double value);

}  // namespace findspace::io
