// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "findspace/error.h"
#include "plane/contour/contour.h"

namespace findspace::io {

using exact::Real;
using plane::ContourEdge;
using plane::GridPoint;

namespace {

constexpr double kFlat = 0.5;  // grid steps: an arc that rises less is a segment

ContourEdge segment(GridPoint from) { return {.start = from}; }

double chord_of(GridPoint from, GridPoint to) { return std::hypot(double(to.x - from.x), double(to.y - from.y)); }

/// Of an arc, in grid steps: its radius, and how far it rises over its chord.
double radius_of(GridPoint from, GridPoint to, const Real& bulge) {
  const double b = std::abs(bulge.to_double());
  return chord_of(from, to) * (1 + b * b) / (4 * b);
}
double rise_of(GridPoint from, GridPoint to, const Real& bulge) {
  return chord_of(from, to) * std::abs(bulge.to_double()) / 2;
}

[[noreturn]] void refuse_radius() {
  throw Error(ErrorCode::kOutOfRange, "an arc's radius is more than 2^40 grid steps");
}

/// The arc, less than half a circle, as a rational curve of degree 2, exactly: its radius is too large for an arc on
/// the grid. With t = tan of a quarter of its angle, the tangents at its ends meet at height 2t / (1 - t^2) halves of
/// the chord over its middle.
plane::Curve as_curve(GridPoint from, GridPoint to, const Real& bulge) {
  const Real square = bulge * bulge, dx(to.x - from.x), dy(to.y - from.y);
  const Real height = bulge / (Real(1) - square);
  const plane::CurvePoint top{(Real(from.x) + Real(to.x)) / Real(2) + dy * height,
                              (Real(from.y) + Real(to.y)) / Real(2) - dx * height};
  const std::array<plane::CurvePoint, 3> points{{{Real(from.x), Real(from.y)}, top, {Real(to.x), Real(to.y)}}};
  const std::array<Real, 3> weights{Real(1), (Real(1) - square) / (Real(1) + square), Real(1)};
  return plane::bezier_curve(points, weights, from, to);
}

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
    bool flat = plane::sagitta(edge, to) < kFlat;
    if (flat) {
      edge = segment(edge.start);
      context_.rounding.add(0.5, 0);
    } else if (edge.arc->r.to_double() > static_cast<double>(Grid::kLimit)) {
      refuse_radius();
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
  if (radius_of(at_, to, bulge) > static_cast<double>(Grid::kLimit) && rise_of(at_, to, bulge) >= kFlat) {
    if (compare(abs(bulge), Real(1)) >= 0) refuse_radius();
    return add(as_curve(at_, to, bulge));
  }
  bool moved = false;
  ContourEdge edge = plane::bulge_arc(at_, to, bulge, &moved);
  if (moved) context_.rounding.add(0.5, 0.5);
  add(std::move(edge), to);
}

void Outline::through_to(const Real& mx, const Real& my, const Real& x, const Real& y) {
  begin();
  GridPoint through = grid_point(mx, my), to = grid_point(x, y);
  if (to == at_) {
    if (mx == x && my == y) throw Error(ErrorCode::kGeometry, "an arc whose three points are one");
    if (std::abs(through.x - at_.x) <= 1 && std::abs(through.y - at_.y) <= 1) return;  // less than the grid shows
    bool moved = false;  // a full circle: the point given is opposite
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

plane::CurvePoint Outline::steps(const plane::CurvePoint& p) const {
  return {context_.grid.steps(p.x * scale_), context_.grid.steps(p.y * scale_)};
}

EllipseArc Outline::steps(const EllipseArc& arc) const {
  return {{steps(arc.frame.center), steps(arc.frame.u), steps(arc.frame.v)}, arc.first, arc.sweep};
}

void Outline::add(plane::Curve curve) {
  const GridPoint to = curve.to;
  edges_.push_back(segment(at_));
  curves_.resize(edges_.size());
  curves_.back() = std::make_shared<const plane::Curve>(std::move(curve));
  at_ = to;
}

void Outline::curve_to(std::span<const plane::CurvePoint> points, std::span<const Real> weights) {
  begin();
  std::vector<plane::CurvePoint> all{{Real(at_.x), Real(at_.y)}};
  for (const plane::CurvePoint& p : points) all.push_back(steps(p));
  const GridPoint to = grid_point(points.back().x, points.back().y);
  auto here = [&](const plane::CurvePoint& p) {
    return abs(p.x - Real(at_.x)) <= Real(1) && abs(p.y - Real(at_.y)) <= Real(1);
  };
  if (to == at_ && std::all_of(all.begin(), all.end(), here)) return;
  add(plane::bezier_curve(all, weights, at_, to));
}

void Outline::ellipse_to(const EllipseArc& arc, const Real& x, const Real& y) {
  begin();
  const GridPoint to = grid_point(x, y);
  if (to == at_) return;
  const EllipseArc a = steps(arc);
  add(plane::ellipse_curve(a.frame, a.first, a.sweep, at_, to));
}

void Outline::spline_to(plane::Spline spline) {
  begin();
  plane::check_spline(spline);
  const plane::CurvePoint end = plane::spline_end(spline, true);
  const GridPoint to = grid_point(end.x, end.y);
  for (plane::CurvePoint& p : spline.points) p = steps(p);
  add(plane::spline_curve(spline, at_, to));
}

void Outline::ellipse(const EllipseArc& whole) {
  finish();
  const plane::EllipseFrame& f = whole.frame;
  move_to(f.center.x + f.u.x, f.center.y + f.u.y);
  const EllipseArc a = steps(whole);
  add(plane::ellipse_curve(a.frame, a.first, a.sweep, at_, at_));
  close();
}

void Outline::end_chain(bool closed) {
  if (!curves_.empty()) curves_.resize(edges_.size());
  drawing_.chains.push_back({std::move(edges_), closed, std::move(curves_), name_});
}

void Outline::close() {
  if (!running_) return;
  if (edges_.empty()) throw Error(ErrorCode::kGeometry, "a closed outline of a single point");
  if (at_ != start_) edges_.push_back(segment(at_));
  end_chain(true);
  edges_.clear();
  curves_.clear();
  running_ = false;
}

void Outline::finish() {
  if (running_ && !edges_.empty()) {
    bool closed = at_ == start_;
    if (!closed) edges_.push_back(segment(at_));
    end_chain(closed);
  }
  edges_.clear();
  curves_.clear();
  running_ = false;
}

void Outline::circle(const Real& x, const Real& y, const Real& radius) {
  if (radius.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
  drawing_.discs.push_back({grid_point(x, y), context_.grid.steps(radius * scale_), name_});
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
