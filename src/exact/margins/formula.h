// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the layer `formula`, by street. Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

// -- planar

/// Of the sizes of the values and of the shapes: a value at a position that differs by more from the level is on its
/// side; it is right to far less. Filters: nearer ones are looked up in the exact sign map.
inline constexpr double kClearOfLevel = 0x1p-34;
/// Of the level and one: the rounding of the level, and 2^3 times that for the bounds that it is compared with. Bounds:
/// a range of values within it of the level has no sign, and the question is refused.
inline constexpr double kRangeAtLevel = 0x1p-50;
/// Of the least value and one: 2^13 roundings above it. Bounds: positions with such a value are possible best ones.
inline constexpr double kAboveLeast = 0x1p-40;
/// Of the boxes that are compared: 2^13 roundings, where some four are made. Bounds: a shape is left out only where it
/// is out of reach by more.
inline constexpr double kOutOfReach = 0x1p-40;
/// Of a leg of a motion: a piece of time this short is not halved. Bounds: it stays between the certain and the
/// possible instants.
inline constexpr double kNarrowestTime = 0x1p-40;
/// Degrees: a search of the best position ends this near to it. Searches: the bound is stated.
inline constexpr double kBestDegrees = 1e-7;
/// Of the size: the same for lengths. Searches.
inline constexpr double kBestPart = 1e-9;
/// Of a value over angles, absolute or of the value and one: some 2^23 roundings, more than values of rotated shapes
/// are off. Bounds: angles with such a value are possible best ones; whether a pose is one of them is refused.
inline constexpr double kBestOfAngles = 1e-9;
/// Degrees: two places about the end of an interval of angles between which the end lies, as its angle in doubles is
/// off by some 360 * 2^-50; 2^11 times that and more. Bounds: what is found between counts for the end.
inline constexpr double kAboutAnEnd = 1e-9;
/// Of a number of degrees, relative to it and 1: some thousand roundings of degrees up to 360, more than the angle of a
/// contact loses (rotational_distance.h says 1e-13). Bounds: it is the stated error.
inline constexpr double kAngleValue = 0x1p-40;

// -- solid

/// Of the value: what a value that is not proven may be off at least (it is right to 2^-38, solid_value.h); its own
/// stated error counts where that is greater. Bounds, and does not decide: farther from the level the sign is certain.
/// Nearer to it there is none, and the question is refused (solve_space.cpp).
inline constexpr double kSideOfLevel = 0x1p-34;
/// Of the length of the box of a group of intervals: an optimum on lines is searched to this. Bounds: the tolerance is
/// stated with the optimum.
inline constexpr double kLineOptimum = 0x1p-20;

}  // namespace findspace::margin
