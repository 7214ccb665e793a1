// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a margin is, and the margins that all layers share. A margin says how far a number in doubles is trusted. A
// double has 53 bits, so one operation is off by at most 2^-53 of its result, called one rounding here. The other files
// of this street hold the margins of one layer each. Each constant says what it covers, and what it does:
//   filters  what lies within the margin is looked at exactly, so the margin costs time and never a result;
//   bounds   it is part of a stated error, or widens an interval that is stated as certain;
//   searches it says where a search stops or what it tries first; the value found states its own error;
//   decides  it takes the place of a sign: the comment says what goes wrong where it is too large or too small.
// "Of the size" means relative to the largest coordinate of the shapes at hand. Keywords: epsilon, tolerance.
#pragma once

namespace findspace::margin {

/// Of the logarithm of a bound, relative and absolute. One step is a difference, an exponential, a logarithm and two
/// sums: less than 2^3 roundings. So 2^10 steps in a row lose less than this. Bounds: it is added, so that the number
/// of bits to which a sign is computed is never too small.
inline constexpr double kLogarithm = 0x1p-40;

// -- what operations on doubles lose, relative to the sum of the magnitudes of their terms. A few operations in a row
// -- lose no more than their number of roundings; the constant is the next power of 2. Bounds: the product is added to
// -- a stated error, or a sign within it is decided exactly.

/// Of one operation, or of a whole number that becomes a double.
inline constexpr double kRounding = 0x1p-53;
/// Of a product less a product, of a quotient, or of an exact number that becomes a double.
inline constexpr double kRoundings4 = 0x1p-51;
/// Of a place on a straight line, a turn of three points, or a distance to a corner.
inline constexpr double kRoundings8 = 0x1p-50;
/// Of a plane's value: the unit normal carries four, the offset four, and the evaluation three.
inline constexpr double kRoundings16 = 0x1p-49;
/// Of a plane's value where the normal was rounded from exact numbers before, and of boxes of points that were.
inline constexpr double kRoundings32 = 0x1p-48;
/// Of a triple product, and of a distance of a projection made of three multiples of normals.
inline constexpr double kRoundings128 = 0x1p-46;
/// Of Cramer's rule for three equations, each determinant being a sum of six products, and of a reach that is made of
/// the corners of four boxes.
inline constexpr double kRoundings512 = 0x1p-44;

// -- boxes; relative to their coordinates

/// Boxes are wider than they need to be by this, 2^13 roundings. Filters: what is in a box is looked at exactly.
inline constexpr double kWiderBox = 0x1p-40;

// -- lengths and results of a few operations

/// Factors that round a computed length up or down: 2^12 roundings fit, and the lengths at hand take less than 2^6.
/// Bounds: a radius or reach that has to be at least, or at most, the exact one.
inline constexpr double kUpward = 1 + 0x1p-40, kDownward = 1 - 0x1p-40;
/// In grid steps, added to a length that is rounded up: it covers numbers near 0, where a factor covers nothing. The
/// coordinates that lengths come from are below 2^40 steps, so their roundings are below 2^-12; those of angles are
/// covered by the shapes' own rounding, which is added before. Bounds.
inline constexpr double kUpwardSteps = 0x1p-20;
/// Relative error of a number after up to 2^3 roundings: a product, a sum of two products, a quotient. Bounds.
inline constexpr double kFewRoundings = 0x1p-50;

}  // namespace findspace::margin
