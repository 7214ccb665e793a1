// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "findspace/error.h"
#include "plane/build/touching_rings.h"
#include "plane/contour/contour.h"

namespace findspace::io {

using exact::Real;
using plane::Contour;
using plane::ContourEdge;
using plane::GridPoint;
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

ContourEdge segment(GridPoint from) { return {.start = from}; }

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

}  // namespace

ShapePtr united(std::vector<ShapePtr> parts, const std::string& place, bool collection) {
  if (parts.size() == 1) return parts[0];
  Shape shape = make(Shape::Kind::kUnion, place);
  shape.children = std::move(parts);
  shape.collection = collection;
  return share(std::move(shape));
}

GridPoint Outline::grid_point(const Real& x, const Real& y) {
  return context_.grid.nearest(x * scale_, y * scale_, context_.rounding);
}

void Outline::move_to(const Real& x, const Real& y) {
  finish();
  start_ = at_ = grid_point(x, y);
  running_ = true;
}

void Outline::begin() {
  if (!running_) at_ = start_;
  running_ = true;
}

void Outline::add(ContourEdge edge, GridPoint to) {
  if (edge.arc) {
    bool flat = plane::sagitta(edge, to) < 0.5;
    if (flat) {
      edge = segment(edge.start);
      context_.rounding.add(0.5, 0);
    } else if (edge.arc->r.to_double() > static_cast<double>(Grid::kLimit)) {
      throw Error(ErrorCode::kOutOfRange, "an arc's radius is more than 2^40 grid steps");
    }
  }
  edges_.push_back(std::move(edge));
  at_ = to;
}

void Outline::line_to(const Real& x, const Real& y) {
  begin();
  add(segment(at_), grid_point(x, y));
}

void Outline::arc_to(const Real& radius, bool large, bool ccw, const Real& x, const Real& y) {
  begin();
  GridPoint to = grid_point(x, y);
  if (to == at_) return;
  Real r = context_.grid.steps(radius * scale_);
  bool grown = false;
  ContourEdge edge = plane::radius_arc(at_, to, r, large, ccw, &grown);
  if (grown && edge.arc->r.to_double() > r.to_double() + 1) ++context_.grown_arcs;  // less than that is rounding
  add(std::move(edge), to);
}

void Outline::bulge_to(const Real& bulge, const Real& x, const Real& y) {
  begin();
  GridPoint to = grid_point(x, y);
  if (to == at_) return;
  if (bulge.sign() == 0) return add(segment(at_), to);
  bool moved = false;
  ContourEdge edge = plane::bulge_arc(at_, to, bulge, &moved);
  if (moved) context_.rounding.add(0.5, 0.5);
  add(std::move(edge), to);
}

void Outline::through_to(const Real& mx, const Real& my, const Real& x, const Real& y) {
  begin();
  GridPoint through = grid_point(mx, my), to = grid_point(x, y);
  if (to == at_) {
    bool moved = false;  // a full circle: the point given is opposite
    if (through == at_) throw Error(ErrorCode::kGeometry, "an arc whose three points are one");
    add(plane::bulge_arc(at_, through, Real(1), &moved), through);
    add(plane::bulge_arc(at_, to, Real(1), &moved), to);
    return;
  }
  if (through == at_ || through == to) return add(segment(at_), to);
  bool moved = false;
  ContourEdge edge = plane::three_point_arc(at_, through, to, &moved);
  if (moved) context_.rounding.add(0.5, 0.5);
  add(std::move(edge), to);
}

void Outline::close() {
  if (!running_) return;
  if (edges_.empty()) throw Error(ErrorCode::kGeometry, "a closed outline of a single point");
  if (at_ != start_) edges_.push_back(segment(at_));
  chains_.push_back({std::move(edges_), true});
  edges_.clear();
  running_ = false;
}

void Outline::finish() {
  if (running_ && !edges_.empty()) {
    bool closed = at_ == start_;
    if (!closed) edges_.push_back(segment(at_));
    chains_.push_back({std::move(edges_), closed});
  }
  edges_.clear();
  running_ = false;
}

