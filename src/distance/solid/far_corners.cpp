// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/far_corners.h"

#include <algorithm>

#include "distance/search/convex_distance.h"
#include "exact/margins/rounding.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::Point;
using space::real;
using space::RealVector;
using space::Vector;
using Lists = std::vector<Corners>;

namespace {

/// One corner as numbers see it.
struct NearCorner {
  Vector at;
  double radius = 0;
  const Point* point = nullptr;
  const Real* by = nullptr;  // the radius
};

template <class Visit>
void each_corner(const Lists& lists, const Vector& by, Visit&& visit) {
  for (const Corners& list : lists) {
    const double radius = list.radius.to_double();
    for (const Point& v : list.points) visit(NearCorner{exact::approx(v) - by, radius, &v, &list.radius});
  }
}

double apart(const Vector& a, const NearCorner& b) { return space::length(a - b.at) + b.radius; }

/// A ball about the corners.
struct About {
  Vector middle;
  double reach = 0;
};

About about(const Lists& lists, const Vector& by) {
  About out;
  double count = 0;
  each_corner(lists, by, [&](const NearCorner& c) {
    out.middle = space::plus(out.middle, c.at);
    ++count;
  });
  out.middle = space::scaled(1 / count, out.middle);
  each_corner(lists, by, [&](const NearCorner& c) { out.reach = std::max(out.reach, apart(out.middle, c)); });
  return out;
}

NearCorner farthest_from(const Vector& place, const Lists& lists, const Vector& by) {
  NearCorner out;
  double most = -exact::kInfinity;
  each_corner(lists, by, [&](const NearCorner& c) {
    const double d = apart(place, c);
    if (!(d > most)) return;
    most = d;
    out = c;
  });
  return out;
}

/// Whether a corner may be as far as `top` from a place in the ball.
bool may_reach(const NearCorner& c, const About& other, double top) {
  const double most = apart(other.middle, c) + other.reach, blur = space::size_of(c.at) + space::size_of(other.middle);
  return most * margin::kUpward + margin::kPlaceNoise * blur >= top * margin::kDownward;
}

/// Those that may be as far as `top` from a place in the ball.
std::vector<NearCorner> not_too_near(const Lists& lists, const Vector& by, const About& other, double top) {
  std::vector<NearCorner> out;
  each_corner(lists, by, [&](const NearCorner& c) {
    if (may_reach(c, other, top)) out.push_back(c);
  });
  return out;
}

/// Corners that follow each other in a list, and a ball about these: those of a mesh mostly lie together.
struct Run {
  std::size_t begin = 0, end = 0;
  About about;
};
constexpr std::size_t kRun = 32;

std::vector<Run> runs_of(const std::vector<NearCorner>& corners) {
  std::vector<Run> out;
  for (std::size_t begin = 0; begin < corners.size(); begin += kRun) {
    Run& run = out.emplace_back(Run{begin, std::min(begin + kRun, corners.size()), {corners[begin].at, 0}});
    for (std::size_t k = run.begin; k < run.end; ++k)
      run.about.reach = std::max(run.about.reach, apart(run.about.middle, corners[k]));
  }
  return out;
}

/// The corners of A and of B + p that may be farthest apart, as far as numbers tell, and the distance of two of them.
struct FarSides {
  std::vector<NearCorner> a, b;
  double top = 0;

  FarSides(const Lists& of_b, const Lists& of_a, const Vector& p) {
    const Vector still;
    const About about_b = about(of_b, still), about_a = about(of_a, p);
    const NearCorner v = farthest_from(about_b.middle, of_a, p), w = farthest_from(v.at, of_b, still);
    top = apart(v.at, w) + v.radius;
    a = not_too_near(of_a, p, about_b, top);
    b = not_too_near(of_b, still, about_a, top);
  }

