// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/contact_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"
#include "space/polytope/near_features.h"

namespace findspace::space {
namespace {

using Triple = near::Triple<double>;

std::size_t at(int k) { return static_cast<std::size_t>(k); }

double squared_of_segments(const Triple& a, const Triple& b, const Triple& c, const Triple& d) {
  const auto from = [](const Triple& p, const Triple& q, const Triple& x) {
    return near::squared_of_segment(near::minus(p, x), near::minus(q, x));
  };
  return std::min({near::squared_between(a, near::minus(b, a), c, near::minus(d, c)), from(a, b, c), from(a, b, d),
                   from(c, d, a), from(c, d, b)});
}

/// The corner of the face that is not on the edge.
const Point& apex(const RayBody& body, int face, const RayEdge& e) {
  const auto& corners = body.faces[at(face)];
  return body
      .points[at(*std::find_if(corners.begin(), corners.end(), [&](int v) { return v != e.from && v != e.to; }))];
}

/// The sign of n . w for n = u x v in doubles, whose factors are exact; 0 where they do not tell.
int surely(const Vector& n, double size, const Vector& w) {
  const double value = dot(n, w), bound = margin::kRoundings128 * size * size_of(w);
  return (value > bound) - (value < -bound);
}

}  // namespace

ContactPlanes::Featured::Featured(const RayBody& of) : body(of), vertices(of.faces.size()), edges(of.faces.size()) {
  for (std::size_t v = 0; v < of.vertices.size(); ++v)
    vertices[at(of.corners[at(of.vertices[v].first)].face)].push_back(static_cast<int>(v));
  for (std::size_t k = 0; k < of.edges.size(); ++k) {
    const RayEdge& e = of.edges[k];
    if (e.bend <= 0) continue;  // along others no solid can lie on one side
    const Point& from = of.points[at(e.from)];
    edges[at(e.left)].push_back({static_cast<int>(k), exact::approx(of.points[at(e.to)] - from),
                                 exact::approx(apex(of, e.left, e) - from),
                                 exact::approx(apex(of, e.right, e) - from)});
  }
}

ContactPlanes::ContactPlanes(const RayBody& a, const BoxTree& a_tree, const RayBody& b, const BoxTree& b_tree)
    : a_(a), b_(b), a_tree_(a_tree), b_tree_(b_tree) {}

class ContactPlanes::Collector {
 public:
  Collector(const ContactPlanes& of, const Vector& middle, double reach) : of_(of), middle_(middle), reach_(reach) {
    const double size = size_of(middle) + size_of(exact::approx(of.a_.body.low)) +
                        size_of(exact::approx(of.a_.body.high)) + size_of(exact::approx(of.b_.body.low)) +
                        size_of(exact::approx(of.b_.body.high));
    reach_ += margin::kRoundings512 * size;  // roundings
    square_ = reach_ * reach_;
  }

  void add(int f, int g) {
    for (const int v : of_.b_.vertices[at(g)]) corner_of_b(f, of_.b_.body.vertices[at(v)]);
    for (const int v : of_.a_.vertices[at(f)]) corner_of_a(of_.a_.body.vertices[at(v)], g);
    for (const EdgeWays& e : of_.a_.edges[at(f)]) {
      for (const EdgeWays& d : of_.b_.edges[at(g)]) {
        if (may_touch(e, d)) edges(of_.a_.body.edges[at(e.edge)], of_.b_.body.edges[at(d.edge)]);
      }
    }
  }
  std::vector<Plane>& planes() { return planes_; }
  void drop_repeated() {
    std::sort(planes_.begin(), planes_.end());
    planes_.erase(std::unique(planes_.begin(), planes_.end()), planes_.end());
  }

 private:
  /// Where it stands, its middle position taken.
  Triple of_a(const Point& p) const { return near::triple(exact::approx(p)); }
  Triple of_b(const Point& p) const { return near::triple(plus(exact::approx(p), middle_)); }

  /// Overlap is where normal . (b + p - a) < 0.
  void put(const Wide3& normal, const Point& a, const Point& b) {
    const Wide3 n = exact::primitive(normal);
    const Plane plane{n, exact::dot(n, b - a)};
    const HalfSpace seen(plane);
    if (std::fabs(seen.approx_value(middle_)) <= reach_ + seen.error(middle_)) planes_.push_back(plane);
  }

  /// Whether all edges of the circuit rise along the normal, or run level.
  static bool stands_on(const RayBody& body, const RayVertex& v, const Wide3& normal, const Approx3& approx) {
    for (int j = v.first; j < v.first + v.count; ++j) {
      const Point way = body.points[at(body.corners[at(j)].to)] - body.points[at(v.point)];
      if (exact::sign_dot(normal, approx, way) < 0) return false;
    }
    return true;
  }

