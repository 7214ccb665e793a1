// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All pairs of boxes that meet. The edges of a ring are neighbours in the plane where they are neighbours in the list,
// so runs of the list are joined in pairs and this tree is descended against itself without any sorting: O(n) for
// curves that do not come back to themselves. Where that would take too long (long spirals, edges in no order) a tree
// of median splits takes over: O(n log n + pairs) for boxes that are small beside the whole, whatever their order; a
// pair may then be visited twice. Boxes in no order, as those of rings, go to that tree at once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace findspace::plane {

/// Closed box, in grid steps.
struct Box {
  std::int64_t x0, y0, x1, y1;

  Box joined(const Box& b) const {
    return {std::min(x0, b.x0), std::min(y0, b.y0), std::max(x1, b.x1), std::max(y1, b.y1)};
  }
  bool meets(const Box& b) const {  // all four at once: which one fails cannot be foreseen
    return (x0 <= b.x1) & (b.x0 <= x1) & (y0 <= b.y1) & (b.y0 <= y1);
  }
  bool holds(std::int64_t x, std::int64_t y) const { return x0 <= x && x <= x1 && y0 <= y && y <= y1; }
};

class BoxTree {
 public:
  /// `run_length`: so many boxes that follow each other stay together.
  explicit BoxTree(std::span<const Box> boxes, std::size_t run_length = kRun) : boxes_(boxes), run_length_(run_length) {
    if (boxes.empty()) return;
    for (std::size_t i = 0; i < boxes.size(); i += run_length_) {
      Box run = boxes[i];
      for (std::size_t k = i + 1; k < end_of(i); ++k) run = run.joined(boxes[k]);
      runs_.push_back({run, i});
    }
    nodes_.reserve(2 * boxes.size());
    build(0, runs_.size());
  }

  template <class Visit>
  void meeting_pairs(Visit visit) const {
    if (!nodes_.empty()) within(0, visit);
  }

 private:
  static constexpr std::size_t kRun = 8;

  struct Node {
    Box box;
    std::size_t leaf;   // the box's index where right == 0
    std::size_t right;  // the left child is the next node
  };

  struct Run {  // boxes first, first + 1, ... up to run_length_ of them
    Box box;
    std::size_t first;
  };

  std::size_t end_of(std::size_t first) const { return std::min(first + run_length_, boxes_.size()); }

  std::size_t build(std::size_t begin, std::size_t end) {
    if (end - begin == 1) return build_run(runs_[begin].first, end_of(runs_[begin].first));
    Box all = runs_[begin].box;
    for (std::size_t i = begin + 1; i < end; ++i) all = all.joined(runs_[i].box);
    std::size_t self = nodes_.size();
    nodes_.push_back({all, 0, 0});
    bool wide = all.x1 - all.x0 >= all.y1 - all.y0;
    auto key = [&](const Run& r) { return wide ? r.box.x0 + r.box.x1 : r.box.y0 + r.box.y1; };
    auto less = [&](const Run& p, const Run& q) { return key(p) != key(q) ? key(p) < key(q) : p.first < q.first; };
    std::size_t middle = begin + (end - begin) / 2;
    auto at = [&](std::size_t i) { return runs_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(begin), at(middle), at(end), less);
    build(begin, middle);
    std::size_t right = build(middle, end);
    nodes_[self].right = right;
    return self;
  }

  std::size_t build_run(std::size_t begin, std::size_t end) {
    std::size_t self = nodes_.size();
    nodes_.push_back({boxes_[begin], begin, 0});
    if (end - begin == 1) return self;
    std::size_t middle = begin + (end - begin) / 2, left = build_run(begin, middle), right = build_run(middle, end);
    nodes_[self] = {nodes_[left].box.joined(nodes_[right].box), begin, right};
    return self;
  }

  template <class Visit>
  void within(std::size_t n, Visit& visit) const {
    if (nodes_[n].right == 0) return;
    within(n + 1, visit);
    within(nodes_[n].right, visit);
    between(n + 1, nodes_[n].right, visit);
  }

  template <class Visit>
  void between(std::size_t a, std::size_t b, Visit& visit) const {
    if (!nodes_[a].box.meets(nodes_[b].box)) return;
    bool leaf_a = nodes_[a].right == 0, leaf_b = nodes_[b].right == 0;
    if (leaf_a && leaf_b) return visit(nodes_[a].leaf, nodes_[b].leaf);
    if (leaf_b || (!leaf_a && a < b)) {
      between(a + 1, b, visit);
      between(nodes_[a].right, b, visit);
    } else {
      between(a, b + 1, visit);
      between(a, nodes_[b].right, visit);
    }
  }

  std::span<const Box> boxes_;
  std::size_t run_length_;
  std::vector<Run> runs_;
  std::vector<Node> nodes_;
};

