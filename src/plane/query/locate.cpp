// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/locate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/margins/rounding.h"
#include "exact/planar/excerpt.h"
#include "exact/planar/geometry_signs.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kMostColumns = 4096;
constexpr std::size_t kEntriesPerEdge = 8;

double widened(double value, double error, int direction) {
  return value + direction * (error + std::abs(value) * margin::kRoundings8);
}

CellBox box_of(const CellComplex& c, Index cell) {
  if (cell >= c.edges.size()) {
    const exact::Point& p = c.point(cell - Index(c.edges.size()));
    return {widened(p.x, p.error, -1), widened(p.x, p.error, 1), widened(p.y, p.error, -1), widened(p.y, p.error, 1),
            cell};
  }
  const Edge& e = c.edges[cell];
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  double bottom = std::min(widened(p.y, p.error, -1), widened(q.y, q.error, -1));
  double top = std::max(widened(p.y, p.error, 1), widened(q.y, q.error, 1));
  if (e.half != 0) {
    const exact::SupportingCurve& k = c.supporting_curve(cell);
    const double error = k.y().error + k.z().error;
    if (e.half > 0)
      top = widened(k.y().value + k.z().value, error, 1);
    else
      bottom = widened(k.y().value - k.z().value, error, -1);
  }
  return {widened(p.x, p.error, -1), widened(q.x, q.error, 1), bottom, top, cell};
}

/// Calls f with the box of every edge and isolated vertex, until it says true.
template <class F>
void each_box(const CellComplex& c, F&& f) {
  for (Index e = 0; e < c.edges.size(); ++e)
    if (f(box_of(c, e))) return;
  for (Index v = 0; v < c.vertices.size(); ++v)
    if (c.vertices[v].out == kNone && f(box_of(c, Index(c.edges.size()) + v))) return;
}

/// The search for one point: looks at the cells it is shown, in any order.
class PointSearch {
 public:
  /// Keeps references to both.
  PointSearch(const CellComplex& c, const exact::RealPoint& p) : c_(c), p_(p), near_(c.geometry) {
    query_ = near_.add_real_point(p);
    const exact::Point& q = near_.geometry().points[query_];
    x0 = widened(q.x, q.error, -1);
    x1 = widened(q.x, q.error, 1);
    y0_ = widened(q.y, q.error, -1);
    y1_ = widened(q.y, q.error, 1);
  }

  /// Whether the point lies on the cell: then nothing else need be looked at.
  bool look(const CellBox& b) {
    if (b.x1 < x0 || b.x0 > x1 || b.y1 < y0_) return false;
    if (near_.size() > kManyCopies) {
      near_.clear();
      query_ = near_.add_real_point(p_);
    }
    if (b.y0 <= y1_ && is_on(b.cell)) return true;
    const bool other = b.cell < c_.edges.size() && b.cell != above_ && (above_ == kNone || b.y0 <= lowest_.y1);
    if (other && is_under(b.cell) && (above_ == kNone || b.y1 < lowest_.y0 || lies_below(b.cell, above_))) {
      above_ = b.cell;
      lowest_ = b;
    }
    return false;
  }

  Cell found() const { return on_.value_or(Cell{2, above_ == kNone ? 0 : c_.face(2 * above_ + 1)}); }

  double x0, x1;  // enclose the point

 private:
  const exact::Point& query() const { return near_.geometry().points[query_]; }
  Index point(Index vertex) { return near_.point(c_.vertices[vertex].point); }
  exact::Heading heading(Index edge) {
    const exact::Heading h = c_.heading(2 * edge);
    return {near_.curve(h.supporting_curve), h.forward};
  }
  bool is_vertical(Index edge) const { return !c_.is_arc(edge) && c_.supporting_curve(edge).b == 0; }

  int compare_x(Index vertex) {
    const exact::Point& v = c_.point(vertex);
    const int sign = exact::detail::filtered(query().x, v.x, query().error + v.error);
    return sign != 0 ? sign : exact::compare_x(near_.geometry(), query_, point(vertex));
  }
  int compare_xy(Index vertex) {
    const exact::Point& v = c_.point(vertex);
    const int sign = exact::detail::filtered(query().x, v.x, query().error + v.error);
    return sign != 0 ? sign : exact::compare_xy(near_.geometry(), query_, point(vertex));
  }
  /// Of a point of the excerpt over the edge.
  int height(Index edge, Index point) {
    const Edge& e = c_.edges[edge];
    const Piece piece{.supporting_curve = near_.curve(e.supporting_curve), .half = e.half};
    return plane::height(near_.geometry(), piece, point);
  }

