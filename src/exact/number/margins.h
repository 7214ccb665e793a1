// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The margins of all layers above `exact`, and of logarithms in it: how far a number in doubles is trusted. A double
// has 53 bits, so one operation is off by at most 2^-53 of its result, called one rounding here. Each constant says
// what it covers, and what it does:
//   filters  what lies within the margin is looked at exactly, so the margin costs time and never a result;
//   bounds   it is part of a stated error, or widens an interval that is stated as certain;
//   searches it says where a search stops or what it tries first; the value found states its own error;
//   decides  it takes the place of a sign: the comment says what goes wrong where it is too large or too small.
// "Of the size" means relative to the largest coordinate of the shapes at hand. Keywords: epsilon, tolerance.
#pragma once

namespace findspace::margin {

// ---- exact --------------------------------------------------------------------------------------------------------

/// Of the logarithm of a bound, relative and absolute. One step is a difference, an exponential, a logarithm and two
/// sums: less than 2^3 roundings. So 2^10 steps in a row lose less than this. Bounds: it is added, so that the number
/// of bits to which a sign is computed is never too small.
inline constexpr double kLogarithm = 0x1p-40;

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

// -- in all streets, and in those of `distance`

/// In grid steps: no level lies beyond, as coordinates are below 2^40 and a distance is below 2^3 times that. Searches:
/// values are bracketed between minus this and this.
inline constexpr double kBeyondAll = 0x1p44;

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
/// The same, and of cosines, at an angle that is itself the root of a rounded equation. At a double root the angle is
/// off by the root of the rounding, 2^-24; with the 2^-24 of the direction that is more than kOneDirection, which is
/// not widened because it decides in one place. Filters: angles too many do no harm.
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

// -- in all streets

/// Factors that round a computed length up or down: 2^12 roundings fit, and the lengths at hand take less than 2^6.
/// Bounds: a radius or reach that has to be at least, or at most, the exact one.
inline constexpr double kUpward = 1 + 0x1p-40, kDownward = 1 - 0x1p-40;
/// In grid steps, added to a length that is rounded up: it covers numbers near 0, where a factor covers nothing. The
/// coordinates that lengths come from are below 2^40 steps, so their roundings are below 2^-12; those of angles are
/// covered by the shapes' own rounding, which is added before. Bounds.
inline constexpr double kUpwardSteps = 0x1p-20;
/// Relative error of a number after up to 2^3 roundings: a product, a sum of two products, a quotient. Bounds.
inline constexpr double kFewRoundings = 0x1p-50;

// -- planar and planar_features: two shapes of the plane; relative to the scale, the size of the coordinates of both

/// Numbers closer than this count as equal in a search. A distance of two features takes some 2^4 roundings, so it is
/// off by less than 2^-48; the margin is 2^5 times that. Filters: what is within goes to the comparison of candidates.
inline constexpr double kSameNumber = 0x1p-43;
/// Two features whose distances differ by this may both be nearest, or farthest: 2^4 times the error of a distance.
/// Filters: all of them are compared exactly.
inline constexpr double kLostByDoubles = 0x1p-44;
/// Features closer than this may meet; circles that touch may seem to cross. 2^8 times the error of a distance, as the
/// place where circles meet loses more than their distance. Filters: exact_pair decides.
inline constexpr double kPairMeets = 0x1p-40;
/// Circles whose centres are this near may have one centre: the distance of centres takes 2^3 roundings, and each
/// centre is rounded by up to 2^-50. Filters: exact_pair decides.
inline constexpr double kOneCentre = 0x1p-46;
/// Centres this near are compared by their exact places. Filters; 2^6 times kOneCentre, as radii enter as well.
inline constexpr double kNearCentres = 0x1p-40;
/// A place this near to the boundary is not told to be in or out by doubles: 2^7 roundings. Filters.
inline constexpr double kOnBoundary = 0x1p-46;
/// A cross product, relative to its terms, or a ratio of distances beyond this has its sign; each takes 2^3 roundings
/// of numbers that are off by up to 2^-45 themselves. Filters.
inline constexpr double kCertainTurn = 0x1p-40;
/// Of the level: an interval this narrow is searched for roots of any degree. Searches: a wider one takes too long.
inline constexpr double kNarrowLevel = 0x1p-30;
/// In radians: a vertex whose edges turn by less is dropped from the Voronoi cells. Filters: what is dropped is no
/// nearer than the ends of its edges, so the places near it are looked at with these.
inline constexpr double kFlatVertex = 0x1p-30;
/// How far the exact smallest circle may be from the rounded one: circles through three points that are nearly on a
/// line lose half of the digits, and 2^4 remain. Filters: what is near both is tried as a support, exactly.
inline constexpr double kNearCircle = 0x1p-22;
/// What is inside the rounded circle by this is inside the exact one: 2^4 times kNearCircle. Filters.
inline constexpr double kInsideCircle = 0x1p-18;
/// A point counts as in a rounded circle within this: its distance from the centre takes 2^4 roundings. Searches: the
/// rounded circle only says which points the exact one is made of.
inline constexpr double kCircleNoise = 0x1p-48;
/// A directed Hausdorff distance beyond is measured, not looked up in the sign map at level 0. Filters: below it the
/// map, which is exact, says whether B lies in A.
inline constexpr double kClearlyOut = 0x1p-26;
/// A positive distance below this, in doubles, is looked up in the exact sign map at level 0. 2^12 times the error of
/// such a distance. Filters.
inline constexpr double kHardlyOut = 0x1p-36;
/// A max-min place is guessed to this, to find the features that make its value. Searches.
inline constexpr double kMaxMinGuess = 0x1p-24;
/// What a guessed place may be off: kMaxMinGuess and a factor 2^3 for places at which the value is nearly level.
/// Filters: features within it are all tried.
inline constexpr double kGuessedPlace = 0x1p-21;
/// Max-min places of one cell that are this near are one place: 2^4 times kMaxMinGuess. Searches: the features near
/// both are tried, and the exact place is one of theirs.
inline constexpr double kSamePlace = 0x1p-20;
/// What an exact level, or an edge, may differ from the place found in doubles: kMaxMinFine and the rounding of the
/// distance. Filters: candidates beyond are other places.
inline constexpr double kRoundedPlace = 0x1p-42;
/// The second, finer search for a max-min value ends here: half of it is noise of the distances. Bounds.
inline constexpr double kMaxMinFine = 0x1p-44;
/// What is better than the first place by less is not looked for: distances are off by up to 2^-46. Decides: where two
/// places differ by less, the value of the first is stated; it is less than the greatest by 2^-45 of the scale.
inline constexpr double kNothingMore = 0x1p-45;
/// An exact level below the value found by this cannot be the greatest. Filters: distances are off by less.
inline constexpr double kSurelyLess = 0x1p-46;
/// A part of an edge this short is a single place: 2^4 times the error of its ends. Filters: the place is found exactly
/// from the features around it.
inline constexpr double kShortPart = 0x1p-44;
/// In a box this small the place is found exactly from the parts of A around it, if these are few. Searches: a wider
/// box holds more parts, a smaller one takes more divisions.
inline constexpr double kExactPlaceBox = 0x1p-24;
/// In a box this small it is found so however many they are: doubles hardly divide it further. Searches.
inline constexpr double kTinyPlaceBox = 0x1p-44;
/// Of an edge: halving ends here, at the spacing of doubles below 1. Searches.
inline constexpr double kNoHalving = 0x1p-52;
/// Of an edge: a place this near to its end is the end, which is looked at anyway. Searches.
inline constexpr double kAtEnd = 0x1p-30;
/// Exact meetings of features are looked for this near to a place: 2^10 times what the place may be off, as meetings of
/// curves that are nearly tangent move farther than the curves. Filters.
inline constexpr double kMeetingOff = 0x1p-34;
/// Depths, or distances to curves, that differ by this may be equal, and windows are widened by it: 2^8 times the error
/// of a distance. Filters: what is within is compared exactly.
inline constexpr double kDepthTolerance = 0x1p-40;
/// Boxes of a max-min search below this are no longer divided: their candidates are found from at most three parts.
/// Searches.
inline constexpr double kMaxMinBox = 0x1p-30;
/// What a distance in a box may be off: 2^5 roundings of half a unit. Bounds: parts are kept unless out by more.
inline constexpr double kMaxMinNoise = 0x1p-47;
/// Factor over half the diagonal of a box, 2^22 roundings where 2^3 happen: the radius only keeps more parts. Bounds.
inline constexpr double kBoxRadius = 1 + 0x1p-30;
/// A candidate this far outside a box still belongs to it: meetings of curves are off by more than distances. Searches:
/// a candidate of two boxes is recorded twice, and the best is taken.
inline constexpr double kCandidateBox = 0x1p-40;

// -- planar_least: least and greatest values over a region of the plane; relative to the scale of levels and
// coordinates

/// Best positions are known to this: bracketing goes past doubles until they are. Bounds.
inline constexpr double kPlacesDecided = 0x1p-42;
/// The first level is taken this much worse than a value that is reached, so that its exact sign map is not empty
/// because of rounding. Searches: the map, which is exact, says whether it is reached.
inline constexpr double kBracketRoom = 0x1p-30;
/// What the numbers of a bracket that is known may be off; the sign maps at both ends are exact. Searches.
inline constexpr double kKnownNumber = 0x1p-40;
/// An exact candidate this near to a known number may be it. Filters: it is accepted by exact sign maps only.
inline constexpr double kNearCandidate = 0x1p-36;
/// Candidates are looked for this far beyond the bracket, so that an exact level at its end is among them. Filters.
inline constexpr double kBracketEnds = 0x1p-48;
/// Candidates that all lie within this are one value, and are tried; if not, bisection parts them first. Searches.
inline constexpr double kOneCandidate = 0x1p-40;
/// Coordinates or levels, relative to 1 more than their size, that are this near may be equal. Filters: it only drops
/// candidates that another one stands for, and the one that is kept is proven by exact sign maps.
inline constexpr double kSameCandidate = 0x1p-44;
/// A bracket is at least this wide, so that its ends differ as doubles by 2^3 units. Bounds.
inline constexpr double kNarrowestBracket = 0x1p-50;
/// Below this width candidates are tried, on every other step. Searches.
inline constexpr double kTryCandidates = 0x1p-8;
/// Of the level: a bracket this narrow is stated as it is. Bounds.
inline constexpr double kNarrowBracket = 0x1p-44;
/// Of the level: likewise for functions that are known by their sign maps alone, where bisection is all there is, and
/// goes on to the last 2^5 units. Bounds.
inline constexpr double kNarrowLevelBracket = 0x1p-48;
/// In grid steps: likewise, for levels near 0. Bounds.
inline constexpr double kLevelWidth = 0x1p-20;
/// Relative error of a linear form of a point: two products and a sum are 2^2 roundings; the rest is room. Filters.
inline constexpr double kFormNoise = 0x1p-48;
/// What the middle of a box, and the distance from it, may be off: 2^4 roundings. Bounds: a radius is rounded up by it.
inline constexpr double kBoxMiddle = 0x1p-48;

// -- rotation: rotating shapes

/// Of the rate of a motion: bounds of an extremum over time are not brought nearer than this, as the values of f at an
/// instant are off by 2^6 roundings. Bounds.
inline constexpr double kMotionGap = 0x1p-46;
/// Of the length of a path: an extremum along it is bracketed to this, before the exact search begins. Searches.
inline constexpr double kPathEnough = 0x1p-24;

// -- search: certified searches in space; relative to the size, the farthest coordinate of the functions at hand

/// What rounding may do to the distance to a plane, a ball or a convex set: 2^6 roundings on numbers of the size.
/// Bounds: cells are kept unless they are out by more, and values state it.
inline constexpr double kDistanceNoise = 0x1p-46;
/// What rounding may do to a place and to the distance from it: 2^8 roundings, as a place is computed from planes that
/// are off by kDistanceNoise. Bounds: what is said to be clear is clear by more.
inline constexpr double kPlaceNoise = 0x1p-44;
/// A place this near to a vertex may be that vertex. Filters: the distance there is then computed exactly.
inline constexpr double kAtVertex = 0x1p-44;
/// By how much, in doubles, a place keeps each rule of a search (boundary_search::allowed). It is less than
/// kDistanceNoise, as a search that asked for more would not offer places on boundaries. Searches in free_space.cpp,
/// where the place is then checked by exact predicates. Decides for solids that others are cut out of (csg), where no
/// exact rule exists: a place may break a rule by kDistanceNoise. The value is then off by less than kFoundError. But a
/// pocket of no width, or of one below kDistanceNoise, may count as a place that belongs, or as none.
inline constexpr double kAllowed = 0x1p-48;
/// Cells are not divided below this: it is 2^2 times kDistanceNoise, so doubles hardly tell their corners apart.
/// Bounds: what is left in such a cell is part of the stated error.
inline constexpr double kSmallestCell = 0x1p-44;
/// What is better than the best by less is not looked for. 2^3 times the noise, so that near the best place, where the
/// boundary and the sphere about it part by squares only, cells are settled before these are lost in noise. Bounds.
inline constexpr double kNearerAtAll = 0x1p-43;
/// What a value found by search may be off: kNearerAtAll, kPlaceNoise and the rounding of shapes to doubles add up to
/// less than 2^-42; the rest is room. Bounds.
inline constexpr double kFoundError = 0x1p-40;
/// The greatest error that is accepted, where boundaries part so slowly from the sphere about the position that the
/// search ends before. Decides whether there is an answer: beyond it the value is refused, never wrong.
inline constexpr double kMostFoundError = 0x1p-32;
/// By how much B may protrude and still fit: twice kDistanceNoise. Decides: a position at which B protrudes by less
/// counts as one at which it fits. The value is off by less than kUnionFitError; where B fits only without clearance,
/// it may count as fitting though it does not.
inline constexpr double kFits = 0x1p-45;
/// Cells of positions at which B fits are not divided below this, 2^3 times kFits: how far B protrudes is known to
/// kFits only, and a smaller cell shows no slope. Bounds.
inline constexpr double kSmallestFitCell = 0x1p-42;
/// What is better than the best fit by less is not looked for. Each cell takes a search of its own, so this trades 2^6
/// times kNearerAtAll for six divisions less. Bounds.
inline constexpr double kNearerFit = 0x1p-37;
/// What a fit found by search may be off: twice kNearerFit. Bounds.
inline constexpr double kUnionFitError = 0x1p-36;
/// How exactly it is searched at first how far B protrudes at the corners of a cell. Searches.
inline constexpr double kRoughCorner = 0x1p-6;
/// Of the spread of the columns: what the simplex method may lose, 2^8 roundings in some ten steps. Bounds.
inline constexpr double kLpNoise = 0x1p-44;
/// Of the shift that makes all entries positive: the two players' values are as good as equal. Searches: each is a
/// bound by itself.
inline constexpr double kLpClose = 0x1p-48;
/// A column that helps by less does not enter the basis: half of kLpClose. Searches.
inline constexpr double kLpHelps = 0x1p-49;
/// A pivot below this would leave a basis made of rounding, so it is not taken. Searches.
inline constexpr double kLpPivot = 0x1p-30;
/// The slack of two solids is bracketed to this, below the noise of the slack itself. Searches.
inline constexpr double kMeetEnough = 0x1p-48;
/// Of the value: a max-min value is proven to this; 2^5 times kDistanceNoise, so that cells end before noise. Bounds.
inline constexpr double kMaxMinNear = 0x1p-41;
/// Vertices whose distances are this much less than the greatest cannot be the farthest: 2^6 times kDistanceNoise.
/// Filters: the others are compared exactly.
inline constexpr double kFarCorner = 0x1p-40;
/// Normals that differ by this are one normal, and faces whose size is this small, of their edge, are none: 2^6 times
/// the noise of a cross product. Filters: a plane that is left out is another one within the noise, which bounds the
/// same side; so the gap changes by less than kFoundError.
inline constexpr double kSameNormal = 0x1p-40;
/// Within this of a core the slope of the distance is rounding. Bounds: there 0 is stated, which is a subgradient too.
inline constexpr double kNoSlope = 0x1p-40;
/// A point deeper in a ball than this, of its radius, is not on its surface. Searches: it chooses a tetrahedron.
inline constexpr double kInsideBall = 0x1p-20;
/// Squared sines below this are those of parallel planes: a crossing of such planes is known to no digit, as its error
/// is kDistanceNoise over the square. Filters: places on these planes are found with others.
inline constexpr double kParallelPlanes = 0x1p-60;
/// Factor over how far a line may be from the middle of a box to meet it. Filters: it keeps more lines.
inline constexpr double kLineReach = 1 + 0x1p-20;
/// What the projection on planes may be off beside what its plane equations are. Bounds; half of kDistanceNoise.
inline constexpr double kProjectionNoise = 0x1p-47;
/// A place beyond a set by this is out of it; nearer ones are asked of the set's exact planes. Filters.
inline constexpr double kOutOfSet = 0x1p-30;
/// A coordinate this near to a simple fraction may be that fraction. Filters: the place is checked by exact predicates.
inline constexpr double kEvenPlace = 0x1p-36;
/// Boxes that are searched are widened by this, so that what lies on their border is inside. Searches.
inline constexpr double kAroundBox = 0x1p-30;
/// Sets in which a place is less deep by this than in the deepest cannot have the nearest boundary. Filters: the others
/// are computed exactly.
inline constexpr double kDeepestSets = 0x1p-40;
/// The sine of the angle of unit normals: below it the planes share a direction. Filters: the dual simplex then goes on
/// with fewer planes, or exactly.
inline constexpr double kDependentNormals = 0x1p-40;
/// The sine of the angle of two planes that make an edge: where it is more, the edge is off by less than 2^-36, as
/// planes are by kRoundings4. Filters: places near sharper edges are found between exact corners.
inline constexpr double kSharpEdge = 0x1p-16;
/// The sine of the angle of two unit normals that is rounding: the planes are parallel, and make no edge. Filters.
inline constexpr double kParallelSine = 0x1p-48;
/// Of the box: a least value over a box is bracketed to this; each value is exact, and as many as this allows are
/// taken. Bounds.
inline constexpr double kLeastInBox = 0x1p-30;
/// Of the size: the secant of a convex function begins so far before the line. Searches; a shorter way is lost in
/// noise.
inline constexpr double kSecantStart = 0x1p-10;
/// Of a tetrahedron's faces: a box beyond a face by less may still meet it; normals of flat ones are off by 2^-44 of
/// their factors, and sums by more. Filters: the box is kept.
inline constexpr double kFacePlane = 0x1p-40;

// -- solid: two bodies

/// Of their distance: witness points whose distance differs from the value by more are those of another value, so that
/// their direction is no slope. Searches: a value without slope ends the search by tangents.
inline constexpr double kWitnessAgrees = 0x1p-40;
/// A least value is proven where tangents come this near to it. Bounds.
inline constexpr double kTangentsMeet = 0x1p-40;
/// What a tangent, or the linear program of tangents, may be off: 2^2 times kPlaceNoise. Bounds.
inline constexpr double kTangentNoise = 0x1p-42;
/// Where tangents stay farther apart than this the next way is tried. Searches.
inline constexpr double kTangentsApart = 0x1p-36;
/// Values found by search are right to kFoundError, so one that is less by this is not better than that of a likelier
/// place. Searches: it chooses among positions, each with its own value.
inline constexpr double kNoBetter = 0x1p-38;
/// Planes this near to touching a ball are said to touch it: of the radius, and of kTouchedOfSize of the coordinates.
/// Searches: the exact place that they give counts by its own value.
inline constexpr double kTouchedPlane = 0x1p-24, kTouchedOfSize = 0x1p-20;
/// The box in which the exact deepest place is looked for. Searches.
inline constexpr double kLikelyBox = 0x1p-20;
/// Coordinates this near to a simple fraction are taken for it. Searches: the place counts by its own value.
inline constexpr double kSimpleCoordinate = 0x1p-24;
/// Pairs of vertices whose distance is less than the greatest by this, relative, cannot be the farthest: 2^7 roundings.
/// Filters: the others are compared exactly.
inline constexpr double kFarthestTie = 0x1p-46;

// -- rays: sign maps on lines

/// Of the size: within this of its level a function by values has sign 0, so an end of a stretch is known to this.
/// Bounds: signs beyond it are certain.
inline constexpr double kRayCertain = 0x1p-30;
/// The same where a line runs along the boundary, and finer values would not end. Bounds.
inline constexpr double kRayCoarse = 0x1p-16;
/// What a value on a line, or the chord of a ball, may be off: 2^2 times kPlaceNoise. Bounds.
inline constexpr double kRayNoise = 0x1p-42;
/// Bounds of a depth this near to each other are one value: 2^2 times kRayNoise. Searches.
inline constexpr double kBoundsMeet = 0x1p-40;
/// A line whose direction has so small a cosine with a normal runs along the face. Filters: the face then bounds
/// nothing on the line, which only keeps more of it.
inline constexpr double kAlongFace = 0x1p-40;
/// Share of its value that a search for the nearest place has to reach where it is used to go on from. Searches: steps
/// are shorter, and searches end earlier.
inline constexpr double kLineShare = 0x1.8p-1;

// -- surface: large meshes by their surfaces

/// Of the radius: a box this large has many triangles, so only few are searched before it is divided. Searches.
inline constexpr double kLargeShare = 0x1p-4;
/// What is better than the best contact by less is not looked for: places of contact are found exactly, so this covers
/// the keys of boxes alone. Bounds.
inline constexpr double kContactSlack = 0x1p-40;
/// The greatest error of a contact that is accepted. Decides whether there is an answer: beyond it none is given.
inline constexpr double kMostContactOff = 0x1p-36;
/// No box of contacts is divided below this. Bounds.
inline constexpr double kSmallestContactBox = 0x1p-38;
/// Of B's box: the box of positions is widened by it, as both bodies may be as large. Searches.
inline constexpr double kAroundContacts = 0x1p-6;
/// What a depth may be off: twice kPlaceNoise. Bounds: a box is said to overlap only if deeper by more.
inline constexpr double kDepthNoise = 0x1p-43;
/// Of the radius: a ball this near to touching the surface is no longer shrunk. Searches.
inline constexpr double kBallTouches = 0x1p-10;
/// Of the radius: an inner ball is taken smaller by this, 2^14 times the noise of a distance. Bounds.
inline constexpr double kBallShrunk = 0x1p-30;
/// Of the sum of the six terms of a volume: 2^4 roundings. Filters: nearer to 0 there is no sign, and another way is
/// taken to tell inside from outside.
inline constexpr double kVolumeNoise = 0x1p-48;
/// Factor over a distance that is known, up to which boxes are looked at. Searches: a greater one looks at more.
inline constexpr double kKnownReach = 1 + 0x1p-30;

// -- csg: solids that others are cut out of; relative to the size, the farthest coordinate of the pair

/// A part of which no place is deeper has no interior that doubles can see: its faces are off by kDistanceNoise each.
/// Decides: a thinner part counts as empty. Its places are then within 2^-44 of the size of those of its neighbours, or
/// are left out, which loses a wall thinner than that.
inline constexpr double kNoInterior = 0x1p-44;
/// An overlap that is less deep counts as none: 2^4 times kDistanceNoise, as a depth is found from four planes.
/// Decides: a position with a shallower overlap counts as free; the depth stated there is off by less than kFoundError.
inline constexpr double kNoDepth = 0x1p-42;
/// Depths below this are not told from none on the lines by which positions are looked for. Searches.
inline constexpr double kDepthOnLines = 0x1p-32;
/// Where boxes are apart by this, their distance is enough of a lower bound. Searches.
inline constexpr double kFarByBoxes = 0x1p-4;
/// Share of its value that a bound has to reach where it is only used to go on from: steps are at least half of the
/// distance. Searches.
inline constexpr double kRoughShare = 0x1p-1;
/// The box of a part is widened by this, so that what lies on its border is inside. Searches.
inline constexpr double kAroundPart = 0x1p-40;
/// Factor over the depth up to which boxes along a line are looked at. Searches: a greater one looks at more.
inline constexpr double kNearReach = 1 + 0x1p-10;
/// A closed form whose place is this near to the one found may be its name. Filters: it has to belong, exactly, and its
/// value has to agree with the one found.
inline constexpr double kNamedPlace = 0x1p-16;
/// Of a cell: slack of which less is not decided; where a deeper place is looked for again; places of one deepest
/// place. Searches: all three trade cells for cuts.
inline constexpr double kSlackOfCell = 0x1p-4, kDeeperAgain = 0x1p-1, kOneDeepest = 0x1p-2;
/// Factor by which a place has to be deeper to go on from it. Searches.
inline constexpr double kDeeper = 1 + 0x1p-7;
/// Of a box: the tetrahedron about it begins so far before its corner. Searches: it only has to hold the box.
inline constexpr double kAroundTetrahedron = 0x1p-8;
/// The cube about a position that is searched is widened by this, so that it holds a free position. Searches.
inline constexpr double kAroundCube = 0x1p-20;

// ---- formula ----------------------------------------------------------------------------------------------------

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
/// Degrees, and of the size: a search of the best position ends this near to it. Searches: the bound is stated.
inline constexpr double kBestDegrees = 1e-7;
inline constexpr double kBestPart = 1e-9;
/// Of a value over angles, absolute or of the value and one: some 2^23 roundings, more than values of rotated shapes
/// are off. Bounds: angles with such a value are possible best ones; whether a pose is one of them is refused.
inline constexpr double kBestOfAngles = 1e-9;
/// Of a number of degrees, relative to it and 1: some thousand roundings of degrees up to 360, more than the angle of a
/// contact loses (rotation.h says 1e-13). Bounds: it is the stated error.
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
