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
  /// The fixed edges (by their places in the net) that a rotated edge certainly crosses, if it meets nothing else.
  std::optional<std::vector<Index>> crossed(const RotatedEdge& e) const;

 private:
  struct Line {
    RoughPoint p, q;
    RoughBox box;  // with tolerance
    bool arc;
  };
  bool is_near(const Line& f, RoughPoint at) const;

  std::vector<RoughPoint> vertices_, now_;  // of the rotating net; in the pose
  std::vector<Line> lines_;                 // of the fixed one
  std::vector<RoughPoint> alone_;           // its isolated vertices
  double reach_ = 0, tolerance_ = 0;
};

}  // namespace findspace::plane
