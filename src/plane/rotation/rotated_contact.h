// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A closed set T that rotates about a point, against a marked complex M that stands still: which marks of M does T meet
// at an angle? With M the sign map of a distance that answers "do they meet, do their insides meet, does T lie in ...",
// at a level too.
//
// Guarantee: exact at every angle of exact cosine and sine, so also at the angles where the answer changes, which are
// found all: a vertex of one on a line or circle of the other, a line tangent to a circle, two circles tangent, each is
// a cos + b sin = c; an isolated contact is not a limit of its neighbours and is evaluated by itself
// (distances.md 7.2). Method: T's edges are cut where they meet M's edges and vertices; each piece lies in one cell of
// M, found exactly; components of equal mark that no edge of T meets are inside T or not, decided at one point; what
// doubles are certain of (rough_contact.h) is not computed. Cost: one angle: pairs of edges in doubles, exact work for
// those that touch or have arcs; the angles: pairs of edges. Keywords: contact angle, critical orientation, rotational
// sweep.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/query/locate.h"
#include "plane/rotation/rotated_edges.h"
#include "plane/rotation/rotation_map.h"
#include "plane/rotation/rough_contact.h"

namespace findspace::plane {

/// A set of marks: bit 0 for -1, bit 1 for 0, bit 2 for +1.
using MarkSet = unsigned;
inline constexpr MarkSet kNegative = 1, kZero = 2, kPositive = 4;

class RotatedContact {
 public:
  /// A pair of sets: T = { to + rotated(b - about) : b in `rotating` }, closed, marks 0/1, and a map with marks -1, 0,
  /// +1. Lengths in grid steps.
  struct Pair {
    const Region& rotating;
    const SignMap& fixed;
    exact::RealPoint about, to;
  };
  /// The regions must outlive this.
  explicit RotatedContact(const Pair& pair);

  /// The angles at which the marks met can change, ascending, each once; more than those, but finitely many.
  std::vector<exact::ExactAngle> events() const;
  /// The marks met at an angle by T moved by `shift`; the search ends as soon as one of `enough` is found. One thread
  /// at a time.
  MarkSet marks_met(const exact::ExactAngle& angle, MarkSet enough = 0, const exact::RealPoint& shift = {});
  /// Exact steps that the last look took: of edges without an arc, and of those with one.
  struct Steps {
    long lines = 0, arcs = 0;
  };
  const Steps& steps() const { return steps_; }
  /// rule(marks met) at the angles of a set; `enough` as above. Threads: uses several.
  static RotationMap rotation_map(const Pair& pair, Mark (*rule)(MarkSet), MarkSet enough,
                                  const RotationMap& within = RotationMap::uniform(1));

 private:
  /// A point of each bounded component of that mark, relative to `to`. Made when a look first needs them.
  const std::vector<RealVector>& samples(Mark m);
  /// A vertex and an edge of T in the pose looked at.
  const RealVector& vertex(Index v);
  RotatedEdge edge(Index e);
  Cell cell_of(Index vertex);
  void meet_edge(const RotatedEdge& e, MarkSet& met, MarkSet enough);
  MarkSet marks_inside(MarkSet met);

  const Region& rotation_;
  const SignMap& fixed_;
  RealVector about_, to_;
  RotatedNet net_, fixed_net_;
  std::vector<RoughPoint> fixed_vertices_;
  std::array<std::optional<std::vector<RealVector>>, 3> samples_;  // of the marks -1, 0, +1
  RoughContact rough_;
  // Of the pose looked at:
  exact::ExactAngle angle_;
  RealVector shift_;
  std::vector<Index> place_;         // of T's vertices: among those that were needed
  std::deque<RealVector> vertices_;  // these
  std::vector<char> in_face_;        // which of T's vertices lie in faces of M
  Steps steps_;
  bool unbounded_ = false;
  Locator locate_rotation_, locate_fixed_;
};

}  // namespace findspace::plane
