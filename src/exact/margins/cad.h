// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of solids from CAD files (cad). Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

/// In millimetres. A corner and the surface at its parameters are each the result of at most eight operations of
/// doubles on numbers below 10^4 mm, off by 8 * 10^4 * 2^-53 < 10^-11 each; larger solids fail the test and get the
/// bound of all directions. Decides: along the axis of a cylinder or cone a triangle that is off by less has no error.
/// What that leaves out is a ten-thousandth of the usual grid's step, 10^-6 mm, to which the corners are rounded
/// afterwards.
inline constexpr double kCornerAlongAxis = 1e-10;

/// Of the greatest coordinate or radius of a solid. Files write ten digits or more, and an assembly's placements add
/// some roundings of doubles. Decides: a solid whose faces are so close to the boundary of a hull of balls is read as
/// that hull, and differs from the file's solid by no more.
inline constexpr double kRoundedSolid = 1e-9;

}  // namespace findspace::margin
