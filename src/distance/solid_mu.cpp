// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid_mu.h"

#include <algorithm>
#include <queue>

#include "distance/matrix_game.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::dot;
using space::HalfSpace;
using space::is_zero;
using space::real;
using space::RealVector;
using space::Vector;

namespace {

Real length(const RealVector& v) { return sqrt(space::dot(v, v)); }

std::vector<HalfSpace> half_spaces(const BodyPart& part) {
  std::vector<HalfSpace> planes;
  for (const space::Plane& p : part.core->planes()) planes.emplace_back(p);
  return planes;
}

/// The greatest plane value over its normal's length at x, among planes that come near it in doubles.
Real depth_value(std::span<const HalfSpace> planes, const RealVector& x, const Vector& near, double top) {
  std::optional<Real> best;
  for (const HalfSpace& h : planes) {
    if (h.shadow_value(near) < top - 2 * h.error(near)) continue;
    const Real value = h.value(x) / sqrt(dot(h.normal, h.normal));
    if (!best || *best < value) best = value;
  }
  return *best;
}

struct Corner {
  const BodyPart* part;
  RealVector at;
  Vector near;
  double floor = 0;  // at most the signed distance to the core, plus the part's radius
};

}  // namespace

SolidValue stick_out_of_convex(const Body& b, const BodyPart& a, const RealVector& p) {
  const std::vector<HalfSpace> planes = a.core ? half_spaces(a) : std::vector<HalfSpace>();
  const RealVector center = real(a.center);
  std::vector<Corner> corners;
  for (const BodyPart& part : b.parts) {
    for (const space::Point& v : part.vertices()) {
      Corner c{&part, space::plus(real(v), p), {}, 0};
      c.near = space::rounded(c.at);
      double highest = a.core ? -exact::kInfinity : space::length(c.near - space::rounded(center));
      for (const HalfSpace& h : planes) highest = std::max(highest, h.shadow_value(c.near));
      c.floor = highest + part.radius.to_double();
      corners.push_back(std::move(c));
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& x, const Corner& y) { return x.floor > y.floor; });
  std::optional<SolidValue> best;
  std::vector<Vector> feet;
  const double slack = 0x1p-40 * (space::size_of(corners[0].near) + std::fabs(corners[0].floor));
  for (const Corner& c : corners) {
    const double radius = c.part->radius.to_double();
    const double highest = c.floor - radius;
    double ceiling = highest > 0 ? exact::kInfinity : highest;
    for (const Vector& q : feet) ceiling = std::min(ceiling, space::length(c.near - q));
    const double known = best ? (best->value + a.radius).to_double() : 0;
    if (best && ceiling + radius < known - slack) continue;
    RealVector foot = center;
    Real core;
    if (!a.core) {
      core = length(space::minus(c.at, center));
    } else if (highest < -slack) {
      core = depth_value(planes, c.at, c.near, highest);
    } else {
      foot = *nearest_in(planes, c.at);
      feet.push_back(space::rounded(foot));
      const RealVector off = space::minus(c.at, foot);
      core = is_zero(off) ? depth_value(planes, c.at, c.near, highest) : length(off);
    }
    const Real value = core + c.part->radius - a.radius;
    if (best && !(best->value < value)) continue;
    best = SolidValue{};
    best->value = value;
    if (core.sign() > 0) {
      const RealVector away = space::minus(c.at, foot);
      best->points = {space::along(c.at, c.part->radius / core, away), space::along(foot, a.radius / core, away)};
    }
  }
  return *best;
}

namespace {

/// Distances to one convex part in doubles: the dual simplex of foot_search.h for a single set.
class PartDistance {
 public:
  explicit PartDistance(const std::vector<HalfSpace>& planes) {
    for (const HalfSpace& h : planes) units_.push_back(h.unit), shifts_.push_back(h.shift);
  }
  double operator()(const Vector& x) const {
    Vector y;
    std::vector<int> basis;
    const double slack = 0x1p-46 * (space::size_of(x) + 1);
    for (int step = 0; step < 100; ++step) {
      int worst = -1;
      double most = slack;
      for (int i = 0; i < static_cast<int>(units_.size()); ++i) {
        const double out = gap(i, x) + dot(units_[i], y);
        if (out > most && std::find(basis.begin(), basis.end(), i) == basis.end()) most = out, worst = i;
      }
      if (worst < 0 || !exchange(basis, worst, x, y)) break;
    }
    return space::length(y);
  }

 private:
  double gap(int i, const Vector& x) const { return dot(units_[i], x) + shifts_[i]; }

  /// The foot of x on plane `fresh` and some of the basis that keeps below all of them.
  bool exchange(std::vector<int>& basis, int fresh, const Vector& x, Vector& y) const {
    for (int kept = 0; kept < (1 << basis.size()); ++kept) {
      std::vector<int> on{fresh};
      for (std::size_t i = 0; i < basis.size(); ++i) {
        if (kept >> i & 1) on.push_back(basis[i]);
      }
      if (on.size() > 3) continue;
      const auto foot = foot_on(on, x);
      if (!foot) continue;
      const bool below = std::all_of(basis.begin(), basis.end(), [&](int i) {
        return gap(i, x) + dot(units_[i], *foot) <= 0x1p-44 * (space::size_of(x) + 1);
      });
      if (!below) continue;
      basis = on;
      y = *foot;
      return true;
    }
    return false;
  }

