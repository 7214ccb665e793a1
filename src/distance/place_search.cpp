// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/place_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "distance/site_pairs.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Cell;
using plane::Index;
using plane::kNone;

namespace {

constexpr double kSlack = 0x1p-43;     // of the scale: what numbers cannot tell apart
constexpr double kSmallBox = 0x1p-24;  // of the scale: its place is found exactly from the parts of A around it

}  // namespace

PlaceSearch::PlaceSearch(const SiteTree& b, const SiteTree& a, const RealPoint& p, double least_value)
    : a_(a),
      b_(b),
      p_(p),
      px_(near_value(p.x)),
      py_(near_value(p.y)),
      scale_(a.scale() + b.scale() + std::abs(px_) + std::abs(py_)),
      slack_(scale_ * kSlack),
      best_(least_value) {}

bool PlaceSearch::in_a(Spot at, const SiteTree::Near& near) const {
  if (auto in = a_.contains(at.x, at.y, near)) return *in;
  if (near.distance <= slack_) return true;
  return mark_of(a_.region(), locate(a_.region(), {Real::from_double(at.x), Real::from_double(at.y)})) > 0;
}

bool PlaceSearch::in_b(Spot at, const SiteTree::Near& near) const {
  double x = at.x - px_, y = at.y - py_;
  if (auto in = b_.contains(x, y, near)) return *in;
  return near.distance <= slack_ ||
         mark_of(b_.region(), locate(b_.region(), {Real::from_double(x), Real::from_double(y)})) > 0;
}

Seen PlaceSearch::see(Spot at, Index guess) const {
  auto near = a_.nearest(at.x, at.y, guess);
  bool inside = near.distance > best_ - 2 * slack_ && in_a(at, near);
  return {at, inside ? 0 : near.distance, near, inside};
}

void PlaceSearch::record(const Seen& seen, Cell cell, double error) {
  if (seen.value + error <= best_ - slack_) return;
  if (error == 0) best_ = std::max(best_, seen.value);
  for (const Found& f : found_)
    if (f.cell == cell && plain_length(f.seen.at.x - seen.at.x, f.seen.at.y - seen.at.y) <= std::max(error, slack_))
      return;
  found_.push_back({seen, cell, error});
}

/// Boxes of B's boundary, the one with the largest bound first. A box is first bounded by the part of A that was
/// nearest to the box it is a half of; its own nearest part is looked for when its turn comes.
void PlaceSearch::walk_boundary() {
  struct Entry {
    double bound;
    Index node, guess;
    bool sharp = false;
    bool operator<(const Entry& o) const { return bound < o.bound; }
  };
  std::priority_queue<Entry> todo;
  auto push = [&](const Entry& e) {
    if (e.bound > best_ + slack_) todo.push(e);
  };
  auto ball = [&](Index node) {
    const SiteBox& box = b_.nodes()[node].box;
    return std::pair{Spot{(box.x0 + box.x1) / 2 + px_, (box.y0 + box.y1) / 2 + py_},
                     plain_length(box.x1 - box.x0, box.y1 - box.y0) / 2};
  };
  todo.push({std::numeric_limits<double>::infinity(), 0, kNone});
  while (!todo.empty()) {
    Entry e = todo.top();
    todo.pop();
    if (e.bound <= best_ + slack_) break;
    const SiteTree::Node& n = b_.nodes()[e.node];
    if (!e.sharp) {
      auto [c, radius] = ball(e.node);
      auto near = a_.nearest(c.x, c.y, e.guess);
      bool outside = near.distance + radius > best_ && !in_a(c, near);
      if (outside || near.distance <= radius) push({(outside ? near.distance : 0) + radius, e.node, near.site, true});
      continue;
    }
    if (n.right == kNone) {
      for (Index k = n.first; k < n.last; ++k) visit_edge(b_.sites()[k], e.guess);
      continue;
    }
    for (Index child : {e.node + 1, n.right}) {
      auto [c, radius] = ball(child);
      push({to_site(c, e.guess) + radius, child, e.guess});
    }
  }
}

