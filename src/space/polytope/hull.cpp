// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact signs. A point in the plane of a triangle counts as below it,
// which equals moving every new point inward by infinitely more than all earlier ones: the triangulated hull is that of
// a nearby set in general position, so the visible part is always a disc. In the end triangles of one plane are merged
// and vertices with fewer than three facets dropped; what remains is the exact hull of the points as they are.
#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "space/polytope/hull_triangles.h"

namespace findspace::space {
namespace {

std::string text(int128 value) {
  if (value < 0) return "-" + text(-value);
  std::string digits;
  do {
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(value % 10)));
    value /= 10;
  } while (value != 0);
  return digits;
}

std::string text(const Wide3& n) { return "(" + text(n.x) + ", " + text(n.y) + ", " + text(n.z) + ")"; }

}  // namespace

int Hull::farthest_from(int a) const {
  int best = -1;
  double distance = 0;
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    const Approx3 e = approx_[p] - approx_[a];
    const double d = e.x * e.x + e.y * e.y + e.z * e.z;
    if (d > distance) {
      distance = d;
      best = p;
    }
  }
  return best;
}

/// A point far off the line through a and b, or -1 if there is none off it. A product of doubles that is not exact may
/// choose a point on the line; only then every point is tried exactly.
int Hull::off_line(int a, int b) const {
  int best = -1;
  double longest = 0;
  const Approx3 u = approx_[b] - approx_[a];
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    const Approx3 w = approx_[p] - approx_[a];
    const double x = u.y * w.z - u.z * w.y, y = u.z * w.x - u.x * w.z, z = u.x * w.y - u.y * w.x;
    const double d = x * x + y * y + z * z;
    if (d > longest) {
      longest = d;
      best = p;
    }
  }
  const auto off = [&](int p) {
    return !exact::is_zero(exact::cross(points_[b] - points_[a], points_[p] - points_[a]));
  };
  if (best >= 0 && off(best)) return best;
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    if (off(p)) return p;
  }
  return -1;
}

int Hull::off_plane(const Triangle& t) const {
  int best = -1;
  double most = 0;
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    const double d = std::fabs(height(t, p));
    if (d > most) {
      most = d;
      best = p;
    }
  }
  if (best >= 0 && side(t, best) != 0) return best;
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    if (side(t, p) != 0) return p;
  }
  return -1;
}

std::optional<std::string> Hull::start() {
  const std::string all = "its " + std::to_string(points_.size()) + " points ";
  if (points_.empty()) return "it has no points";
  const int a = static_cast<int>(std::min_element(points_.begin(), points_.end()) - points_.begin());
  const int b = farthest_from(a);
  if (b < 0) return "all its points are one point";
  const int c = off_line(a, b);
  if (c < 0) {
    const Point e = points_[b] - points_[a];
    return all + "lie on one line of direction " + text(exact::primitive({e.x, e.y, e.z}));
  }
  const int base = make(a, b, c);
  const int d = off_plane(triangles_[base]);
  if (d < 0) return all + "lie in one plane of normal " + text(exact::primitive(triangles_[base].normal));
  const bool above = side(triangles_[base], d) > 0;
  triangles_.clear();
  const std::array<int, 4> v = above ? std::array<int, 4>{a, c, b, d} : std::array<int, 4>{a, b, c, d};
  make(v[0], v[1], v[2]);
  make(v[0], v[3], v[1]);
  make(v[1], v[3], v[2]);
  make(v[2], v[3], v[0]);
  triangles_[0].next = {1, 2, 3};
  triangles_[1].next = {3, 2, 0};
  triangles_[2].next = {1, 3, 0};
  triangles_[3].next = {2, 1, 0};
  for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
    for (Triangle& t : triangles_) {
      if (side(t, p) <= 0) continue;
      t.outside.push_back(p);
      break;
    }
  }
  for (int t = 0; t < 4; ++t) note_todo(t);
  return std::nullopt;
}

void Hull::add(int t) {
  const Triangle& seed = triangles_[t];
  int apex = seed.outside[0];
  double most = height(seed, apex);
  for (const int p : seed.outside) {
    const double h = height(seed, p);
    if (h > most) {
      most = h;
      apex = p;
    }
  }
  find_visible(t, apex);
  cover_horizon(apex);
  hand_over();
}

void Hull::find_visible(int t, int apex) {
  ++round_;
  visible_.assign(1, t);
  triangles_[t].alive = false;
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    for (const int n : std::array<int, 3>(triangles_[visible_[i]].next)) {
      Triangle& other = triangles_[n];
      if (!other.alive || other.mark == round_) continue;
      if (side(other, apex) > 0) {
        other.alive = false;
        visible_.push_back(n);
      } else {
        other.mark = round_;
      }
    }
  }
}

