// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/tilting_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

/// Four columns a part: its move, and how far its farthest corner turns, counter-clockwise and clockwise; then the
/// length.
int dx_of(std::size_t item) { return int(4 * item); }
int dy_of(std::size_t item) { return int(4 * item + 1); }
int ccw_of(std::size_t item) { return int(4 * item + 2); }
int cw_of(std::size_t item) { return int(4 * item + 3); }

Vec quarter_turn(Vec v) { return {-v.y, v.x}; }

Vec rotated(Vec v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// The corner on a segment nearest to where `way` units of it are gone.
Vec on_segment(Vec from, Vec direction, double length, double way) {
  return from + std::clamp(way, 0.0, length) * direction;
}

}  // namespace

TiltingMoves::Body TiltingMoves::body_of(const Variant& variant) {
  Body body;
  for (const auto& ring : variant.shape.rings) {
    auto& corners = body.rings.emplace_back();
    for (const auto& [x, y] : ring) corners.push_back({double(x) * variant.shape.step, double(y) * variant.shape.step});
  }
  body.middle = 0.5 * (variant.low + variant.high);
  for (const Vec corner : body.rings[0])
    body.radius = std::max(body.radius, std::hypot(corner.x - body.middle.x, corner.y - body.middle.y));
  body.is_round = variant.shape.round.has_value();
  return body;
}

bool TiltingMoves::add_corners_at_edges(const Contact& pair, Vec t, const Side& side, bool swapped) {
  const Body &edges = bodies_[swapped ? pair.b : pair.a], &corners = bodies_[swapped ? pair.a : pair.b];
  const Vec normal = swapped ? Vec{-side.normal.x, -side.normal.y} : side.normal;
  const Vec off = swapped ? Vec{-t.x, -t.y} : t;
  bool found = false;
  for (const auto& ring : edges.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec from = ring[i], way = ring[(i + 1) % ring.size()] - from;
      const double length = std::hypot(way.x, way.y);
      const Vec direction = (1 / length) * way, outward{direction.y, -direction.x};
      if (dot(outward, normal) < 1 - margin::kTiltDirection) continue;
      for (const auto& other : corners.rings)
        for (const Vec corner : other) {
          const Vec from_edge = corner + off - from;
          const double gone = dot(from_edge, direction), left = dot(from_edge, normal) - side.gap;
          if (gone < -side.reach || gone > length + side.reach) continue;
          if (left + side.lacks < -side.tolerance || left + side.lacks > side.reach) continue;
          found = found || left + side.lacks <= side.tolerance;
          const Vec met = on_segment(from, direction, length, gone);
          contacts_.push_back(
              {pair.a, pair.b, side.normal, swapped ? corner : met, swapped ? met : corner, std::min(-left, 0.0)});
        }
    }
  return found;
}

/// Two corners with the line across the way between them.
bool TiltingMoves::add_corners(const Contact& pair, Vec t, const Side& side) {
  double nearest = std::numeric_limits<double>::infinity();
  Contact best = pair;
  for (const auto& ring : bodies_[pair.a].rings)
    for (const Vec on_a : ring)
      for (const auto& other : bodies_[pair.b].rings)
        for (const Vec on_b : other) {
          const Vec way = t + on_b - on_a;
          if (std::abs(dot(side.normal, way) - side.gap + side.lacks) > side.tolerance) continue;
          if (const double beside = std::abs(cross(side.normal, way)); beside < nearest) {
            nearest = beside;
            best.on_a = on_a;
            best.on_b = on_b;
          }
        }
  if (nearest > side.reach) return false;
  best.normal = side.normal;
  best.need = std::min(side.lacks, 0.0);
  contacts_.push_back(best);
  return true;
}

bool TiltingMoves::add_contacts(const Contact& pair, Vec t, const Side& side) {
  const bool by_edge = add_corners_at_edges(pair, t, side, false);
  return add_corners_at_edges(pair, t, side, true) || by_edge || add_corners(pair, t, side);
}

