// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a drawing or an Error: SVG, GeoJSON, DXF or WKT, decided apart by the first byte.
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
  auto reader = first == '<'                   ? io::read_svg
                : first == '{'                 ? io::read_geojson
                : first == ' ' || first == '0' ? io::read_dxf
                                               : io::read_wkt;
  try {
    plane::ShapePtr shape = reader(text, "fuzz", {}, context);
    if (!shape) std::abort();
  } catch (const Error& error) {
    if (error.message().empty()) std::abort();
  }
  return 0;
}