void Outline::circle(const Real& x, const Real& y, const Real& radius) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
  discs_.push_back({grid_point(x, y), context_.grid.steps(radius * scale_)});
}

void Outline::point(const Real& x, const Real& y) { points_.push_back(grid_point(x, y)); }

bool Outline::is_at(const Real& x, const Real& y) {
  RoundingLog ignored;
  return running_ && context_.grid.nearest(x * scale_, y * scale_, ignored) == at_;
}

int Outline::open_chains() const {
  return static_cast<int>(std::count_if(chains_.begin(), chains_.end(), [](const Chain& c) { return !c.closed; }));
}

Contour Outline::ring_of(const Disc& disc) {
  auto radius = static_cast<std::int64_t>(round(disc.radius));
  double moved = std::abs((disc.radius - Real(radius)).to_double());
  context_.rounding.add(moved, 0);
  if (radius == 0) throw Error(ErrorCode::kGeometry, "a circle smaller than a grid step");
  return plane::circle_ring(disc.center, radius);
}

std::vector<Contour> Outline::take_rings() {
  finish();
  std::vector<Contour> rings;
  for (Chain& chain : chains_) {
    if (chain.closed) rings.push_back(std::move(chain.edges));
  }
  chains_.erase(std::remove_if(chains_.begin(), chains_.end(), [](const Chain& c) { return c.closed; }), chains_.end());
  return rings;
}

std::vector<ShapePtr> Outline::parts(const std::string& place) {
  std::vector<ShapePtr> all;
  std::vector<Contour> rings = take_rings();
  if (rings.empty() && discs_.size() == 1) {
    Shape shape = make(Shape::Kind::kDisc, place);
    shape.points = {discs_[0].center};
    shape.amount = discs_[0].radius;
    all.push_back(share(std::move(shape)));
  } else {
    for (const Disc& disc : discs_) rings.push_back(ring_of(disc));
    if (auto cells = plane::region_of_touching_rings(rings, plane::RingRule::kEvenOdd)) {
      all.push_back(cells_shape(*std::move(cells), place));
      rings.clear();
    }
    for (plane::RingSet& set : plane::nest_rings(std::move(rings), context_.grid.step_size())) {
      context_.repeated_points += set.repeated_points;
      all.push_back(rings_shape(std::move(set.contours), place));
    }
  }
  add_lines_and_points(all, place);
  return all;
}

void Outline::add_lines_and_points(std::vector<ShapePtr>& all, const std::string& place) {
  for (Chain& chain : chains_) {
    if (chain.closed) chain.edges.push_back(segment(chain.edges[0].start));
    Shape shape = make(Shape::Kind::kPolyline, place);
    shape.contours.push_back(plane::make_chain(std::move(chain.edges), context_.repeated_points));
    all.push_back(share(std::move(shape)));
  }
  if (!points_.empty()) {
    Shape shape = make(Shape::Kind::kPoints, place);
    shape.points = points_;
    all.push_back(share(std::move(shape)));
  }
}

ShapePtr Outline::lines(const std::string& place) {
  finish();
  std::vector<ShapePtr> all;
  add_lines_and_points(all, place);
  return united(std::move(all), place);
}

ShapePtr Outline::shape(const std::string& place) {
  std::vector<ShapePtr> all = parts(place);
  if (all.empty()) throw Error(ErrorCode::kGeometry, "an outline that draws nothing");
  return united(std::move(all), place);
}

ShapePtr Outline::polygon(const std::string& place) {
  std::vector<Contour> rings = take_rings();
  if (auto cells = plane::region_of_touching_rings(rings, plane::RingRule::kHoles))
    return cells_shape(*std::move(cells), place);
  plane::RingSet set = plane::make_rings(std::move(rings), context_.grid.step_size());
  context_.repeated_points += set.repeated_points;
  return rings_shape(std::move(set.contours), place);  // formats disagree about the direction of rings: no note
}

}  // namespace findspace::io
