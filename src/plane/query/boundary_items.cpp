// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/boundary_items.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"

namespace findspace::plane {
namespace {

bool is_grid_point(const BlurredPoint& q) {
  constexpr double kMost = 0x1p52;  // no sign: whole numbers below are exact
  return q.error == 0 && std::abs(q.x) < kMost && std::abs(q.y) < kMost && q.x == std::floor(q.x) &&
         q.y == std::floor(q.y);
}

BoundaryItems::Box box_of_item(const BoundaryItem& item) {
  BoundaryItems::Box b{item.x0, item.x1, std::min(item.y0, item.y1), std::max(item.y0, item.y1)};
  if (item.kind != BoundaryItem::Kind::kArc) return b;
  if (item.upper)
    b.y1 = item.b + item.c;
  else
    b.y0 = item.b - item.c;
  return b;
}

BoundaryItems::Side arc_side(const BoundaryItem& item, const BlurredPoint& q) {
  const double dx = q.x - item.a, dy = q.y - item.b, off = item.error + q.error;
  const double up = item.upper ? dy : -dy;  // towards the arc
  const BoundaryItems::Side inner = item.upper ? BoundaryItems::Side::kBelow : BoundaryItems::Side::kAbove,
                            outer = item.upper ? BoundaryItems::Side::kAbove : BoundaryItems::Side::kBelow;
  if (up < -off) return inner;
  const double squares = dx * dx + dy * dy, v = squares - item.c * item.c;
  const double error = 2 * ((std::abs(dx) + std::abs(dy) + off) * off + item.c * item.c_error) +
                       (squares + item.c * item.c) * margin::kRoundings4;
  if (v < -error) return inner;
  return v > error && up > off ? outer : BoundaryItems::Side::kOpen;
}

BoundaryItems::Side vertical_side(const BoundaryItem& item, const BlurredPoint& q) {
  const double e = q.error + std::max(item.end_error0, item.end_error1);
  if (std::abs(q.x - item.x0) > e || q.y < item.y0 - e || q.y > item.y1 + e) return BoundaryItems::Side::kBeside;
  return e == 0 ? BoundaryItems::Side::kOn : BoundaryItems::Side::kOpen;
}

}  // namespace

BoundaryItems::BoundaryItems(const CellComplex& complex) {
  items_.reserve(complex.edges.size());
  for (Index e = 0; e < complex.edges.size(); ++e) add_edge(complex, e);
  for (Index v = 0; v < complex.vertices.size(); ++v) {
    if (complex.vertices[v].out == kNone) add_vertex(complex, v);
  }
  if (items_.empty()) return;
  enclose();
  for (BoundaryItem& item : items_) set_error(item);
}

void BoundaryItems::add_edge(const CellComplex& c, Index edge) {
  const Edge& e = c.edges[edge];
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  BoundaryItem item{.x0 = p.x, .x1 = q.x, .end_error0 = p.error, .end_error1 = q.error, .y0 = p.y, .y1 = q.y};
  item.mark = e.mark;
  item.above = c.faces[c.face(2 * edge)].mark;
  item.below = c.faces[c.face(2 * edge + 1)].mark;
  item.mark0 = c.vertices[e.v0].mark;
  item.mark1 = c.vertices[e.v1].mark;
  item.upper = e.half > 0;
  item.kind = k.circle   ? BoundaryItem::Kind::kArc
              : k.b == 0 ? BoundaryItem::Kind::kVertical
                         : BoundaryItem::Kind::kLine;
  const double sign = !k.circle && k.b < 0 ? -1 : 1;
  item.a = sign * k.x().value;
  item.b = sign * k.y().value;
  item.c = sign * k.z().value;
  item.c_error = k.z().error;
  item.error = k.circle ? std::max(k.x().error, k.y().error) : k.x().error + k.y().error;
  if (item.kind == BoundaryItem::Kind::kLine) {
    item.steep = std::abs(item.a / item.b);
    if (k.grid) {
      item.line = Index(lines_.size());
      lines_.push_back({k.a, k.b, k.c});
    }
  }
  items_.push_back(item);
}

void BoundaryItems::add_vertex(const CellComplex& c, Index vertex) {
  const exact::Point& p = c.point(vertex);
  BoundaryItem item{.x0 = p.x, .x1 = p.x, .end_error0 = p.error, .end_error1 = p.error, .y0 = p.y, .y1 = p.y};
  item.kind = BoundaryItem::Kind::kVertical;  // a segment without length
  item.mark = item.mark0 = item.mark1 = c.vertices[vertex].mark;
  items_.push_back(item);
}

void BoundaryItems::enclose() {
  Box all{exact::kInfinity, -exact::kInfinity, exact::kInfinity, -exact::kInfinity};
  double errors = 0;
  for (const BoundaryItem& item : items_) {
    const Box b = box_of_item(item);
    all = {std::min(all.x0, b.x0), std::max(all.x1, b.x1), std::min(all.y0, b.y0), std::max(all.y1, b.y1)};
    errors = std::max({errors, item.end_error0, item.end_error1});
    if (item.kind == BoundaryItem::Kind::kArc) errors = std::max(errors, item.error + item.c_error);
  }
  largest_ = std::max({std::abs(all.x0), std::abs(all.x1), std::abs(all.y0), std::abs(all.y1), 1.0});
  slack_ = 2 * errors + largest_ * margin::kWiderBox;
  bounds_ = {all.x0 - slack_, all.x1 + slack_, all.y0 - slack_, all.y1 + slack_};
}

/// For points in the box of all items.
void BoundaryItems::set_error(BoundaryItem& item) const {
  if (item.kind == BoundaryItem::Kind::kArc)
    item.error += (largest_ + std::abs(item.a) + std::abs(item.b)) * margin::kRoundings4;
  else
    item.error = item.error * largest_ + item.c_error + (2 * largest_ + std::abs(item.c)) * margin::kRoundings4;
}

BoundaryItems::Heights BoundaryItems::heights(const BoundaryItem& item, double x, double error) const {
  if (item.kind == BoundaryItem::Kind::kLine) {
    const double off = item.steep * (error + largest_ * margin::kRoundings4) + slack_;
    const double y = item.y0 + (x - item.x0) * ((item.y1 - item.y0) / (item.x1 - item.x0));
    return {y - off, y + off};
  }
  const double dx = x - item.a, off = item.error + error, square = item.c * item.c - dx * dx;
  const double loose =
      2 * (std::abs(dx) + off) * off + 2 * item.c * item.c_error + (item.c * item.c + dx * dx) * margin::kRoundings4;
  const double least = std::sqrt(std::max(0.0, square - loose)), most = std::sqrt(std::max(0.0, square + loose));
  return item.upper ? Heights{item.b + least - slack_, item.b + most + slack_}
                    : Heights{item.b - most - slack_, item.b - least + slack_};
}

BoundaryItems::Box BoundaryItems::part(const BoundaryItem& item, double from, double to) const {
  const Box b = box_of_item(item);
  if (item.kind == BoundaryItem::Kind::kVertical) return b;
  const double x0 = std::clamp(from, b.x0, b.x1), x1 = std::clamp(to, b.x0, b.x1);
  const Heights p = heights(item, x0, 0), q = heights(item, x1, 0);
  Box out{x0, x1, std::min(p.low, q.low), std::max(p.high, q.high)};
  if (item.kind == BoundaryItem::Kind::kArc && x0 <= item.a + slack_ && item.a - slack_ <= x1) {
    if (item.upper)
      out.y1 = b.y1;
    else
      out.y0 = b.y0;
  }
  return out;
}

BoundaryItems::Side BoundaryItems::side(const BoundaryItem& item, const BlurredPoint& q) const {
  if (item.kind == BoundaryItem::Kind::kVertical) return vertical_side(item, q);
  const double e0 = q.error + item.end_error0, e1 = q.error + item.end_error1;
  if (q.x < item.x0 - e0 || q.x > item.x1 + e1) return Side::kBeside;
  if ((e0 > 0 && q.x <= item.x0 + e0) || (e1 > 0 && q.x >= item.x1 - e1)) return Side::kOpen;
  const Side s = item.kind == BoundaryItem::Kind::kLine ? line_side(item, q) : arc_side(item, q);
  return q.x == item.x1 && (s == Side::kBelow || s == Side::kAbove) ? Side::kBeside : s;
}

BoundaryItems::Side BoundaryItems::line_side(const BoundaryItem& item, const BlurredPoint& q) const {
  const double v = item.a * q.x + item.b * q.y - item.c, error = item.error + 2 * q.error;
  if (v > error) return Side::kAbove;
  if (v < -error) return Side::kBelow;
  if (item.line == kNone || !is_grid_point(q)) return Side::kOpen;
  const GridLine& l = lines_[item.line];
  const exact::int128 s = exact::int128(l.a) * std::int64_t(q.x) + exact::int128(l.b) * std::int64_t(q.y) - l.c;
  if (s == 0) return Side::kOn;
  return (s > 0) == (l.b > 0) ? Side::kAbove : Side::kBelow;
}

}  // namespace findspace::plane
