// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed convolution of boundary paths: for every pair of boundary places with one tangent direction the sum of the
// two places. Its curves are the candidates for the boundary of a Minkowski sum, and its winding number at p, taken on
// the displaced curves, is the Euler characteristic of A n (p - B). A path is a sequence of lines (one direction) and
// turns (an interval of directions about a centre: a vertex, or an arc with its signed radius); a line meets a turn
// in a translated line, two turns meet in an arc of the summed radius. Guarantee: exact; equal directions are decided
// apart by turning B by an infinitesimal. Cost: O((n+m) log(n+m) + curves) for polygons. Source: Guibas, Ramshaw,
// Stolfi 1983; Wein 2006 for arcs. Keywords: convolution cycles, kinetic framework.
#pragma once

#include <array>

#include "exact/planar/curve_reals.h"
#include "plane/complex/boundary.h"
#include "plane/complex/piece_builder.h"
#include "plane/complex/winding.h"

namespace findspace::plane {

/// The reals of curves that are made one after the other.
class SharedReals {
 public:
  /// With this radius or displacement: those of an earlier curve where they are the same.
  const exact::CurveReals& of(const exact::Real& w);

 private:
  std::array<exact::CurveReals, 2> known_{};  // the last ones: lines of one disc have its radius and its opposite
};

/// Collects the convolutions of many pairs of parts, to be arranged at once; their winding numbers add up.
class ConvolutionBuilder {
 public:
  /// `inward`: curves are thought displaced towards the inside, as for open sums; else outward, as for closed ones.
  explicit ConvolutionBuilder(bool inward) : inward_(inward) {}

  void add(const Part& a, const Part& b);
  /// Room for so many more curves: lists that grow are copied, and both are there.
  void reserve(std::size_t more);

  PieceBuilder curves;
  std::vector<Chain> chains;  // per piece of `curves`
  std::vector<Corner> corners;
  std::vector<Index> points;  // sums of two lonely points
  /// Points that a displaced path of length 0 circles (an arc inside one of the same radius): they are single cells of
  /// the sum, and their winding number is that of the face around plus `rounds`.
  struct Circled {
    Index point;
    int rounds;
  };
  std::vector<Circled> circled;

 private:
  friend class PathPair;
  bool inward_;
  SharedReals shared_;
};

}  // namespace findspace::plane
