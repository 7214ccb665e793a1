// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the layer `plane`, by street. Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

// -- in all streets, and in those of `distance`

/// In grid steps: no level lies beyond, as coordinates are at most 2^42 and a distance is below 2^2 times that.
/// Searches: values are bracketed between minus this and this.
inline constexpr double kBeyondAll = 0x1p44;

// -- base and complex

/// In lattice units: coordinates stay below 2^43 steps, and a unit has more than 2 of them, so a quotient below 2^42 is
/// off by 2^-9 in the four operations made. Bounds: cells and points nearer to an edge count as not inside, as the
/// guarantee of lattice_runs.h allows.
inline constexpr double kLatticeSlack = 0x1p-6;
/// Grid steps: a point less a corner is below 2^43, and the side of a point beside an edge is off by 2^-6 of its length
/// at most. Filters: a point that is not so far from every edge of a face is decided by exact winding numbers.
inline constexpr double kInsideFace = 2;
/// Of the size of a polynomial's terms: 2^13 roundings, more than its evaluation loses. Filters: places of roots too
/// many do no harm.
inline constexpr double kPolynomialLost = 1e-12;
/// Half the width with which the place of a root begins, 2^3 roundings of 1. Searches: it is doubled until the
/// polynomial is clear of 0 at both ends.
inline constexpr double kFirstRootPlace = 1e-15;
/// Of the coordinates: covers the arithmetic of boxes of pieces, 2^9 roundings. Filters: pieces whose boxes meet are
/// compared exactly.
inline constexpr double kPieceBoxSlack = 0x1p-44;

// -- contour, build and offset

/// Of the radius: near a half circle the apothem is the root of a difference of rounded squares, off by the root of
/// 2^-51, which is 2^-25.5. Filters: a wider box is right too.
inline constexpr double kApothemSlack = 0x1p-24;
/// Of the lengths compared: 2^33 roundings. Filters: an arc that is not clearly within the hull of the corners is a
/// candidate, which is decided exactly.
inline constexpr double kHullCandidate = 1e-6;
/// Of the coordinates below 2^53: 2^13 roundings. Filters: an edge that is not certainly farther is kept, and compared
/// exactly.
inline constexpr double kCertainlyFarther = 0x1p-40;

// -- grid and query

/// Of a diamond angle, which is at most 4 and takes three operations: off by 2^-49; 2^3 times that. Filters: directions
/// closer than this are compared exactly.
inline constexpr double kDiamondAngle = 0x1p-46;
/// Of the coordinates and the distance: rounding exchanges only candidates within this of the least, 2^9 roundings.
/// Filters: they are compared by their exact distances.
inline constexpr double kNearestCandidate = 0x1p-44;
/// Of the centre's coordinates: an arc with a smaller radius loses, in differences of coordinates to about 94 bits,
/// more digits than its angle may. Filters: the differences are then taken exactly.
inline constexpr double kSmallRadius = 0x1p-40;
/// Relative error of one operation of Twofold, a sum of two doubles: twice that which is proved for the worst of them.
/// Bounds: it goes into the error that stands beside each number.
inline constexpr double kTwofoldOperation = 0x1p-102;
/// By how much a sum of errors is enlarged for its own roundings: 2^13 of them. Bounds.
inline constexpr double kGrowError = 1 + 0x1p-40;
/// Relative error with which a vertex will do, as the header of measure_cells_places.h states. Filters: beyond it the
/// exact coordinates are taken.
inline constexpr double kGoodPlace = 0x1p-94;
/// Relative error of a double that is good enough to begin with: the rest, a double too, then brings the sum to 2^-94.
/// Filters: else both halves are taken from the exact number.
inline constexpr double kGoodFirstHalf = 0x1p-42;

// -- rotation: sets of angles; directions in radians, tolerances relative to the sizes

