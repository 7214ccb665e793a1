// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of boards (io/board, apps/in_plane). Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

/// In hundredths of a millimetre: one nanometre, KiCad's unit, in which sizes were rounded before. Decides: a body's
/// box is widened to hundredths, and one that is less than this beyond a hundredth stays there.
inline constexpr double kBodyBox = 1e-4;

/// In millimetres: two steps of a board's grid. The points of a part at an angle are rounded to the grid, each by less
/// than a step, so that bodies drawn side by side may overlap by two. Decides: the rules that hold without --where, and
/// are printed, let them.
inline constexpr double kTurnedBodies = 2e-6;

}  // namespace findspace::margin
