// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the layer `distance` in the plane, by street. Each says what it covers and does, in the words of
// rounding.h.
#pragma once

namespace findspace::margin {

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
/// A place this near to the boundary is not decided to be in or out by doubles: 2^7 roundings. Filters.
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
/// Of a found place's error: parts of A that meet at the exact place are at most this farther from the found one; twice
/// the error for the place and for each of two distances, and 2^2 to spare. Filters: all of them are tried.
inline constexpr double kMeetingTolerance = 8;
/// Of the width in which an extremum lies, and of the mean of that and the size: a place where level curves touch moves
/// by the root of the width. Filters: level curves that pass nearer are candidates, which are compared exactly.
inline constexpr double kCandidateCurves = 4;
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
/// Factor: exact distances that were rounded once, each by 2^-52 of itself, and differ by less may be equal. Filters:
/// of places that differ by less the first is taken.
inline constexpr double kRoundedOnce = 1 - 0x1p-50;
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
inline constexpr double kBracketSlack = 0x1p-30;
/// What the numbers of a bracket that is known may be off, and bounds that say where maps are made; the sign maps at
/// both ends are exact. Searches and bounds.
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

// -- rotation: shapes that rotate, over angles and time

/// Degrees: an extremum over time is searched until its bounds are this near. Searches: the bounds are stated.
inline constexpr double kCloseExtremum = 1e-6;
/// Degrees: the angle of a place of the circle takes an arc tangent and a product, some 360 * 2^-50 off; the margin is
/// 2^5 times that. Bounds: values over angles are widened by it.
inline constexpr double kRoundingOfAngle = 1e-11;

}  // namespace findspace::margin