/// Directions closer than this count as one. A direction is made of rounded coordinates: with an edge of 2^-28 of them
/// it is off by 2^-24, which is less. Filters: features, curves and meetings too many do no harm. Decides in one place:
/// where an arc joins an edge with less of a corner, the corner has no normals of its own.
inline constexpr double kOneDirection = 1e-7;
/// The same, and of cosines, at an angle that is itself the root of a rounded equation. At a double root the angle is
/// off by the root of the rounding, 2^-24; with the 2^-24 of the direction that is more than kOneDirection, which is
/// not widened because it decides in one place. Filters: angles too many do no harm.
inline constexpr double kOneDirectionAtRoot = 1e-6;
/// Of the sizes: what is nearer is decided exactly. 2^20 times what a rotated point is off. Filters.
inline constexpr double kRotatedTolerance = 1e-9;
/// Of the tolerance above: more than rough curves are off, which is 2^-49 of the sizes. Bounds: it goes into the
/// distance by which a rough meeting may be off.
inline constexpr double kRoughCurveError = 1e-4;
/// In radians, and relative where a cosine is compared with 1: by how much a sector of angles is wider than stated.
/// 2^20 roundings of an angle. Filters: angles too many do no harm.
inline constexpr double kSectorSlack = 1e-9;
/// Of the tangent of the half angle: in a wider place of a root nothing is filtered, as the curves move too far in it
/// to be looked at in one position. Filters.
inline constexpr double kWideRootPlace = 1e-4;
/// Of the sizes: features closer than this are compared exactly. 2^23 roundings. Filters.
inline constexpr double kNearFeatures = 1e-9;
/// In degrees: angles closer than this are compared exactly. An angle in degrees is off by 2^-43. Filters.
inline constexpr double kNearAngles = 1e-9;
/// Of the coordinates: a tangency moves by the root of their rounding, which is 2^-26, here times 2^8. Filters: it only
/// admits angles too many.
inline constexpr double kTangencyTolerance = 0x1p-18;
/// Of kRotatedTolerance: a distance and the curve it is taken to are off by one of it each; the rest is for their sums.
/// Filters: what is nearer is decided exactly.
inline constexpr double kRotatedSum = 10;
/// Of kRotatedTolerance: where three curves meet at angles down to 1/10 of a radian. Filters: places that are off by
/// more are not witnesses, and the places of roots are looked at as exactly either way.
inline constexpr double kRotatedMeeting = 100;
/// Of what a point travels over the angle by which the place of a root may be off: that is 2 du, to both sides.
/// Filters.
inline constexpr double kRootReach = 4;
/// Of the sizes: a rotated point is off by less than 2^-50 of them. Filters.
inline constexpr double kRotatedPoint = 0x1p-40;
/// Of the chord and the radius: by how much a chord counts as upright or level, so that the box of the whole circle is
/// taken. Far above the roundings. Bounds: a wider box is right too.
inline constexpr double kUprightChord = 0x1p-20;
/// Sine of the angle at which two curves cross: less steep is left to exact work. At that angle a crossing moves 10^4
/// times as far as the curves are off. Filters.
inline constexpr double kSteepCrossing = 1e-4;
/// Of the radius squared: where a chord's half is shorter than 10^-4 of the radius, the line is near a tangent, and
/// nothing is certain. The square of kSteepCrossing. Filters.
inline constexpr double kNearTangentSquare = 1e-8;
/// By how much the way of a place through a sector is lengthened: far above the rounding of its few operations.
/// Filters: places too many do no harm.
inline constexpr double kLongerTravel = 1.01;
/// Cosine of half the angle between the normals of two contact curves where they meet, and of the angle between a third
/// normal and the way out: below it the way leads away from a curve by less than a tenth of its length. Filters: such
/// places are left to exact numbers.
inline constexpr double kOpenCurves = 0.1;
/// Of the level: where its bisection stops, 2^11 roundings wide. Searches: the bracket is stated with the value.
inline constexpr double kRotatedBracket = 0x1p-42;
/// Grid steps: no vertex of cells that are read or constructed is farther along x or y. The sum of two such sets has
/// coordinates up to 2^43, as the margins here assume. Bounds: what goes beyond is refused.
inline constexpr double kFarthestVertex = 0x1p42;

}  // namespace findspace::margin