  /// Of those that may be farther apart than `least`, which may grow.
  template <class Visit>
  void each_pair(const std::vector<Run>& runs, const double& least, Visit&& visit) const {
    for (const NearCorner& v : a) {
      for (const Run& run : runs) {
        if (!may_reach(v, run.about, least)) continue;
        for (std::size_t k = run.begin; k < run.end; ++k)
          visit(v, b[k], space::length(v.at - b[k].at) + (v.radius + b[k].radius));
      }
    }
  }
  /// Of the pairs that are farthest from each other.
  template <class Visit>
  void each_farthest(Visit&& visit) {
    const std::vector<Run> runs = runs_of(b);
    each_pair(runs, top, [&](const NearCorner&, const NearCorner&, double d) { top = std::max(top, d); });
    const double least = top * (1 - margin::kFarthestTie);
    each_pair(runs, least, [&](const NearCorner& v, const NearCorner& w, double d) {
      if (d >= least) visit(v, w);
    });
  }
};

Answer farthest_pair(FarSides sides, const RealVector& p) {
  std::optional<Answer> best;
  sides.each_farthest([&](const NearCorner& v, const NearCorner& w) {
    const RealVector a = real(*v.point), b = space::plus(real(*w.point), p), e = space::minus(a, b);
    const Real core = sqrt(space::dot(e, e)), value = core + *v.by + *w.by;
    if (best && !(best->value < value)) return;
    best = Answer{};
    best->value = value;
    if (core.sign() == 0) return;
    best->witness = point_pair(space::along(b, -(*w.by / core), e), space::along(a, *v.by / core, e));
  });
  return *std::move(best);
}

}  // namespace

Lists corners_of(const space::Body& body) {
  Lists out;
  for (const space::BodyPart& part : body.parts) out.push_back({part.vertices(), part.radius});
  return out;
}

Answer farthest_apart(const Lists& b, const Lists& a, const RealVector& p) {
  return farthest_pair(FarSides(b, a, space::rounded(p)), p);
}

std::optional<Answer> farthest_of_few(const Lists& b, const Lists& a, const RealVector& p) {
  constexpr std::size_t kFewPairs = 20000000;
  FarSides sides(b, a, space::rounded(p));
  if (sides.a.size() * sides.b.size() > kFewPairs) return std::nullopt;
  return farthest_pair(std::move(sides), p);
}

std::optional<space::BodyPart> only_farthest(const Lists& b, const space::BodyPart& a, const RealVector& p) {
  constexpr std::size_t kFewPlanes = 60;
  const std::vector<space::HalfSpace> planes = a.planes();
  if (planes.empty() || planes.size() > kFewPlanes) return std::nullopt;
  const Vector by = space::scaled(-1, space::rounded(p));
  NearCorner first;
  double most = -exact::kInfinity, size = 0;
  each_corner(b, by, [&](const NearCorner& c) {
    double floor = -exact::kInfinity;
    for (const space::HalfSpace& h : planes) floor = std::max(floor, h.approx_value(c.at));
    size = std::max(size, space::size_of(c.at) + c.radius);
    if (!(floor + c.radius > most)) return;
    most = floor + c.radius;
    first = c;
  });
  // No corner is farther from A than from a place of it.
  const auto way = way_to(planes);
  const Vector place = space::plus(first.at, way(first.at));
  const double slack = margin::kNumbersOff * (size + space::size_of(place)), top = apart(place, first);
  if (!(top - first.radius > slack)) return std::nullopt;
  double second = -exact::kInfinity;
  most = second;
  each_corner(b, by, [&](const NearCorner& c) {
    if (apart(place, c) < top - slack) return;
    const double d = space::length(way(c.at)) + c.radius;
    second = std::max(second, std::min(d, most));
    if (d > most) first = c;
    most = std::max(most, d);
  });
  if (!(most - second > slack)) return std::nullopt;
  return space::BodyPart{std::nullopt, *first.point, *first.by};
}

Real diameter(const space::Body& body) {
  const Lists all = corners_of(body);
  Real best;
  FarSides(all, all, {}).each_farthest([&](const NearCorner& v, const NearCorner& w) {
    const RealVector e = real(*v.point - *w.point);
    const Real value = sqrt(space::dot(e, e)) + *v.by + *w.by;
    if (best < value) best = value;
  });
  return best;
}

}  // namespace findspace::distance
