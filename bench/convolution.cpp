// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "convolution.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace bench {
namespace {

Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
std::int64_t cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }
std::int64_t rotation(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - b); }

// By angle in [0, 360).
bool before(const Point& p, const Point& q) {
  bool lower_p = p.y < 0 || (p.y == 0 && p.x < 0), lower_q = q.y < 0 || (q.y == 0 && q.x < 0);
  return lower_p != lower_q ? lower_q : cross(p, q) > 0;
}

struct Edges {
  explicit Edges(const Polygon& p) : direction(p.size()), order(p.size()) {
    for (std::size_t i = 0; i < p.size(); ++i) direction[i] = p[(i + 1) % p.size()] - p[i];
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return before(direction[i], direction[j]); });
  }
  std::vector<Point> direction;    // of the edge that starts at each vertex
  std::vector<std::size_t> order;  // edges by angle

  // Calls use(edge) for the edges with directions from `low` counter-clockwise to `high`; `closed_low`: low itself
  // counts and high does not, else the other way round.
  template <class Use>
  void in_sector(const Point& low, const Point& high, bool closed_low, Use use) const {
    auto first = bound(low, closed_low), last = bound(high, closed_low);
    if (!before(low, high)) {
      for (auto i = first; i < order.size(); ++i) use(order[i]);
      first = 0;
    }
    for (auto i = first; i < last; ++i) use(order[i]);
  }

 private:
  std::size_t bound(const Point& d, bool closed) const {
    auto less = [&](std::size_t i, const Point& q) { return before(direction[i], q); };
    auto more = [&](const Point& q, std::size_t i) { return before(q, direction[i]); };
    auto it = closed ? std::lower_bound(order.begin(), order.end(), d, less)
                     : std::upper_bound(order.begin(), order.end(), d, more);
    return std::size_t(it - order.begin());
  }
};

// One directed edge of the convolution between sums of vertices, a state being (vertex of a, vertex of b).
struct Link {
  std::size_t from, to;
};

// Equal directions are decided apart by rotating b a little: its edges come after those of a. So a sector of b takes
// the edges of a in (low, high], a sector of a those of b in [low, high).
std::vector<Link> links(const Polygon& a, const Polygon& b) {
  Edges ea(a), eb(b);
  std::size_t n = a.size(), m = b.size();
  std::vector<Link> all;
  auto add = [&](std::size_t from, std::size_t to, bool forward) {
    forward ? all.push_back({from, to}) : all.push_back({to, from});
  };
  for (std::size_t j = 0; j < m; ++j) {
    const Point &in = eb.direction[(j + m - 1) % m], &out = eb.direction[j];
    bool convex = cross(in, out) > 0;
    ea.in_sector(convex ? in : out, convex ? out : in, false,
                 [&](std::size_t i) { add(i * m + j, (i + 1) % n * m + j, convex); });
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point &in = ea.direction[(i + n - 1) % n], &out = ea.direction[i];
    bool convex = cross(in, out) > 0;
    eb.in_sector(convex ? in : out, convex ? out : in, true,
                 [&](std::size_t j) { add(i * m + j, i * m + (j + 1) % m, convex); });
  }
  return all;
}

// A ring of vertices by index, as a doubly linked list.
struct Ring {
  std::vector<std::size_t> next, prev;
};

bool inside(const Point& a, const Point& b, const Point& c, const Point& p) {
  return rotation(a, b, p) >= 0 && rotation(b, c, p) >= 0 && rotation(c, a, p) >= 0;
}

bool is_ear(const Polygon& p, const Ring& ring, std::size_t i) {
  std::size_t h = ring.prev[i], j = ring.next[i];
  if (rotation(p[h], p[i], p[j]) <= 0) return false;
  for (std::size_t k = ring.next[j]; k != h; k = ring.next[k]) {
    if (rotation(p[ring.prev[k]], p[k], p[ring.next[k]]) <= 0 && inside(p[h], p[i], p[j], p[k])) return false;
  }
  return true;
}

std::vector<std::vector<std::size_t>> triangles(const Polygon& p) {
  std::size_t n = p.size();
  Ring ring{std::vector<std::size_t>(n), std::vector<std::size_t>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    ring.next[i] = (i + 1) % n;
    ring.prev[i] = (i + n - 1) % n;
  }
  std::vector<std::vector<std::size_t>> all;
  std::size_t i = 0, left = n, tried = 0;
  while (left > 3 && tried <= left) {
    if (!is_ear(p, ring, i)) {
      i = ring.next[i];
      ++tried;
      continue;
    }
    all.push_back({ring.prev[i], i, ring.next[i]});
    ring.next[ring.prev[i]] = ring.next[i];
    ring.prev[ring.next[i]] = ring.prev[i];
    i = ring.next[ring.next[i]];
    --left;
    tried = 0;
  }
  all.push_back({ring.prev[i], i, ring.next[i]});
  return all;
}

