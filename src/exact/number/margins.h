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

}  // namespace findspace::margin
