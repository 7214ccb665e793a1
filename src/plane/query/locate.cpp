// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/locate.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/planar/geometry_signs.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

constexpr Index kMostColumns = 4096;
constexpr std::size_t kEntriesPerEdge = 8;

double widened(double value, double error, int direction) {
  return value + direction * (error + std::abs(value) * margin::kRoundings8);
}

}  // namespace

Locator::Locator(const CellComplex& c) : c_(c) {
  geometry_.supporting_curves = c.geometry.supporting_curves;
  geometry_.points.reserve(c.geometry.points.size() + 1);  // with the point asked for
  geometry_.points = c.geometry.points;
  geometry_.reals = c.geometry.reals;
  boxes_.reserve(c.edges.size());
  for (Index e = 0; e < c.edges.size(); ++e) boxes_.push_back(box(e));
  for (Index v = 0; v < c.vertices.size(); ++v) {
    if (c.vertices[v].out == kNone) boxes_.push_back(box(Index(c.edges.size()) + v));
  }
  build_columns();
}

Locator::Box Locator::box(Index cell) const {
  if (cell >= c_.edges.size()) {
    const exact::Point& p = c_.point(cell - Index(c_.edges.size()));
    return {widened(p.x, p.error, -1), widened(p.x, p.error, 1), widened(p.y, p.error, -1), widened(p.y, p.error, 1),
            cell};
  }
  const Edge& e = c_.edges[cell];
  const exact::Point &p = c_.point(e.v0), &q = c_.point(e.v1);
  double bottom = std::min(widened(p.y, p.error, -1), widened(q.y, q.error, -1));
  double top = std::max(widened(p.y, p.error, 1), widened(q.y, q.error, 1));
  if (e.half != 0) {
    const exact::SupportingCurve& k = c_.supporting_curve(cell);
    const double error = k.y.error + k.z.error;
    if (e.half > 0)
      top = widened(k.y.value + k.z.value, error, 1);
    else
      bottom = widened(k.y.value - k.z.value, error, -1);
  }
  return {widened(p.x, p.error, -1), widened(q.x, q.error, 1), bottom, top, cell};
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
  for (const Box& b : boxes_) {
    left_ = std::min(left_, b.x0);
    right = std::max(right, b.x1);
  }
  for (Index n = std::clamp<Index>(Index(boxes_.size()), 1, kMostColumns);; n /= 2) {
    column_start_.assign(n + 1, 0);
    per_width_ = right > left_ ? n / (right - left_) : 0;
    std::size_t entries = 0;
    for (const Box& b : boxes_) entries += columns(b).last - columns(b).first + 1;
    if (n == 1 || entries <= kEntriesPerEdge * boxes_.size()) break;
  }
  for (const Box& b : boxes_) {
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

bool Locator::is_vertical(Index edge) const { return !c_.is_arc(edge) && c_.supporting_curve(edge).b == 0; }
int Locator::compare_x(Index vertex) const { return exact::compare_x(geometry_, query_, c_.vertices[vertex].point); }
int Locator::compare_xy(Index vertex) const { return exact::compare_xy(geometry_, query_, c_.vertices[vertex].point); }

int Locator::height(Index edge, Index point) const {
  const Edge& e = c_.edges[edge];
  Piece piece{e.supporting_curve, c_.vertices[e.v0].point, c_.vertices[e.v1].point, e.half, false, false};
  return plane::height(geometry_, piece, point);
}

/// Whether the point is on the edge, one of its ends, or the isolated vertex.
bool Locator::is_found(Index cell, Cell& found) const {
  if (cell >= c_.edges.size()) {
    found = {0, cell - Index(c_.edges.size())};
    return compare_xy(found.index) == 0;
  }
  const Edge& e = c_.edges[cell];
  int start = compare_xy(e.v0), end = compare_xy(e.v1);
  if (start == 0 || end == 0) {
    found = {0, start == 0 ? e.v0 : e.v1};
    return true;
  }
  found = {1, cell};
  if (is_vertical(cell)) return start > 0 && end < 0;
  return compare_x(e.v0) >= 0 && compare_x(e.v1) <= 0 && height(cell, query_) == 0;
}

/// Of two edges over the point, which do not cross: whether e is the lower one a little to the right of it.
bool Locator::lies_below(Index e, Index f) const {
  Index ve = c_.edges[e].v0, vf = c_.edges[f].v0;
  if (ve == vf) {
    auto p = c_.vertices[ve].point;
    auto he = c_.heading(2 * e), hf = c_.heading(2 * f);
    int turn = exact::turn(geometry_, p, he, hf);
    if (turn != 0) return turn > 0;
    if (along(geometry_, p, he, hf) < 0)
      return c_.edges[e].half < 0;  // straight down and straight up: halves of circles
    return compare_curvature(geometry_, he, hf) < 0;
  }
  if (exact::compare_x(geometry_, c_.vertices[ve].point, c_.vertices[vf].point) >= 0)
    return height(f, c_.vertices[ve].point) < 0;
  return height(e, c_.vertices[vf].point) > 0;
}

bool Locator::is_under(Index edge) const {
  if (is_vertical(edge)) return false;
  return compare_x(c_.edges[edge].v0) >= 0 && compare_x(c_.edges[edge].v1) < 0 && height(edge, query_) < 0;
}

Cell Locator::search() const {
  const exact::Point& q = geometry_.points[query_];
  const double x0 = widened(q.x, q.error, -1), x1 = widened(q.x, q.error, 1);
  const double y0 = widened(q.y, q.error, -1), y1 = widened(q.y, q.error, 1);
  Index above = kNone;
  const Box* lowest = nullptr;  // of the edge above
  for (Index i = column_start_[column(x0)]; i < column_start_[column(x1) + 1]; ++i) {
    const Box& b = boxes_[entries_[i]];
    if (b.x1 < x0 || b.x0 > x1 || b.y1 < y0) continue;
    Cell found;
    if (b.y0 <= y1 && is_found(b.cell, found)) return found;
    if (b.cell >= c_.edges.size() || b.cell == above || (lowest && b.y0 > lowest->y1) || !is_under(b.cell)) continue;
    if (!lowest || b.y1 < lowest->y0 || lies_below(b.cell, above)) {
      above = b.cell;
      lowest = &b;
    }
  }
  return {2, above == kNone ? 0 : c_.face(2 * above + 1)};
}

Cell Locator::locate(const exact::RealPoint& p) {
  geometry_.points.resize(c_.geometry.points.size());
  geometry_.reals.resize(c_.geometry.reals.size());
  query_ = geometry_.add_real_point(p.x, p.y);
  return search();
}

Cell locate(const CellComplex& c, const exact::RealPoint& p) { return Locator(c).locate(p); }

}  // namespace findspace::plane