// The union of two convex parts, the left one with the edge from u to v and the right one with that from v to u, if it
// is convex, else nothing.
std::vector<std::size_t> merged(const Polygon& p, const std::vector<std::size_t>& left,
                                const std::vector<std::size_t>& right, std::size_t u, std::size_t v) {
  auto at = [](const std::vector<std::size_t>& part, std::size_t i) {
    return std::size_t(std::find(part.begin(), part.end(), i) - part.begin());
  };
  std::vector<std::size_t> whole;
  for (std::size_t k = 0, i = at(left, v); k < left.size(); ++k)
    whole.push_back(left[(i + k) % left.size()]);  // v ... u
  for (std::size_t k = 1, i = at(right, u); k + 1 < right.size(); ++k) whole.push_back(right[(i + k) % right.size()]);
  std::size_t n = whole.size(), end = left.size() - 1;
  bool convex_at_u = rotation(p[whole[end - 1]], p[u], p[whole[(end + 1) % n]]) >= 0;
  bool convex_at_v = rotation(p[whole[n - 1]], p[v], p[whole[1]]) >= 0;
  return convex_at_u && convex_at_v ? whole : std::vector<std::size_t>{};
}

}  // namespace

std::vector<Polygon> convolution_cycles(const Polygon& a, const Polygon& b) {
  std::vector<Link> all = links(a, b);
  std::sort(all.begin(), all.end(), [](const Link& p, const Link& q) { return p.from < q.from; });
  std::vector<std::uint8_t> used(all.size(), 0);
  auto leaving = [&](std::size_t state) {
    auto it = std::lower_bound(all.begin(), all.end(), state, [](const Link& l, std::size_t s) { return l.from < s; });
    while (used[std::size_t(it - all.begin())]) ++it;
    return std::size_t(it - all.begin());
  };

  // As many links enter a state as leave it, so a walk along unused ones ends where it began.
  std::vector<Polygon> cycles;
  for (std::size_t first = 0; first < all.size(); ++first) {
    if (used[first]) continue;
    Polygon cycle;
    std::size_t link = first;
    for (;;) {
      std::size_t state = all[link].from;
      cycle.push_back(a[state / b.size()] + b[state % b.size()]);
      used[link] = 1;
      if (all[link].to == all[first].from) break;
      link = leaving(all[link].to);
    }
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

std::vector<Polygon> convex_parts(const Polygon& p) {
  auto parts = triangles(p);
  std::vector<std::size_t> root(parts.size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  auto part_of = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> right_of;  // directed edge -> triangle on its right
  for (std::size_t t = 0; t < parts.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) right_of[{parts[t][(k + 1) % 3], parts[t][k]}] = t;
  }
  auto before_merging = parts;
  for (std::size_t t = 0; t < before_merging.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t u = before_merging[t][k], v = before_merging[t][(k + 1) % 3];
      auto other = right_of.find({u, v});
      if (other == right_of.end()) continue;
      std::size_t i = part_of(t), j = part_of(other->second);
      if (i == j) continue;
      auto whole = merged(p, parts[i], parts[j], u, v);
      if (whole.empty()) continue;
      parts[i] = std::move(whole);
      root[j] = i;
    }
  }
  std::vector<Polygon> polygons;
  for (std::size_t t = 0; t < parts.size(); ++t) {
    if (part_of(t) != t) continue;
    polygons.emplace_back();
    for (std::size_t i : parts[t]) polygons.back().push_back(p[i]);
  }
  return polygons;
}

Polygon convex_sum(const Polygon& a, const Polygon& b) {
  auto lowest = [](const Polygon& p) {
    return std::size_t(
        std::min_element(p.begin(), p.end(),
                         [](const Point& s, const Point& t) { return s.y != t.y ? s.y < t.y : s.x < t.x; }) -
        p.begin());
  };
  std::size_t i0 = lowest(a), j0 = lowest(b), i = 0, j = 0, n = a.size(), m = b.size();
  Polygon sum;
  while (i < n || j < m) {
    const Point &p = a[(i0 + i) % n], &q = b[(j0 + j) % m];
    sum.push_back(p + q);
    std::int64_t side = cross(a[(i0 + i + 1) % n] - p, b[(j0 + j + 1) % m] - q);
    bool step_a = j == m || (i < n && side >= 0), step_b = i == n || (j < m && side <= 0);
    i += step_a;
    j += step_b;
  }
  return sum;
}

}  // namespace bench
