// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/mark_grid.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "plane/query/locate.h"

namespace findspace::plane {
namespace {

constexpr double kBucketsPerItem = 3, kFewestBuckets = 1024, kMostBuckets = 1 << 22;

std::int32_t code(Mark mark) { return -2 - mark; }
Mark decoded(std::int32_t start) { return Mark(-2 - start); }

bool is_grid_point(const MarkGrid::Query& q) {
  constexpr double kMost = 0x1p52;  // no sign: whole numbers below are exact
  return q.error == 0 && std::abs(q.x) < kMost && std::abs(q.y) < kMost && q.x == std::floor(q.x) &&
         q.y == std::floor(q.y);
}

}  // namespace

MarkGrid::MarkGrid(const CellComplex& complex) : outside_(complex.faces[0].mark) {
  items_.reserve(complex.edges.size());
  for (Index e = 0; e < complex.edges.size(); ++e) add_edge(complex, e);
  for (Index v = 0; v < complex.vertices.size(); ++v) {
    if (complex.vertices[v].out == kNone) add_vertex(complex, v);
  }
  if (items_.empty()) return;
  fit();
  fill();
  settle(complex);
}

void MarkGrid::add_edge(const CellComplex& c, Index edge) {
  const Edge& e = c.edges[edge];
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  Item item{.x0 = p.x, .x1 = q.x, .end_error0 = p.error, .end_error1 = q.error, .y0 = p.y, .y1 = q.y};
  item.mark = e.mark;
  item.above = c.faces[c.face(2 * edge)].mark;
  item.below = c.faces[c.face(2 * edge + 1)].mark;
  item.mark0 = c.vertices[e.v0].mark;
  item.mark1 = c.vertices[e.v1].mark;
  item.upper = e.half > 0;
  item.kind = k.circle ? Item::Kind::kArc : k.b == 0 ? Item::Kind::kVertical : Item::Kind::kLine;
  const double sign = !k.circle && k.b < 0 ? -1 : 1;
  item.a = sign * k.x.value;
  item.b = sign * k.y.value;
  item.c = sign * k.z.value;
  item.c_error = k.z.error;
  item.error = k.circle ? std::max(k.x.error, k.y.error) : k.x.error + k.y.error;
  if (item.kind == Item::Kind::kLine) {
    item.steep = std::abs(item.a / item.b);
    if (k.grid) {
      item.line = Index(lines_.size());
      lines_.push_back({k.a, k.b, k.c});
    }
  }
  items_.push_back(item);
}

void MarkGrid::add_vertex(const CellComplex& c, Index vertex) {
  const exact::Point& p = c.point(vertex);
  Item item{.x0 = p.x, .x1 = p.x, .end_error0 = p.error, .end_error1 = p.error, .y0 = p.y, .y1 = p.y};
  item.kind = Item::Kind::kVertical;  // a segment without length
  item.mark = item.mark0 = item.mark1 = c.vertices[vertex].mark;
  items_.push_back(item);
}

MarkGrid::Box MarkGrid::box(const Item& item) {
  Box b{item.x0, item.x1, std::min(item.y0, item.y1), std::max(item.y0, item.y1)};
  if (item.kind != Item::Kind::kArc) return b;
  if (item.upper)
    b.y1 = item.b + item.c;
  else
    b.y0 = item.b - item.c;
  return b;
}

void MarkGrid::fit() {
  left_ = bottom_ = exact::kInfinity;
  right_ = top_ = -exact::kInfinity;
  double errors = 0;
  for (const Item& item : items_) {
    const Box b = box(item);
    left_ = std::min(left_, b.x0);
    right_ = std::max(right_, b.x1);
    bottom_ = std::min(bottom_, b.y0);
    top_ = std::max(top_, b.y1);
    errors = std::max({errors, item.end_error0, item.end_error1});
    if (item.kind == Item::Kind::kArc) errors = std::max(errors, item.error + item.c_error);
  }
  largest_ = std::max({std::abs(left_), std::abs(right_), std::abs(bottom_), std::abs(top_), 1.0});
  slack_ = 2 * errors + largest_ * margin::kWiderBox;
  left_ -= slack_;
  bottom_ -= slack_;
  right_ += slack_;
  top_ += slack_;
  for (Item& item : items_) set_error(item);
  const double wide = right_ - left_, high = top_ - bottom_;
  const double buckets = std::clamp(kBucketsPerItem * double(items_.size()), kFewestBuckets, kMostBuckets);
  const double columns = std::clamp(std::sqrt(buckets * wide / high), 1.0, buckets);
  columns_ = Index(columns);
  rows_ = Index(std::max(1.0, buckets / columns));
  width_ = wide / columns_;
  height_ = high / rows_;
}

/// For points in the box of all items.
void MarkGrid::set_error(Item& item) const {
  if (item.kind == Item::Kind::kArc)
    item.error += (largest_ + std::abs(item.a) + std::abs(item.b)) * margin::kRoundings4;
  else
    item.error = item.error * largest_ + item.c_error + (2 * largest_ + std::abs(item.c)) * margin::kRoundings4;
}

Index MarkGrid::column(double x) const { return Index(std::clamp((x - left_) / width_, 0.0, double(columns_ - 1))); }
Index MarkGrid::row(double y) const { return Index(std::clamp((y - bottom_) / height_, 0.0, double(rows_ - 1))); }

/// The heights of an item, not vertical, where x is off by at most `error`.
MarkGrid::Range MarkGrid::height(const Item& item, double x, double error) const {
  if (item.kind == Item::Kind::kLine) {
    const double off = item.steep * (error + largest_ * margin::kRoundings4) + slack_;
    const double y = item.y0 + (x - item.x0) * ((item.y1 - item.y0) / (item.x1 - item.x0));
    return {y - off, y + off};
  }
  const double dx = x - item.a, off = item.error + error, square = item.c * item.c - dx * dx;
  const double loose =
      2 * (std::abs(dx) + off) * off + 2 * item.c * item.c_error + (item.c * item.c + dx * dx) * margin::kRoundings4;
  const double least = std::sqrt(std::max(0.0, square - loose)), most = std::sqrt(std::max(0.0, square + loose));
  return item.upper ? Range{item.b + least - slack_, item.b + most + slack_}
                    : Range{item.b - most - slack_, item.b - least + slack_};
}

/// Encloses the part of an item that lies over a column.
MarkGrid::Box MarkGrid::strip(const Item& item, Index column) const {
  const Box b = box(item);
  if (item.kind == Item::Kind::kVertical) return b;
  const double x0 = std::clamp(left_ + column * width_ - slack_, b.x0, b.x1);
  const double x1 = std::clamp(left_ + (column + 1) * width_ + slack_, b.x0, b.x1);
  const Range p = height(item, x0, 0), q = height(item, x1, 0);
  Box out{x0, x1, std::min(p.low, q.low), std::max(p.high, q.high)};
  if (item.kind == Item::Kind::kArc && x0 <= item.a + slack_ && item.a - slack_ <= x1) {
    if (item.upper)
      out.y1 = b.y1;
    else
      out.y0 = b.y0;
  }
  return out;
}

template <class Visit>
void MarkGrid::each_bucket(const Item& item, Visit visit) const {
  for (Index i = column(item.x0 - slack_), last = column(item.x1 + slack_); i <= last; ++i) {
    const Box s = strip(item, i);
    for (Index j = row(s.y0 - slack_), top = row(s.y1 + slack_); j <= top; ++j) visit(std::size_t(i) * rows_ + j);
  }
}

void MarkGrid::fill() {
  std::vector<std::uint32_t> count(std::size_t(columns_) * rows_, 0);
  for (const Item& item : items_) each_bucket(item, [&](std::size_t k) { ++count[k]; });
  start_.assign(count.size(), code(0));
  std::int32_t next = 0;
  for (std::size_t k = 0; k < count.size(); ++k) {
    if (count[k] == 0) continue;
    start_[k] = next;
    next += std::int32_t(count[k]) + 1;
  }
  listed_.assign(std::size_t(next), kNone);
  for (Index n = 0; n < items_.size(); ++n)
    each_bucket(items_[n], [&](std::size_t k) { listed_[std::size_t(start_[k]) + --count[k]] = n; });
}

/// Gives empty buckets the marks of their faces, each column from its top down.
void MarkGrid::settle(const CellComplex& c) {
  std::optional<Locator> locator;
  for (Index i = 0; i < columns_; ++i) {
    const double x = left_ + (i + 0.5) * width_;
    for (Index j = rows_; j-- > 0;) {
      std::int32_t& start = start_[std::size_t(i) * rows_ + j];
      if (start >= 0) continue;
      const double y = bottom_ + (j + 0.5) * height_;
      std::optional<Mark> mark = climb(i, j + 1, {x, y, 0});
      if (!mark) {
        if (!locator) locator.emplace(c);
        mark = locator->mark({exact::Real::from_double(x), exact::Real::from_double(y)});
      }
      start = code(*mark);
    }
  }
}

/// Where the point lies from an item; of an end that is exact the ray runs to its right.
MarkGrid::Side MarkGrid::side(const Item& item, const Query& q) const {
  if (item.kind == Item::Kind::kVertical) return vertical_side(item, q);
  const double e0 = q.error + item.end_error0, e1 = q.error + item.end_error1;
  if (q.x < item.x0 - e0 || q.x > item.x1 + e1) return Side::kBeside;
  if ((e0 > 0 && q.x <= item.x0 + e0) || (e1 > 0 && q.x >= item.x1 - e1)) return Side::kOpen;
  const Side s = item.kind == Item::Kind::kLine ? line_side(item, q) : arc_side(item, q);
  return q.x == item.x1 && (s == Side::kBelow || s == Side::kAbove) ? Side::kBeside : s;
}

MarkGrid::Side MarkGrid::line_side(const Item& item, const Query& q) const {
  const double v = item.a * q.x + item.b * q.y - item.c, error = item.error + 2 * q.error;
  if (v > error) return Side::kAbove;
  if (v < -error) return Side::kBelow;
  if (item.line == kNone || !is_grid_point(q)) return Side::kOpen;
  const GridLine& l = lines_[item.line];
  const exact::int128 s = exact::int128(l.a) * std::int64_t(q.x) + exact::int128(l.b) * std::int64_t(q.y) - l.c;
  if (s == 0) return Side::kOn;
  return (s > 0) == (l.b > 0) ? Side::kAbove : Side::kBelow;
}

MarkGrid::Side MarkGrid::arc_side(const Item& item, const Query& q) {
  const double dx = q.x - item.a, dy = q.y - item.b, off = item.error + q.error;
  const double up = item.upper ? dy : -dy;  // towards the arc
  const Side inner = item.upper ? Side::kBelow : Side::kAbove, outer = item.upper ? Side::kAbove : Side::kBelow;
  if (up < -off) return inner;
  const double squares = dx * dx + dy * dy, v = squares - item.c * item.c;
  const double error = 2 * ((std::abs(dx) + std::abs(dy) + off) * off + item.c * item.c_error) +
                       (squares + item.c * item.c) * margin::kRoundings4;
  if (v < -error) return inner;
  return v > error && up > off ? outer : Side::kOpen;
}

MarkGrid::Side MarkGrid::vertical_side(const Item& item, const Query& q) {
  const double e = q.error + std::max(item.end_error0, item.end_error1);
  if (std::abs(q.x - item.x0) > e || q.y < item.y0 - e || q.y > item.y1 + e) return Side::kBeside;
  return e == 0 ? Side::kOn : Side::kOpen;
}

/// Of two lines from one grid point: whether the first rises more.
bool MarkGrid::steeper(const Item& first, const Item& second) {
  if (first.x0 != second.x0 || first.y0 != second.y0 || first.end_error0 + second.end_error0 > 0) return false;
  if (first.kind != Item::Kind::kLine || second.kind != Item::Kind::kLine) return false;
  return first.b * second.a - first.a * second.b > margin::kRoundings32;
}

/// The lowest item above the point that is not above `top`, or what the point lies on.
MarkGrid::Look MarkGrid::look(std::size_t bucket, double top, const Query& q) const {
  const Look open{true, std::nullopt};
  const double highest = top + slack_;
  Range lowest{highest, highest};
  const Item* first = nullptr;  // the lowest
  for (const Index* k = &listed_[std::size_t(start_[bucket])]; *k != kNone; ++k) {
    const Item& item = items_[*k];
    const Side s = side(item, q);
    if (s == Side::kOpen) return open;
    if (s == Side::kOn) {
      if (q.x == item.x0 && q.y == item.y0) return {false, item.mark0};
      return {false, q.x == item.x1 && q.y == item.y1 ? item.mark1 : item.mark};
    }
    if (s != Side::kBelow) continue;
    const Range y = height(item, q.x, q.error);
    if (y.low > lowest.high) continue;
    if (!first || y.high < lowest.low || steeper(*first, item)) {
      lowest = y;
      first = &item;
    } else if (!steeper(item, *first)) {
      // Those that doubles do not put in order have to agree.
      if (first->below != item.below) return open;
      lowest = {std::min(lowest.low, y.low), std::min(lowest.high, y.high)};
    }
  }
  if (!first) return {};
  if (lowest.high > highest + 2 * slack_) return open;
  return {false, first->below};
}

/// From a bucket upwards.
std::optional<Mark> MarkGrid::climb(Index column, Index row, const Query& q) const {
  for (Index j = row; j < rows_; ++j) {
    const std::size_t bucket = std::size_t(column) * rows_ + j;
    if (start_[bucket] < 0) return decoded(start_[bucket]);
    const Look found = look(bucket, bottom_ + (j + 1) * height_, q);
    if (found.open) return std::nullopt;
    if (found.mark) return found.mark;
  }
  return outside_;
}

std::optional<Mark> MarkGrid::mark(const Query& q) const {
  if (items_.empty() || q.x < left_ - q.error || q.x > right_ + q.error || q.y < bottom_ - q.error ||
      q.y > top_ + q.error)
    return outside_;
  if (!(q.error < slack_)) return std::nullopt;
  return climb(column(q.x), row(q.y), q);
}

}  // namespace findspace::plane
