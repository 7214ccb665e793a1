// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands around the map: title, ticks, scale bar, and a legend that names only what is to be seen.
#pragma once

#include <string>
#include <vector>

#include "io/draw/draw_canvas.h"

namespace findspace::io {

struct LegendEntry {
  enum class Mark {
    kFace,
    kClosed,
    kOpen,
    kFree,
    kPoint,
    kFull,
    kHollow,
    kFixed,
    kBehind,
    kCopper,
    kMoving,
    kPole,
    kAround,
    kArrow,
    kDimension,
    kFails,
    kNearest
  };
  Mark mark = Mark::kFace;
  std::string text;
  std::string style{};  // of kCopper and kMoving: its class
};

/// A block of the picture and its height in pixels.
struct Block {
  std::string svg;
  double height = 0;
};

Block title_block(std::string_view title, std::string_view subtitle, double left, double top, double width);
/// The frame's border with ticks and their numbers, left of it and below.
std::string axes(const Frame& frame);
/// The scale bar with its length; `left`, `top`: where the block begins.
Block scale_bar(const Frame& frame, std::string_view unit, double left, double top);
Block legend(const std::vector<LegendEntry>& entries, double left, double top, double width);

/// The classes that all parts of a picture use; those of a circuit board where a picture shows one.
std::string style_sheet(bool board = false);

}  // namespace findspace::io
