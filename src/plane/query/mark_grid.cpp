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
/// How often items are listed, about: as much memory as the edges themselves take, and what a small complex may take in
/// any case. Twice the greatest is a place in the list, which 31 bits hold.
constexpr double kListedPerItem = 64, kListedAnyway = 1 << 20, kMostListed = 1 << 29;

std::int32_t code(Mark mark) { return -2 - mark; }
Mark decoded(std::int32_t start) { return Mark(-2 - start); }

/// Of two lines from one grid point: whether the first rises more.
bool steeper(const BoundaryItem& first, const BoundaryItem& second) {
  if (first.x0 != second.x0 || first.y0 != second.y0 || first.end_error0 + second.end_error0 > 0) return false;
  if (first.kind != BoundaryItem::Kind::kLine || second.kind != BoundaryItem::Kind::kLine) return false;
  return first.b * second.a - first.a * second.b > margin::kRoundings32;
}

}  // namespace

MarkGrid::MarkGrid(const CellComplex& complex) : items_(complex), outside_(complex.faces[0].mark) {
  if (items_.all().empty()) return;
  choose_size();
  shorten_lists();
  fill();
  settle(complex);
}

void MarkGrid::choose_size() {
  const BoundaryItems::Box& b = items_.bounds();
  const double wide = b.x1 - b.x0, high = b.y1 - b.y0;
  const double buckets = std::clamp(kBucketsPerItem * double(items_.all().size()), kFewestBuckets, kMostBuckets);
  const double columns = std::clamp(std::sqrt(buckets * wide / high), 1.0, buckets);
  columns_ = Index(columns);
  rows_ = Index(std::max(1.0, buckets / columns));
}

/// Fewer columns or rows where long edges would be listed in too many buckets.
void MarkGrid::shorten_lists() {
  const BoundaryItems::Box& b = items_.bounds();
  const double wide = b.x1 - b.x0, high = b.y1 - b.y0;
  double across = 0, upwards = 0;  // the widths and heights of all items, as parts of the whole
  for (const BoundaryItem& item : items_.all()) {
    const double width = item.x1 - item.x0, height = std::abs(item.y1 - item.y0);
    across += width / wide;
    // An arc may rise by half its width beyond its ends, and falls again.
    upwards += item.kind == BoundaryItem::Kind::kArc ? std::min(2.0, (width + height) / high) : height / high;
  }
  const double most = std::min(kListedPerItem * double(items_.all().size()) + kListedAnyway, kMostListed);
  while (columns_ * rows_ > 1 && across * columns_ + upwards * rows_ > most) {
    if (columns_ > 1 && (rows_ == 1 || across * columns_ >= upwards * rows_))
      columns_ /= 2;
    else
      rows_ /= 2;
  }
  width_ = wide / columns_;
  height_ = high / rows_;
}

Index MarkGrid::column(double x) const {
  return Index(std::clamp((x - items_.bounds().x0) / width_, 0.0, double(columns_ - 1)));
}
Index MarkGrid::row(double y) const {
  return Index(std::clamp((y - items_.bounds().y0) / height_, 0.0, double(rows_ - 1)));
}

template <class Visit>
void MarkGrid::each_bucket(const BoundaryItem& item, Visit visit) const {
  const double slack = items_.slack(), left = items_.bounds().x0;
  for (Index i = column(item.x0 - slack), last = column(item.x1 + slack); i <= last; ++i) {
    const BoundaryItems::Box s = items_.part(item, left + i * width_ - slack, left + (i + 1) * width_ + slack);
    for (Index j = row(s.y0 - slack), top = row(s.y1 + slack); j <= top; ++j) visit(std::size_t(i) * rows_ + j);
  }
}

void MarkGrid::fill() {
  std::vector<std::uint32_t> count(std::size_t(columns_) * rows_, 0);
  for (const BoundaryItem& item : items_.all()) each_bucket(item, [&](std::size_t k) { ++count[k]; });
  start_.assign(count.size(), code(0));
  std::size_t next = 0;
  for (std::size_t k = 0; k < count.size(); ++k) {
    if (count[k] == 0) continue;
    start_[k] = std::int32_t(next);
    next += std::size_t(count[k]) + 1;
  }
  listed_.assign(next, kNone);
  for (Index n = 0; n < items_.all().size(); ++n)
    each_bucket(items_.all()[n], [&](std::size_t k) { listed_[std::size_t(start_[k]) + --count[k]] = n; });
}

/// Gives empty buckets the marks of their faces, each column from its top down.
void MarkGrid::settle(const CellComplex& c) {
  std::optional<Locator> locator;
  for (Index i = 0; i < columns_; ++i) {
    const double x = items_.bounds().x0 + (i + 0.5) * width_;
    for (Index j = rows_; j-- > 0;) {
      std::int32_t& start = start_[std::size_t(i) * rows_ + j];
      if (start >= 0) continue;
      const double y = items_.bounds().y0 + (j + 0.5) * height_;
      std::optional<Mark> mark = climb(i, j + 1, {x, y, 0});
      if (!mark) {
        if (!locator) locator.emplace(c);
        mark = locator->mark({exact::Real::from_double(x), exact::Real::from_double(y)});
      }
      start = code(*mark);
    }
  }
}

/// The lowest item above the point that is not above `top`, or what the point lies on.
MarkGrid::Look MarkGrid::look(std::size_t bucket, double top, const Query& q) const {
  const Look open{true, std::nullopt};
  const double highest = top + items_.slack();
  BoundaryItems::Heights lowest{highest, highest};
  const BoundaryItem* first = nullptr;  // the lowest
  for (const Index* k = &listed_[std::size_t(start_[bucket])]; *k != kNone; ++k) {
    const BoundaryItem& item = items_.all()[*k];
    const BoundaryItems::Side s = items_.side(item, q);
    if (s == BoundaryItems::Side::kOpen) return open;
    if (s == BoundaryItems::Side::kOn) {
      if (q.x == item.x0 && q.y == item.y0) return {false, item.mark0};
      return {false, q.x == item.x1 && q.y == item.y1 ? item.mark1 : item.mark};
    }
    if (s != BoundaryItems::Side::kBelow) continue;
    const BoundaryItems::Heights y = items_.heights(item, q.x, q.error);
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
  if (lowest.high > highest + 2 * items_.slack()) return open;
  return {false, first->below};
}

/// From a bucket upwards.
std::optional<Mark> MarkGrid::climb(Index column, Index row, const Query& q) const {
  for (Index j = row; j < rows_; ++j) {
    const std::size_t bucket = std::size_t(column) * rows_ + j;
    if (start_[bucket] < 0) return decoded(start_[bucket]);
    const Look found = look(bucket, items_.bounds().y0 + (j + 1) * height_, q);
    if (found.open) return std::nullopt;
    if (found.mark) return found.mark;
  }
  return outside_;
}

std::optional<Mark> MarkGrid::mark(const Query& q) const {
  if (items_.all().empty() || q.x < items_.bounds().x0 - q.error || q.x > items_.bounds().x1 + q.error ||
      q.y < items_.bounds().y0 - q.error || q.y > items_.bounds().y1 + q.error)
    return outside_;
  if (!(q.error < items_.slack())) return std::nullopt;
  return climb(column(q.x), row(q.y), q);
}

}  // namespace findspace::plane
