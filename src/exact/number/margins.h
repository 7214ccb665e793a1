// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The margins of all layers above `exact`: how far a number in doubles is trusted. A double has 53 bits, so one
// operation is off by at most 2^-53 of its result, called one rounding here. Each constant says what it covers, and
// what it does:
//   filters  what lies within the margin is looked at exactly, so the margin costs time and never a result;
//   bounds   it is part of a stated error, or widens an interval that is stated as certain;
//   searches it says where a search stops or what it tries first; the value found states its own error;
//   decides  it takes the place of a sign: the comment says what goes wrong where it is too large or too small.
// "Of the size" means relative to the largest coordinate of the shapes at hand. Keywords: epsilon, tolerance.
#pragma once

namespace findspace::margin {

// ---- plane ------------------------------------------------------------------------------------------------------

// -- rotation: sets of angles; directions in radians, rooms relative to the sizes

/// Directions closer than this count as one. A direction is made of rounded coordinates: with an edge of 2^-28 of them
/// it is off by 2^-24, which is less. Filters: features, curves and meetings too many do no harm. Decides in one place:
/// where an arc joins an edge with less of a corner, the corner has no normals of its own.
inline constexpr double kOneDirection = 1e-7;
/// The same at an angle that is itself the root of a rounded polynomial. Filters: angles too many do no harm.
inline constexpr double kOneDirectionAtRoot = 1e-6;
/// Of the sizes: what is nearer is decided exactly. 2^20 times what a rotated point is off. Filters.
inline constexpr double kRotatedRoom = 1e-9;
/// Of the room above: more than rough curves are off, which is 2^-49 of the sizes. Bounds: it goes into the distance by
/// which a rough meeting may be off.
inline constexpr double kRoughCurveError = 1e-4;
/// In radians, and relative where a cosine is compared with 1: by how much a sector of angles is wider than stated.
/// 2^20 roundings of an angle. Filters: angles too many do no harm.
inline constexpr double kSectorSlack = 1e-9;
/// Of the tangent of the half angle: in a wider place of a root nothing is filtered, as the curves move too far in it
/// to be looked at in one position. Filters.
inline constexpr double kWideRootPlace = 1e-4;
/// Of the sizes: features closer than this are compared exactly. 2^20 roundings. Filters.
inline constexpr double kNearFeatures = 1e-9;
/// In degrees: angles closer than this are compared exactly. An angle in degrees is off by 2^-43. Filters.
inline constexpr double kNearAngles = 1e-9;
/// Of the coordinates: a tangency moves by the root of their rounding, which is 2^-26, here times 2^8. Filters: it only
/// admits angles too many.
inline constexpr double kTangencyRoom = 0x1p-18;
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
/// In grid steps: no level lies beyond, as coordinates are below 2^40. Searches: the least level is bracketed so.
inline constexpr double kBeyondRotatedLevels = 0x1p44;
/// Of the level: where its bisection stops, 2^11 roundings wide. Searches: the bracket is stated with the value.
inline constexpr double kRotatedBracket = 0x1p-42;

// ---- space ------------------------------------------------------------------------------------------------------

// -- convolution: sums of surfaces along rays

/// In radians, and of cosines: how much wider a cone of normals is taken. The arc cosine of a number near 1 is off by
/// the root of its rounding, 2^-26; 2^6 times that. Filters: a wider cone only tests more pairs.
inline constexpr double kWiderCone = 0x1p-20;
/// Of the radius: how much wider the box of a patch of a ball is taken on each side. Far above the roundings of a sine
/// and a cosine. Filters: a wider box only tests more lines.
inline constexpr double kWiderPatchBox = 0x1p-20;

// ---- distance ---------------------------------------------------------------------------------------------------

// -- planar: two shapes of the plane; lengths relative to the scale, the size of the coordinates of both

/// Numbers closer than this count as equal in a search. A distance of two features takes some 2^4 operations on
/// coordinates, so it is off by less than 2^-48; 2^5 such numbers are compared with each other. Filters: what is
/// within goes to the exact comparison of candidates.
inline constexpr double kSameNumber = 0x1p-43;
/// A directed Hausdorff distance beyond is measured, not looked up in the sign map at level 0. Filters: below it the
/// map, which is exact, says whether B lies in A.
inline constexpr double kClearlyOut = 0x1p-26;
/// A positive distance in doubles below this is looked up in the exact sign map at level 0. 2^12 times the error of
/// such a distance (2^-48). Filters.
inline constexpr double kHardlyOut = 0x1p-36;
/// A part of an edge this short is a single place, near to which the features are paired. It is 2^4 times the error of
/// its ends. Filters: the place is found exactly from the features around it.
inline constexpr double kShortPart = 0x1p-44;
/// In a box this small the place is found exactly from the parts of A around it, if these are few. Searches: a wider
/// box would hold more parts, a smaller one takes more divisions.
inline constexpr double kExactPlaceBox = 0x1p-24;
/// In a box this small it is found so however many they are: doubles cannot divide much further. Searches.
inline constexpr double kTinyPlaceBox = 0x1p-44;

// -- planar_least: least and greatest values over a region of the plane

/// In grid steps: no level lies beyond, as coordinates are below 2^40 and a distance below 2^3 times that. Searches:
/// the value is bracketed between minus this and this.
inline constexpr double kBeyondAll = 0x1p44;

// -- search: certified searches in space; lengths relative to the size, the farthest coordinate of the functions

/// What rounding may do to the distance to a plane, a ball or a convex set: 2^6 operations of half a rounding each on
/// numbers of the size. Bounds: cells are kept unless they are out by more.
inline constexpr double kDistanceNoise = 0x1p-46;
/// By how much a place that is found has to keep each rule, in doubles. Decides: see boundary_search::allowed.
inline constexpr double kAllowed = 0x1p-48;
/// Cells are not divided below this: they are 2^2 times the noise, so doubles cannot tell their corners apart. Bounds:
/// what is left in such a cell is part of the stated error.
inline constexpr double kSmallestCell = 0x1p-44;
/// What is better than the best by less is not looked for. 2^3 times the noise, so that near the best place, where the
/// boundary and the sphere about it part by squares only, cells are settled before these are lost in noise. Bounds.
inline constexpr double kNearerAtAll = 0x1p-43;
/// What a value found by search may be off: kNearerAtAll and the noise of the place and of the value, each less than
/// 2^-43, leave 2^-40 as a safe sum. Bounds.
inline constexpr double kFoundError = 0x1p-40;
/// The greatest error that is accepted, where boundaries part so slowly from the sphere about the position that the
/// search ends before. Decides: beyond it the value is refused, not wrong.
inline constexpr double kMostFoundError = 0x1p-32;
/// By how much B has to fit, twice kDistanceNoise. Decides: a place at which B sticks out by less counts as one at
/// which it fits, and the value found there states kFoundError.
inline constexpr double kFits = 0x1p-45;
/// Cells of positions at which B fits are not divided below this: a distance that B sticks out is known to kFits only,
/// and a cell has to be 2^3 times as wide to show a slope. Bounds.
inline constexpr double kSmallestFitCell = 0x1p-42;
/// What is better than the best fit by less is not looked for. Each cell takes a search of its own, so this trades
/// 2^6 of kNearerAtAll for six divisions less. Bounds.
inline constexpr double kNearerFit = 0x1p-37;

// -- csg: solids that others are cut out of; lengths relative to the size, the farthest coordinate of the pair

/// A part, or what two parts share, that is thinner has no interior that doubles can see: its faces are off by 2^-46
/// each. Decides: a thinner overlap counts as none; by values it could not be told from touching.
inline constexpr double kNoInterior = 0x1p-44;
/// Depths below this are not told from none on the lines by which places are looked for. Searches.
inline constexpr double kDepthOnLines = 0x1p-32;
/// Where boxes are apart by this, their distance is enough of a lower bound. Searches.
inline constexpr double kFarByBoxes = 0x1p-4;
/// Share of its value that a bound has to reach where it is only used to go on from: a line is walked in steps of at
/// least half the distance. Searches.
inline constexpr double kRoughShare = 0x1p-1;

// ---- formula ----------------------------------------------------------------------------------------------------

// ---- planning ---------------------------------------------------------------------------------------------------

// ---- apps -------------------------------------------------------------------------------------------------------

}  // namespace findspace::margin
