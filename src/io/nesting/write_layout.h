// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Layouts as files: JSON with exact numbers, which read_layout reads back, and a drawing as the strip is cut.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "packing/proof/remnant.h"

namespace findspace::io {

struct LayoutFacts {
  double density = 0, seconds = 0;
  packing::Fraction lower_bound;
  bool proven = false;
  std::optional<packing::Remnant> remnant = {};
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

std::string layout_json(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts);
/// A page a sheet, one below the other.
std::string layout_svg(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts);
/// A part as SVG path data about its origin, y downwards.
std::string outline_path(const packing::Problem& problem, std::size_t part);
/// Outlines on the layers "cut" and "sheet", arcs as bulges; coordinates are rounded to twelve digits.
std::string layout_dxf(const packing::Problem& problem, const packing::Layout& layout);

}  // namespace findspace::io
