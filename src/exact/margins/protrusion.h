// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The margin of how far a body protrudes from a solid that others are cut out of (set_protrusion.h), and of the
// diameter of such a solid.
#pragma once

namespace findspace::margin {

/// Of the sizes: how near value and bound come. Along the edge of what is cut out so many places are nearly as near as
/// each other that telling them apart takes the inverse of its square root in cells: 2^8. Bounds: what is left between
/// value and bound is said as the error, and decides nothing.
inline constexpr double kProtrudesTo = 0x1p-16;

}  // namespace findspace::margin
