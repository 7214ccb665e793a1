// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which places of two boundary paths have one tangent direction: the curves of the convolution without coordinates. A
// curve is a node (place in a, place in b): a line of one side with a turn of the other, or two turns, one of them an
// arc. convolution_walks.h joins them. Guarantee: exact. Cost: O(nodes), a search a turn. Source: convolution.h.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "plane/sum/tracing.h"

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
  Index supporting_curve = kNone;
};

class ConvolutionNodes {
 public:
  using Node = ConvolutionNode;
  using Kind = Node::Kind;
  using Line = Tracing::Line;
  using Turn = Tracing::Turn;

  /// `keys`: of both paths' directions (assign_keys).
  ConvolutionNodes(const Tracing& a, const Tracing& b, Index keys);

  std::vector<Node> nodes;
  /// Pairs of arcs of one radius: curves of length 0 that turn.
  std::vector<std::array<Index, 2>> still;

  const Tracing& side(int s) const { return *side_[s]; }
  const Turn& turn(int s, Index at) const { return side_[s]->turns[at]; }
  const Line& line_of(const Node& n) const { return side_[n.side]->lines[n.at[n.side]]; }
  const Turn& turn_of(const Node& n) const { return turn(1 - n.side, n.at[1 - n.side]); }
  const Direction& direction_at(const Node& n, Index key) const;

  /// The node of a line of side s and a turn of the other that meet.
  Index line_node(int s, Index line, Index turn) const;
  /// That of two turns; kNone where they have none.
  Index arc_node(Index i, Index j) const;

  /// Differences and sums of keys, counter-clockwise.
  Index keys() const { return keys_; }
  Index minus(Index p, Index q) const { return p >= q ? p - q : p + keys_ - q; }
  Index plus(Index p, Index q) const { return p + q >= keys_ ? p + q - keys_ : p + q; }
  Index high(const Turn& t) const { return plus(t.low, t.length); }

 private:
  struct Range {               // the lines whose keys a turn of the other side sweeps
    Index first, count, base;  // places in `sorted`; first node
  };

  static std::uint64_t pair_key(Index i, Index j) { return (std::uint64_t(i) << 32) | j; }
  /// Finds the lines of side s that meet the turns of the other side; how many there are.
  Index count_lines(int s);
  /// Lines of side s with the turns of the other side.
  void add_lines(int s);
  void add_arcs();
  void add_arc(Index i, Index j);

  const Tracing* side_[2];
  Index keys_;
  std::vector<Range> ranges_[2];  // of the lines of a side, per turn of the other
  std::unordered_map<std::uint64_t, Index> arc_node_;
};

}  // namespace findspace::plane
