// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_outline.h"

#include <utility>

#include "findspace/error.h"
#include "plane/contour/contour.h"

namespace findspace::io {

using exact::Real;
using plane::ContourEdge;
using plane::GridPoint;

namespace {

ContourEdge segment(GridPoint from) { return {.start = from}; }

}  // namespace

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
  drawing_.chains.push_back({std::move(edges_), true});
  edges_.clear();
  running_ = false;
}

void Outline::finish() {
  if (running_ && !edges_.empty()) {
    bool closed = at_ == start_;
    if (!closed) edges_.push_back(segment(at_));
    drawing_.chains.push_back({std::move(edges_), closed});
  }
  edges_.clear();
  running_ = false;
}

void Outline::circle(const Real& x, const Real& y, const Real& radius) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
  drawing_.discs.push_back({grid_point(x, y), context_.grid.steps(radius * scale_)});
}

void Outline::point(const Real& x, const Real& y) { drawing_.points.push_back(grid_point(x, y)); }

bool Outline::is_at(const Real& x, const Real& y) {
  RoundingLog ignored;
  return running_ && context_.grid.nearest(x * scale_, y * scale_, ignored) == at_;
}

Drawing Outline::take() {
  finish();
  return std::exchange(drawing_, {});
}

}  // namespace findspace::io
