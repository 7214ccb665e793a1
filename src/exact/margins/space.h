// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the layer `space`, by street. Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

// -- polytope and body

/// Of the squares of the lengths, so the sine of the angle of two edges is 2^-20: of edges more parallel than that, the
/// nearest places are ends. Bounds: the distance is too large by at most 2^-18 of the longer edge.
inline constexpr double kParallelEdges = 0x1p-40;
/// Of the determinant: how far beyond the end of an edge the nearest place still counts as on it. At kParallelEdges the
/// terms of a determinant are known to 2^-12. Bounds: the place is moved to the end, so the distance is that of a
/// point.
inline constexpr double kBeyondEnd = 0x1p-10;
/// Of the offsets: by how much a place may be outside a plane when the deepest place is proposed. A meeting of four
/// planes is found by 2^6 operations that kFlatMeeting lets grow. Filters: real numbers decide afterwards.
inline constexpr double kProposedPlace = 0x1p-32;
/// A pivot of four planes with unit normals below this counts as 0. Filters: as above.
inline constexpr double kFlatMeeting = 0x1p-30;
/// Of the size of the points: corners this near to the highest in a direction may be as high. The direction is known to
/// 2^-42 by kKnownDirection, and a point of that size moves by as much; 2^6 times that. Filters: planes too many are
/// redundant; too small a value would lose a facet.
inline constexpr double kAsHigh = 0x1p-36;
/// Sine of the angle of two edges above which the direction across both is known to 2^10 roundings. Filters: else it is
/// computed exactly.
inline constexpr double kKnownDirection = 0x1p-10;
/// Share by which the direction across two edges may be off and is taken by numbers. Filters: else the set that it
/// bounds is made exactly, and what is nearer to the plane than so much is decided by that.
inline constexpr double kUnknownNormal = 0x1p-20;
/// Cosine below 1 of two directions that may be the same, an angle of 2^-14.5. Filters: these are compared exactly.
inline constexpr double kSameDirection = 0x1p-30;
/// Below this determinant of a Gram matrix of unit normals planes may be parallel, as its entries are rounded. Filters:
/// exact arithmetic takes over.
inline constexpr double kThinWedge = 0x1p-30;
/// Of the sizes: nearer to a plane the value in doubles has lost six of its bits. Filters: it is then rounded from the
/// exact one.
inline constexpr double kNextToPlane = 0x1p-6;

// -- convolution and rays

/// In radians, and of cosines: how much wider a cone of normals is taken. The arc cosine of a number near 1 is off by
/// the root of its rounding, 2^-26; 2^6 times that. Filters: a wider cone only tests more pairs.
inline constexpr double kWiderCone = 0x1p-20;
/// Of the radius: how much wider the box of a patch of a ball is taken on each side. Far above the roundings of a sine
/// and a cosine. Filters: a wider box only tests more lines.
inline constexpr double kWiderPatchBox = 0x1p-20;
/// Into how many parts of the radius a direction is rounded, so that its components are whole numbers below 2^41.
/// Searches: what the rounded direction gives is a place of the ball, exactly.
inline constexpr double kDirectionParts = 0x1p40;
/// Of the radius: what a direction rounded to those parts is off, 2^-40 a component, times 2^2. Filters: nearer to the
/// plane of an edge the line is computed exactly.
inline constexpr double kRoundedDirection = 0x1p-38;
/// Of the distance asked for: coordinates below 2^40 relative to a place at about that distance, and the roundings of
/// the formulas, 2^13. Filters: faces within it are compared exactly.
inline constexpr double kDistanceBlur = 0x1p-40;
/// Of the terms: how far outside a face the foot of the perpendicular still counts as on it. Bounds: so a distance in
/// doubles is never too large; faces it makes too near are compared exactly.
inline constexpr double kOnFace = 0x1p-30;
/// In grid steps: beyond this error, heights of a facet are computed exactly and rounded. Filters.
inline constexpr double kCoarseHeight = 0x1p-8;
/// Slope of a line across an axis: below it, where the line crosses the box says little, as it is known to
/// kWiderBox over the slope. Filters: that axis then leaves nothing out.
inline constexpr double kAcrossAxis = 0x1p-30;

// -- phi and surface

/// Of a squared distance: facets that come nearer than the least found and this are tried exactly. 2^23 roundings.
/// Filters.
inline constexpr double kFacetTried = 0x1p-30;
/// Of what one plane gains on another in a box: 2^33 roundings. Filters: a facet too many is kept as a candidate.
inline constexpr double kLargerGain = 0x1p-20;
/// Of the squares of the lengths, so the sine of the angle of two edges is 2^-18: of more parallel ones the distance is
/// hard to tell. Filters: they are kept, and their planes are exact.
inline constexpr double kHardToTell = 0x1p-36;
/// Of the coordinates: what the distance of two faces may be off, 2^10 roundings. Bounds: pairs within it of the least
/// are looked at exactly.
inline constexpr double kFaceDistance = 0x1p-43;
/// Of the longest edge: the same of a projection that is hard to tell; see kParallelEdges. Bounds.
inline constexpr double kFaceProjection = 0x1p-18;

}  // namespace findspace::margin
