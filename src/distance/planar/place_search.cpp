// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/place_search.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_features/feature_pair_search.h"
#include "exact/margins/planar_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Cell;
using plane::Index;
using plane::kNone;

PlacedSets::PlacedSets(const FeatureTree& moving, const FeatureTree& fixed, const RealPoint& at)
    : a(fixed),
      b(moving),
      p(at),
      px(near_value(at.x)),
      py(near_value(at.y)),
      scale(a.scale() + b.scale() + std::abs(px) + std::abs(py)),
      slack(scale * margin::kSameNumber) {}

bool PlacedSets::in_a(Spot at, const FeatureTree::Near& near) const {
  if (auto in = a.contains(at.x, at.y, near)) return *in;
  if (near.distance <= slack) return true;
  return mark_of(a.region(), locate(a.region(), {Real::from_double(at.x), Real::from_double(at.y)})) > 0;
}

bool PlacedSets::in_b(Spot at, const FeatureTree::Near& near) const {
  double x = at.x - px, y = at.y - py;
  if (auto in = b.contains(x, y, near)) return *in;
  return near.distance <= slack ||
         mark_of(b.region(), locate(b.region(), {Real::from_double(x), Real::from_double(y)})) > 0;
}

/// The distance to one part of A is convex, so a corner of the box has the greatest.
double PlacedSets::most(const FeatureBox& box, Index feature) const {
  const BoundaryFeature& s = a.features()[feature];
  return std::sqrt(std::max(std::max(s.squared_distance(box.x0, box.y0), s.squared_distance(box.x1, box.y0)),
                            std::max(s.squared_distance(box.x0, box.y1), s.squared_distance(box.x1, box.y1))));
}

FeatureBox PlacedSets::placed(Index node) const {
  const FeatureBox& box = b.nodes()[node].box;
  return {box.x0 + px, box.y0 + py, box.x1 + px, box.y1 + py};
}

std::vector<BoundaryFeature> PlacedSets::parts_near(Spot at, double reach) const {
  std::vector<BoundaryFeature> out;
  auto add = [&](const BoundaryFeature& s) {
    auto same = [&](const BoundaryFeature& k) { return k.cell == s.cell; };
    if (s.distance(at.x, at.y) <= reach && std::none_of(out.begin(), out.end(), same)) out.push_back(s);
  };
  a.for_near(at.x, at.y, reach, [&](plane::Index k) {
    const BoundaryFeature& s = a.features()[k];
    if (s.faces(at.x, at.y)) add(s);
    if (s.is_vertex()) return true;
    const plane::Edge& e = a.region().edges[s.cell.index];
    add(vertex_feature(a.region(), e.v0));
    add(vertex_feature(a.region(), e.v1));
    return true;
  });
  return out;
}

PlaceSearch::PlaceSearch(const PlacedSets& sets, const MaxMinBoxes& boxes, double least_value)
    : sets_(sets),
      boxes_(boxes),
      scale_(sets.scale),
      slack_(sets.slack),
      best_(least_value),
      left_(kLeastSteps + kStepsPerFeature * long(sets.a.features().size() + sets.b.features().size())) {}

Seen PlaceSearch::see(Spot at, Index guess) const {
  auto near = sets_.a.nearest(at.x, at.y, guess);
  bool inside = near.distance > best_ - 2 * slack_ && sets_.in_a(at, near);
  return {at, inside ? 0 : near.distance, near, inside};
}

void PlaceSearch::record(const Found& found) {
  const auto& [seen, cell, error, halving] = found;
  if (!may_be_farthest(seen.value + error)) return;
  if (error == 0) best_ = std::max(best_, seen.value);
  if (cell.dimension == 0 && !corners_.insert(cell.index).second) return;
  // The places of an edge follow each other, and so do those inside.
  for (auto f = out_.places.rbegin(); f != out_.places.rend() && f->cell == cell; ++f)
    if (plain_length(f->seen.at.x - seen.at.x, f->seen.at.y - seen.at.y) <= std::max(error, slack_)) return;
  out_.places.push_back(found);
}

