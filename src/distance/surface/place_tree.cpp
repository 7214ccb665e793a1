// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/place_tree.h"

#include <algorithm>
#include <utility>

namespace findspace::distance {

using space::Vector;

PlaceTree::PlaceTree(std::vector<Place> places) : places_(std::move(places)) {
  std::uint32_t number = 0;
  for (Place& p : places_) p.number = number++;
  nodes_.push_back(node_of(0, number));
}

space::Extent PlaceTree::box_of(std::span<const Place> places) {
  space::Extent box{places[0].at, places[0].at};
  for (const Place& p : places) box.add({p.at, p.at});
  return box;
}

PlaceTree::Node PlaceTree::node_of(std::uint32_t begin, std::uint32_t end) const {
  const std::span<const Place> places = std::span(places_).subspan(begin, end - begin);
  Node made;
  made.begin = begin;
  made.end = end;
  made.least = made.most = places[0].clearance;
  made.middle = box_of(places).middle();
  for (const Place& p : places) {
    made.least = std::min(made.least, p.clearance);
    made.most = std::max(made.most, p.clearance);
    made.radius = std::max(made.radius, space::length(p.at - made.middle));
  }
  return made;
}

std::array<int, 2> PlaceTree::divided(int k) {
  const Node of = node(k);
  int first = of.first;
  if (first < 0) {
    const std::span<Place> places = std::span(places_).subspan(of.begin, of.end - of.begin);
    const space::Extent box = box_of(places);
    const Vector wide = box.high - box.low;
    const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
    const std::uint32_t half = (of.end - of.begin) / 2;
    std::nth_element(places.begin(), places.begin() + half, places.end(),
                     [axis](const Place& p, const Place& q) { return component(p.at, axis) < component(q.at, axis); });
    first = static_cast<int>(nodes_.size());
    nodes_[static_cast<std::size_t>(k)].first = first;
    nodes_.push_back(node_of(of.begin, of.begin + half));
    nodes_.push_back(node_of(of.begin + half, of.end));
  }
  return {first, first + 1};
}

}  // namespace findspace::distance