/// One new triangle for each edge of the horizon, in its cyclic order, so that neighbours are made one after another.
void Hull::cover_horizon(int apex) {
  fresh_.clear();
  int dead = visible_[0], edge = 0;
  for (const int d : visible_) {
    for (int i = 0; i < 3; ++i) {
      if (triangles_[triangles_[d].next[i]].alive) {
        dead = d;
        edge = i;
      }
    }
  }
  const int first_vertex = triangles_[dead].v[edge];
  int vertex = first_vertex;
  do {
    // (dead, edge) is a horizon edge that starts at `vertex`.
    const int end = triangles_[dead].v[(edge + 1) % 3], outer = triangles_[dead].next[edge];
    const int t = make(vertex, end, apex);
    triangles_[t].next[0] = outer;
    for (int i = 0; i < 3; ++i) {
      if (triangles_[outer].v[i] == end && triangles_[outer].v[(i + 1) % 3] == vertex) triangles_[outer].next[i] = t;
    }
    fresh_.push_back(t);
    vertex = end;
    // ExactAngle about `end` through the dead triangles to the next horizon edge.
    edge = (edge + 1) % 3;
    while (!triangles_[triangles_[dead].next[edge]].alive) {
      const int over = triangles_[dead].next[edge];
      for (int i = 0; i < 3; ++i) {
        if (triangles_[over].v[i] == end) edge = i;
      }
      dead = over;
    }
  } while (vertex != first_vertex);
  const int n = static_cast<int>(fresh_.size());
  for (int i = 0; i < n; ++i) {
    triangles_[fresh_[i]].next[1] = fresh_[(i + 1) % n];
    triangles_[fresh_[i]].next[2] = fresh_[(i + n - 1) % n];
  }
}

void Hull::hand_over() {
  for (const int d : visible_) {
    for (const int p : triangles_[d].outside) {
      for (const int t : fresh_) {
        if (side(triangles_[t], p) <= 0) continue;
        triangles_[t].outside.push_back(p);
        break;
      }
    }
    triangles_[d].outside.clear();
  }
  dead_.insert(dead_.end(), visible_.begin(), visible_.end());
  for (const int t : fresh_) note_todo(t);
}

namespace {

void check_range(std::span<const Point> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    for (const std::int64_t c : {p.x, p.y, p.z}) {
      if (c > kCoordinateLimit || c < -kCoordinateLimit) {
        throw Error(ErrorCode::kOutOfRange, "a coordinate of point " + std::to_string(i) + " exceeds 2^40 grid steps");
      }
    }
  }
}

/// The rest keeps its order, so vertices come out in the order in which they were given.
std::vector<Point> without_duplicates(std::span<const Point> points) {
  struct Placed {
    Point point;
    std::size_t index;
  };
  std::vector<Placed> sorted;
  sorted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sorted.push_back({points[i], i});
  std::sort(sorted.begin(), sorted.end(), [](const Placed& a, const Placed& b) {
    return a.point == b.point ? a.index < b.index : a.point < b.point;
  });
  std::vector<char> repeats(points.size(), 0);
  for (std::size_t k = 1; k < sorted.size(); ++k) repeats[sorted[k].index] = sorted[k].point == sorted[k - 1].point;
  std::vector<Point> out;
  out.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (repeats[i] == 0) out.push_back(points[i]);
  return out;
}

}  // namespace

Polytope Polytope::hull(std::span<const Point> points, Repair* repair) { return try_hull(points, repair).or_throw(); }

exact::Tried<Polytope> Polytope::try_hull(std::span<const Point> points, Repair* repair) {
  check_range(points);
  const std::vector<Point> distinct = without_duplicates(points);
  Hull hull(distinct);
  if (const auto flat = hull.run())
    return exact::Refusal(Error(ErrorCode::kGeometry, "a polytope needs interior, but " + *flat));
  std::vector<std::vector<int>> circuits = hull.merged();
  std::vector<int> index(distinct.size(), -1);
  for (const auto& ring : circuits) {
    for (const int v : ring) index[v] = 0;
  }
  std::vector<Point> vertices;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    if (index[i] < 0) continue;
    index[i] = static_cast<int>(vertices.size());
    vertices.push_back(distinct[i]);
  }
  for (auto& ring : circuits) {
    for (int& v : ring) v = index[v];
  }
  if (repair != nullptr) {
    repair->duplicates = static_cast<int>(points.size() - distinct.size());
    repair->not_extreme = static_cast<int>(distinct.size() - vertices.size());
  }
  return PolytopeBuilder::build(std::move(vertices), circuits);
}

}  // namespace findspace::space
