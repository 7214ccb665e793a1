// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sets of positions of minkowski.h of two sets bounded by grid segments, asked about one place at a time:
//   contact:     U = {p : int A meets int (B + p)};
//   containment: L = {p : B + p leaves A} = {p : the complement of A meets int (B + p)}.
// Guarantee: as of the maps of minkowski.h. Cost: prepared in O((n + m) log(n + m)); then that of convolution_index.h
// and window_sum.h. Threads: safe once made. Keywords: lazy Minkowski sum.
#pragma once

#include <memory>

#include "plane/grid/window_sum.h"
#include "plane/sum/pair_sums.h"

namespace findspace::plane {

class LocalSum {
 public:
  /// Null unless both sets are bounded by grid segments and have no part without interior. References are kept.
  static std::shared_ptr<const LocalSum> contact(const Region& a, const Region& b);
  static std::shared_ptr<const LocalSum> containment(const Region& a, const Region& b);

  LocalSum(const LocalSum&) = delete;
  LocalSum& operator=(const LocalSum&) = delete;

  /// Outside, everything is in the set, or nothing is; without bounds this is so everywhere.
  const std::optional<GridBox>& bounds() const { return bounds_; }
  bool holds(const exact::RealPoint& p) const;
  const ConvolutionIndex& index() const { return index_; }
  /// Whether at least so many of the index's curves at convex corners lie in the box, as far as convex faces tell
  /// without them. Cost: linear in the faces.
  bool surely_has(std::size_t curves, const GridBox& w) const;
  /// -1 on the set, as of window_sum. `surely` may say that a place, given by numbers, is in the set.
  SignMap map(const GridBox& w, std::span<const ConvolutionIndex::Curve> curves,
              const std::function<bool(const exact::Point&)>& surely = {}) const;

 private:
  LocalSum(Operand a, Operand b, GridFaces p, GridFaces q);
  static std::shared_ptr<const LocalSum> made(Operand a, Operand b);

  /// Convex faces.
  struct Convex {
    GridBox box;  // around all
    std::size_t faces, corners;
  };
  static std::vector<Convex> convex_faces(const GridFaces& faces);

  Operand a_, b_;
  GridFaces p_, q_;
  ConvolutionIndex index_;
  std::optional<GridBox> bounds_;
  std::vector<Convex> many_;     // each of the set that has more faces
  std::optional<Convex> few_{};  // all of the other one
};

}  // namespace findspace::plane
