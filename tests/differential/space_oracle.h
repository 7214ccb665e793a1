// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two independent constructions of gamma12, and random pairs full of ties.
//   hull_of_differences: the hull of all a - b; planes and circuits, no contact types.
//   three_stages: the paper's construction (phi.md 4): by definition, for every facet of A, every facet of B and every
//   pair of edges, the vertices of A highest and of B lowest along the normal; the facet is the hull of their
//   differences.
#pragma once

#include <findspace/error.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "space/phi/contact_surface.h"

namespace findspace::space {

/// A facet in a form that can be compared: the circuit as points, beginning with the smallest.
struct PlainFacet {
  Plane plane;
  std::vector<Point> circuit;
  std::string contact;
  friend auto operator<=>(const PlainFacet&, const PlainFacet&) = default;
};

inline std::vector<Point> from_smallest(std::vector<Point> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

inline std::vector<PlainFacet> plain(const ContactSurface& s, bool with_contact) {
  std::vector<PlainFacet> facets;
  for (int f = 0; f < s.facet_count(); ++f) {
    std::vector<Point> ring;
    for (const int v : s.circuit(f)) ring.push_back(s.vertices()[v]);
    facets.push_back({s.plane(f), from_smallest(ring), with_contact ? std::string(contact_name(s.contact(f))) : ""});
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

inline std::vector<PlainFacet> plain(const Polytope& p) {
  std::vector<PlainFacet> facets;
  for (int f = 0; f < p.facet_count(); ++f) {
    std::vector<Point> ring;
    for (const int v : p.circuit(f)) ring.push_back(p.vertices()[v]);
    facets.push_back({p.planes()[f], from_smallest(ring), ""});
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

inline Polytope hull_of_differences(const Polytope& a, const Polytope& b) {
  std::vector<Point> all;
  for (const Point& p : a.vertices()) {
    for (const Point& q : b.vertices()) all.push_back(p - q);
  }
  return Polytope::hull(all);
}

inline std::vector<int> extreme(const Polytope& p, const Wide3& n, int sense) {
  std::vector<int> best;
  for (int v = 0; v < p.vertex_count(); ++v) {
    const int order = best.empty() ? 0 : sense * exact::sign(exact::dot(n, p.vertices()[v] - p.vertices()[best[0]]));
    if (order > 0) best.clear();
    if (order >= 0) best.push_back(v);
  }
  return best;
}

/// The hull of points in one plane, counter-clockwise about n, by rotating about the polygon (gift wrapping).
inline std::vector<Point> planar_hull(std::vector<Point> points, const Wide3& n) {
  const auto rotation = [&](const Point& a, const Point& b, const Point& c) {
    const Wide3 w = exact::cross(b - a, c - a);
    return exact::sign(w.x) * exact::sign(n.x) + exact::sign(w.y) * exact::sign(n.y) +
           exact::sign(w.z) * exact::sign(n.z);
  };
  std::vector<Point> ring{*std::min_element(points.begin(), points.end())};
  for (;;) {
    const Point at = ring.back();
    Point next = at;
    for (const Point& p : points) {
      if (p == at) continue;
      if (next == at) next = p;
      const int side = rotation(at, next, p);
      const Point d = next - at, e = p - at;
      const auto length = [](const Point& v) { return int128(v.x) * v.x + int128(v.y) * v.y + int128(v.z) * v.z; };
      if (side < 0 || (side == 0 && length(e) > length(d))) next = p;
    }
    if (next == ring[0]) return ring;
    ring.push_back(next);
  }
}

inline std::vector<PlainFacet> three_stages(const Polytope& a, const Polytope& b) {
  std::vector<PlainFacet> facets;
  const auto add = [&](const Wide3& n, const std::vector<int>& high, const std::vector<int>& low,
                       const std::string& tag) {
    std::vector<Point> points;
    for (const int i : high) {
      for (const int j : low) points.push_back(a.vertices()[i] - b.vertices()[j]);
    }
    facets.push_back({{n, -exact::dot(n, points[0])}, planar_hull(points, n), tag});
  };
  const auto letter = [](std::size_t n) { return std::string(n == 1 ? "V" : n == 2 ? "E" : "F"); };
  for (int h = 0; h < a.facet_count(); ++h) {
    const Wide3& n = a.planes()[h].normal;
    const auto low = extreme(b, n, -1);
    add(n, extreme(a, n, 1), low, "F" + letter(low.size()));
  }
  for (int g = 0; g < b.facet_count(); ++g) {
    const Wide3 n = -b.planes()[g].normal;
    const auto high = extreme(a, n, 1);
    if (high.size() < 3) add(n, high, extreme(b, n, -1), letter(high.size()) + "F");
  }
  for (int e = 0; e < static_cast<int>(a.half_edges().size()); ++e) {
    if (a.half_edges()[e].origin > a.target(e)) continue;
    for (int f = 0; f < static_cast<int>(b.half_edges().size()); ++f) {
      const Wide3 m = exact::cross(a.vertices()[a.target(e)] - a.vertices()[a.half_edges()[e].origin],
                                   b.vertices()[b.target(f)] - b.vertices()[b.half_edges()[f].origin]);
      if (exact::is_zero(m)) continue;
      const auto high = extreme(a, m, 1), low = extreme(b, m, -1);
      const auto is = [](const Polytope& p, int h, const std::vector<int>& ends) {
        return ends.size() == 2 && std::minmax(p.half_edges()[h].origin, p.target(h)) == std::minmax(ends[0], ends[1]);
      };
      if (is(a, e, high) && is(b, f, low)) add(exact::primitive(m), high, low, "EE");
    }
  }
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// Random polytopes of many kinds, most of them with ties against each other.
class RandomPolytopes {
 public:
  explicit RandomPolytopes(unsigned seed) : random_(seed) {}

  Polytope next() {
    for (;;) {
      try {
        return Polytope::hull(points(pick(0, 5)));
      } catch (const Error&) {
        continue;  // a flat draw
      }
    }
  }
  std::pair<Polytope, Polytope> pair() {
    Polytope a = next();
    switch (pick(0, 5)) {
      case 0:
        return {a, a};
      case 1:
        return {a, a.mirrored()};
      case 2:
        return {a, a.translated({pick(-9, 9), pick(-9, 9), pick(-9, 9)})};
      default:
        return {a, next()};
    }
  }
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

 private:
  std::vector<Point> points(std::int64_t kind) {
    std::vector<Point> p;
    if (kind == 0) {  // box
      const std::int64_t x = pick(1, 9), y = pick(1, 9), z = pick(1, 9);
      for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0});
    } else if (kind == 1) {  // prism over a lattice polygon, axis x, y or z
      const std::int64_t axis = pick(0, 2), n = pick(3, 7), high = pick(1, 5);
      for (int i = 0; i < n; ++i) {
        const std::int64_t u = pick(-5, 5), v = pick(-5, 5);
        for (const std::int64_t w : {std::int64_t{0}, high}) {
          p.push_back(axis == 0 ? Point{w, u, v} : axis == 1 ? Point{v, w, u} : Point{u, v, w});
        }
      }
    } else if (kind == 2) {  // tetrahedron
      for (int i = 0; i < 4; ++i) p.push_back({pick(-9, 9), pick(-9, 9), pick(-9, 9)});
    } else if (kind == 3) {  // lattice polytope
      const std::int64_t n = pick(5, 14);
      for (int i = 0; i < n; ++i) p.push_back({pick(0, 3), pick(0, 3), pick(0, 3)});
    } else {  // points in general position, small or over the whole range of a million steps
      const std::int64_t n = pick(4, 16), size = kind == 4 ? 50 : 1000000;
      for (int i = 0; i < n; ++i) p.push_back({pick(-size, size), pick(-size, size), pick(-size, size)});
    }
    return p;
  }

  std::mt19937_64 random_;
};

}  // namespace findspace::space