  void corner_of_b(int f, const RayVertex& v) {
    const RayBody &a = of_.a_.body, &b = of_.b_.body;
    const Triple x = of_b(b.points[at(v.point)]);
    const auto from = [&](int k) { return near::minus(of_a(a.corner(f, k)), x); };
    if (near::squared_of_triangle(from(0), from(1), from(2)) > square_) return;
    if (!stands_on(b, v, a.normals[at(f)], a.normal_approx[at(f)])) return;
    put(a.normals[at(f)], a.corner(f, 0), b.points[at(v.point)]);
  }

  void corner_of_a(const RayVertex& v, int g) {
    const RayBody &a = of_.a_.body, &b = of_.b_.body;
    const Triple x = of_a(a.points[at(v.point)]);
    const auto from = [&](int k) { return near::minus(of_b(b.corner(g, k)), x); };
    if (near::squared_of_triangle(from(0), from(1), from(2)) > square_) return;
    if (!stands_on(a, v, b.normals[at(g)], b.normal_approx[at(g)])) return;
    put(-b.normals[at(g)], a.points[at(v.point)], b.corner(g, 0));
  }

  /// Whether a plane along both may have the solids on its two sides.
  static bool may_touch(const EdgeWays& e, const EdgeWays& d) {
    const Vector n = cross(e.way, d.way);
    const double size = size_of(e.way) * size_of(d.way);
    const int below = surely(n, size, e.left), other = surely(n, size, e.right);
    if (below * other < 0) return false;
    const int above = surely(n, size, d.left), next = surely(n, size, d.right);
    return above * next >= 0 && (below + other) * (above + next) <= 0;
  }

  void edges(const RayEdge& e, const RayEdge& d) {
    const RayBody &a = of_.a_.body, &b = of_.b_.body;
    const Point &a0 = a.points[at(e.from)], &a1 = a.points[at(e.to)], &b0 = b.points[at(d.from)],
                &b1 = b.points[at(d.to)];
    const Wide3 n = exact::cross(a1 - a0, b1 - b0);
    if (exact::is_zero(n)) return;
    const Approx3 approx = exact::approx(n), of_e = exact::approx(a1 - a0), of_d = exact::approx(b1 - b0);
    // Of nearly parallel ones the distance is hard to tell.
    const bool decided = dot(approx, approx) > margin::kHardToTell * dot(of_e, of_e) * dot(of_d, of_d);
    if (decided && squared_of_segments(of_a(a0), of_a(a1), of_b(b0), of_b(b1)) > square_) return;
    const auto sides = [&](const RayBody& body, const RayEdge& of) {
      const Point& from = body.points[at(of.from)];
      const int left = exact::sign_dot(n, approx, apex(body, of.left, of) - from),
                right = exact::sign_dot(n, approx, apex(body, of.right, of) - from);
      return left * right < 0 ? 0 : left + right;
    };
    const int below = sides(a, e), above = sides(b, d);
    if (below == 0 || above == 0 || (below > 0) == (above > 0)) return;
    put(below > 0 ? -n : n, a0, b0);
  }

  const ContactPlanes& of_;
  Vector middle_;
  double reach_, square_ = 0;
  std::vector<Plane> planes_;
};

std::optional<std::vector<Plane>> ContactPlanes::near(const Vector& middle, double reach, std::size_t most,
                                                      std::size_t most_pairs) const {
  Collector found(*this, middle, reach);
  const auto down = [](double c) { return static_cast<std::int64_t>(std::floor(c)) - 1; };
  const Point from{down(middle.x - reach), down(middle.y - reach), down(middle.z - reach)};
  const std::int64_t wide = static_cast<std::int64_t>(std::ceil(2 * reach)) + 3;
  std::vector<std::array<int, 2>> pairs;  // counted first, which is cheaper
  const bool many = any_pair(a_tree_, b_tree_, from, Point{wide, wide, wide}, [&](int f, int g) {
    if (pairs.size() == most_pairs) return true;
    pairs.push_back({f, g});
    return false;
  });
  if (many) return std::nullopt;
  for (const auto& [f, g] : pairs) {
    found.add(f, g);
    if (found.planes().size() <= 4 * most + 64) continue;
    found.drop_repeated();
    if (found.planes().size() > 4 * most + 64) return std::nullopt;
  }
  found.drop_repeated();
  if (found.planes().size() > most) return std::nullopt;
  return std::move(found.planes());
}

}  // namespace findspace::space