/// Where along the part the nearest sites of its ends are equally far, from 0 to 1.
double PlaceSearch::split(const Seen& s, const Seen& t) const {
  double low = 0, high = 1;
  for (int k = 0; k < 60 && high - low > 0x1p-52; ++k) {
    double m = (low + high) / 2;
    Spot at{s.at.x + m * (t.at.x - s.at.x), s.at.y + m * (t.at.y - s.at.y)};
    (to_site(at, s.near.site) < to_site(at, t.near.site) ? low : high) = m;
  }
  return (low + high) / 2;
}

void PlaceSearch::visit_edge(const Site& edge, Index guess) {
  const auto& region = b_.region();
  const Spot from{edge.x0 + px_, edge.y0 + py_}, to{edge.x1 + px_, edge.y1 + py_};
  // The distance to one part of A is convex along the edge.
  if (std::max(to_site(from, guess), to_site(to, guess)) <= best_ + slack_) return;
  Seen first = see(from, guess);
  record(first, {0, edge.is_vertex() ? edge.cell.index : region.edges[edge.cell.index].v0});
  if (edge.is_vertex()) return;
  Seen last = see(to, first.near.site);
  record(last, {0, region.edges[edge.cell.index].v1});
  std::vector<std::pair<Seen, Seen>> parts{{first, last}};
  while (!parts.empty()) {
    const Seen s = parts.back().first, t = parts.back().second;
    parts.pop_back();
    const double size = plain_length(t.at.x - s.at.x, t.at.y - s.at.y);
    double bound = std::min({std::max(s.near.distance, to_site(t.at, s.near.site)),
                             std::max(to_site(s.at, t.near.site), t.near.distance), (s.value + t.value + size) / 2});
    if (bound <= best_ + slack_ || size <= scale_ * kShortPart) continue;
    double covered = (s.inside ? s.near.distance : 0) + (t.inside ? t.near.distance : 0);
    if (covered >= size) continue;  // all inside A
    auto on_part = [&](double m) { return Spot{s.at.x + m * (t.at.x - s.at.x), s.at.y + m * (t.at.y - s.at.y)}; };
    double m = s.near.site != t.near.site ? split(s, t) : 0.5;
    if (m > 0x1p-30 && m < 1 - 0x1p-30) record(see(on_part(m), s.near.site), edge.cell);
    if (m < 0.125 || m > 0.875) m = 0.5;  // where both are equally far at an end, splitting there leads nowhere
    Seen middle = see(on_part(m), s.near.site);
    parts.push_back({s, middle});
    parts.push_back({middle, t});
  }
}

/// At most two parts of A can be nearest around `middle`: distances to two convex parts have no strict maximum
/// together.
bool PlaceSearch::few_sites(Spot middle, double reach) const {
  int count = 0;
  std::vector<Index> stack{0};
  while (!stack.empty() && count < 3) {
    const SiteTree::Node& node = a_.nodes()[stack.back()];
    Index first = stack.back() + 1;
    stack.pop_back();
    if (node.box.nearest_squared(middle.x, middle.y) > reach * reach) continue;
    if (node.right != kNone) stack.insert(stack.end(), {node.right, first});
    for (Index k = node.first; node.right == kNone && k < node.last; ++k)
      count += a_.sites()[k].distance(middle.x, middle.y) <= reach;
  }
  return count < 3;
}

