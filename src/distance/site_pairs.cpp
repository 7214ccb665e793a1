// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/site_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Cell;
using plane::Index;
using plane::kNone;
using plane::Region;

namespace {

constexpr double kSlack = 0x1p-43;  // of the scale: what doubles cannot tell apart
constexpr double kMeets = 0x1p-40;  // of the scale: crossings closer than this to the ends of sites count

/// Two features and their distance in numbers.
struct Candidate {
  double value;
  Cell first, second;
};

/// A site seen as what its end points and its inside are; moved to its place.
struct Placed {
  Site s;
  std::array<Index, 2> vertex;  // equal for an isolated vertex
};

Placed placed(const Region& r, const Site& site, double px, double py) {
  Placed out{site, {site.cell.index, site.cell.index}};
  if (!site.is_vertex()) out.vertex = {r.edges[site.cell.index].v0, r.edges[site.cell.index].v1};
  Site& s = out.s;
  s.x0 += px, s.x1 += px, s.cx += px, s.y0 += py, s.y1 += py, s.cy += py;
  return out;
}

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// They cross, the ends of each further than `room` from the line of the other.
bool segments_cross(const Site& s, const Site& t, double room) {
  double dx = s.x1 - s.x0, dy = s.y1 - s.y0, ex = t.x1 - t.x0, ey = t.y1 - t.y0;
  double a = cross(dx, dy, t.x0 - s.x0, t.y0 - s.y0), b = cross(dx, dy, t.x1 - s.x0, t.y1 - s.y0);
  double c = cross(ex, ey, s.x0 - t.x0, s.y0 - t.y0), d = cross(ex, ey, s.x1 - t.x0, s.y1 - t.y0);
  if ((a > 0) == (b > 0) || (c > 0) == (d > 0)) return false;
  double wide = std::hypot(dx, dy) * room, high = std::hypot(ex, ey) * room;
  return std::min(std::abs(a), std::abs(b)) > wide && std::min(std::abs(c), std::abs(d)) > high;
}

/// Within `room` of the site, for a place on its line or circle.
bool is_on(const Site& s, double x, double y, double room) { return s.distance(x, y) <= room; }

/// Where an arc and another site meet, if they do or seem to.
std::optional<std::array<double, 2>> arc_meeting(const Site& arc, const Site& other, double room) {
  if (other.is_vertex())
    return is_on(arc, other.x0, other.y0, room) ? std::optional(std::array{other.x0, other.y0}) : std::nullopt;
  double ux, uy, fx, fy, h2;
  if (other.arc) {
    double dx = other.cx - arc.cx, dy = other.cy - arc.cy, d = std::hypot(dx, dy);
    if (d == 0) return std::nullopt;
    double along = (d * d + arc.r * arc.r - other.r * other.r) / (2 * d);
    ux = -dy / d, uy = dx / d, fx = arc.cx + along * dx / d, fy = arc.cy + along * dy / d,
    h2 = arc.r * arc.r - along * along;
  } else {
    double dx = other.x1 - other.x0, dy = other.y1 - other.y0, n = std::hypot(dx, dy);
    ux = dx / n, uy = dy / n;
    double t = (arc.cx - other.x0) * ux + (arc.cy - other.y0) * uy;
    fx = other.x0 + t * ux, fy = other.y0 + t * uy;
    double off = std::hypot(fx - arc.cx, fy - arc.cy);
    h2 = (arc.r - off) * (arc.r + off);
  }
  if (h2 < -room * arc.r) return std::nullopt;
  double h = std::sqrt(std::max(0.0, h2)), wide = room + std::sqrt(room * arc.r) * (h2 < room * arc.r);
  for (double side : {-h, h})
    if (is_on(arc, fx + side * ux, fy + side * uy, wide) && is_on(other, fx + side * ux, fy + side * uy, wide))
      return std::array{fx + side * ux, fy + side * uy};
  return std::nullopt;
}

bool may_meet(const Site& s, const Site& t, double room) {
  if (s.arc) return arc_meeting(s, t, room).has_value();
  if (t.arc) return arc_meeting(t, s, room).has_value();
  return !s.is_vertex() && !t.is_vertex() && segments_cross(s, t, 0);
}

/// Calls take(candidate) for the pairs of features of two sites that can be nearest.
template <class Take>
void nearest_features(const Placed& p, const Placed& q, Take&& take) {
  const Site &s = p.s, &t = q.s;
  for (int i = 0; i < (s.is_vertex() ? 1 : 2); ++i) {
    double x = i ? s.x1 : s.x0, y = i ? s.y1 : s.y0;
    for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k)
      take(Candidate{std::hypot(x - (k ? t.x1 : t.x0), y - (k ? t.y1 : t.y0)), {0, p.vertex[i]}, {0, q.vertex[k]}});
    if (!t.is_vertex() && t.faces(x, y)) take(Candidate{t.distance(x, y), {0, p.vertex[i]}, t.cell});
  }
  for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k) {
    double x = k ? t.x1 : t.x0, y = k ? t.y1 : t.y0;
    if (!s.is_vertex() && s.faces(x, y)) take(Candidate{s.distance(x, y), s.cell, {0, q.vertex[k]}});
  }
  if (s.arc && t.arc) {
    double dx = t.cx - s.cx, dy = t.cy - s.cy, d = std::hypot(dx, dy);
    if (d == 0) return;
    double room = (s.r + t.r) * kMeets;  // circles that touch may seem to cross
    if (d > s.r + t.r - room && s.has_direction(dx, dy) && t.has_direction(-dx, -dy))
      take(Candidate{std::abs(d - s.r - t.r), s.cell, t.cell});
    double turn = s.r > t.r ? 1 : -1;
    if (d < std::abs(s.r - t.r) + room && s.has_direction(turn * dx, turn * dy) &&
        t.has_direction(turn * dx, turn * dy))
      take(Candidate{std::abs(std::abs(s.r - t.r) - d), s.cell, t.cell});
  } else if ((s.arc && !t.is_vertex()) || (t.arc && !s.is_vertex())) {
    const Site &arc = s.arc ? s : t, &line = s.arc ? t : s;
    double dx = line.x1 - line.x0, dy = line.y1 - line.y0,
           at = ((arc.cx - line.x0) * dx + (arc.cy - line.y0) * dy) / (dx * dx + dy * dy);
    double fx = line.x0 + at * dx - arc.cx, fy = line.y0 + at * dy - arc.cy, d = std::hypot(fx, fy);
    if (at >= 0 && at <= 1 && d > arc.r * (1 - kMeets) && arc.has_direction(fx, fy))
      take(Candidate{std::abs(d - arc.r), s.cell, t.cell});
  }
}

