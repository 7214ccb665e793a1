// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/convex_region.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace findspace::space {

using exact::Real;

namespace {

std::vector<int> common(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

bool holds_all(const std::vector<int>& a, const std::vector<int>& part) {
  return std::includes(a.begin(), a.end(), part.begin(), part.end());
}

/// The point where three of the planes meet, if three do in one point.
std::optional<RealVector> meeting(const std::vector<HalfSpace>& planes, const std::vector<int>& tight) {
  for (std::size_t i = 0; i + 2 < tight.size(); ++i) {
    for (std::size_t j = i + 1; j + 1 < tight.size(); ++j) {
      const HalfSpace &f = planes[std::size_t(tight[i])], &g = planes[std::size_t(tight[j])];
      const RealVector fg = cross(f.normal, g.normal);
      if (is_zero(fg)) continue;
      for (std::size_t k = j + 1; k < tight.size(); ++k) {
        const HalfSpace& h = planes[std::size_t(tight[k])];
        const Real determinant = dot(fg, h.normal);
        if (determinant.sign() == 0) continue;
        const RealVector gh = cross(g.normal, h.normal), hf = cross(h.normal, f.normal);
        const RealVector sum = plus(plus(scaled(f.offset, gh), scaled(g.offset, hf)), scaled(h.offset, fg));
        return scaled(Real(-1) / determinant, sum);
      }
    }
  }
  return std::nullopt;
}

/// Whether two ascending lists have two numbers in common.
bool two_in_common(const std::vector<int>& a, const std::vector<int>& b) {
  int found = 0;
  for (auto i = a.begin(), k = b.begin(); i != a.end() && k != b.end();) {
    if (*i == *k && ++found == 2) return true;
    const bool less = *i <= *k, more = *k <= *i;
    i += less;
    k += more;
  }
  return false;
}

bool all_rational(const RealVector& p) {
  return std::all_of(p.begin(), p.end(), [](const Real& c) { return c.is_rational(); });
}

bool all_integers(const RealVector& p) {
  return std::all_of(p.begin(), p.end(), [](const Real& c) { return c.integer().has_value(); });
}

/// Where the segment from v to w crosses the last of the planes that the point lies on. Three planes of integers give
/// it with one division a coordinate, and roots of several numbers in a short expression.
RealVector crossing(const RealVector& v, const RealVector& w, const std::vector<HalfSpace>& planes,
                    const std::vector<int>& tight) {
  std::optional<RealVector> met;
  if (!all_integers(v) || !all_integers(w)) met = meeting(planes, tight);
  if (met && all_rational(*met)) return *std::move(met);
  const HalfSpace& plane = planes[std::size_t(tight.back())];
  const Real f = plane.value(v), g = plane.value(w);
  RealVector at = along(v, f / (f - g), minus(w, v));
  if (all_rational(at)) return at;
  if (!met) met = meeting(planes, tight);
  return met ? *std::move(met) : at;
}

}  // namespace

ConvexRegion::ConvexRegion(const RealVector& low, const RealVector& high) {
  for (int k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(-1);
    planes_.emplace_back(n, low[k]);
    n[k] = Real(1);
    planes_.emplace_back(n, -high[k]);
  }
  for (int i = 0; i < 8; ++i) {
    RealVector at;
    for (int k = 0; k < 3; ++k) at[k] = (i >> k & 1) != 0 ? high[k] : low[k];
    const bool repeated = std::any_of(vertices_.begin(), vertices_.end(), [&](const Vertex& v) { return v.at == at; });
    if (repeated) continue;
    Vertex v{at, space::rounded(at), {}};
    for (int k = 0; k < 3; ++k) {
      if (at[k] == low[k]) v.tight.push_back(2 * k);
      if (at[k] == high[k]) v.tight.push_back(2 * k + 1);
    }
    vertices_.push_back(std::move(v));
  }
}

ConvexRegion::Sides ConvexRegion::sides(const HalfSpace& plane) const {
  Sides s;
  for (const Vertex& v : vertices_) {
    const int sign = plane.sign(v.at, v.near);
    (sign < 0 ? s.inside : sign > 0 ? s.outside : s.on) = true;
  }
  return s;
}

bool ConvexRegion::adjacent(int v, int w) const {
  if (!two_in_common(vertices_[v].tight, vertices_[w].tight)) return false;
  const std::vector<int> both = common(vertices_[v].tight, vertices_[w].tight);
  for (int u = 0; u < static_cast<int>(vertices_.size()); ++u) {
    if (u != v && u != w && holds_all(vertices_[u].tight, both)) return false;
  }
  return true;
}

bool ConvexRegion::cut(const HalfSpace& plane) {
  std::vector<int> sign;
  for (const Vertex& v : vertices_) sign.push_back(plane.sign(v.at, v.near));
  // A half space that holds the whole set says nothing new; so no plane is listed twice.
  if (std::count(sign.begin(), sign.end(), 1) == 0) return false;
  const int id = static_cast<int>(planes_.size());
  planes_.push_back(plane);
  std::vector<Vertex> kept;
  const int n = static_cast<int>(vertices_.size());
  std::vector<int> beyond;
  for (int w = 0; w < n; ++w)
    if (sign[w] > 0) beyond.push_back(w);
  for (int v = 0; v < n; ++v) {
    if (sign[v] >= 0) continue;
    for (const int w : beyond) {
      if (!adjacent(v, w)) continue;
      Vertex fresh;
      fresh.tight = common(vertices_[v].tight, vertices_[w].tight);
      fresh.tight.push_back(id);
      fresh.at = crossing(vertices_[v].at, vertices_[w].at, planes_, fresh.tight);
      fresh.near = space::rounded(fresh.at);
      kept.push_back(std::move(fresh));
    }
  }
  for (int v = 0; v < n; ++v) {
    if (sign[v] > 0) continue;
    if (sign[v] == 0) vertices_[v].tight.push_back(id);
    kept.push_back(std::move(vertices_[v]));
  }
  vertices_ = std::move(kept);
  return true;
}

std::vector<int> ConvexRegion::facets() const {
  std::vector<int> count(planes_.size(), 0), out;
  for (const Vertex& v : vertices_) {
    for (const int k : v.tight) ++count[k];
  }
  for (int k = 0; k < static_cast<int>(planes_.size()); ++k) {
    if (count[k] >= 3) out.push_back(k);
  }
  return out;
}

std::vector<std::vector<int>> ConvexRegion::on_planes() const {
  std::vector<std::vector<int>> on(planes_.size());
  for (int v = 0; v < static_cast<int>(vertices_.size()); ++v)
    for (const int k : vertices_[v].tight) on[k].push_back(v);
  return on;
}

/// Seen from the first, all others lie within half a turn, and no two in one direction.
std::vector<int> ConvexRegion::in_circuit(std::vector<int> on, int k) const {
  if (on.size() < 3) return on;
  const RealVector &n = planes_[k].normal, &from = vertices_[on[0]].at;
  std::sort(on.begin() + 1, on.end(), [&](int v, int w) {
    return dot(cross(minus(vertices_[v].at, from), minus(vertices_[w].at, from)), n).sign() > 0;
  });
  return on;
}

std::vector<int> ConvexRegion::circuit(int k) const {
  std::vector<int> on;
  for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
    if (std::binary_search(vertices_[v].tight.begin(), vertices_[v].tight.end(), k)) on.push_back(v);
  }
  return in_circuit(std::move(on), k);
}

