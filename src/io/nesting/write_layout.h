// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Layouts as files: JSON with exact numbers, which read_layout reads back, and a drawing as the strip is cut.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/export/dxf_writer.h"
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

/// A line of a layout.
std::string left_out_json(const std::string& part, const packing::LeftOut& out);
/// A list of what is left out.
template <class Part>
std::string left_out_json(const std::vector<Part>& parts, const std::vector<packing::LeftOut>& left_out) {
  std::string text;
  for (const packing::LeftOut& out : left_out)
    text += (text.empty() ? "" : ",") + left_out_json(parts[out.part].name, out);
  return "[" + text + "]";
}

std::string layout_json(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts);
/// A page a sheet, one below the other.
std::string layout_svg(const packing::Problem& problem, const packing::Layout& layout, const LayoutFacts& facts);
/// A part as SVG path data about its origin, y downwards.
std::string outline_path(const packing::Problem& problem, std::size_t part);
/// A kind of sheet, and all zones on it, in the same way.
std::string sheet_path(const packing::Problem& problem, std::size_t sheet);
std::string zones_path(const packing::Problem& problem, std::size_t sheet);
/// Outlines on the layers "cut" and "sheet", arcs as bulges.
std::string layout_dxf(const packing::Problem& problem, const packing::Layout& layout, DxfVersion version);

}  // namespace findspace::io
