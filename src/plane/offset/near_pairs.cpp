// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/near_pairs.h"

#include <algorithm>
#include <cmath>

#include "plane/complex/sequence_boxes.h"

namespace findspace::plane {
namespace {

/// Pieces from `first` on, up to that before `end`, that go on in one quadrant of directions; or a single one.
struct Stretch {
  Index first, end;
  Index size() const { return end - first; }
};

/// Pieces in a stretch, in the mean, from where on stretches pay: a tree over the pieces needs no sorting of pairs.
constexpr std::size_t kLong = 4;

double slack_of(std::span<const exact::Point> points) {
  double error = 0, largest_x = 0, largest_y = 0;
  for (const exact::Point& p : points) {
    error = std::max<double>(error, p.error);
    largest_x = std::max(largest_x, std::abs(p.x));
    largest_y = std::max(largest_y, std::abs(p.y));
  }
  return box_slack(error, std::max(largest_x, largest_y));
}

/// Whether the highest bit of k is lower than that of n.
bool has_less_bits(Index k, Index n) { return k < n && k < (k ^ n); }

/// In a binary tree over the numbers: first the pairs below the lowest nodes, then by the ways down from these.
bool comes_first(const PiecePair& p, const PiecePair& q) {
  const Index above_p = p.i ^ p.j, above_q = q.i ^ q.j;
  if (has_less_bits(above_p, above_q)) return true;
  if (has_less_bits(above_q, above_p)) return false;
  return has_less_bits(p.i ^ q.i, p.j ^ q.j) ? p.j < q.j : p.i < q.i;
}

class Search {
 public:
  explicit Search(const OffsetCurves& c) : c_(c), slack_(slack_of(c.geometry.points)) {}

  std::vector<PiecePair> run() {
    find_stretches(true);
    const bool are_long = stretches_.size() * kLong <= c_.pieces.size();
    if (!are_long) find_stretches(false);
    std::vector<PieceBox> boxes;
    boxes.reserve(SequenceBoxes::size_with_joined(stretches_.size()));
    for (const Stretch& s : stretches_) boxes.push_back(box(s));
    SequenceBoxes(std::move(boxes), std::move(rows_)).meeting_pairs([&](Index k, Index l) {
      const Stretch &s = stretches_[k], &t = stretches_[l];
      if (s.size() == 1 && t.size() == 1)
        add(s.first, t.first);
      else
        between(s, box(s), t, box(t));
    });
    if (are_long) std::sort(pairs_.begin(), pairs_.end(), comes_first);
    return std::move(pairs_);
  }

 private:
  /// `join`: else each piece is one.
  void find_stretches(bool join) {
    stretches_.clear();
    rows_.clear();
    for (Index i = 0; i < c_.pieces.size(); ++i) {
      const OffsetOrigin& t = c_.origins[i];
      const bool advances = i > 0 && c_.origins[i - 1].next == i && c_.origins[i - 1].right == t.right;
      if (join && advances && t.rises != 0 && c_.origins[i - 1].rises == t.rises) {
        ++stretches_.back().end;
        continue;
      }
      rows_.push_back(advances ? rows_.back() : i);
      stretches_.push_back({i, i + 1});
    }
  }

  PieceBox box(const Stretch& s) const {
    const exact::Geometry& g = c_.geometry;
    if (c_.origins[s.first].rises == 0) return box_of(g, c_.pieces[s.first], slack_);
    const exact::Point &p = g.points[c_.start(s.first)], &q = g.points[c_.end(s.end - 1)];
    return {std::min(p.x, q.x) - slack_, std::min(p.y, q.y) - slack_, std::max(p.x, q.x) + slack_,
            std::max(p.y, q.y) + slack_};
  }

  /// Of two stretches whose boxes meet; not both are single pieces.
  void between(const Stretch& s, const PieceBox& of_s, const Stretch& t, const PieceBox& of_t) {
    const bool halve_s = s.size() >= t.size();
    const Stretch& whole = halve_s ? s : t;
    const Index middle = whole.first + whole.size() / 2;
    for (const Stretch half : {Stretch{whole.first, middle}, Stretch{middle, whole.end}}) {
      const PieceBox of_half = box(half);
      if (!of_half.meets(halve_s ? of_t : of_s)) continue;
      const Stretch &left = halve_s ? half : s, &right = halve_s ? t : half;
      if (left.size() == 1 && right.size() == 1)
        add(left.first, right.first);
      else
        between(left, halve_s ? of_half : of_s, right, halve_s ? of_t : of_half);
    }
  }

  void add(Index i, Index j) {
    if (c_.origins[i].next != j && c_.origins[j].next != i) pairs_.push_back({i, j});
  }

  const OffsetCurves& c_;
  double slack_;
  std::vector<Stretch> stretches_;
  std::vector<Index> rows_;  // of a stretch: the first piece of its row
  std::vector<PiecePair> pairs_;
};

}  // namespace

std::vector<PiecePair> near_pairs(const OffsetCurves& curves) { return Search(curves).run(); }

}  // namespace findspace::plane
