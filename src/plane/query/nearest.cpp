// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"
#include "plane/complex/extent.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::RealPoint;

/// A number as a double, with a bound of its error.
struct Around {
  double value, error;
};

Around around(const Real& r) {
  const auto i = r.interval();
  return {i.lo + (i.hi - i.lo) / 2, i.hi - i.lo};
}

/// The sign of the turn from the direction of a vertex to (dx, dy), seen from the centre.
class Turn {
 public:
  Turn(const CellComplex& c, Index arc, const Real& dx, const Real& dy)
      : c_(c), circle_(c.supporting_curve(arc)), dx_(dx), dy_(dy), x_(around(dx)), y_(around(dy)) {}

  int sign(Index v) const {
    const exact::Point& p = c_.point(v);
    const double cx = circle_.x().value, cy = circle_.y().value, ex = p.x - cx, ey = p.y - cy;
    const double turn = ex * y_.value - ey * x_.value;
    const double scale = std::abs(p.x) + std::abs(p.y) + std::abs(cx) + std::abs(cy);
    const double size = std::abs(x_.value) + std::abs(y_.value);
    const double moved = p.error + circle_.x().error + circle_.y().error;
    const double error = scale * (size * margin::kNearestCandidate + 2 * (x_.error + y_.error)) + 2 * size * moved;
    const bool plain = dx_.fraction() && dy_.fraction() && p.kind != exact::Point::Kind::kReal;
    if (std::abs(turn) > error || !plain) return (turn > 0) - (turn < 0);
    const exact::RealPoint end = c_.geometry.exact(c_.vertices[v].point);
    return ((end.x - circle_.center_x()) * dy_ - (end.y - circle_.center_y()) * dx_).sign();
  }

 private:
  const CellComplex& c_;
  const exact::SupportingCurve& circle_;
  const Real &dx_, &dy_;
  Around x_, y_;
};

struct Candidate {
  double distance;
  Cell cell;
};

/// The foot of the perpendicular is inside the edge, or no farther than `slack` beyond an end.
bool projection_inside(const CellComplex& c, Index edge, double x, double y, double slack) {
  const Edge& e = c.edges[edge];
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  if (e.half == 0) {
    const double dx = q.x - p.x, dy = q.y - p.y, t = (x - p.x) * dx + (y - p.y) * dy, size = dx * dx + dy * dy;
    return std::max(-t, t - size) < slack * std::sqrt(size);
  }
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  // The direction lies between those of the ends. The foot itself is rounded, which moves it far along an arc where
  // this is vertical.
  const double dx = x - k.x().value, dy = y - k.y().value;
  const auto turn = [&](const exact::Point& end) { return (end.x - k.x().value) * dy - (end.y - k.y().value) * dx; };
  const double most = slack * std::hypot(dx, dy);
  return e.half * turn(p) <= most && e.half * turn(q) >= -most;
}

/// Whether the box of a straight edge is farther than `reach`, as near as rounding; of an arc never.
bool is_beyond(const CellComplex& c, Index edge, double x, double y, double reach) {
  const Edge& e = c.edges[edge];
  if (e.half != 0) return false;
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  return x < std::min(p.x, q.x) - reach || x > std::max(p.x, q.x) + reach || y < std::min(p.y, q.y) - reach ||
         y > std::max(p.y, q.y) + reach;
}

/// No less than that of what of it is nearest.
double edge_distance(const CellComplex& c, Index edge, double x, double y) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  if (c.edges[edge].half == 0) {
    const exact::Point &p = c.point(c.edges[edge].v0), &q = c.point(c.edges[edge].v1);
    const double dx = q.x - p.x, dy = q.y - p.y, t = (x - p.x) * dx + (y - p.y) * dy;
    if (t < 0) return std::hypot(x - p.x, y - p.y);
    if (t > dx * dx + dy * dy) return std::hypot(x - q.x, y - q.y);
    return std::abs(k.x().value * (x - p.x) + k.y().value * (y - p.y));
  }
  if (!projection_inside(c, edge, x, y, 0)) {
    const exact::Point &p = c.point(c.edges[edge].v0), &q = c.point(c.edges[edge].v1);
    return std::min(std::hypot(x - p.x, y - p.y), std::hypot(x - q.x, y - q.y));
  }
  return std::abs(std::hypot(x - k.x().value, y - k.y().value) - k.z().value);
}

