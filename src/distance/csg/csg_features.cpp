// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_features.h"

#include <algorithm>
#include <cmath>

#include "distance/csg/csg_part.h"
#include "exact/margins/csg_features.h"
#include "exact/number/interval.h"
#include "plane/base/search_work.h"
#include "space/body/body_boxes.h"

namespace findspace::distance {

using space::BodyPart;
using space::dot;
using space::Extent;
using space::Vector;

namespace {

/// Surfaces, at most: pairs of them are looked at.
constexpr std::size_t kMostSurfaces = 2000, kMostPlanes = 100;
/// Points of a stretch: a search tells sooner then.
constexpr int kMostPoints = 200;
/// Steps are at most this many distances long.
constexpr double kLongest = 16;
constexpr std::array<int, 3> kNowhere{-1, -1, -1};

/// How two surfaces meet, of which the second comes so near to the middle of something round.
enum class Meet { kApart, kTouch, kNearly, kCross };
Meet meet(double near, double radius, double noise) {
  if (near > radius + noise) return Meet::kApart;
  if (near > radius - noise) return Meet::kTouch;
  const double half = std::sqrt((radius - near) * (radius + near));
  return half < margin::kFlatMeet * radius ? Meet::kNearly : Meet::kCross;
}

Extent about(const Vector& at, const Vector& by) { return {at - by, space::plus(at, by)}; }

}  // namespace

double CsgFeatures::Surface::value(const Vector& x) const {
  if (ball == 0) return dot(at, x) + by;
  return ball * (space::length(x - at) - by);
}

Vector CsgFeatures::Feature::nearest(const Vector& x) const {
  switch (kind) {
    case Kind::kPlane:
      return x - space::scaled(dot(unit, x) + radius, unit);
    case Kind::kSphere: {
      const Vector off = x - at;
      const double far = space::length(off);
      return space::plus(at, far > 0 ? space::scaled(radius / far, off) : Vector{radius, 0, 0});
    }
    case Kind::kEdge:
      return space::plus(at, space::scaled(dot(x - at, unit), unit));
    case Kind::kCircle: {
      Vector off = x - at;
      off = off - space::scaled(dot(off, unit), unit);
      const double far = space::length(off);
      return space::plus(at, space::scaled(radius, far > 0 ? space::scaled(1 / far, off) : distance::across(unit)));
    }
    case Kind::kPoint:
      return at;
  }
  return at;
}

std::unique_ptr<const CsgFeatures> CsgFeatures::of(const space::CsgPart& part, double size) {
  std::unique_ptr<CsgFeatures> out(new CsgFeatures);
  out->noise_ = margin::kDistanceNoise * size;
  out->tolerance_ = margin::kPlaceBreaks * size;
  out->box_ = grown(space::rounded(bounds(part)), margin::kAroundPart * size);
  if (!out->add_surfaces(part)) return nullptr;
  const int count = static_cast<int>(out->surfaces_.size());
  for (int i = 0; i < count; ++i) out->add_plane_or_sphere(i);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!out->add_pair(i, j)) return nullptr;
    }
  }
  out->tree_ = space::ExtentTree(std::move(out->boxes_));
  return out;
}

bool CsgFeatures::add_surfaces(const space::CsgPart& part) {
  std::vector<Extent> cut_boxes;
  for (const std::vector<BodyPart>* sets : {&part.within, &part.without}) {
    const bool cut = sets == &part.without;
    for (const BodyPart& set : *sets) {
      if (set.point()) {
        const double radius = set.radius.to_double();
        const Surface ball{exact::approx(set.center), radius, cut ? -1 : 1};
        if (!(radius > 0)) return false;
        (cut ? cuts_ : plain_).push_back(static_cast<int>(surfaces_.size()));
        if (cut) cut_boxes.push_back(about(ball.at, {radius, radius, radius}));
        surfaces_.push_back(ball);
        continue;
      }
      if (cut || !set.core || set.radius.sign() > 0) return false;
      for (const space::HalfSpace& h : set.planes()) {
        plain_.push_back(static_cast<int>(surfaces_.size()));
        surfaces_.push_back({h.unit, h.shift, 0});
      }
    }
  }
  if (surfaces_.size() > kMostSurfaces || plain_.size() > kMostPlanes) return false;
  cut_tree_ = space::ExtentTree(std::move(cut_boxes));
  return true;
}

