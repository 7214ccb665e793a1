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

// ---- plane and space --------------------------------------------------------------------------------------------

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

// ---- plane ------------------------------------------------------------------------------------------------------

// -- base and complex

/// In lattice units: coordinates stay below 2^43 steps, and a unit has more than 2 of them, so a quotient below 2^42 is
/// off by 2^-9 in the four operations made. Bounds: cells and points nearer to an edge count as not inside, as the
/// guarantee of lattice_runs.h allows.
inline constexpr double kLatticeSlack = 0x1p-6;
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
/// Of the sizes: features closer than this are compared exactly. 2^23 roundings. Filters.
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
/// By how much the way of a place through a sector is lengthened: far above the rounding of its few operations.
/// Filters: places too many do no harm.
inline constexpr double kLongerTravel = 1.01;
/// Cosine of half the angle between the normals of two contact curves where they meet, and of the angle between a third
/// normal and the way out: below it the way leads away from a curve by less than a tenth of its length. Filters: such
/// places are left to exact numbers.
inline constexpr double kOpenCurves = 0.1;
/// In grid steps: no level lies beyond, as coordinates are below 2^40. Searches: the least level is bracketed so.
inline constexpr double kBeyondRotatedLevels = 0x1p44;
/// Of the level: where its bisection stops, 2^11 roundings wide. Searches: the bracket is stated with the value.
inline constexpr double kRotatedBracket = 0x1p-42;

// ---- space ------------------------------------------------------------------------------------------------------

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
