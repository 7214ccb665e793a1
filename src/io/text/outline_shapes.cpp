// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/outline_shapes.h"

#include <algorithm>
#include <utility>

#include "findspace/error.h"
#include "plane/build/touching_rings.h"
#include "plane/contour/contour.h"

namespace findspace::io {

using exact::Real;
using plane::Contour;
using plane::ContourEdge;
using plane::Shape;
using plane::ShapePtr;

namespace {

Shape make(Shape::Kind kind, const std::string& place) {
  Shape shape;
  shape.kind = kind;
  shape.place = place;
  return shape;
}

ShapePtr share(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

ShapePtr rings_shape(std::vector<Contour> contours, const std::string& place) {
  Shape shape = make(Shape::Kind::kRings, place);
  shape.contours = std::move(contours);
  return share(std::move(shape));
}

ShapePtr cells_shape(plane::Region cells, const std::string& place) {
  Shape shape = make(Shape::Kind::kCells, place);
  shape.cells = std::make_shared<const plane::Region>(std::move(cells));
  return share(std::move(shape));
}

Contour ring_of(const Disc& disc, ReadContext& context) {
  auto radius = static_cast<std::int64_t>(round(disc.radius));
  double moved = std::abs((disc.radius - Real(radius)).to_double());
  context.rounding.add(moved, 0);
  if (radius == 0) throw Error(ErrorCode::kGeometry, "a circle smaller than a grid step");
  return plane::circle_ring(disc.center, radius);
}

std::vector<Contour> take_rings(Drawing& drawing) {
  std::vector<Contour> rings;
  for (Chain& chain : drawing.chains) {
    if (chain.closed) rings.push_back(std::move(chain.edges));
  }
  drawing.chains.erase(
      std::remove_if(drawing.chains.begin(), drawing.chains.end(), [](const Chain& c) { return c.closed; }),
      drawing.chains.end());
  return rings;
}

void add_lines_and_points(Drawing drawing, ReadContext& context, const std::string& place, std::vector<ShapePtr>& all) {
  for (Chain& chain : drawing.chains) {
    if (chain.closed) chain.edges.push_back(ContourEdge{.start = chain.edges[0].start});
    Shape shape = make(Shape::Kind::kPolyline, place);
    shape.contours.push_back(plane::make_chain(std::move(chain.edges), context.repeated_points));
    all.push_back(share(std::move(shape)));
  }
  if (!drawing.points.empty()) {
    Shape shape = make(Shape::Kind::kPoints, place);
    shape.points = std::move(drawing.points);
    all.push_back(share(std::move(shape)));
  }
}

}  // namespace

ShapePtr united(std::vector<ShapePtr> parts, const std::string& place, bool collection) {
  if (parts.size() == 1) return parts[0];
  Shape shape = make(Shape::Kind::kUnion, place);
  shape.children = std::move(parts);
  shape.collection = collection;
  return share(std::move(shape));
}

int open_chains(const Drawing& drawing) {
  return static_cast<int>(
      std::count_if(drawing.chains.begin(), drawing.chains.end(), [](const Chain& c) { return !c.closed; }));
}

std::vector<ShapePtr> parts_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all;
  std::vector<Contour> rings = take_rings(drawing);
  if (rings.empty() && drawing.discs.size() == 1) {
    Shape shape = make(Shape::Kind::kDisc, place);
    shape.points = {drawing.discs[0].center};
    shape.amount = drawing.discs[0].radius;
    all.push_back(share(std::move(shape)));
  } else {
    for (const Disc& disc : drawing.discs) rings.push_back(ring_of(disc, context));
    if (auto cells = plane::region_of_touching_rings(rings, plane::RingRule::kEvenOdd)) {
      all.push_back(cells_shape(*std::move(cells), place));
      rings.clear();
    }
    for (plane::RingSet& set : plane::nest_rings(std::move(rings), context.grid.step_size())) {
      context.repeated_points += set.repeated_points;
      all.push_back(rings_shape(std::move(set.contours), place));
    }
  }
  add_lines_and_points(std::move(drawing), context, place, all);
  return all;
}

ShapePtr lines_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all;
  add_lines_and_points(std::move(drawing), context, place, all);
  return united(std::move(all), place);
}

ShapePtr shape_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all = parts_of(std::move(drawing), context, place);
  if (all.empty()) throw Error(ErrorCode::kGeometry, "an outline that draws nothing");
  return united(std::move(all), place);
}

ShapePtr polygon_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<Contour> rings = take_rings(drawing);
  if (auto cells = plane::region_of_touching_rings(rings, plane::RingRule::kHoles))
    return cells_shape(*std::move(cells), place);
  plane::RingSet set = plane::make_rings(std::move(rings), context.grid.step_size());
  context.repeated_points += set.repeated_points;
  return rings_shape(std::move(set.contours), place);  // formats disagree about the direction of rings: no note
}

}  // namespace findspace::io