/// The tree over the runs of the list as it is; level 0 holds the runs, each level above the joined pairs of the last.
class RunTree {
 public:
  RunTree(std::span<const Box> boxes, std::span<const std::uint32_t> chains) : boxes_(boxes), chains_(chains) {
    nodes_.reserve(boxes.size() / kRun * 2 + 64);  // two a run, one more a level
    for (std::size_t i = 0; i < boxes.size(); i += kRun) {
      Box run = boxes[i];
      for (std::size_t k = i + 1; k < end_of(i / kRun); ++k) run = run.joined(boxes[k]);
      nodes_.push_back(run);
    }
    runs_ = nodes_.size();
    for (std::size_t first = 0, count = runs_; count > 1; count = nodes_.size() - first) {
      levels_.push_back({first, count});
      first += count;
      for (std::size_t i = first - count; i < first; i += 2)
        nodes_.push_back(i + 1 < first ? nodes_[i].joined(nodes_[i + 1]) : nodes_[i]);
    }
    levels_.push_back({nodes_.size() - 1, 1});
  }

  /// False where it gave up: more pairs of nodes met than a tree of median splits costs.
  template <class Visit>
  bool meeting_pairs(Visit visit) {
    left_ = kNodesPerRun * runs_;
    within(levels_.size() - 1, 0, visit);
    return left_ > 0;
  }

 private:
  static constexpr std::size_t kRun = 8, kNodesPerRun = 256;

  struct Level {
    std::size_t first, count;
  };

  std::size_t end_of(std::size_t run) const { return std::min((run + 1) * kRun, boxes_.size()); }
  const Box& node(std::size_t level, std::size_t i) const { return nodes_[levels_[level].first + i]; }

  template <class Visit>
  void within(std::size_t level, std::size_t i, Visit& visit) {
    if (level == 0) {
      for (std::size_t p = i * kRun; p < end_of(i); ++p)
        for (std::size_t q = p + 1; q < end_of(i); ++q)
          if (chains_[q] > p && boxes_[p].meets(boxes_[q])) visit(p, q);
      return;
    }
    within(level - 1, 2 * i, visit);
    if (2 * i + 1 == levels_[level - 1].count) return;
    within(level - 1, 2 * i + 1, visit);
    between(level - 1, 2 * i, 2 * i + 1, visit);
  }

  template <class Visit>
  void between(std::size_t level, std::size_t i, std::size_t j, Visit& visit) {
    if (left_ == 0 || !node(level, i).meets(node(level, j))) return;
    --left_;
    if (level == 0) return runs(i, j, visit);
    const std::size_t count = levels_[level - 1].count;
    for (std::size_t p = 2 * i; p < std::min(2 * i + 2, count); ++p)
      for (std::size_t q = 2 * j; q < std::min(2 * j + 2, count); ++q) between(level - 1, p, q, visit);
  }

  template <class Visit>
  void runs(std::size_t i, std::size_t j, Visit& visit) {
    const Box& other = nodes_[j];
    for (std::size_t p = i * kRun; p < end_of(i); ++p) {
      if (!boxes_[p].meets(other)) continue;
      for (std::size_t q = j * kRun; q < end_of(j); ++q)
        if (boxes_[p].meets(boxes_[q])) visit(p, q);
    }
  }

  std::span<const Box> boxes_;
  std::span<const std::uint32_t> chains_;
  std::vector<Box> nodes_;
  std::vector<Level> levels_;
  std::size_t runs_ = 0, left_ = 0;
};

constexpr std::size_t kFewBoxes = 16;  // up to here a tree costs more than it saves

/// Of boxes that are near in the plane where they are near in the list. `chains`: for each box the first up to which
/// those before it meet it only where they should: they need not be visited.
template <class Visit>
void for_meeting_boxes(std::span<const Box> boxes, std::span<const std::uint32_t> chains, Visit visit) {
  if (boxes.size() > kFewBoxes) {
    if (!RunTree(boxes, chains).meeting_pairs(visit)) BoxTree(boxes).meeting_pairs(visit);
    return;
  }
  for (std::size_t j = 1; j < boxes.size(); ++j)
    for (std::size_t i = 0; i < chains[j]; ++i)
      if (boxes[i].meets(boxes[j])) visit(i, j);
}

/// Of boxes in no order, for each those others that meet it and are wanted(box, other), in their order.
template <class Wanted>
std::vector<std::vector<std::size_t>> meeting_others(std::span<const Box> boxes, Wanted wanted) {
  std::vector<std::vector<std::size_t>> out(boxes.size());
  const auto visit = [&](std::size_t i, std::size_t j) {
    if (wanted(i, j)) out[i].push_back(j);
    if (wanted(j, i)) out[j].push_back(i);
  };
  if (boxes.size() > kFewBoxes) {
    BoxTree(boxes, 1).meeting_pairs(visit);
  } else {
    for (std::size_t j = 1; j < boxes.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (boxes[i].meets(boxes[j])) visit(i, j);
  }
  for (std::vector<std::size_t>& others : out) std::sort(others.begin(), others.end());
  return out;
}

}  // namespace findspace::plane