void CsgFeatures::add(const Feature& feature, const Extent& box) {
  const Extent inside = in_both(box, box_);
  if (inside.low.x > inside.high.x || inside.low.y > inside.high.y || inside.low.z > inside.high.z) return;
  features_.push_back(feature);
  boxes_.push_back(inside);
}

void CsgFeatures::add_plane_or_sphere(int k) {
  const Surface& s = surfaces_[static_cast<std::size_t>(k)];
  if (s.ball == 0) return add({Kind::kPlane, {k, -1, -1}, {}, s.at, s.by}, box_);
  add({Kind::kSphere, {k, -1, -1}, s.at, {}, s.by}, about(s.at, {s.by, s.by, s.by}));
}

bool CsgFeatures::add_pair(int i, int j) {
  const bool first = surfaces_[static_cast<std::size_t>(i)].ball != 0,
             second = surfaces_[static_cast<std::size_t>(j)].ball != 0;
  if (!first && !second) return add_edge(i, j);
  return first ? add_circle(i, j) : add_circle(j, i);
}

/// As far as all other planes allow.
bool CsgFeatures::add_edge(int i, int j) {
  const Surface &a = surfaces_[static_cast<std::size_t>(i)], &b = surfaces_[static_cast<std::size_t>(j)];
  const Vector way = space::cross(a.at, b.at);
  const double angle = space::length(way);
  if (angle < margin::kSameNormal) return true;
  Feature edge{Kind::kEdge, {i, j, -1}, {}, space::scaled(1 / angle, way)};
  const double both = dot(a.at, b.at);
  edge.at = space::plus(space::scaled((b.by * both - a.by) / (angle * angle), a.at),
                        space::scaled((a.by * both - b.by) / (angle * angle), b.at));
  double from = -exact::kInfinity, to = exact::kInfinity;
  int first = -1, last = -1;
  for (const int k : plain_) {
    const Surface& s = surfaces_[static_cast<std::size_t>(k)];
    if (k == i || k == j || s.ball != 0) continue;
    const double value = s.value(edge.at), ahead = dot(s.at, edge.unit);
    if (std::fabs(ahead) < margin::kSameNormal) {  // no sign: the place is tested
      if (value > noise_) return true;
      continue;
    }
    const double end = -value / ahead;
    if (ahead > 0 && end < to) {
      to = end;
      last = k;
    }
    if (ahead < 0 && end > from) {
      from = end;
      first = k;
    }
  }
  if (!(from <= to + noise_)) return true;
  if (angle < margin::kFlatMeet) return false;
  const auto along = [&](double t) { return space::plus(edge.at, space::scaled(t, edge.unit)); };
  Extent box = space::everywhere();
  if (first >= 0 && last >= 0) {
    box = Extent{along(from), along(from)};
    box.add({along(to), along(to)});
    box = grown(box, noise_);
  }
  if (first >= 0) add_point(along(from), {i, j, first});
  if (last >= 0) add_point(along(to), {i, j, last});
  add(edge, box);
  return add_on_edge(edge, from, to);
}