std::vector<std::vector<int>> ConvexRegion::circuits() const {
  std::vector<std::vector<int>> on = on_planes(), out;
  for (const int k : facets()) out.push_back(in_circuit(std::move(on[k]), k));
  return out;
}

std::vector<std::pair<int, int>> ConvexRegion::edges() const {
  std::vector<std::pair<int, int>> out;
  if (dimension() == 3) {
    for (const std::vector<int>& ring : circuits())
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const int v = ring[i], w = ring[(i + 1) % ring.size()];
        if (v < w) out.emplace_back(v, w);  // the facet on the other side has it the other way round
      }
    std::sort(out.begin(), out.end());
    return out;
  }
  for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
    for (int w = v + 1; w < static_cast<int>(vertices_.size()); ++w) {
      if (adjacent(v, w)) out.emplace_back(v, w);
    }
  }
  return out;
}

/// A set without interior lies on one of the planes that bound it, and no vertex between two others is kept.
int ConvexRegion::dimension() const {
  const std::size_t n = vertices_.size();
  if (n < 3) return static_cast<int>(n) - 1;
  std::vector<int> shared = vertices_[0].tight;
  for (std::size_t v = 1; v < n && !shared.empty(); ++v) shared = common(shared, vertices_[v].tight);
  return shared.empty() ? 3 : 2;
}

Real ConvexRegion::six_volumes() const {
  Real sum;
  if (dimension() < 3) return sum;
  const RealVector& base = vertices_[0].at;
  for (const std::vector<int>& ring : circuits()) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const RealVector a = minus(vertices_[ring[0]].at, base), b = minus(vertices_[ring[i]].at, base),
                       c = minus(vertices_[ring[i + 1]].at, base);
      sum += dot(a, cross(b, c));
    }
  }
  return sum;
}

}  // namespace findspace::space
