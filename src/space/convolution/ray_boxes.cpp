// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_boxes.h"

#include <array>
#include <span>
#include <utility>

#include "plane/base/parallel.h"
#include "space/polytope/vector.h"

namespace findspace::space {
namespace {

constexpr int kLeaf = 4;
constexpr std::size_t kManyFaces = 1 << 14;  // from here on in several threads
constexpr std::size_t kBranches = 32;        // that are built at once

GridBox united(const GridBox& a, const GridBox& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

GridBox box_of(const RayBody& body, int face) {
  const Point& p = body.corner(face, 0);
  GridBox box{p, p};
  for (int k = 1; k < 3; ++k) {
    const Point& q = body.corner(face, k);
    box = united(box, {q, q});
  }
  return box;
}

/// How many nodes stand below one of so many faces.
int nodes_below(int count) { return count <= kLeaf ? 0 : 2 + nodes_below(count / 2) + nodes_below(count - count / 2); }

}  // namespace

/// Halves the faces by the middles of their boxes, mostly across the longest side of the box about all. The nodes below
/// one stand together, so branches can be built at once.
class BoxTree::Builder {
 public:
  Builder(BoxTree& tree, const RayBody& body) : tree_(tree), places_(body.faces.size()) {
    plane::in_ranges(places_.size(), kManyFaces, [&](const plane::IndexRange& some) {
      for (std::size_t f = some.first; f < some.end; ++f)
        places_[f] = {box_of(body, static_cast<int>(f)), static_cast<int>(f)};
    });
  }

  void run() {
    const auto faces = static_cast<int>(places_.size());
    tree_.nodes_.resize(static_cast<std::size_t>(nodes_below(faces)) + 1);
    tree_.order_.resize(places_.size());
    tree_.boxes_.resize(places_.size());
    std::vector<Branch> branches{{0, 0, faces, 1}};
    const bool several = plane::range_count(places_.size(), kManyFaces) > 1;
    while (several && branches.size() < kBranches) branches = halves(branches);
    plane::at_once(branches.size(), places_.size(), kManyFaces, [&](std::size_t k) { build(branches[k]); });
  }

 private:
  struct Place {
    GridBox box;
    int face;
  };
  struct Branch {
    int node, first, count, next;  // a node with its faces; those below it are next, next + 1, ...
  };

  std::vector<Branch> halves(const std::vector<Branch>& branches) {
    std::vector<Branch> result(2 * branches.size());
    plane::parallel_for(branches.size(), [&](std::size_t k) {
      const auto [left, right] = halved(branches[k], bounded(branches[k]));
      result[2 * k] = left;
      result[2 * k + 1] = right;
    });
    return result;
  }

  void build(const Branch& b) {
    const GridBox& box = bounded(b);
    if (b.count <= kLeaf) return make_leaf(b);
    for (const Branch& half : halved(b, box)) build(half);
  }

  /// The box about its faces, which its node gets.
  const GridBox& bounded(const Branch& b) {
    const auto begin = places_.begin() + b.first;
    GridBox box = begin->box;
    for (auto place = begin; place != begin + b.count; ++place) box = united(box, place->box);
    return tree_.nodes_[static_cast<std::size_t>(b.node)].box = box;
  }

  static Point twice_middle(const GridBox& box) { return box.low + box.high; }
  static int longest(const Point& size) { return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2; }

  /// The longest of the box, unless the faces are long there and lie beside each other along another one.
  static int axis_to_halve(std::span<const Place> places, const GridBox& box) {
    GridBox middles{twice_middle(places[0].box), twice_middle(places[0].box)};
    for (const Place& p : places) middles = united(middles, {twice_middle(p.box), twice_middle(p.box)});
    const Point spread = middles.high - middles.low;
    const int of_box = longest(box.high - box.low), of_middles = longest(spread);
    return 2 * component(spread, of_box) < component(spread, of_middles) ? of_middles : of_box;
  }

  std::array<Branch, 2> halved(const Branch& b, const GridBox& box) {
    const auto begin = places_.begin() + b.first, end = begin + b.count;
    const int axis = axis_to_halve({begin, end}, box);
    const auto key = [&](const Place& p) { return std::pair(component(twice_middle(p.box), axis), p.face); };
    std::nth_element(begin, begin + b.count / 2, end, [&](const Place& p, const Place& q) { return key(p) < key(q); });
    tree_.nodes_[static_cast<std::size_t>(b.node)].first = b.next;
    const int left = b.count / 2;
    return {Branch{b.next, b.first, left, b.next + 2},
            Branch{b.next + 1, b.first + left, b.count - left, b.next + 2 + nodes_below(left)}};
  }

  void make_leaf(const Branch& b) {
    Node& node = tree_.nodes_[static_cast<std::size_t>(b.node)];
    node.first = b.first;
    node.count = b.count;
    const auto first = static_cast<std::size_t>(b.first), count = static_cast<std::size_t>(b.count);
    for (std::size_t k = first; k < first + count; ++k) {
      tree_.order_[k] = places_[k].face;
      tree_.boxes_[k] = places_[k].box;
    }
  }

  BoxTree& tree_;
  std::vector<Place> places_;
};

BoxTree::BoxTree(const RayBody& body) { Builder(*this, body).run(); }

RaySheet::RaySheet(RayBody made) : body(std::move(made)), tree(body) {
  for (const RayEdge& e : body.edges) {
    const Vector way = exact::approx(body.points[std::size_t(e.to)] - body.points[std::size_t(e.from)]);
    longest = std::max(longest, length(way));
  }
}

}  // namespace findspace::space
