// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_ball.h"

#include <algorithm>
#include <cmath>

#include "distance/search/position_set.h"
#include "distance/surface/surface_field.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/body/ball_meet.h"
#include "space/body/open_union.h"
#include "space/polytope/extent.h"
#include "space/surface/surface_gap.h"

namespace findspace::distance {

using exact::Real;
using space::HalfSpace;
using space::Point;
using space::RealVector;
using space::Vector;
using Sheet = space::SurfaceSet::Sheet;

namespace {

// Exact names for what is found, where square roots have one: places known in doubles, and so which features of the
// surface the ball touches there.

/// The features that the ball touches at a place: faces by their planes, edges by their ends, corners.
struct Touched {
  std::vector<int> faces;
  std::vector<std::pair<Point, Point>> edges;
  std::vector<Point> corners;
};

/// The feature of the face on which its place nearest to y lies, as doubles see it.
void add_feature(const Sheet& sheet, int face, const Vector& y, double blur, Touched& out) {
  const Vector projection = space::nearest_place(sheet, face, y);
  for (int k = 0; k < 3; ++k) {
    const Point& v = sheet.body.corner(face, k);
    if (space::length(exact::approx(v) - projection) > blur) continue;
    if (std::find(out.corners.begin(), out.corners.end(), v) == out.corners.end()) out.corners.push_back(v);
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const Point &v = sheet.body.corner(face, k), &w = sheet.body.corner(face, (k + 1) % 3);
    const Vector e = exact::approx(w - v), f = projection - exact::approx(v);
    const double off = space::length(f - space::scaled(space::dot(e, f) / space::dot(e, e), e));
    if (off > blur) continue;
    const auto edge = std::minmax(
        v, w, [](const Point& p, const Point& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); });
    const std::pair<Point, Point> ends(edge.first, edge.second);
    if (std::find(out.edges.begin(), out.edges.end(), ends) == out.edges.end()) out.edges.push_back(ends);
    return;
  }
  out.faces.push_back(face);
}

Touched touched(const SurfaceBall& ball, const Vector& y, double blur) {
  const Sheet& sheet = *ball.surface->sheets()[0];
  const double reach = ball.radius.to_double() + 2 * blur + 1;
  const auto complete = [](double c) { return static_cast<std::int64_t>(std::floor(c)); };
  const space::GridBox about{{complete(y.x - reach), complete(y.y - reach), complete(y.z - reach)},
                             {complete(y.x + reach) + 1, complete(y.y + reach) + 1, complete(y.z + reach) + 1}};
  Touched out;
  sheet.tree.any_meeting(about, [&](int face) {
    const double d = std::sqrt(space::squared_distance(sheet, face, y));
    if (d <= ball.radius.to_double() + 2 * blur) add_feature(sheet, face, y, 64 * blur, out);
    return false;
  });
  return out;
}

/// The half space in which the ball is too near to the plane of the face, or beyond it.
HalfSpace too_near(const SurfaceBall& ball, int face) {
  const space::RayBody& body = ball.surface->sheets()[0]->body;
  RealVector normal = space::real(body.normals[static_cast<std::size_t>(face)]);
  if (ball.side == space::TouchSide::kInside) normal = space::negated(normal);
  const Real size = sqrt(space::dot(normal, normal));
  return HalfSpace(normal, -space::dot(normal, space::real(body.corner(face, 0))) - ball.radius * size);
}

/// Each once.
std::vector<HalfSpace> planes_of(const SurfaceBall& ball, const std::vector<int>& faces) {
  std::vector<HalfSpace> planes;
  for (const int face : faces) {
    HalfSpace plane = too_near(ball, face);
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
      return space::is_zero(space::cross(h.normal, plane.normal));
    });
    if (!known) planes.push_back(std::move(plane));
  }
  return planes;
}

/// The place nearest to x that lies before all planes; nothing where fewer than `least` of these hold it.
std::optional<RealVector> on_planes(const std::vector<HalfSpace>& planes, const RealVector& x, std::size_t least) {
  const plane::ScopedSearchWork of_no_question(nullptr);  // a few looks, also where that may take no more
  space::OpenUnion cover;
  for (const HalfSpace& h : planes) cover.add(space::everywhere(), space::OpenUnion::Planes{h});
  auto found = cover.nearest_in_complement(x).settled().or_throw();
  const auto holds = [&](const HalfSpace& h) { return h.sign(*found, space::rounded(*found)) == 0; };
  if (!found || std::size_t(std::count_if(planes.begin(), planes.end(), holds)) < least) return std::nullopt;
  return found;
}