void TiltingMoves::collect_pair(const std::vector<Pose>& poses, std::size_t a, std::size_t b, double trust) {
  const Pose &first = poses[a], &second = b < poses.size() ? poses[b] : row_.obstacles()[b - poses.size()];
  const Vec t = second.at - first.at;
  const Variant &va = variant(first), &vb = variant(second);
  const double reach = 4 * trust, clearance = reach + 2 * table_.gap();
  const bool tied = table_.are_tied(first.variant, second.variant);
  if (!tied && (t.x - clearance > va.high.x - vb.low.x || t.x + clearance < va.low.x - vb.high.x ||
                t.y - clearance > va.high.y - vb.low.y || t.y + clearance < va.low.y - vb.high.y))
    return;
  const FieldTable::Link& link = table_.link(first.variant, second.variant);
  const Vec at = link.in_field(t);
  const Nearest inside = link.field().nearest(at);
  const double height = table_.height(), gap = link.gap();
  free_half_planes(link.field().polygon(), inside.depth > 0 ? inside.projection : at, reach, height, planes_);
  const double known = height * (bodies_[a].is_round || bodies_[b].is_round ? margin::kTiltOfArcs : margin::kTilt);
  for (const HalfPlane& h : planes_) {
    const Side side{link.rotated(h.normal), h.offset - dot(h.normal, at), gap, reach, known + 0.01 * gap};
    if (!tied && add_contacts({a, b, {}, {}, {}, 0}, t, side)) continue;
    for (const std::size_t item : {a, b}) keeps_angle_[item] = true;
    contacts_.push_back({a, b, side.normal, bodies_[a].middle, bodies_[b].middle, std::min(side.lacks, 0.0)});
  }
}

/// Of a place of an item, along the normal.
void TiltingMoves::add_velocity(LinearProgram& program, std::size_t item, Vec normal, Vec place, double sign) const {
  const Body& body = bodies_[item];
  program.add(dx_of(item), sign * normal.x);
  program.add(dy_of(item), sign * normal.y);
  const double turn = sign * dot(normal, quarter_turn(place - body.middle)) / body.radius;
  program.add(ccw_of(item), turn);
  program.add(cw_of(item), -turn);
}

/// Corners near a side of their room, or near the end, stay before it.
void TiltingMoves::add_walls(LinearProgram& program, const std::vector<Pose>& poses, int end, double trust) const {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Variant& v = variant(poses[i]);
    const Room<Vec>& room = row_.rooms()[row_.room_of(v, poses[i].at)];
    const auto keep = [&](Vec normal, double least, Vec corner) {
      const double left = dot(normal, poses[i].at + corner) - least;
      if (left > 4 * trust) return;
      program.begin_row(std::min(-left, 0.0));
      add_velocity(program, i, normal, corner, 1);
    };
    for (const Vec corner : bodies_[i].rings[0]) {
      keep({1, 0}, room.low.x, corner);
      keep({0, 1}, 0, corner);
      keep({-1, 0}, -room.high.x, corner);
      keep({0, -1}, -room.high.y, corner);
      if (corner.x < v.high.x - 4 * trust) continue;
      program.begin_row(poses[i].at.x + std::min(corner.x, v.high.x));  // of arcs the corners lie outside
      program.add(end, 1);
      add_velocity(program, i, {1, 0}, corner, -1);
    }
  }
}

std::optional<std::vector<TiltingMoves::Move>> TiltingMoves::shorten(const std::vector<Pose>& poses,
                                                                     const std::vector<TiltRange>& ranges,
                                                                     double length, double trust) {
  bodies_.clear();
  for (const Pose& pose : poses) bodies_.push_back(body_of(variant(pose)));
  for (const Pose& pose : row_.obstacles()) bodies_.push_back(body_of(variant(pose)));
  keeps_angle_.assign(bodies_.size(), false);
  contacts_.clear();
  for (std::size_t a = 0; a < poses.size(); ++a)
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) collect_pair(poses, a, b, trust);
  LinearProgram program(table_.height());
  bool any = false;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    program.add_column(-trust, trust, 0);
    program.add_column(-trust, trust, 0);
    const double radius = keeps_angle_[i] ? 0 : bodies_[i].radius;
    program.add_column(0, std::clamp(ranges[i].high * radius, 0.0, trust), margin::kCostOfTilt);
    program.add_column(0, std::clamp(-ranges[i].low * radius, 0.0, trust), margin::kCostOfTilt);
    any = any || (radius > 0 && ranges[i].low < ranges[i].high);
  }
  if (!any) return std::nullopt;
  const int end = program.add_column(row_.fixed_end(), std::max(length, row_.fixed_end()), 1);
  add_walls(program, poses, end, trust);
  for (const Contact& c : contacts_) {
    program.begin_row(c.need);
    add_velocity(program, c.a, c.normal, c.on_a, -1);
    if (c.b < poses.size()) add_velocity(program, c.b, c.normal, c.on_b, 1);
  }
  if (!program.solve()) return std::nullopt;
  std::vector<Move> moves;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double angle = (program.value(ccw_of(i)) - program.value(cw_of(i))) / bodies_[i].radius;
    const Vec middle = bodies_[i].middle, moved{program.value(dx_of(i)), program.value(dy_of(i))};
    moves.push_back({poses[i].at + moved + middle - rotated(middle, angle), angle});
  }
  return moves;
}

}  // namespace findspace::packing
