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
  /// All positions as good as the level `most` lie in the boxes. `least`, times `rotation`: no better levels are likely
  /// to be asked for. `rotation`: +1 where less is better, -1 where more is. Nothing where windows have no gain.
  /// `closed`: what probes are mostly about; it is kept as a reference, as f is.
  static std::optional<LevelWindows> of(const TDistance& f, const plane::Region& closed, int rotation,
                                        std::vector<plane::PieceBox> boxes, double least, const exact::Real& most);

  /// Whether the windows hold all positions as good as the level.
  bool hold(const exact::Real& level) const;
  /// As level_probe.h, for a level that they hold; nothing where windows cannot tell.
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

  LevelWindows(const TDistance& f, const plane::Region& closed, int rotation)
      : f_(&f), closed_(&closed), rotation_(rotation) {}
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
