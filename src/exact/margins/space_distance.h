// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the layer `distance` in space, by street. Each says what it covers and does, in the words of rounding.h.
#pragma once

namespace findspace::margin {

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
/// kDistanceNoise, as a search that asked for more would not offer places on boundaries. Searches in position_set.cpp,
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
/// Of kFoundError: two searches for one value are off by one of it each, in place and in value, and their difference
/// by four; four times that. Searches: values nearer to each other are taken for one, and the exact one of them is
/// said.
inline constexpr double kSearchesAgree = 16;
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
/// with fewer planes, or by facets.
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

/// Of the coordinates: what a distance in doubles may be off beside edges as sharp as kSharpEdge (convex_distance.h),
/// twice. Bounds: what is said to hold the value is wider by it.
inline constexpr double kNumbersOff = 0x1p-35;
/// Of their distance: witness points whose distance differs from the value by more are those of another value, so that
/// their direction is not a slope. Searches: a value without slope ends the search by tangents.
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
/// Of unit normals: planes this near to parallel are taken for one where the end of a stretch is looked for, and what
/// breaks a rule by less, of the step, keeps it. Searches: the place found is tested.
inline constexpr double kEndPivot = 0x1p-20;
/// Of the size: half of what a slope is the difference over. Searches.
inline constexpr double kSlopeStep = 0x1p-20;
/// Of the sizes: what the nearest step is to an end that is looked for. Searches.
inline constexpr double kEndReach = 0x1p-27;
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

// -- csg: solids that others are cut out of; relative to the size, the farthest coordinate of the pair

/// A part of which no place is deeper has no interior that doubles can see: its faces are off by kDistanceNoise each.
/// Decides: a thinner part counts as empty. Its places are then within 2^-44 of the size of those of its neighbours, or
/// are left out, which loses a wall thinner than that.
inline constexpr double kNoInterior = 0x1p-44;
/// An overlap that is less deep counts as none: 2^4 times kDistanceNoise, as a depth is found from four planes.
/// Decides: a position with a shallower overlap counts as free; the depth stated there is off by less than kFoundError.
inline constexpr double kNoDepth = 0x1p-42;
/// Depths below this are not distinguished from none on the lines by which positions are looked for. Searches.
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
/// Of the size: how near value and bound of the deepest overlap of two solids need come. Each place takes a search of
/// its own. Bounds: what is left is said.
inline constexpr double kDeepestGap = 0x1p-12;
/// The cube about a position that is searched is widened by this, so that it holds a free position. Searches.
inline constexpr double kAroundCube = 0x1p-20;

}  // namespace findspace::margin