bool CsgFeatures::add_on_edge(const Feature& edge, double from, double to) {
  for (int k = 0; k < static_cast<int>(surfaces_.size()); ++k) {
    const Surface& s = surfaces_[static_cast<std::size_t>(k)];
    if (s.ball == 0) continue;
    const double middle = dot(s.at - edge.at, edge.unit);
    const Vector at = space::plus(edge.at, space::scaled(middle, edge.unit));
    const double near = space::length(at - s.at);
    const Meet how = meet(near, s.by, noise_);
    if (how == Meet::kApart || middle + s.by < from || middle - s.by > to || how == Meet::kTouch) continue;
    if (how == Meet::kNearly) return false;
    const double half = std::sqrt((s.by - near) * (s.by + near));
    for (const double t : {-half, half})
      add_point(space::plus(at, space::scaled(t, edge.unit)), {edge.on[0], edge.on[1], k});
  }
  return true;
}

std::optional<CsgFeatures::Surface> CsgFeatures::plane_with(int sphere, int other) const {
  const Surface &s = surfaces_[static_cast<std::size_t>(sphere)], &o = surfaces_[static_cast<std::size_t>(other)];
  if (o.ball == 0) return o;
  const Vector way = o.at - s.at;
  const double far = space::length(way);
  if (far <= noise_) return std::nullopt;
  const double ahead = (far * far + s.by * s.by - o.by * o.by) / (2 * far);
  const Vector unit = space::scaled(1 / far, way);
  return Surface{unit, -dot(unit, s.at) - ahead, 0};
}

bool CsgFeatures::add_circle(int sphere, int other) {
  const Surface& s = surfaces_[static_cast<std::size_t>(sphere)];
  const std::optional<Surface> plane = plane_with(sphere, other);
  if (!plane) return true;
  const double high = plane->value(s.at);
  const Meet how = meet(std::fabs(high), s.by, noise_);
  if (how == Meet::kApart || how == Meet::kTouch) return true;
  if (how == Meet::kNearly) return false;
  Feature circle{Kind::kCircle, {sphere, other, -1}, s.at - space::scaled(high, plane->at), plane->at};
  circle.radius = std::sqrt((s.by - high) * (s.by + high));
  const auto reach = [&](double along) { return circle.radius * std::sqrt(std::max(0.0, 1 - along * along)) + noise_; };
  const Extent box = about(circle.at, {reach(circle.unit.x), reach(circle.unit.y), reach(circle.unit.z)});
  // One that lies all beyond a plane, or in a ball, has no place of the part.
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    if (static_cast<int>(k) == sphere || static_cast<int>(k) == other) continue;
    const Surface& of = surfaces_[k];
    const double away = of.value(circle.at);
    const double room = of.ball == 0
                            ? circle.radius * std::sqrt(std::max(0.0, 1 - std::pow(dot(of.at, circle.unit), 2)))
                            : circle.radius;
    if (away > room + tolerance_) return true;
  }
  add(circle, box);
  return add_on_circle(circle);
}

bool CsgFeatures::add_on_circle(const Feature& circle) {
  for (int k = 0; k < static_cast<int>(surfaces_.size()); ++k) {
    if (k == circle.on[0] || k == circle.on[1]) continue;
    if (std::fabs(surfaces_[static_cast<std::size_t>(k)].value(circle.at)) > circle.radius + noise_)
      continue;  // no sign: too far
    const std::optional<Surface> plane = plane_with(circle.on[0], k);
    if (!plane) continue;
    const Vector in_plane = plane->at - space::scaled(dot(plane->at, circle.unit), circle.unit);
    const double angle = space::length(in_plane);
    if (angle < margin::kSameNormal) continue;
    const double off = plane->value(circle.at) / angle;
    const Meet how = meet(std::fabs(off), circle.radius, noise_);
    if (how == Meet::kApart || how == Meet::kTouch) continue;
    if (how == Meet::kNearly || angle < margin::kFlatMeet) return false;
    const Vector toward = space::scaled(1 / angle, in_plane), along = space::cross(circle.unit, toward);
    const double half = std::sqrt((circle.radius - off) * (circle.radius + off));
    for (const double t : {-half, half}) {
      add_point(space::plus(circle.at - space::scaled(off, toward), space::scaled(t, along)),
                {circle.on[0], circle.on[1], k});
    }
  }
  return true;
}

