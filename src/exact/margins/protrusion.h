// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The margins of how far a body protrudes from a solid that others are cut out of (set_protrusion.h), of the diameter
// of such a solid, and of how far a body protrudes on lines (protrusion_rays.h).
#pragma once

namespace findspace::margin {

/// Of the sizes: how near value and bound come. Along the edge of what is cut out so many places are nearly as near as
/// each other that telling them apart takes the inverse of its square root in cells: 2^8. Bounds: what is left between
/// value and bound is said as the error, and decides nothing.
inline constexpr double kProtrudesTo = 0x1p-16;

/// Of the sizes: features this near to where a cut ends are looked at, though the cut is less far from the body. At
/// level 0 cuts are nearly 0, and no feature would be so near. Searches: a place is tested.
inline constexpr double kEndWindow = 0x1p-6;

}  // namespace findspace::margin