template <class Take>
void farthest_features(const Placed& p, const Placed& q, Take&& take) {
  const Site &s = p.s, &t = q.s;
  for (int i = 0; i < (s.is_vertex() ? 1 : 2); ++i) {
    double x = i ? s.x1 : s.x0, y = i ? s.y1 : s.y0;
    for (int k = 0; k < (t.is_vertex() ? 1 : 2); ++k)
      take(Candidate{std::hypot(x - (k ? t.x1 : t.x0), y - (k ? t.y1 : t.y0)), {0, p.vertex[i]}, {0, q.vertex[k]}});
    if (t.arc && t.has_direction(t.cx - x, t.cy - y))
      take(Candidate{std::hypot(t.cx - x, t.cy - y) + t.r, {0, p.vertex[i]}, t.cell});
  }
  for (int k = 0; k < (t.is_vertex() ? 1 : 2) && s.arc; ++k) {
    double dx = s.cx - (k ? t.x1 : t.x0), dy = s.cy - (k ? t.y1 : t.y0);
    if (s.has_direction(dx, dy)) take(Candidate{std::hypot(dx, dy) + s.r, s.cell, {0, q.vertex[k]}});
  }
  if (!s.arc || !t.arc) return;
  double dx = t.cx - s.cx, dy = t.cy - s.cy, d = std::hypot(dx, dy);
  if (d == 0 ? s.half != t.half || s.cell == t.cell : s.has_direction(-dx, -dy) && t.has_direction(dx, dy))
    take(Candidate{d + s.r + t.r, s.cell, t.cell});
}

// -- exact
// ----------------------------------------------------------------------------------------------------------------------

/// A vertex, or the centre and radius of an arc.
struct Centre {
  RealPoint at;
  Real radius;
};

Centre centre(const Region& r, Cell cell, const RealPoint& by) {
  if (cell.dimension == 0) {
    RealPoint at = r.geometry.exact(r.vertices[cell.index].point);
    return {{at.x + by.x, at.y + by.y}, Real()};
  }
  const exact::Carrier& k = r.carrier(cell.index);
  return {{k.center_x() + by.x, k.center_y() + by.y}, k.w};
}

