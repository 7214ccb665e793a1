// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A filter in doubles for one net of vertices and edges that is rotated and moved over another: which vertices are
// certainly off all of the other's edges, and which edges certainly cross what at inner points, and touch nothing else.
// At nearly every angle only one or two contacts are not certain. Guarantee: what is called certain is right: the
// tolerance is a thousand times what doubles lose; the rest says nothing and is decided exactly elsewhere. Arcs are
// left to that. Cost: pairs of edges, some nanoseconds each. Keywords: floating point filter, rotation.
#pragma once

#include <optional>

#include "exact/planar/angle.h"
#include "plane/rotation/rotated_edges.h"
#include "plane/rotation/rough_overlap.h"

namespace findspace::plane {

class RoughContact {
 public:
  /// Both relative to the centre of the rotation.
  RoughContact(const RotatedNet& rotating, const RotatedNet& fixed);

  /// The pose that the questions below are about.
  void set(const exact::ExactAngle& angle, const RealVector& shift);
  /// A vertex in the pose, if it is certainly off all edges and vertices that stand still.
  std::optional<RoughPoint> clear(Index vertex) const;
  /// The fixed edges (by their places in the net) that a rotating one certainly crosses, if it meets nothing else.
  std::optional<std::vector<Index>> crossed(const Edge& e) const;
  /// Contains a fixed edge.
  const RoughBox& fixed_box(Index place) const { return lines_[place].box; }

 private:
  struct Line {
    RoughPoint p, q;
    RoughBox box;
    bool arc;
  };
  bool is_near(const Line& f, RoughPoint at) const;
  /// A vertex in the pose.
  RoughPoint now(Index vertex) const { return rotation_ * vertices_[vertex] + shift_; }

  std::vector<RoughPoint> vertices_;  // of the rotating net
  std::vector<Line> lines_;           // of the fixed one
  std::vector<RoughPoint> alone_;     // its isolated vertices
  RoughPoint rotation_, shift_;
  double reach_ = 0, tolerance_ = 0;
};

}  // namespace findspace::plane
