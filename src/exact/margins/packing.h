// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The margins of searches in doubles whose results are proved exactly afterwards (src/packing). Most are relative
// to the size of the strip. They search: too large or too small, they cost density or time, never a proof.
#pragma once

namespace findspace::margin {

/// A shallower overlap counts as none: 2^20 times what the depth of an overlap in doubles is off. A linear program
/// moves the parts out of it before the proof. Searches.
inline constexpr double kNoOverlap = 1e-9;
/// Boxes in single precision are this much larger on each side: four roundings of 2^-24 of the longer side.
inline constexpr double kBoxRounding = 0x1p-22;
/// What a linear program may leave of a violated row; as near to Clp's own tolerance for primal values, 1e-9, as it can
/// be. Searches: what is left is taken back on the grid of the layout.
inline constexpr double kProgramTolerance = 1e-9;
/// The grid on which finished layouts stand is no coarser than this: what the program above may leave. Searches.
inline constexpr double kLayoutGrid = 1e-9;
/// A part of an edge this short or this near behind a half-plane needs no half-plane of its own: a tenth of the overlap
/// that counts as none. Searches.
inline constexpr double kPieceLeft = 1e-10;
/// A compaction ends where it gains less than this: a thousandth of a percent, far below what one more round of search
/// finds. Searches.
inline constexpr double kCompactionGain = 1e-5;
/// How far the corners that make an edge of a no-fit polygon may be off its line, of the height of the strip: a
/// thousand times what programs leave; of arcs the tangents and chords that stand for them. A rotation to first order
/// needs no more. Searches.
inline constexpr double kTilt = 1e-6, kTiltOfArcs = 1e-3;
/// Two unit normals are one where their product is within this of 1: 40 millionths of a radian, where roundings of
/// corners turn short edges by some millionths. Searches.
inline constexpr double kTiltDirection = 0x1p-30;
/// What the way of a part's farthest corner costs beside the length when parts are tilted: so little that it changes no
/// length worth having, and enough that no part rotates for nothing. Searches.
inline constexpr double kCostOfTilt = 1e-3;
/// Tilts by steps of a smaller part of the height are not tried, steps that gain less than the second number of the
/// length are made smaller, and rounds that gain less than the third are the last. Found by trial. Searches.
inline constexpr double kLeastTilt = 1e-4, kTiltGain = 2e-4, kTiltRoundGain = 1e-3;

/// Solids this near count as touching where directions along contacts are chosen; of the floor. A thousand times what
/// programs leave. Searches.
inline constexpr double kSolidContact = 1e-6;
/// Conditions of pairs hold by this much in the search; of the floor. A hundred steps of the grid on which finished
/// layouts stand, so that they hold there, too. Searches.
inline constexpr double kSolidTie = 1e-7;
/// A plane whose unit normal has less than this along a line does not end what lies on the line: 2^12 roundings.
/// Searches.
inline constexpr double kAlongPlane = 0x1p-40;

/// No layout is lower than the best by more than this, of its height, where that is proved: a hundred times what the
/// shaken goal below leaves. Decides what is called proved, and is stated with it.
inline constexpr double kHeightProof = 1e-7;
/// The goal of such a proof is shaken by this, so that no two exchanges of rows are equally good; a row that lacks less
/// of the floor holds at a vertex; a row with a smaller part in another one does not take its place. The bound that
/// follows is right for any of them. Searches.
inline constexpr double kHeightShake = 1e-9, kHeightRow = 1e-9, kHeightPivot = 1e-9;

/// Grid steps: an item is moved no farther, so that sums of fractions stay within 127 bits. Bounds: refused beyond.
inline constexpr double kFarthestItem = 0x1p100;

}  // namespace findspace::margin