/// Of the sphere about a corner, or of the cylinder about an edge, within at most one plane, to which the edge is
/// normal.
std::optional<RealVector> on_round(std::vector<HalfSpace> planes, const Touched& at, const RealVector& x,
                                   const Real& radius) {
  RealVector center;
  if (at.edges.empty()) {
    center = space::real(at.corners[0]);
  } else {
    const auto& [a, b] = at.edges[0];
    const RealVector along = space::real(b - a);
    if (planes.empty()) planes.emplace_back(along, -space::dot(along, x));
    if (!space::is_zero(space::cross(along, planes[0].normal))) return std::nullopt;
    center = space::name_places(planes, {}, space::real(a))[0];
  }
  const std::array<space::Ball, 1> sphere{{{center, radius}}};
  const auto places = space::name_places(planes, sphere, x);
  return places.empty() ? std::nullopt : std::optional(places[0]);
}

std::optional<RealVector> candidate(const SurfaceBall& ball, const Touched& at, const RealVector& x, bool corner) {
  const std::vector<HalfSpace> planes = planes_of(ball, at.faces);
  const std::size_t edges = at.edges.size(), corners = at.corners.size();
  if (edges + corners == 0 && !planes.empty()) return on_planes(planes, x, corner ? 3 : 1);
  if (corner || planes.size() > 1) return std::nullopt;
  if (edges + corners == 1) return on_round(planes, at, x, ball.radius);
  if (!planes.empty() || edges > 0 || corners == 0 || corners > space::BallMeet::kMostBalls) return std::nullopt;
  std::vector<space::Ball> balls;
  for (const Point& v : at.corners) balls.push_back({space::real(v), ball.radius});
  return nearest_outside(balls, x);
}

/// The place nearest to x (or, `farthest`, which several features have to hold) that is `blur` or less from `place`, at
/// which the ball touches and no triangle is nearer, exactly.
std::optional<RealVector> named_for_ball(const SurfaceBall& ball, const RealVector& x, const Vector& place,
                                         bool farthest, double blur) {
  const Touched at = touched(ball, place, blur);
  // A corner of planes that is the farthest place from x is the nearest one to what lies as far beyond it.
  RealVector from = x;
  if (farthest) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double c = k == 0 ? place.x : k == 1 ? place.y : place.z;
      from[k] = Real::from_double(2 * c) - x[k];
    }
  }
  const auto found = candidate(ball, at, from, farthest);
  if (!found || space::length(space::rounded(*found) - place) > blur) return std::nullopt;
  const RealVector way = space::way_to(*ball.surface->sheets()[0], *found);
  if (space::dot(way, way) < ball.radius * ball.radius) return std::nullopt;
  return found;
}

constexpr long kMostBallCells = 200000;

/// Triangles whose distances are searched in a cell of that share of the radius.
std::size_t few(double share) { return share > margin::kLargeShare ? 64 : 400; }

/// The functions of one search: distances to the triangles that may be nearest to a place of a cell, by number.
class BallConstraints : public LazyConstraints {
 public:
  BallConstraints(const SurfaceBall& ball, const SurfaceField& field, double size)
      : field_(field),
        sense_(ball.side == space::TouchSide::kOutside ? 1 : -1),
        radius_(ball.radius.to_double()),
        size_(size) {}

  Constraints constraints() override { return {{}, {}, this}; }
  bool spent() const override { return cells_ > plane::allowed(kMostBallCells); }

  double beyond(int number, const Vector& x) const override {
    return number == kNone ? -exact::kInfinity : field_.distance(number, x) - radius_;
  }

  std::vector<int> near(const Tetrahedron& cell, double /*edge*/, std::span<const int> known) override {
    ++cells_;
    if (!known.empty()) return {known.begin(), known.end()};
    const Vector middle = centre(cell);
    double half = 0;
    for (const Vector& v : cell) half = std::max(half, space::length(v - middle));
    const double noise = margin::kPlaceNoise * size_;
    const SurfaceField::Signed at = signed_at(middle);
    const double clear = sense_ * at.value - radius_;
    if ((at.certain || at.distance + half < radius_) && clear + half < -noise) return {kNone};
    // Near a surface that is as near as the radius all of a small cell is on one side of it.
    if ((at.certain && clear - half > noise) || !(half < radius_ / 4)) return {};
    return field_.near(middle, at.distance + 2 * half + noise, few(half / radius_)).value_or(std::vector<int>());
  }