  /// Whether the point is on the edge, one of its ends, or the isolated vertex.
  bool is_on(Index cell) {
    on_ = cell_at(cell);
    return on_.has_value();
  }

  std::optional<Cell> cell_at(Index cell) {
    if (cell >= c_.edges.size()) {
      const Index vertex = cell - Index(c_.edges.size());
      return compare_xy(vertex) == 0 ? std::optional(Cell{0, vertex}) : std::nullopt;
    }
    const Edge& e = c_.edges[cell];
    const int start = compare_xy(e.v0), end = compare_xy(e.v1);
    if (start == 0 || end == 0) return Cell{0, start == 0 ? e.v0 : e.v1};
    const bool on = is_vertical(cell) ? start > 0 && end < 0
                                      : compare_x(e.v0) >= 0 && compare_x(e.v1) <= 0 && height(cell, query_) == 0;
    return on ? std::optional(Cell{1, cell}) : std::nullopt;
  }

  /// Of two edges over the point, which do not cross: whether e is the lower one a little to the right of it.
  bool lies_below(Index e, Index f) {
    const Index p = point(c_.edges[e].v0), q = point(c_.edges[f].v0);
    if (p == q) {
      const exact::Heading he = heading(e), hf = heading(f);
      const exact::Geometry& g = near_.geometry();
      const int turn = exact::turn(g, p, he, hf);
      if (turn != 0) return turn > 0;
      if (along(g, p, he, hf) < 0) return c_.edges[e].half < 0;  // straight down and straight up: halves of circles
      return compare_curvature(g, he, hf) < 0;
    }
    if (exact::compare_x(near_.geometry(), p, q) >= 0) return height(f, p) < 0;
    return height(e, q) > 0;
  }

  bool is_under(Index edge) {
    if (is_vertical(edge)) return false;
    return compare_x(c_.edges[edge].v0) >= 0 && compare_x(c_.edges[edge].v1) < 0 && height(edge, query_) < 0;
  }

  static constexpr std::size_t kManyCopies = 64;  // among which one is not looked for any more

  const CellComplex& c_;
  const exact::RealPoint& p_;
  exact::Excerpt near_;  // what has to be compared exactly, and the point
  Index query_ = 0;
  double y0_ = 0, y1_ = 0;
  Index above_ = kNone;  // the lowest edge above the point, and its box
  CellBox lowest_{};
  std::optional<Cell> on_;
};

}  // namespace

Locator::Locator(const CellComplex& c) : c_(c) {
  boxes_.reserve(c.edges.size());
  each_box(c, [&](const CellBox& b) {
    boxes_.push_back(b);
    return false;
  });
  build_columns();
}

Index Locator::column(double x) const {
  double k = (x - left_) * per_width_, last = double(column_start_.size()) - 2;
  return Index(std::clamp(k, 0.0, last));
}

void Locator::build_columns() {
  column_start_.assign(2, 0);
  if (boxes_.empty()) return;
  double right = boxes_[0].x1;
  left_ = boxes_[0].x0;
  for (const CellBox& b : boxes_) {
    left_ = std::min(left_, b.x0);
    right = std::max(right, b.x1);
  }
  for (Index n = std::clamp<Index>(Index(boxes_.size()), 1, kMostColumns);; n /= 2) {
    column_start_.assign(n + 1, 0);
    per_width_ = right > left_ ? n / (right - left_) : 0;
    std::size_t entries = 0;
    for (const CellBox& b : boxes_) entries += columns(b).last - columns(b).first + 1;
    if (n == 1 || entries <= kEntriesPerEdge * boxes_.size()) break;
  }
  for (const CellBox& b : boxes_) {
    for (Index k = columns(b).first; k <= columns(b).last; ++k) ++column_start_[k + 1];
  }
  for (std::size_t k = 1; k < column_start_.size(); ++k) column_start_[k] += column_start_[k - 1];
  entries_.resize(column_start_.back());
  std::vector<Index> next(column_start_.begin(), column_start_.end() - 1);
  for (Index i = 0; i < boxes_.size(); ++i) {
    const Span within = columns(boxes_[i]);
    for (Index k = within.first; k <= within.last; ++k) entries_[next[k]++] = i;
  }
}

Cell Locator::locate(const exact::RealPoint& p) const {
  PointSearch search(c_, p);
  for (Index i = column_start_[column(search.x0)]; i < column_start_[column(search.x1) + 1]; ++i)
    if (search.look(boxes_[entries_[i]])) break;
  return search.found();
}

Cell locate(const CellComplex& c, const exact::RealPoint& p) {
  PointSearch search(c, p);
  each_box(c, [&](const CellBox& b) { return search.look(b); });
  return search.found();
}

}  // namespace findspace::plane
