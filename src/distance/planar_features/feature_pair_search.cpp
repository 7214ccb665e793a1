// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/feature_pair_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "exact/margins/planar_distance.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Cell;
using plane::Index;
using plane::kNone;
using plane::Region;

namespace {

class PairSearch {
 public:
  PairSearch(const FeatureTree& a, const FeatureTree& b, const RealPoint& p)
      : a_(a), b_(b), p_(p), px_(near_value(p.x)), py_(near_value(p.y)) {
    double scale = a.scale() + b.scale() + std::abs(px_) + std::abs(py_);
    slack_ = scale * margin::kSameNumber;
    tolerance_ = scale * margin::kPairMeets;
  }

  /// Returns false where the boundaries meet or come closer than numbers can tell; not if `touching`.
  bool run_nearest(bool touching);
  void run_farthest();
  double gap() const { return best_ - slack_; }
  /// A crossing of straight edges, certain; with `arcs` also a place where arcs meet or seem to.
  std::optional<FeaturePair> run_common(bool arcs);
  CutSearch run_crossing(const Moves& by, std::size_t most);
  /// The exact best among what numbers left over.
  FeaturePair best(bool far) const;
  /// What numbers say is nearest, exactly.
  FeaturePair first() const;

 private:
  struct Entry {
    double squared;
    Index i, j;
  };
  void keep(const Candidate& c);
  using Cells = std::tuple<int, Index, int, Index>;
  static Cells cells(const Candidate& c) {
    return {c.first.dimension, c.first.index, c.second.dimension, c.second.index};
  }
  bool meet_when_moved(const FeatureBox& s, const FeatureBox& t, double px, double py) const {
    return std::min(s.x1 - (t.x0 + px), t.x1 + px - s.x0) >= moves_->x &&
           std::min(s.y1 - (t.y0 + py), t.y1 + py - s.y0) >= moves_->y;
  }
  /// Two features of the nodes may reach so far that they meet however one is moved.
  bool reach_far_enough(Index i, Index j) const {
    const FeatureTree::Reach s = a_.reaches()[i], t = b_.reaches()[j];
    return s.x + t.x >= 2 * moves_->x && s.y + t.y >= 2 * moves_->y;
  }
  /// Of the boxes. Small ones are better to find edges that cross: a long edge makes the boxes of short ones large.
  double size(const Entry& e) const {
    const FeatureBox &s = a_.nodes()[e.i].box, &t = b_.nodes()[e.j].box;
    return (s.x1 - s.x0) + (s.y1 - s.y0) + (t.x1 - t.x0) + (t.y1 - t.y0);
  }
  Entry entry(Index i, Index j, bool far) const;
  /// leaves(leaf of A, leaf of B) for those whose features may count; ends when it returns false.
  template <class Leaves>
  void walk_leaves(bool far, Leaves&& leaves);
  /// leaf(feature of A, feature of B) for the pairs of features that may count; ends when it returns false.
  template <class Leaf>
  void walk(bool far, Leaf&& leaf);
  bool worth(double squared, bool far) const;

