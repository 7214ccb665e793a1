// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a drawing or an Error: SVG, GeoJSON, DXF (binary too) or WKT, decided apart by the first byte. Their
// number says on which side arcs lie, and whether gaps are closed and lines kept.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "findspace/error.h"
#include "io/read/read_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace findspace;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  io::ReadContext context;
  context.options.files = false;
  context.unit = io::Unit::kMillimetre;
  char first = text.empty() ? ' ' : text[0];
  context.drawing.curves = static_cast<findspace::CurveRule>(size % 3);
  if (size % 5 == 0) context.drawing.join = 1000000;
  context.drawing.open_lines = size % 7 < 4;
  const bool binary = text.starts_with("AutoCAD");
  auto reader = first == '<'                             ? io::read_svg
                : first == '{'                           ? io::read_geojson
                : first == ' ' || first == '0' || binary ? io::read_dxf
                                                         : io::read_wkt;
  try {
    plane::ShapePtr shape = reader(text, "fuzz", {}, context);
    if (!shape) std::abort();
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
  return 0;
}