std::optional<Nearest> exact_vertex(const CellComplex& c, Index v, const RealPoint& from) {
  RealPoint at = c.geometry.exact(c.vertices[v].point);
  Real dx = at.x - from.x, dy = at.y - from.y;
  return Nearest{sqrt(dx * dx + dy * dy), at, {0, v}};
}

/// The projection on a straight edge is between its ends, exactly.
bool is_between_ends(const CellComplex& c, Index edge, const RealPoint& from) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  const auto along = [&](Index v) {
    const RealPoint end = c.geometry.exact(c.vertices[v].point);
    return (Real(k.b) * (from.x - end.x) - Real(k.a) * (from.y - end.y)).sign();
  };
  return along(c.edges[edge].v0) * along(c.edges[edge].v1) < 0;
}

/// Nothing where the projection is not on the edge.
std::optional<Nearest> exact_edge(const CellComplex& c, Index edge, const RealPoint& from) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  if (!k.circle) {
    if (!is_between_ends(c, edge, from)) return std::nullopt;
    Real a(k.a), b(k.b), n2 = a * a + b * b, h = a * from.x + b * from.y - k.offset();
    Real d = h / sqrt(n2);
    return Nearest{d.sign() < 0 ? -d : d, {from.x - a * h / n2, from.y - b * h / n2}, {1, edge}};
  }
  Real dx = from.x - k.center_x(), dy = from.y - k.center_y(), length = sqrt(dx * dx + dy * dy), d = length - k.w();
  if (!has_direction(c, edge, dx, dy)) return std::nullopt;
  RealPoint at = length.sign() == 0 ? c.geometry.exact(c.vertices[c.edges[edge].v0].point)
                                    : RealPoint{k.center_x() + dx * k.w() / length, k.center_y() + dy * k.w() / length};
  return Nearest{d.sign() < 0 ? -d : d, at, {1, edge}};
}

/// How far the coordinates of the vertices reach.
double greatest_coordinate(const CellComplex& c) {
  double greatest = 0;
  for (Index v = 0; v < c.vertices.size(); ++v)
    greatest = std::max({greatest, std::abs(c.point(v).x), std::abs(c.point(v).y)});
  return greatest;
}

/// Vertices and edges that may be nearest to a place, by numbers.
class Candidates {
 public:
  Candidates(const CellComplex& c, const RealPoint& from, double greatest)
      : c_(c),
        from_(from),
        x_(around(from.x).value),
        y_(around(from.y).value),
        scale_(std::abs(x_) + std::abs(y_) + greatest),
        slack_(scale_ * margin::kNearestCandidate) {}

  void add_vertex(Index v) {
    const double dx = c_.point(v).x - x_, dy = c_.point(v).y - y_;
    take(std::sqrt(dx * dx + dy * dy), {0, v});
  }
  void add_edge(Index e) {
    if (!is_beyond(c_, e, x_, y_, reach_) && projection_inside(c_, e, x_, y_, slack_))
      take(edge_distance(c_, e, x_, y_), {1, e});
  }
  /// Farther than anything that counts, more than rounding says.
  bool is_out_of_reach(const PieceBox& box) const { return distance(box) > reach_ + 2 * slack_; }
  double distance(const PieceBox& box) const {
    return std::hypot(std::max({box.x0 - x_, x_ - box.x1, 0.0}), std::max({box.y0 - y_, y_ - box.y1, 0.0}));
  }