bool is_line(const Region& r, Cell cell) { return cell.dimension == 1 && !r.is_arc(cell.index); }

RealPoint towards(const Centre& from, const Real& dx, const Real& dy, const Real& d, const Real& length) {
  if (d.sign() == 0) return {from.at.x + length, from.at.y};
  return {from.at.x + dx * length / d, from.at.y + dy * length / d};
}

/// Foot of the perpendicular from the centre (radius 0 or less than the distance) on an edge moved by `by`, if it lies
/// there.
std::optional<SitePair> line_pair(const Region& lines, Index edge, const RealPoint& by, const Centre& c) {
  const exact::Carrier& k = lines.carrier(edge);
  Real a(k.a), b(k.b), x = c.at.x - by.x, y = c.at.y - by.y;
  auto along = [&](Index v) {
    RealPoint end = lines.geometry.exact(lines.vertices[v].point);
    return (b * (x - end.x) - a * (y - end.y)).sign();
  };
  if (along(lines.edges[edge].v0) * along(lines.edges[edge].v1) > 0) return std::nullopt;
  Real n2 = a * a + b * b, h = a * x + b * y - k.offset();
  Real d = abs(h) / sqrt(n2);
  RealPoint foot{c.at.x - a * h / n2, c.at.y - b * h / n2};
  SitePair out{d - c.radius, foot, c.at, {}, {}};
  if (c.radius.sign() != 0) out.second = towards(c, foot.x - c.at.x, foot.y - c.at.y, d, c.radius);
  return out;
}

/// The nearest points of two circles that lie apart, or one inside the other; or the farthest points.
enum class Between { kApart, kInside, kFar };

SitePair centre_pair(const Centre& f, const Centre& g, Between how) {
  Real dx = g.at.x - f.at.x, dy = g.at.y - f.at.y, d = sqrt(dx * dx + dy * dy);
  if (how == Between::kFar)
    return {d + f.radius + g.radius, towards(f, dx, dy, d, -f.radius), towards(g, dx, dy, d, g.radius), {}, {}};
  if (how == Between::kApart)
    return {d - f.radius - g.radius, towards(f, dx, dy, d, f.radius), towards(g, dx, dy, d, -g.radius), {}, {}};
  int turn = compare(f.radius, g.radius);
  Real s(turn);
  return {
      abs(f.radius - g.radius) - d, towards(f, dx, dy, d, s * f.radius), towards(g, dx, dy, d, s * g.radius), {}, {}};
}

std::optional<SitePair> exact_pair(const Region& a, const Region& b, const RealPoint& p, const Candidate& k, bool far) {
  const RealPoint origin{Real(), Real()};
  SitePair out;
  if (is_line(a, k.first)) {
    auto found = line_pair(a, k.first.index, origin, centre(b, k.second, p));
    if (!found) return std::nullopt;
    out = std::move(*found);
  } else if (is_line(b, k.second)) {
    auto found = line_pair(b, k.second.index, p, centre(a, k.first, origin));
    if (!found) return std::nullopt;
    out = std::move(*found);
    std::swap(out.first, out.second);
  } else {
    Centre f = centre(a, k.first, origin), g = centre(b, k.second, p);
    double d = std::hypot(near_value(f.at.x) - near_value(g.at.x), near_value(f.at.y) - near_value(g.at.y));
    bool inside = d < std::max(near_value(f.radius), near_value(g.radius));
    out = centre_pair(f, g, far ? Between::kFar : inside ? Between::kInside : Between::kApart);
  }
  out.first_cell = k.first, out.second_cell = k.second;
  return out;
}

/// The common point of two straight edges that cross.
SitePair crossing(const Region& a, const Region& b, Cell s, Cell t, const RealPoint& p) {
  const exact::Carrier &f = a.carrier(s.index), &g = b.carrier(t.index);
  Real c = f.offset(), d = g.offset() + Real(g.a) * p.x + Real(g.b) * p.y;
  Real n(exact::int128(f.a) * g.b - exact::int128(f.b) * g.a);
  RealPoint at{(c * Real(g.b) - d * Real(f.b)) / n, (Real(f.a) * d - Real(g.a) * c) / n};
  return {Real(), at, at, s, t};
}