  const FeatureTree &a_, &b_;
  const RealPoint& p_;
  double px_, py_, slack_ = 0, tolerance_ = 0, best_ = std::numeric_limits<double>::infinity();
  std::size_t looks_left_ = SIZE_MAX;  // at pairs of boxes
  std::optional<Moves> moves_;         // the pairs that count meet, however one is moved by as much
  std::vector<Candidate> candidates_;  // each pair once: thousands may touch at once
  std::set<Cells> kept_;               // these
};

/// Nearest values count as they are, farthest ones with a minus: less is better.
void PairSearch::keep(const Candidate& c) {
  if (c.value > best_ + slack_) return;
  if (c.value < best_) {
    best_ = c.value;
    std::erase_if(candidates_, [&](const Candidate& k) {
      const bool worse = k.value > best_ + slack_;
      if (worse) kept_.erase(cells(k));
      return worse;
    });
  }
  if (kept_.insert(cells(c)).second) candidates_.push_back(c);
}

PairSearch::Entry PairSearch::entry(Index i, Index j, bool far) const {
  const FeatureBox &s = a_.nodes()[i].box, &t = b_.nodes()[j].box;
  if (moves_ && !(reach_far_enough(i, j) && meet_when_moved(s, t, px_, py_)))
    return {std::numeric_limits<double>::infinity(), i, j};
  return {far ? -s.farthest_squared(t, px_, py_) : s.nearest_squared(t, px_, py_), i, j};
}

bool PairSearch::worth(double squared, bool far) const {
  double limit = best_ + slack_;
  return far ? limit > 0 || -squared >= limit * limit : squared <= limit * limit;
}

template <class Leaves>
void PairSearch::walk_leaves(bool far, Leaves&& leaves) {
  std::vector<Entry> stack{entry(0, 0, far)};
  while (!stack.empty() && looks_left_ > 0) {
    --looks_left_;
    Entry e = stack.back();
    stack.pop_back();
    if (!worth(e.squared, far)) continue;
    const FeatureTree::Node &s = a_.nodes()[e.i], &t = b_.nodes()[e.j];
    bool split_first = s.right != kNone && (t.right == kNone || s.last - s.first >= t.last - t.first);
    if (!split_first && t.right == kNone) {
      if (!leaves(s, t)) return;
      continue;
    }
    Entry near = split_first ? entry(e.i + 1, e.j, far) : entry(e.i, e.j + 1, far);
    Entry other = split_first ? entry(s.right, e.j, far) : entry(e.i, t.right, far);
    if (other.squared < near.squared || (moves_ && !(near.squared < other.squared) && size(other) < size(near)))
      std::swap(near, other);
    if (worth(other.squared, far)) stack.push_back(other);
    if (worth(near.squared, far)) stack.push_back(near);
  }
}

template <class Leaf>
void PairSearch::walk(bool far, Leaf&& leaf) {
  walk_leaves(far, [&](const FeatureTree::Node& s, const FeatureTree::Node& t) {
    for (Index j = t.first; j < t.last; ++j) {
      const Placed q = placed(b_.region(), b_.features()[j], px_, py_);
      for (Index i = s.first; i < s.last; ++i)
        if (!leaf(placed(a_.region(), a_.features()[i], 0, 0), q)) return false;
    }
    return true;
  });
}

bool PairSearch::run_nearest(bool touching) {
  bool meet = false;
  walk(false, [&](const Placed& p, const Placed& q) {
    if (!worth(box_of(p.s).nearest_squared(box_of(q.s), 0, 0), false)) return true;
    nearest_features(p, q, slack_, [&](const Candidate& c) { keep(c); });
    meet = !touching && (best_ <= slack_ || may_meet(p.s, q.s, tolerance_));
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

std::optional<FeaturePair> PairSearch::run_common(bool arcs) {
  std::optional<FeaturePair> found;
  best_ = 0;
  walk(false, [&](const Placed& p, const Placed& q) {
    const BoundaryFeature &s = p.s, &t = q.s;
    if (!s.arc && !t.arc) {
      if (!s.is_vertex() && !t.is_vertex() && segments_cross(s, t, {slack_, slack_}))
        found = crossing(a_.region(), b_.region(), s.cell, t.cell, p_);
    } else if (arcs) {
      if (auto at = s.arc ? arc_meeting(s, t, tolerance_) : arc_meeting(t, s, tolerance_)) {
        RealPoint place{Real::from_double((*at)[0]), Real::from_double((*at)[1])};
        found = FeaturePair{Real(), place, place, s.cell, t.cell};
      }
    }
    return !found;
  });
  return found;
}

CutSearch PairSearch::run_crossing(const Moves& by, std::size_t most) {
  bool found = false;
  best_ = 0;
  moves_ = by;
  looks_left_ = most;
  walk_leaves(false, [&](const FeatureTree::Node& of_a, const FeatureTree::Node& of_b) {
    for (Index i = of_a.first; i < of_a.last && !found; ++i) {
      const BoundaryFeature& s = a_.features()[i];
      const FeatureBox box = box_of(s);
      if (s.is_vertex() || !meet_when_moved(box, of_b.box, px_, py_)) continue;
      for (Index j = of_b.first; j < of_b.last && !found; ++j) {
        const BoundaryFeature t = placed(b_.region(), b_.features()[j], px_, py_).s;
        found = !t.is_vertex() && meet_when_moved(box, box_of(t), 0, 0) && edges_cross(s, t, by, slack_);
      }
    }
    return !found;
  });
  return {found, !found && looks_left_ == 0, most - looks_left_};
}

FeaturePair PairSearch::best(bool far) const {
  std::optional<FeaturePair> best;
  for (const Candidate& c : candidates_) {
    auto k = exact_pair(a_.region(), b_.region(), p_, c, far);
    if (k && (!best || (far ? k->distance > best->distance : k->distance < best->distance))) best = std::move(k);
  }
  return *best;
}

FeaturePair PairSearch::first() const {
  std::vector<Candidate> all = candidates_;
  std::stable_sort(all.begin(), all.end(), [](const Candidate& c, const Candidate& d) { return c.value < d.value; });
  for (const Candidate& c : all)
    if (auto k = exact_pair(a_.region(), b_.region(), p_, c, false)) return *k;
  return {};
}

}  // namespace

std::optional<FeaturePair> nearest_pair(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  if (!search.run_nearest(false)) return std::nullopt;
  return search.best(false);
}

FeaturePair closest_pair(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  search.run_nearest(true);
  return search.best(false);
}

std::optional<FeaturePair> crossing_pair(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  return PairSearch(a, b, p).run_common(false);
}

CutSearch certainly_cross(const FeatureTree& a, const FeatureTree& b, double x, double y, const Moves& by,
                          std::size_t most) {
  const RealPoint p{Real::from_double(x), Real::from_double(y)};
  return PairSearch(a, b, p).run_crossing(by, most);
}

bool certainly_apart(const FeatureTree& a, const FeatureTree& b, double x, double y, double margin) {
  const RealPoint p{Real::from_double(x), Real::from_double(y)};
  PairSearch search(a, b, p);
  return search.run_nearest(false) && search.gap() > margin;
}

FeaturePair common_point(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  auto found = PairSearch(a, b, p).run_common(true);
  return found ? *found : touching_pair(a, b, p);
}

FeaturePair touching_pair(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  search.run_nearest(true);
  return search.first();
}

FeaturePair farthest_pair(const FeatureTree& a, const FeatureTree& b, const RealPoint& p) {
  PairSearch search(a, b, p);
  search.run_farthest();
  return search.best(true);
}

FeaturePair nearest_point(const FeatureTree& a, const RealPoint& at) {
  double x = near_value(at.x), y = near_value(at.y);
  const double slack = (a.scale() + std::abs(x) + std::abs(y)) * margin::kSameNumber;
  const double limit = a.nearest(x, y).distance + slack;
  std::optional<FeaturePair> best;
  std::vector<Cell> known;  // two edges share a vertex
  auto take = [&](Cell cell) {
    if (std::find(known.begin(), known.end(), cell) != known.end()) return;
    known.push_back(cell);
    auto k = exact_pair(a.region(), cell, at);
    if (k && (!best || k->distance < best->distance)) best = std::move(k);
  };
  a.for_near(x, y, limit, [&](Index k) {
    const BoundaryFeature& s = a.features()[k];
    const Placed p = placed(a.region(), s, 0, 0);
    if (plain_length(x - s.x0, y - s.y0) <= limit) take({0, p.vertex[0]});
    if (plain_length(x - s.x1, y - s.y1) <= limit) take({0, p.vertex[1]});
    if (!s.is_vertex() && s.faces(x, y, slack)) take(s.cell);
    return true;
  });
  return *best;
}

}  // namespace findspace::distance