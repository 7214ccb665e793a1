// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps of a T-distance f in the few small windows where it can be as good as a level: each made of the features
// that count there (TDistance::near). Guarantee: for levels no worse than the windows are said to hold, the positions
// of a set at the level, and beyond it, are the same cells as by maps of the whole plane. Cost: that of small maps.
// Keywords: locality, clipping.
#pragma once

#include <optional>
#include <vector>

#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

class LevelWindows {
 public:
  /// `closed`: what probes are mostly about; both are kept as references. `rotation`: +1 where less is better, -1 where
  /// more is.
  LevelWindows(const TDistance& f, const plane::Region& closed, int rotation)
      : f_(&f), closed_(&closed), rotation_(rotation) {}

  /// All positions as good as the level lie in the boxes: windows are opened there, if small maps cost less than those
  /// of the whole plane. `least`, times the rotation: no better levels are likely to be asked for.
  void open(std::vector<plane::PieceBox> boxes, const exact::Real& level, double least);
  /// Whether the windows hold all positions as good as the level.
  bool hold(const exact::Real& level) const;
  /// As level_probe.h, for a level that they hold; nothing where there is no gain after all.
  std::optional<plane::CellComplex> probe(const exact::Real& level, const plane::Region& over);
  /// All positions as good as `level` are those with marks: the windows become smaller if that is worth it.
  void shrink(const plane::CellComplex& probed, const exact::Real& level, double least);

 private:
  struct Window {
    plane::PieceBox box;
    plane::Region filled, closed;  // the box; the part of the closed set in it
    TDistancePointer f;
  };

  /// Boxes that hold all positions as good as the level.
  struct Stage {
    std::vector<plane::PieceBox> boxes;
    exact::Real level;
  };

  bool place(double least);
  double first(const exact::Real& level) const;
  double last(const exact::Real& level) const;
  bool holds(const Stage& stage, const exact::Real& level) const;

  const TDistance* f_;
  const plane::Region* closed_;
  int rotation_;
  std::vector<Stage> stages_;    // each within the one before
  std::vector<Window> windows_;  // of the last stage
  double least_ = 0;             // from this level on, times the rotation, the windows' functions are made
};

}  // namespace findspace::distance