  /// Those that are as near as the nearest, vertices first, in the order of their numbers.
  std::vector<Nearest> nearest() {
    std::erase_if(all_, [&](const Candidate& k) { return k.distance > reach_; });
    std::sort(all_.begin(), all_.end(), [](const Candidate& p, const Candidate& q) {
      return p.cell.dimension != q.cell.dimension ? p.cell.dimension < q.cell.dimension : p.cell.index < q.cell.index;
    });
    std::vector<Nearest> best;
    for (const Candidate& k : all_) {
      auto n = k.cell.dimension == 0 ? exact_vertex(c_, k.cell.index, from_) : exact_edge(c_, k.cell.index, from_);
      if (!n) continue;
      const int order = best.empty() ? 0 : compare_if_closed(n->distance, best.front().distance);
      if (order < 0) best.clear();
      if (order <= 0) best.push_back(*std::move(n));
    }
    return best;
  }

 private:
  /// Rounding can only exchange candidates that are as near as the reach, a little beyond the least; their distances
  /// are exact, and compared so where they are closed forms.
  void take(double d, Cell cell) {
    if (d > reach_) return;
    all_.push_back({d, cell});
    reach_ = std::min(reach_, d + (scale_ + d) * margin::kNearestCandidate);
  }

  const CellComplex& c_;
  const RealPoint& from_;
  double x_, y_, scale_, slack_, reach_ = std::numeric_limits<double>::infinity();
  std::vector<Candidate> all_;
};

/// Of the vertices and edges whose mark is wanted, those that are as near as the nearest.
std::vector<Nearest> all_nearest(const CellComplex& c, const std::function<bool(Mark)>& wanted, const RealPoint& from) {
  Candidates all(c, from, greatest_coordinate(c));
  for (Index v = 0; v < c.vertices.size(); ++v)
    if (wanted(c.vertices[v].mark)) all.add_vertex(v);
  for (Index e = 0; e < c.edges.size(); ++e)
    if (wanted(c.edges[e].mark)) all.add_edge(e);
  return all.nearest();
}

/// The middle of an arc, whose every point is as far from the centre.
RealPoint middle(const CellComplex& c, Index arc) {
  const exact::SupportingCurve& k = c.supporting_curve(arc);
  const auto end = [&](Index v) { return c.geometry.exact(c.vertices[v].point); };
  const RealPoint p = end(c.edges[arc].v0), q = end(c.edges[arc].v1);
  const Real half(c.edges[arc].half), dx = (p.y - q.y) * half, dy = (q.x - p.x) * half;  // across the chord
  const Real share = k.w() / sqrt(dx * dx + dy * dy);
  return {k.center_x() + dx * share, k.center_y() + dy * share};
}

bool has(const Region& set, const RealPoint& p) { return mark_of(set, locate(set, p)) > 0; }

/// The nearest point of a vertex or an edge that belongs to the region; nothing where it is an end that does not.
std::optional<RealPoint> own_place(const Region& region, const Nearest& n, const RealPoint& from) {
  if (n.cell.dimension != 1 || !region.is_arc(n.cell.index)) return n.at;  // of a segment it is between the ends
  const exact::SupportingCurve& k = region.supporting_curve(n.cell.index);
  if (from.x == k.center_x() && from.y == k.center_y()) return middle(region, n.cell.index);
  return has(region, n.at) ? std::optional(n.at) : std::nullopt;
}

}  // namespace

bool has_direction(const CellComplex& c, Index arc, const Real& dx, const Real& dy) {
  const Edge& e = c.edges[arc];
  const Turn turn(c, arc, dx, dy);
  return e.half * turn.sign(e.v0) <= 0 && e.half * turn.sign(e.v1) >= 0;
}

std::optional<Nearest> nearest(const CellComplex& c, const std::function<bool(Mark)>& wanted, const RealPoint& from) {
  std::vector<Nearest> all = all_nearest(c, wanted, from);
  if (all.empty()) return std::nullopt;
  return std::move(all.front());
}