class PairSearch {
 public:
  PairSearch(const SiteTree& a, const SiteTree& b, const RealPoint& p)
      : a_(a), b_(b), p_(p), px_(near_value(p.x)), py_(near_value(p.y)) {
    double scale = a.scale() + b.scale() + std::abs(px_) + std::abs(py_);
    slack_ = scale * kSlack, room_ = scale * kMeets;
  }

  /// Returns false where the boundaries meet or come closer than numbers can tell; not if `touching`.
  bool run_nearest(bool touching);
  void run_farthest();
  /// A crossing of straight edges, certain; with `arcs` also a place where arcs meet or seem to.
  std::optional<SitePair> run_common(bool arcs);
  /// The exact best among what numbers left over.
  SitePair best(bool far) const;
  /// What numbers say is nearest, exactly.
  SitePair first() const;

 private:
  struct Entry {
    double squared;
    Index i, j;
  };
  void keep(const Candidate& c);
  Entry entry(Index i, Index j, bool far) const;
  /// leaf(site of A, site of B) for the pairs of sites that may count; ends when it returns false.
  template <class Leaf>
  void walk(bool far, Leaf&& leaf);
  bool worth(double squared, bool far) const;

  const SiteTree &a_, &b_;
  const RealPoint& p_;
  double px_, py_, slack_ = 0, room_ = 0, best_ = std::numeric_limits<double>::infinity();
  std::vector<Candidate> candidates_;
};

/// Nearest values count as they are, farthest ones with a minus: less is better.
void PairSearch::keep(const Candidate& c) {
  if (c.value > best_ + slack_) return;
  if (c.value < best_) {
    best_ = c.value;
    std::erase_if(candidates_, [&](const Candidate& k) { return k.value > best_ + slack_; });
  }
  auto same = [&](const Candidate& k) { return k.first == c.first && k.second == c.second; };
  if (std::none_of(candidates_.begin(), candidates_.end(), same)) candidates_.push_back(c);
}

PairSearch::Entry PairSearch::entry(Index i, Index j, bool far) const {
  const SiteBox &s = a_.nodes()[i].box, &t = b_.nodes()[j].box;
  return {far ? -s.farthest_squared(t, px_, py_) : s.nearest_squared(t, px_, py_), i, j};
}

bool PairSearch::worth(double squared, bool far) const {
  double limit = best_ + slack_;
  return far ? limit > 0 || -squared >= limit * limit : squared <= limit * limit;
}

template <class Leaf>
void PairSearch::walk(bool far, Leaf&& leaf) {
  std::vector<Entry> stack{entry(0, 0, far)};
  while (!stack.empty()) {
    Entry e = stack.back();
    stack.pop_back();
    if (!worth(e.squared, far)) continue;
    const SiteTree::Node &s = a_.nodes()[e.i], &t = b_.nodes()[e.j];
    bool split_first = s.right != kNone && (t.right == kNone || s.last - s.first >= t.last - t.first);
    if (!split_first && t.right == kNone) {
      for (Index j = t.first; j < t.last; ++j) {
        Placed q = placed(b_.region(), b_.sites()[j], px_, py_);
        for (Index i = s.first; i < s.last; ++i)
          if (!leaf(placed(a_.region(), a_.sites()[i], 0, 0), q)) return;
      }
      continue;
    }
    Entry near = split_first ? entry(e.i + 1, e.j, far) : entry(e.i, e.j + 1, far);
    Entry other = split_first ? entry(s.right, e.j, far) : entry(e.i, t.right, far);
    if (other.squared < near.squared) std::swap(near, other);
    if (worth(other.squared, far)) stack.push_back(other);
    if (worth(near.squared, far)) stack.push_back(near);
  }
}

bool PairSearch::run_nearest(bool touching) {
  bool meet = false;
  walk(false, [&](const Placed& p, const Placed& q) {
    if (!worth(box_of(p.s).nearest_squared(box_of(q.s), 0, 0), false)) return true;
    nearest_features(p, q, [&](const Candidate& c) { keep(c); });
    meet = !touching && (best_ <= slack_ || may_meet(p.s, q.s, room_));
    return !meet;
  });
  return !meet;
}

void PairSearch::run_farthest() {
  walk(true, [&](const Placed& p, const Placed& q) {
    farthest_features(p, q, [&](Candidate c) {
      c.value = -c.value;
      keep(c);
    });
    return true;
  });
}