/// The corner of B farthest from the middle of A in the direction of B's: often the place, or near it.
Index PlaceSearch::start() {
  const FeatureBox &s = sets_.a.nodes()[0].box, &t = sets_.b.nodes()[0].box;
  const auto v = sets_.b.extreme(t.x0 + t.x1 + 2 * sets_.px - s.x0 - s.x1, t.y0 + t.y1 + 2 * sets_.py - s.y0 - s.y1);
  const Seen seen = see({v.x + sets_.px, v.y + sets_.py}, kNone);
  out_.first = {0, v.vertex};
  record({seen, out_.first});
  return seen.near.feature;
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
  plane::Subdivision<Entry> todo;
  auto push = [&](const Entry& e) {
    if (may_be_farthest(e.bound)) todo.push(e);
  };
  todo.push({sets_.most(sets_.placed(0), start()), 0, start(), true});
  const auto look = [&](const Entry& e) {
    const FeatureTree::Node& n = sets_.b.nodes()[e.node];
    if (!e.sharp) {
      const FeatureBox box = sets_.placed(e.node);
      const Spot c{(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
      const double radius = plain_length(box.x1 - box.x0, box.y1 - box.y0) / 2;
      const auto near = sets_.a.nearest(c.x, c.y, e.guess);
      const double bound = sets_.most(box, near.feature);
      if (!may_be_farthest(bound)) return;
      if (!sets_.in_a(c, near))
        push({bound, e.node, near.feature, true});
      else if (near.distance <= radius)
        push({std::min(bound, radius), e.node, near.feature, true});
      return;
    }
    if (n.right == kNone) {
      for (Index k = n.first; k < n.last; ++k) visit_edge(sets_.b.features()[k], e.guess);
      return;
    }
    for (Index child : {e.node + 1, n.right}) push({sets_.most(sets_.placed(child), e.guess), child, e.guess});
  };
  todo.run([&](const Entry& e) { return settled(e.bound, may_be_farthest(e.bound)); }, look);
}

/// Where along the part the nearest features of its ends are equally far, from 0 to 1.
double PlaceSearch::split(const Seen& s, const Seen& t) const {
  double low = 0, high = 1;
  for (int k = 0; k < 60 && high - low > margin::kNoHalving; ++k) {
    double m = (low + high) / 2;
    Spot at{s.at.x + m * (t.at.x - s.at.x), s.at.y + m * (t.at.y - s.at.y)};
    (sets_.to_feature(at, s.near.feature) < sets_.to_feature(at, t.near.feature) ? low : high) = m;
  }
  return (low + high) / 2;
}

void PlaceSearch::visit_edge(const BoundaryFeature& edge, Index guess) {
  const auto& region = sets_.b.region();
  const Spot from{edge.x0 + sets_.px, edge.y0 + sets_.py}, to{edge.x1 + sets_.px, edge.y1 + sets_.py};
  // The distance to one part of A is convex along the edge.
  if (!may_be_farthest(std::max(sets_.to_feature(from, guess), sets_.to_feature(to, guess)))) return;
  Seen first = see(from, guess);
  record({first, {0, edge.is_vertex() ? edge.cell.index : region.edges[edge.cell.index].v0}});
  if (edge.is_vertex()) return;
  Seen last = see(to, first.near.feature);
  record({last, {0, region.edges[edge.cell.index].v1}});
  std::vector<std::pair<Seen, Seen>> parts{{first, last}};
  while (!parts.empty()) {
    const Seen s = parts.back().first, t = parts.back().second;
    parts.pop_back();
    const double size = plain_length(t.at.x - s.at.x, t.at.y - s.at.y);
    double bound =
        std::min({std::max(s.near.distance, sets_.to_feature(t.at, s.near.feature)),
                  std::max(sets_.to_feature(s.at, t.near.feature), t.near.distance), (s.value + t.value + size) / 2});
    if (!may_be_farthest(bound) || size <= scale_ * margin::kShortPart) continue;
    double covered = (s.inside ? s.near.distance : 0) + (t.inside ? t.near.distance : 0);
    if (covered >= size) continue;  // all inside A
    if (spent()) {
      leave_open(bound);
      continue;
    }
    auto on_part = [&](double m) { return Spot{s.at.x + m * (t.at.x - s.at.x), s.at.y + m * (t.at.y - s.at.y)}; };
    const double m = s.near.feature != t.near.feature ? split(s, t) : 0.5;
    if (m > margin::kAtEnd && m < 1 - margin::kAtEnd) record({see(on_part(m), s.near.feature), edge.cell});
    // No place of the part is farther than its ends, which are looked at.
    if (bound <= std::max(s.value, t.value) + scale_ * margin::kSurelyLess) continue;
    const bool halved = m < 0.125 || m > 0.875;  // where both are equally far at an end, splitting there leads nowhere
    Seen middle = see(on_part(halved ? 0.5 : m), s.near.feature);
    if (halved && may_be_farthest(middle.value)) halvings_.push_back({middle, edge.cell, 0, true});
    parts.push_back({s, middle});
    parts.push_back({middle, t});
  }
}

/// Squares in which the distance to A can have a strict maximum, as far as B + p reaches; the one with the largest
/// bound first, so that no ridge is walked along step by step.
void PlaceSearch::search_inside() {
  const auto& faces = sets_.b.region().faces;
  if (std::none_of(faces.begin(), faces.end(), [](const plane::Face& f) { return f.mark > 0; })) return;
  plane::Subdivision<Square> todo("squares of the farthest place inside a set", true);
  const auto push = [&](double bound, const MaxMinBoxes::Part& part, Index guess) {
    todo.push({bound, part, guess, box_of(part)});
  };
  push(sets_.most(box_of({}), start()), {}, kNone);
  todo.run([&](const Square& e) { return settled(e.bound, e.bound > best_ + slack_); },
           [&](const Square& e) {
             const auto nearest = look_inside(e);
             for (int k = 0; nearest && k < 4; ++k) {
               const MaxMinBoxes::Part quarter = e.part.quarter(k);
               const double bound = std::min(e.bound, sets_.most(box_of(quarter), *nearest));
               if (bound > best_ + slack_) push(bound, quarter, *nearest);
             }
           });
}

FeatureBox PlaceSearch::box_of(const MaxMinBoxes::Part& part) const {
  const Spot middle = boxes_.middle(part);
  const double half = boxes_.half(part);
  return {middle.x - half, middle.y - half, middle.x + half, middle.y + half};
}

/// The feature of A nearest to the square's middle, if the square is to be divided.
std::optional<Index> PlaceSearch::look_inside(const Square& e) {
  const FeatureBox &box = e.box, reach = sets_.placed(0);
  if (box.x0 >= reach.x1 || box.x1 <= reach.x0 || box.y0 >= reach.y1 || box.y1 <= reach.y0) return std::nullopt;
  const auto look = boxes_.look(e.part, e.guess);
  if (look.barren || sets_.most(box, look.near.feature) <= best_ + slack_) return std::nullopt;
  const Spot middle = boxes_.middle(e.part);
  const double half = boxes_.half(e.part), radius = half * std::sqrt(2.0);
  const auto to_b = sets_.nearest_of_b(middle);
  const bool in = sets_.in_b(middle, to_b);
  if (!in && to_b.distance > radius) return std::nullopt;
  const Seen seen{middle, look.inside ? 0 : look.near.distance, look.near, look.inside};
  if (in) best_ = std::max(best_, seen.value - 2 * slack_);  // the square with the max-min place stays
  if (half > scale_ * margin::kExactPlaceBox || seen.inside) return look.near.feature;
  const bool few = sets_.parts_near(middle, seen.value + margin::kMeetingTolerance * 4 * radius).size() <= kMostParts;
  if (!few && half > scale_ * margin::kTinyPlaceBox) return look.near.feature;
  record({seen, {2, 0}, 4 * radius});
  return std::nullopt;
}

FoundPlaces PlaceSearch::run() {
  walk_boundary();
  search_inside();
  // Last, as of places that are as far the first is taken, and others are known exactly.
  for (const Found& f : halvings_) record(f);
  out_.best = best_;
  return std::move(out_);
}

}  // namespace findspace::distance
