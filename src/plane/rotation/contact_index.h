// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The contact curves (contact_curves.h) of two sets as they stand, n by m pairs of features, not made but found: which
// of them reach into a box, and what box lies around all. Each set's features stand in trees, parted by their normals
// first and by their places then; two trees are walked together, past what cannot have opposite normals or lies
// elsewhere. Guarantee: every pair that ContactCurves::pairs tells and whose box meets, no other. Cost: O((n + m) log(n
// + m)) to prepare; a question about the features near the box and what it finds. Keywords: dual tree, bounding volume
// hierarchy, convolution, range query.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plane/rotation/contact_curves.h"

namespace findspace::plane {

class ContactIndex {
 public:
  /// Keeps a reference. Lengths below the tolerance are left to exact numbers.
  ContactIndex(const ContactCurves& curves, double tolerance);

  /// Around a pair's curve; of a part of a circle, around the whole circle.
  RoughBox box(const ContactPair& pair) const;
  /// Calls visit(pair) for the pairs whose boxes meet the box, in no order, while it returns true.
  template <class Visit>
  void visit(const RoughBox& box, Visit&& visit) const {
    for (const Kind kind : {Kind::kRounds, Kind::kFixedEdge, Kind::kTurningEdge}) {
      const bool on = walk(
          kind, [&](const RoughBox& b) { return !b.apart(box); }, visit);
      if (!on) return;
    }
  }
  /// Around all boxes; nothing if there is no pair.
  std::optional<RoughBox> bounds() const;

 private:
  using Kind = ContactPair::Kind;

  struct Item {
    RoughBox box;  // of an arc around its circle
    Cone normals;
    double middle;  // of these
    Outside outside;
    bool round;  // it has a radius
    Index feature;
  };
  struct Node {
    RoughBox box;
    Cone normals;  // of all below it
    bool round;
    Index first, last;    // items
    Index right = kNone;  // the second child; the first one follows. kNone: a leaf
  };
  struct Tree {
    explicit Tree(std::vector<Item> all);
    std::vector<Item> items;
    std::vector<Node> nodes;

   private:
    Index build(Index first, Index last);
    Node node_of(Index first, Index last) const;
    Index part(Index first, Index last);
  };
  struct NodePair {
    Index fixed, rotating;
  };

  static std::vector<Item> items(const std::vector<RoundFeature>& rounds);
  static std::vector<Item> items(const std::vector<EdgeFeature>& edges);

  const Tree& fixed(Kind kind) const { return fixed_[kind == Kind::kFixedEdge ? 1 : 0]; }
  const Tree& rotating(Kind kind) const { return rotating_[kind == Kind::kTurningEdge ? 1 : 0]; }
  /// Around the boxes of all pairs of two parts.
  template <class Part>
  RoughBox around(const Part& of_fixed, const Part& of_rotating) const {
    const RoughBox &a = of_fixed.box, &b = of_rotating.box;
    const double off = of_fixed.round || of_rotating.round ? 2 * tolerance_ : tolerance_;
    return {a.x0 - b.x1 - off, a.y0 - b.y1 - off, a.x1 - b.x0 + off, a.y1 - b.y0 + off};
  }
  bool may_touch(const Node& fixed, const Node& rotating) const;
  /// The parts of a pair of nodes, one of which is no leaf.
  std::array<NodePair, 2> parts(Kind kind, const NodePair& pair) const;

  /// Visits pairs among those with wanted(box), of parts and of their own.
  template <class Wanted, class Visit>
  bool walk(Kind kind, Wanted&& wanted, Visit&& visit) const {
    const Tree &f = fixed(kind), &r = rotating(kind);
    if (f.nodes.empty() || r.nodes.empty()) return true;
    std::vector<NodePair> stack{{0, 0}};
    while (!stack.empty()) {
      const NodePair k = stack.back();
      stack.pop_back();
      const Node &a = f.nodes[k.fixed], &b = r.nodes[k.rotating];
      if (!wanted(around(a, b)) || !may_touch(a, b)) continue;
      if (a.right != kNone || b.right != kNone) {
        for (const NodePair& part : parts(kind, k)) stack.push_back(part);
        continue;
      }
      for (Index i = a.first; i < a.last; ++i)
        for (Index j = b.first; j < b.last; ++j) {
          const Item &p = f.items[i], &q = r.items[j];
          if (!wanted(around(p, q)) || !can_touch(p.normals, p.outside, q.normals, q.outside, 0, 0)) continue;
          const ContactPair pair{kind, p.feature, q.feature};
          // Of corners and edges the box is that around the two.
          if ((p.round || q.round) && !wanted(box(pair))) continue;
          if (!visit(pair)) return false;
        }
    }
    return true;
  }

  const ContactCurves& curves_;
  double tolerance_;
  std::array<Tree, 2> fixed_, rotating_;  // of rounds, of edges
};

}  // namespace findspace::plane
