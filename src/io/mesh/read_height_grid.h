// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Height fields (space/mesh/height_field.h) from ASCII grids (.asc). A head of words and numbers states ncols, nrows,
// xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy), and NODATA_value, which is -9999 unless
// stated. Heights follow, rows from the greatest y down. Each is that of the middle of its cell: xllcorner is half a
// cell before the first column. Numbers are read as the decimals they are. Cost: linear in the text. Keywords: Esri
// ASCII raster, Arc/Info ASCII grid, digital elevation model.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/text/read_context.h"
#include "space/polytope/solid.h"

namespace findspace::io {

inline constexpr std::string_view kHeightGridEnding = ".asc";

/// `scale`: the file's unit in the scene's; `floor` is in the scene's. Counts the work. Throws Error: kSyntax with the
/// line, kFile where heights are missing, kGeometry.
space::Solid read_height_grid(const std::string& bytes, const exact::Real& scale, const exact::Real& floor,
                              ReadContext& context);

/// What a square of a height field costs beside the text of its height.
inline constexpr std::uint64_t kHeightFieldSquare = 4;

}  // namespace findspace::io