  std::optional<Vector> foot_on(const std::vector<int>& on, const Vector& x) const {
    // Gram-Schmidt on the normals, then back substitution for the multipliers.
    const std::size_t n = on.size();
    std::array<std::array<double, 4>, 3> g{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) g[i][j] = dot(units_[on[i]], units_[on[j]]);
      g[i][3] = -gap(on[i], x);
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (g[k][k] < 0x1p-40) return std::nullopt;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const double factor = g[i][k] / g[k][k];
        for (std::size_t j = 0; j < 4; ++j) g[i][j] -= factor * g[k][j];
      }
    }
    Vector y;
    for (std::size_t i = 0; i < n; ++i) {
      const double multiplier = g[i][3] / g[i][i];
      if (multiplier > 0) return std::nullopt;
      y = space::plus(y, space::scaled(multiplier, units_[on[i]]));
    }
    return y;
  }

  std::vector<Vector> units_;
  std::vector<double> shifts_;
};

struct Cell {
  std::array<Vector, 4> corner;
  std::vector<int> parts;  // of A that can be nearest in the cell
  std::vector<std::array<double, 4>> distances;
  double bound = 0;
  bool operator<(const Cell& other) const { return bound < other.bound; }
};

class Search {
 public:
  Search(const Body& b, const Body& a, const RealVector& p) : p_(space::rounded(p)) {
    for (const BodyPart& part : a.parts) parts_.emplace_back(half_spaces(part));
    for (const BodyPart& part : b.parts) add_tetrahedra(*part.core);
  }

  /// The value and the place; false where the limit was reached.
  bool run(double& value, Vector& place) {
    bool whole = true;
    for (int count = 0; !queue_.empty(); ++count) {
      Cell top = queue_.top();
      if (top.bound <= best_ * (1 + 0x1p-41)) break;
      if (count == kMostCells) {
        whole = false;
        break;
      }
      queue_.pop();
      split(top);
    }
    value = best_;
    place = place_;
    return whole;
  }

 private:
  void add_tetrahedra(const space::Polytope& s) {
    const auto at = [&](int v) { return space::plus(exact::shadow(s.vertices()[v]), p_); };
    std::vector<int> all(parts_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    for (int f = 0; f < s.facet_count(); ++f) {
      const std::vector<int> ring = s.circuit(f);
      if (std::find(ring.begin(), ring.end(), 0) != ring.end()) continue;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        add({at(0), at(ring[0]), at(ring[i]), at(ring[i + 1])}, all, exact::kInfinity);
    }
  }

  double nearest(const Vector& x, const std::vector<int>& parts) const {
    double least = exact::kInfinity;
    for (const int i : parts) least = std::min(least, parts_[i](x));
    return least;
  }

  void offer(const Vector& x, double value) {
    if (value > best_) best_ = value, place_ = x;
  }

  void add(const std::array<Vector, 4>& corner, const std::vector<int>& parts, double ceiling) {
    Cell cell;
    cell.corner = corner;
    double size = 0, bound = exact::kInfinity;
    for (const Vector& v : corner) {
      for (const Vector& w : corner) size = std::max(size, space::length(v - w));
    }
    std::vector<std::array<double, 4>> all;
    std::array<double, 4> least;
    least.fill(exact::kInfinity);
    for (const int i : parts) {
      std::array<double, 4> d{};
      for (int v = 0; v < 4; ++v) d[v] = parts_[i](corner[v]), least[v] = std::min(least[v], d[v]);
      all.push_back(d);
      bound = std::min(bound, *std::max_element(d.begin(), d.end()));
    }
    for (int v = 0; v < 4; ++v) offer(corner[v], least[v]);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (*std::max_element(all[k].begin(), all[k].end()) - size > bound) continue;
      cell.parts.push_back(parts[k]);
      cell.distances.push_back(all[k]);
    }
    const GameValue game = matrix_game(cell.distances);
    cell.bound = std::min(ceiling, game.value);
    if (cell.bound <= best_) return;
    Vector x;
    for (int v = 0; v < 4; ++v) x = space::plus(x, space::scaled(game.rows[v], corner[v]));
    offer(x, nearest(x, cell.parts));
    queue_.push(std::move(cell));
  }

  void split(const Cell& cell) {
    int a = 0, b = 1;
    double longest = 0;
    for (int v = 0; v < 4; ++v) {
      for (int w = v + 1; w < 4; ++w) {
        const double d = space::length(cell.corner[v] - cell.corner[w]);
        if (d > longest) longest = d, a = v, b = w;
      }
    }
    const Vector middle = space::scaled(0.5, space::plus(cell.corner[a], cell.corner[b]));
    for (const int moved : {a, b}) {
      std::array<Vector, 4> corner = cell.corner;
      corner[moved] = middle;
      add(corner, cell.parts, cell.bound);
    }
  }

  Vector p_;
  std::vector<PartDistance> parts_;
  std::priority_queue<Cell> queue_;
  double best_ = 0;
  Vector place_;
};

}  // namespace

SolidValue stick_out_of_union(const Body& b, const Body& a, const RealVector& p) {
  double value = 0;
  Vector place;
  const bool whole = Search(b, a, p).run(value, place);
  // At a vertex of B the exact distance to the nearest part is known.
  for (const BodyPart& part : b.parts) {
    for (const space::Point& v : part.vertices()) {
      const RealVector at = space::plus(real(v), p);
      if (!whole || space::length(space::rounded(at) - place) > 0x1p-44 * space::size_of(place)) continue;
      std::optional<SolidValue> best;
      for (const BodyPart& t : a.parts) {
        const RealVector foot = *nearest_in(half_spaces(t), at);
        const Real d = length(space::minus(at, foot));
        if (best && !(d < best->value)) continue;
        best = SolidValue{};
        best->value = d;
        best->points = {at, foot};
      }
      return *best;
    }
  }
  SolidValue out;
  out.value = Real::from_double(value);
  out.proven = false;
  return out;
}

}  // namespace findspace::distance