NearestSearch::NearestSearch(const CellComplex& c, const std::function<bool(Mark)>& wanted)
    : c_(c), greatest_(greatest_coordinate(c)) {
  std::vector<Item> items;
  for (Index v = 0; v < c.vertices.size(); ++v) {
    const exact::Point& p = c.point(v);
    if (wanted(c.vertices[v].mark)) items.push_back({{p.x, p.y, p.x, p.y}, {0, v}});
  }
  for (Index e = 0; e < c.edges.size(); ++e)
    if (wanted(c.edges[e].mark)) items.push_back({edge_box(c, e), {1, e}});
  if (!items.empty()) build(items);
  cells_.reserve(items.size());
  for (const Item& item : items) cells_.push_back(item.cell);
}

/// The items of a node stand beside each other.
void NearestSearch::build(std::span<Item> all) {
  constexpr std::size_t kFewItems = 8;
  struct Todo {
    Index node, first, end;
  };
  std::vector<Todo> todo{{0, 0, Index(all.size())}};
  nodes_.emplace_back();
  while (!todo.empty()) {
    const Todo at = todo.back();
    todo.pop_back();
    const std::span<Item> items = all.subspan(at.first, at.end - at.first);
    PieceBox box = items[0].box;
    for (const Item& item : items) box = joined(box, item.box);
    nodes_[at.node] = {box, at.first, at.end, kNone};
    if (items.size() <= kFewItems) continue;
    const bool wide = box.x1 - box.x0 >= box.y1 - box.y0;
    const auto middle = items.begin() + std::ptrdiff_t(items.size() / 2);
    std::nth_element(items.begin(), middle, items.end(), [wide](const Item& p, const Item& q) {
      return wide ? p.box.x0 + p.box.x1 < q.box.x0 + q.box.x1 : p.box.y0 + p.box.y1 < q.box.y0 + q.box.y1;
    });
    const Index child = Index(nodes_.size()), half = at.first + Index(items.size() / 2);
    nodes_[at.node].child = child;
    nodes_.resize(nodes_.size() + 2);
    todo.push_back({child, at.first, half});
    todo.push_back({child + 1, half, at.end});
  }
}

std::optional<Nearest> NearestSearch::nearest(const RealPoint& from) const {
  if (nodes_.empty()) return std::nullopt;
  Candidates all(c_, from, greatest_);
  std::vector<Index> todo{0};
  while (!todo.empty()) {
    const Node& node = nodes_[todo.back()];
    todo.pop_back();
    if (all.is_out_of_reach(node.box)) continue;
    if (node.child != kNone) {
      const bool first_is_nearer = all.distance(nodes_[node.child].box) < all.distance(nodes_[node.child + 1].box);
      todo.push_back(node.child + (first_is_nearer ? 1 : 0));
      todo.push_back(node.child + (first_is_nearer ? 0 : 1));
      continue;
    }
    for (Index k = node.first; k < node.end; ++k) {
      if (cells_[k].dimension == 0)
        all.add_vertex(cells_[k].index);
      else
        all.add_edge(cells_[k].index);
    }
  }
  std::vector<Nearest> best = all.nearest();
  if (best.empty()) return std::nullopt;
  return std::move(best.front());
}

std::optional<NearestInClosure> nearest_in_closure(const Region& region, const Region& closed, const RealPoint& from) {
  if (has(closed, from)) return NearestInClosure{{Real(), from, {}}, has(region, from)};
  const auto is_in = [](Mark m) { return m > 0; };
  const std::optional<Nearest> least = nearest(closed, is_in, from);
  if (!least) return std::nullopt;
  if (has(region, least->at)) return NearestInClosure{*least, true};
  for (const Nearest& n : all_nearest(region, is_in, from)) {
    if (compare_if_closed(n.distance, least->distance) != 0) break;
    if (const auto at = own_place(region, n, from)) return NearestInClosure{{n.distance, *at, n.cell}, true};
  }
  return NearestInClosure{*least, false};
}

}  // namespace findspace::plane