void CsgFeatures::add_point(const Vector& x, const std::array<int, 3>& on) {
  add({Kind::kPoint, on, x}, about(x, {noise_, noise_, noise_}));
}

double CsgFeatures::breaks(const Vector& x, const std::array<int, 3>& on) const {
  double worst = -exact::kInfinity;
  const auto ask = [&](int k) {
    if (k != on[0] && k != on[1] && k != on[2])
      worst = std::max(worst, surfaces_[static_cast<std::size_t>(k)].value(x));
  };
  for (const int k : plain_) ask(k);
  cut_tree_.each([&](const Extent& box) { return box.holds(x, 2 * tolerance_); },
                 [&](std::size_t i) { ask(cuts_[i]); });
  return worst;
}

/// `known`: a place of the part. Places that break rules by rounding alone count for `low`; for `high` those that keep
/// them for sure.
std::optional<CsgFeatures::Nearest> CsgFeatures::nearest(const Vector& x, const std::optional<Vector>& known) const {
  plane::count_cell();
  const double least = breaks(x, kNowhere), tolerance = tolerance_;
  if (least <= 0) return Nearest{0, 0, x};
  Nearest out{exact::kInfinity, exact::kInfinity, {}};
  if (known) out = {space::length(*known - x), space::length(*known - x), *known};
  if (least <= tolerance) out.low = 0;
  tree_.each([&](const Extent& box) { return box.distance(x) < out.high; },
             [&](std::size_t k) {
               const Feature& feature = features_[k];
               const Vector place = feature.nearest(x);
               const double away = space::length(place - x);
               if (!(away < out.high)) return;
               const double off = breaks(place, feature.on);
               if (off > tolerance) return;
               out.low = std::min(out.low, away);
               if (off > -tolerance) return;
               out.high = away;
               out.place = place;
             });
  if (!(out.high - out.low <= tolerance)) return std::nullopt;
  return out;
}

namespace {

/// A step by the distance leaves nothing out; where the distance grows one that is longer does not, either.
double share_of_step(double slope) {
  return std::clamp(1.5 / std::max(1 - slope, 0.1), 1.0, kLongest);
}  // no sign: a choice

}  // namespace

std::optional<CsgFeatures::Nearest> CsgFeatures::nearest(const PointWay& way, const Until& until) const {
  const auto point = [&](double t) { return space::plus(way.start, space::scaled(t, way.unit)); };
  std::optional<Nearest> here = nearest(point(way.from), std::nullopt);
  if (!here || way.from == way.to) return here;
  if (until.share > 0) return std::nullopt;
  Nearest out{here->low, exact::kInfinity, {}};
  const auto take = [&](const Nearest& found) {
    const double t = std::clamp(dot(found.place - way.start, way.unit), way.from, way.to),
                 away = space::length(found.place - point(t));
    if (!(away < out.high)) return;
    out.high = away;
    out.place = found.place;
  };
  take(*here);
  double at = way.from, share = 1;
  for (int count = 0; at < way.to; ++count) {
    if (out.high < until.level - until.blur) return Nearest{0, out.high, out.place};
    if (count == kMostPoints) return std::nullopt;
    const double room = here->low - until.level;
    const double next = std::min(way.to, at + std::max(share * room, 0.0) + (room > until.blur ? 0 : until.blur / 2));
    const std::optional<Nearest> there = nearest(point(next), here->place);
    if (!there) return std::nullopt;
    take(*there);
    const double more = there->low - until.level, least = (here->low + there->low - (next - at)) / 2 - until.level;
    const double enough = std::min(room, more) > until.blur ? std::min(room, more) / 8 : -until.blur;
    if (least < enough) {
      if (share == 1) return std::nullopt;
      share = 1;
      continue;
    }
    out.low = std::min(out.low, least + until.level);
    share = share_of_step((there->low - here->low) / (next - at));
    at = next;
    here = there;
  }
  return out;
}

}  // namespace findspace::distance
