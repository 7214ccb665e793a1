// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions as files that machines cut: DXF, a layer a region, and GeoJSON. In DXF faces are closed polylines whose arcs
// are bulges, whole circles are CIRCLE, free curves open polylines, single points POINT, in the scene's unit
// ($INSUNITS). Both know closed sets only. Guarantee: where
// corners and centres are on the grid the file reads back as the same set; other corners are rounded to the nearest
// double. Source: AutoCAD DXF reference; RFC 7946. Keywords: export, laser cutting, CNC.
#pragma once

#include <optional>
#include <span>

#include "io/export/dxf_writer.h"
#include "io/write/write_svg.h"

namespace findspace::io {

/// Throws Error(kUnsupported) for an unbounded region.
DrawingText shapes_dxf(std::span<const NamedRegion> regions, const exact::Real& step, std::optional<formula::Unit> unit,
                       DxfVersion version = DxfVersion::kR12);

/// A feature a region, with its name. Throws Error(kUnsupported) for an unbounded region and for arcs, which GeoJSON
/// does not know.
DrawingText shapes_geojson(std::span<const NamedRegion> regions, const exact::Real& step);

}  // namespace findspace::io