  bool allows(const Vector& x, std::span<const int> known) const override {
    if (!known.empty()) return true;  // these say so
    const SurfaceField::Signed at = signed_at(x);
    return at.certain && sense_ * at.value - radius_ >= margin::kAllowed * size_;
  }

 private:
  static constexpr int kNone = -1;  // nothing of the cell is allowed

  /// The middle of a cell is asked for twice.
  const SurfaceField::Signed& signed_at(const Vector& x) const {
    const bool same = asked_ && asked_->x == x.x && asked_->y == x.y && asked_->z == x.z;  // no sign: the same place
    if (!same) {
      asked_ = x;
      answer_ = field_.at(x);
    }
    return answer_;
  }

  const SurfaceField& field_;
  double sense_, radius_, size_;
  long cells_ = 0;
  mutable std::optional<Vector> asked_;
  mutable SurfaceField::Signed answer_;
};

class BallSearch {
 public:
  BallSearch(const SurfaceBall& ball, const RealVector& x) : ball_(ball), x_(x), field_(*ball.surface, {}) {
    const space::RayBody& body = ball.surface->sheets()[0]->body;
    const double tolerance = ball.side == space::TouchSide::kOutside ? ball.radius.to_double() : 0;
    box_ = grown({exact::approx(body.low), exact::approx(body.high)}, tolerance);
    size_ = std::max(space::length(box_.low), space::length(box_.high)) + space::length(space::rounded(x));
  }

  BallPlace run(bool farthest) const {
    const PositionSet places =
        PositionSet::lazily([this] { return std::make_unique<BallConstraints>(ball_, field_, size_); }, box_, size_);
    const TouchingConstraint away = distance_to_point(space::rounded(x_));
    BoundaryPlace found;
    if (farthest) {
      found = places.farthest_from(space::rounded(x_));
    } else {
      std::optional<Answer> first = pushed();
      PositionSet::Query query;
      if (first) {
        const double reach = first->value.to_double() + margin::kAroundCube * size_;
        query.box = grown({space::rounded(x_), space::rounded(x_)}, reach);
        query.known = [&] { return std::optional(first->value.to_double()); };
      }
      found = places.nearest_to(away, query);
      if (found.known && found.complete && found.value - found.bound <= margin::kMostFoundError * size_)
        return {true, std::move(first)};
    }
    if (!found.complete) return {};
    if (!found.found) return {!std::isfinite(found.bound), std::nullopt};
    const double off = std::fabs(found.value - found.bound);
    if (off > margin::kMostFoundError * size_) return {};
    return {true, value(found, off, farthest)};
  }

 private:
  /// Where the ball is pushed to from the nearest place of the surface, if it is free there: mostly the nearest place.
  std::optional<Answer> pushed() const {
    const Vector near = space::rounded(x_);
    const SurfaceField::Signed at = field_.at(near);
    if (!at.certain || !(at.distance > 0)) return std::nullopt;
    const bool outside = at.value > 0, wanted = ball_.side == space::TouchSide::kOutside;
    const double by = (outside == wanted ? 1 : -1) * ball_.radius.to_double() / at.distance;
    const Vector place = space::plus(at.projection, space::scaled(by, near - at.projection));
    const auto named = named_for_ball(ball_, x_, place, false, margin::kFoundError * size_ * 64);
    if (!named) return std::nullopt;
    // The nearest surface may be a wall within, and what is beyond it not free.
    const SurfaceField::Signed there = field_.at(space::rounded(*named));
    if (!there.certain || (there.value > 0) != wanted) return std::nullopt;
    return signed_value(x_, *named, 1);
  }

  Answer value(const BoundaryPlace& found, double off, bool farthest) const {
    const double error = margin::kFoundError * size_ + off;
    if (const auto named = named_for_ball(ball_, x_, found.place, farthest, error * 64))
      return signed_value(x_, *named, 1);
    Answer out = unproven_answer(found.value, error);
    out.nearest = space::real(found.place);
    return out;
  }

  const SurfaceBall& ball_;
  const RealVector& x_;
  SurfaceField field_;
  space::Extent box_;
  double size_ = 0;
};

}  // namespace

BallPlace nearest_for_ball(const SurfaceBall& ball, const RealVector& x) { return BallSearch(ball, x).run(false); }
BallPlace farthest_for_ball(const SurfaceBall& ball, const RealVector& x) { return BallSearch(ball, x).run(true); }

}  // namespace findspace::distance