std::optional<SitePair> PairSearch::run_common(bool arcs) {
  std::optional<SitePair> found;
  best_ = 0;
  walk(false, [&](const Placed& p, const Placed& q) {
    const Site &s = p.s, &t = q.s;
    if (!s.arc && !t.arc) {
      if (!s.is_vertex() && !t.is_vertex() && segments_cross(s, t, slack_))
        found = crossing(a_.region(), b_.region(), s.cell, t.cell, p_);
    } else if (arcs) {
      if (auto at = s.arc ? arc_meeting(s, t, room_) : arc_meeting(t, s, room_)) {
        RealPoint place{Real::from_double((*at)[0]), Real::from_double((*at)[1])};
        found = SitePair{Real(), place, place, s.cell, t.cell};
      }
    }
    return !found;
  });
  return found;
}

SitePair PairSearch::best(bool far) const {
  std::optional<SitePair> best;
  for (const Candidate& c : candidates_) {
    auto k = exact_pair(a_.region(), b_.region(), p_, c, far);
    if (k && (!best || (far ? k->distance > best->distance : k->distance < best->distance))) best = std::move(k);
  }
  return *best;
}

SitePair PairSearch::first() const {
  std::vector<Candidate> all = candidates_;
  std::stable_sort(all.begin(), all.end(), [](const Candidate& c, const Candidate& d) { return c.value < d.value; });
  for (const Candidate& c : all)
    if (auto k = exact_pair(a_.region(), b_.region(), p_, c, false)) return *k;
  return {};
}

}  // namespace

std::optional<SitePair> nearest_pair(const SiteTree& a, const SiteTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  if (!search.run_nearest(false)) return std::nullopt;
  return search.best(false);
}

std::optional<SitePair> crossing_pair(const SiteTree& a, const SiteTree& b, const RealPoint& p) {
  return PairSearch(a, b, p).run_common(false);
}

SitePair common_point(const SiteTree& a, const SiteTree& b, const RealPoint& p) {
  auto found = PairSearch(a, b, p).run_common(true);
  return found ? *found : touching_pair(a, b, p);
}

SitePair touching_pair(const SiteTree& a, const SiteTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  search.run_nearest(true);
  return search.first();
}

SitePair farthest_pair(const SiteTree& a, const SiteTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  search.run_farthest();
  return search.best(true);
}

SitePair nearest_point(const SiteTree& a, const RealPoint& at) {
  double x = near_value(at.x), y = near_value(at.y);
  double limit = a.nearest(x, y).distance + (a.scale() + std::abs(x) + std::abs(y)) * kSlack;
  const RealPoint origin{Real(), Real()};
  std::optional<SitePair> best;
  auto take = [&](std::optional<SitePair> k, Cell cell) {
    if (!k || (best && !(k->distance < best->distance))) return;
    best = std::move(k);
    best->first_cell = cell;
  };
  std::vector<Index> stack{0};
  while (!stack.empty()) {
    const SiteTree::Node& n = a.nodes()[stack.back()];
    Index first = stack.back() + 1;
    stack.pop_back();
    if (n.box.nearest_squared(x, y) > limit * limit) continue;
    if (n.right != kNone) {
      stack.insert(stack.end(), {n.right, first});
      continue;
    }
    for (Index k = n.first; k < n.last; ++k) {
      const Site& s = a.sites()[k];
      if (s.distance(x, y) > limit) continue;
      Placed p = placed(a.region(), s, 0, 0);
      if (std::hypot(x - s.x0, y - s.y0) <= limit)
        take(centre_pair(centre(a.region(), {0, p.vertex[0]}, origin), {at, Real()}, Between::kApart),
             {0, p.vertex[0]});
      if (std::hypot(x - s.x1, y - s.y1) <= limit)
        take(centre_pair(centre(a.region(), {0, p.vertex[1]}, origin), {at, Real()}, Between::kApart),
             {0, p.vertex[1]});
      if (s.is_vertex() || !s.faces(x, y)) continue;
      if (!s.arc) {
        take(line_pair(a.region(), s.cell.index, origin, {at, Real()}), s.cell);
      } else {
        bool inside = std::hypot(x - s.cx, y - s.cy) < s.r;
        take(centre_pair(centre(a.region(), s.cell, origin), {at, Real()}, inside ? Between::kInside : Between::kApart),
             s.cell);
      }
    }
  }
  return *best;
}

}  // namespace findspace::distance
