// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Single entities of DXF as outlines. Used by read_dxf.cpp. Source: AutoCAD DXF reference (2012).
#pragma once

#include "io/read/read_dxf_groups.h"
#include "io/text/read_transform.h"

namespace findspace::io {

/// Draws LINE, CIRCLE, ARC, ELLIPSE, SPLINE, POINT, LWPOLYLINE, POLYLINE, SOLID or TRACE; false where it is none of
/// these. Throws Error(kUnsupported) for what would change the set if it were left out.
bool draw_dxf_entity(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline);

/// The loops of a HATCH.
void draw_dxf_hatch(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline);

/// The map of an entity that is seen from behind (extrusion direction 0, 0, -1), which mirrors it; throws
/// Error(kUnsupported) for other planes than those.
Affine dxf_plane(const DxfDocument& document, const DxfEntity& entity);

/// Whether some height of it is not 0: its own, that of an end or corner, or of a vertex.
bool is_raised(const DxfDocument& document, const DxfEntity& entity);

/// Whether it is a polyline that is wider than a line, somewhere.
bool has_width(const DxfDocument& document, const DxfEntity& entity);

}  // namespace findspace::io
