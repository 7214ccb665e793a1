// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which places of two boundary paths have one tangent direction, and in what order they are passed: the convolution
// without its coordinates. Its curves are nodes (place in a, place in b): a line of one side with a turn of the other,
// or two turns, one of them an arc. Nodes follow each other in closed walks; pairs of turns that stay at one point
// are walked through. Guarantee: exact. Cost: O(nodes), a search a turn. Source: convolution.h, which alone uses this.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "plane/sum/turning_path.h"

namespace findspace::plane {

struct ConvolutionNode {
  enum class Kind : std::uint8_t { kLine, kArc };  // line of `side` x turn of the other side; turn x turn

  Kind kind;
  std::uint8_t side;       // kLine: whose line
  bool forward = true;     // true direction of travel is that of the common tangent; displaced side accordingly
  bool turns_left = true;  // kArc: directions run counter-clockwise
  bool smooth_start = false, smooth_end = false;
  std::int8_t rotation = 0, extra = 0;  // at its end: as of a Corner
  Index at[2] = {0, 0};                 // the turns; kLine: at[side] is the line
  Index key_in = 0, key_out = 0;        // kArc: directions at its start and end; kLine: both the line's key
  Index next = kNone;
  // Where it lies, filled in by who gives the nodes coordinates.
  Index start = kNone, end = kNone;  // points
  Index supporting_curve = kNone, piece = kNone;
};

class ConvolutionNodes {
 public:
  using Node = ConvolutionNode;
  using Kind = Node::Kind;
  using Line = TurningPath::Line;
  using ExactAngle = TurningPath::ExactAngle;

  /// A walk that stays at one point, the sum of the centres of two turns: an arc against one of the same radius and
  /// their neighbours, round and round.
  struct Still {
    Index at[2];
    int rounds;  // of the displaced path about the point
  };

  /// `keys`: of both paths' directions (assign_keys).
  ConvolutionNodes(const TurningPath& a, const TurningPath& b, Index keys);

  std::vector<Node> nodes;
  std::vector<Still> stills;

  const ExactAngle& turn(int side, Index at) const { return side_[side]->turns[at]; }
  const Line& line_of(const Node& n) const { return side_[n.side]->lines[n.at[n.side]]; }
  const ExactAngle& turn_of(const Node& n) const { return turn(1 - n.side, n.at[1 - n.side]); }
  const Direction& direction_at(const Node& n, Index key) const;

 private:
  struct Range {               // the lines whose keys a turn of the other side sweeps
    Index first, count, base;  // places in `sorted`; first node
  };

  Index minus(Index p, Index q) const { return p >= q ? p - q : p + keys_ - q; }
  Index plus(Index p, Index q) const { return p + q >= keys_ ? p + q - keys_ : p + q; }
  static std::uint64_t pair_key(Index i, Index j) { return (std::uint64_t(i) << 32) | j; }
  Index high(const ExactAngle& t) const { return plus(t.low, t.length); }

  /// Finds the lines of side s that meet the turns of the other side; how many there are.
  Index count_lines(int s);
  /// Lines of side s with the turns of the other side.
  void add_lines(int s);
  Index line_node(int s, Index line, Index turn) const;
  void add_arcs();
  void add_arc(Index i, Index j);
  /// Finds the node that follows in the true direction of travel, and how much the direction turns on the way.
  void connect(Index k);
  /// If the turn pair is a curve of its own, it follows node k.
  bool to_arc(const Index turns[2], Index key, std::int64_t turned, Index k);
  /// Leaves a turn pair, a single place unless `moved`, at the first end of one of its two intervals in the direction
  /// of movement. `moved`: the pair is a curve, and its end has been reached.
  void step_out(Index turns[2], Index key, bool left, std::int64_t turned, Index k, bool moved);
  /// Walks that stay at one point: an arc against one of the same radius and their neighbours, round and round. The
  /// displaced path circles the point.
  void add_still_walks();
  void follow(Index from, Index to, Index key, std::int64_t turned);
  const Direction& direction_of(const Node& n, Index key) const;
  /// Whole rounds that the displaced path at the corner makes beyond what its two ends show (see Corner).
  std::int8_t extra_rounds(const Node& in, const Node& out, Index key, std::int64_t turned) const;
  /// Sign of the sum of the curvatures, positive to the left of the direction of travel: where the path turns back,
  /// which of its two ends lies to the left of the other.
  int bend_sum(const Node& in, const Node& out) const;

  const TurningPath* side_[2];
  Index keys_;
  std::vector<Range> ranges_[2];  // of the lines of a side, per turn of the other
  std::unordered_map<std::uint64_t, Index> arc_node_;
  std::vector<std::array<Index, 2>> still_;   // pairs of arcs of one radius: curves of length 0 that turn
  std::unordered_set<std::uint64_t> passed_;  // pairs walked through; kept only if there are such arcs
  std::array<Index, 2> loop_start_{kNone, kNone};
  std::int64_t loop_turned_ = 0;
};

}  // namespace findspace::plane
