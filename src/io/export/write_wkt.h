// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions as well-known text: faces as POLYGON, or CURVEPOLYGON with CIRCULARSTRINGs where arcs bound them, dangling
// curves as LINESTRING or CIRCULARSTRING, isolated points as POINT; several as GEOMETRYCOLLECTION. WKT means closed
// sets: which ends are open, cracks and punctures are lost. Arcs stay arcs, given by three points. Source: OGC
// 06-103r4; ISO/IEC 13249-3 (SQL/MM) for arcs. Keywords: well-known text, simple features.
#pragma once

#include <string>

#include "plane/complex/cell_complex.h"

namespace findspace::io {

struct WktText {
  std::string text;  // one line
  std::string lost;  // what the text does not say of the region, for people; empty if nothing
};

/// Throws Error(kUnsupported) for an unbounded region.
WktText region_wkt(const plane::Region& region, const exact::Real& step);

}  // namespace findspace::io