/// Whether the distance to A grows in one direction from every place within `radius` of `middle`, so that none is a
/// local maximum.
bool PlaceSearch::can_grow(Spot middle, const Seen& seen, double radius) const {
  const Site& s = a_.sites()[seen.near.site];
  double ux = middle.x - s.x0, uy = middle.y - s.y0;
  if (!s.is_vertex() && s.faces(middle.x, middle.y)) {
    double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
    double side = (middle.y - s.y0) * dx - (middle.x - s.x0) * dy > 0 ? 1 : -1;
    ux = -dy * side, uy = dx * side;
  } else if (!s.is_vertex() && plain_length(middle.x - s.x1, middle.y - s.y1) < plain_length(ux, uy)) {
    ux = middle.x - s.x1, uy = middle.y - s.y1;
  }
  double n = plain_length(ux, uy), reach = seen.near.distance + 2 * radius + slack_;
  ux /= n, uy /= n;
  double level = ux * middle.x + uy * middle.y - radius - slack_;
  auto height = [&](double x, double y) { return ux * x + uy * y - level; };
  std::vector<Index> stack{0};
  while (!stack.empty()) {
    Index at = stack.back();
    stack.pop_back();
    const SiteTree::Node& node = a_.nodes()[at];
    if (height(ux > 0 ? node.box.x1 : node.box.x0, uy > 0 ? node.box.y1 : node.box.y0) < 0) continue;
    if (node.box.nearest_squared(middle.x, middle.y) > reach * reach) continue;
    if (node.right != kNone) {
      stack.insert(stack.end(), {node.right, at + 1});
      continue;
    }
    for (Index k = node.first; k < node.last; ++k) {
      Site part = a_.sites()[k];
      double h0 = height(part.x0, part.y0), h1 = height(part.x1, part.y1);
      if (h0 < 0 && h1 < 0) continue;
      if (h0 < 0 || h1 < 0) {
        double t = h0 / (h0 - h1), x = part.x0 + t * (part.x1 - part.x0), y = part.y0 + t * (part.y1 - part.y0);
        (h0 < 0 ? part.x0 : part.x1) = x, (h0 < 0 ? part.y0 : part.y1) = y;
      }
      if (part.distance(middle.x, middle.y) <= reach) return false;
    }
  }
  return true;
}

void PlaceSearch::search_inside() {
  const auto& faces = b_.region().faces;
  if (std::none_of(faces.begin(), faces.end(), [](const plane::Face& f) { return f.mark > 0; })) return;
  const SiteBox &s = a_.nodes()[0].box, &t = b_.nodes()[0].box;
  double x0 = std::max(s.x0, t.x0 + px_), x1 = std::min(s.x1, t.x1 + px_);
  double y0 = std::max(s.y0, t.y0 + py_), y1 = std::min(s.y1, t.y1 + py_);
  if (!(x0 < x1 && y0 < y1)) return;
  struct Box {
    Spot middle;
    double half;
    Index guess;
  };
  std::vector<Box> stack{{{(x0 + x1) / 2, (y0 + y1) / 2}, std::max(x1 - x0, y1 - y0) / 2, kNone}};
  while (!stack.empty()) {
    Box box = stack.back();
    stack.pop_back();
    double radius = box.half * std::sqrt(2.0);
    if (box.guess != kNone && to_site(box.middle, box.guess) + radius <= best_ + slack_) continue;
    Seen seen = see(box.middle, box.guess);
    if (seen.value + radius <= best_ + slack_) continue;
    if (seen.inside ? seen.near.distance >= radius : seen.near.distance > radius && can_grow(box.middle, seen, radius))
      continue;
    if (few_sites(box.middle, seen.near.distance + 2 * radius + slack_)) continue;
    auto to_b = b_.nearest(box.middle.x - px_, box.middle.y - py_);
    bool in = in_b(box.middle, to_b);
    if (!in && to_b.distance > radius) continue;
    if (in && !seen.inside) best_ = std::max(best_, seen.value - slack_);
    if (box.half <= scale_ * kSmallBox) {
      if (!seen.inside) record(seen, {2, 0}, 4 * radius);
      continue;
    }
    double h = box.half / 2;
    for (double dx : {-h, h})
      for (double dy : {-h, h}) stack.push_back({{box.middle.x + dx, box.middle.y + dy}, h, seen.near.site});
  }
}

}  // namespace findspace::distance
