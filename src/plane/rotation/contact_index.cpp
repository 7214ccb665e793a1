// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/contact_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

constexpr Index kItemsOfLeaf = 4;
constexpr double kSpread = kPi / 8;  // of normals, from which on they are parted by these

double around_zero(double angle) { return std::remainder(angle, 2 * kPi); }

RoughBox joined(const RoughBox& a, const RoughBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// How far it reaches to one of four sides.
double reach(const RoughBox& b, int side) { return std::array{-b.x0, -b.y0, b.x1, b.y1}[std::size_t(side)]; }

}  // namespace

ContactIndex::ContactIndex(const ContactCurves& curves, double tolerance)
    : curves_(curves),
      tolerance_(tolerance),
      fixed_{Tree(items(curves.fixed().rounds)), Tree(items(curves.fixed().edges))},
      rotating_{Tree(items(curves.rotating().rounds)), Tree(items(curves.rotating().edges))} {}

std::vector<ContactIndex::Item> ContactIndex::items(const std::vector<RoundFeature>& rounds) {
  std::vector<Item> out;
  out.reserve(rounds.size());
  for (Index k = 0; k < rounds.size(); ++k) {
    const RoundFeature& f = rounds[k];
    const double r = std::abs(f.r), middle = around_zero(f.normals.from + f.normals.width / 2);
    out.push_back({{f.x - r, f.y - r, f.x + r, f.y + r}, f.normals, middle, f.outside, r > 0, k});
  }
  return out;
}

std::vector<ContactIndex::Item> ContactIndex::items(const std::vector<EdgeFeature>& edges) {
  std::vector<Item> out;
  out.reserve(edges.size());
  for (Index k = 0; k < edges.size(); ++k) {
    const EdgeFeature& f = edges[k];
    out.push_back({{std::min(f.x0, f.x1), std::min(f.y0, f.y1), std::max(f.x0, f.x1), std::max(f.y0, f.y1)},
                   {f.normal, 0},
                   around_zero(f.normal),
                   f.outside,
                   false,
                   k});
  }
  return out;
}

ContactIndex::Tree::Tree(std::vector<Item> all) : items(std::move(all)) {
  if (!items.empty()) build(0, Index(items.size()));
}

ContactIndex::Node ContactIndex::Tree::node_of(Index first, Index last) const {
  const Item& one = items[first];
  Node out{one.box, {}, one.round, first, last};
  double from = one.middle - one.normals.width / 2, to = from + one.normals.width;
  for (Index k = first + 1; k < last; ++k) {
    const Item& item = items[k];
    out.box = joined(out.box, item.box);
    out.round |= item.round;
    from = std::min(from, item.middle - item.normals.width / 2);
    to = std::max(to, item.middle + item.normals.width / 2);
  }
  out.normals = {from, std::min(to - from, 2 * kPi)};
  return out;
}

/// Parts the items in two halves; where the second one begins.
Index ContactIndex::Tree::part(Index first, Index last) {
  const auto begin = items.begin() + first, end = items.begin() + last, middle = begin + (last - first) / 2;
  const auto halve = [&](auto&& place) {
    std::nth_element(begin, middle, end, [&](const Item& p, const Item& q) { return place(p) < place(q); });
  };
  const auto [low, high] =
      std::minmax_element(begin, end, [](const Item& p, const Item& q) { return p.middle < q.middle; });
  const RoughBox box = node_of(first, last).box;
  if (high->middle - low->middle > kSpread)
    halve([](const Item& k) { return k.middle; });
  else if (box.x1 - box.x0 > box.y1 - box.y0)
    halve([](const Item& k) { return k.box.x0 + k.box.x1; });
  else
    halve([](const Item& k) { return k.box.y0 + k.box.y1; });
  return Index(middle - items.begin());
}

Index ContactIndex::Tree::build(Index first, Index last) {
  const Index at = Index(nodes.size());
  nodes.push_back(node_of(first, last));
  if (last - first <= kItemsOfLeaf) return at;
  const Index middle = part(first, last);
  build(first, middle);
  const Index right = build(middle, last);
  nodes[at].right = right;
  return at;
}

bool ContactIndex::may_touch(const Node& fixed, const Node& rotating) const {
  return cones_meet(fixed.normals, {rotating.normals.from + kPi, rotating.normals.width}, 2 * margin::kOneDirection);
}

std::array<ContactIndex::NodePair, 2> ContactIndex::parts(Kind kind, const NodePair& k) const {
  const Node &a = fixed(kind).nodes[k.fixed], &b = rotating(kind).nodes[k.rotating];
  if (b.right == kNone || (a.right != kNone && a.last - a.first >= b.last - b.first))
    return {NodePair{k.fixed + 1, k.rotating}, NodePair{a.right, k.rotating}};
  return {NodePair{k.fixed, k.rotating + 1}, NodePair{k.fixed, b.right}};
}

RoughBox ContactIndex::box(const ContactPair& pair) const {
  const RoughCurve c = curves_.rough(pair, 0);
  RoughPoint low = c.line ? c.p : c.center, high = low;
  const auto add = [&](RoughPoint p) {
    low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
    high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
  };
  if (c.line) {
    add(c.q);
  } else {
    const double r = std::abs(c.radius);
    add(c.center - RoughPoint(r, r));
    add(c.center + RoughPoint(r, r));
  }
  return {low.real() - tolerance_, low.imag() - tolerance_, high.real() + tolerance_, high.imag() + tolerance_};
}

std::optional<RoughBox> ContactIndex::bounds() const {
  std::array<double, 4> most;
  for (int side = 0; side < 4; ++side) {
    double& best = most[std::size_t(side)] = -std::numeric_limits<double>::infinity();
    for (const Kind kind : {Kind::kRounds, Kind::kFixedEdge, Kind::kTurningEdge})
      walk(
          kind, [&](const RoughBox& b) { return reach(b, side) > best; },
          [&](const ContactPair& pair) {
            best = reach(box(pair), side);
            return true;
          });
  }
  if (std::isinf(most[0])) return std::nullopt;
  return RoughBox{-most[0], -most[1], most[2], most[3]};
}

}  // namespace findspace::plane
