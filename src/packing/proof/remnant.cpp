// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/remnant.h"

#include <algorithm>
#include <array>
#include <vector>

#include "packing/proof/standing.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostLines = 1000, kEvenLines = 200;
constexpr int kDigits = 6;  // of the rectangle, at least
constexpr int kBits = 40;   // to which a side is where it was found; the proof follows

/// A polygon, and how far from it the rectangle stays.
struct Obstacle {
  const Standing* standing;
  Fraction gap;
  int128 grown;  // the gap in common steps; of a part with arcs what the polygon about it needs besides
};

class Cells {
 public:
  Cells(const LatticeBox& sheet, const std::vector<Obstacle>& obstacles) {
    x_ = lines(sheet.low.x, sheet.high.x, obstacles, [](const LatticePoint& p) { return p.x; });
    y_ = lines(sheet.low.y, sheet.high.y, obstacles, [](const LatticePoint& p) { return p.y; });
    taken_.assign(columns() * rows(), 0);
    for (const Obstacle& obstacle : obstacles) take(obstacle);
  }

  /// The largest rectangle of free cells: in each row the heights of free columns below it are a histogram.
  std::optional<LatticeBox> largest() const {
    std::optional<LatticeBox> best;
    double most = 0;
    std::vector<std::size_t> floor(columns() + 1);  // of each column, the lowest row that is free up to this one
    for (std::size_t row = 0; row < rows(); ++row) {
      for (std::size_t c = 0; c < columns(); ++c)
        if (taken_[row * columns() + c] != 0) floor[c] = row + 1;
      floor[columns()] = row + 1;                             // an end without height
      std::vector<std::pair<std::size_t, std::size_t>> open;  // columns from where a floor holds, the floors descending
      for (std::size_t c = 0; c <= columns(); ++c) {
        std::size_t from = c;
        while (!open.empty() && open.back().second <= floor[c]) {
          const auto [first, low] = open.back();
          const LatticeBox box{{x_[first], y_[low]}, {x_[c], y_[row + 1]}};
          const double area = double(box.high.x - box.low.x) * double(box.high.y - box.low.y);
          if (low <= row && area > most) {
            most = area;
            best = box;
          }
          from = first;
          open.pop_back();
        }
        open.emplace_back(from, floor[c]);
      }
    }
    return best;
  }

 private:
  std::size_t columns() const { return x_.size() - 1; }
  std::size_t rows() const { return y_.size() - 1; }

  /// The coordinates at which a side of the rectangle may lie: those of corners, and even ones for slanted edges.
  template <class Coordinate>
  static std::vector<int128> lines(int128 low, int128 high, const std::vector<Obstacle>& obstacles,
                                   const Coordinate& coordinate) {
    std::vector<int128> result;
    const auto add = [&](const Obstacle& obstacle, int128 c) {
      for (const int128 line : {c - obstacle.grown, c + obstacle.grown})
        if (line > low && line < high) result.push_back(line);
    };
    for (const Obstacle& obstacle : obstacles) {
      add(obstacle, coordinate(obstacle.standing->box.low));
      add(obstacle, coordinate(obstacle.standing->box.high));
    }
    keep_some(result);
    const std::size_t boxes = result.size();
    for (const Obstacle& obstacle : obstacles)
      for (const Ring& ring : obstacle.standing->shape.rings)
        for (const LatticePoint& p : ring)
          if (obstacle.standing->round == nullptr) add(obstacle, coordinate(p));
    if (result.size() - boxes > kMostLines) result.resize(boxes);
    for (std::size_t k = 0; k <= kEvenLines; ++k) result.push_back(low + (high - low) * int128(k) / int128(kEvenLines));
    sort(result);
    return result;
  }

  static void sort(std::vector<int128>& lines) {
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  }

  static void keep_some(std::vector<int128>& lines) {
    sort(lines);
    const std::size_t all = lines.size();
    if (all <= kMostLines) return;
    for (std::size_t k = 0; k < kMostLines; ++k) lines[k] = lines[k * all / kMostLines];
    lines.resize(kMostLines);
  }

  /// Takes the cells of a row that a polygon, with a square about each of its points, enters.
  void take(const Obstacle& obstacle) {
    const LatticeBox& box = obstacle.standing->box;
    for (std::size_t row = 0; row < rows(); ++row) {
      const int128 low = y_[row] - obstacle.grown, high = y_[row + 1] + obstacle.grown;
      if (high <= box.low.y || low >= box.high.y) continue;
      for (const Ring& ring : obstacle.standing->shape.rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
          take_edge(row, ring[i], ring[(i + 1) % ring.size()], low, high, obstacle);
      take_inside(row, obstacle.standing->shape);
    }
  }

  /// What of the edge lies between two heights, by doubles and rounded outwards: the proof is elsewhere.
  void take_edge(std::size_t row, const LatticePoint& p, const LatticePoint& q, int128 low, int128 high,
                 const Obstacle& obstacle) {
    if (std::max(p.y, q.y) <= low || std::min(p.y, q.y) >= high) return;
    int128 left = std::min(p.x, q.x), right = std::max(p.x, q.x);
    if (p.y != q.y) {
      const auto x_at = [&](int128 y) {
        const double t = double(y - p.y) / double(q.y - p.y);
        return double(p.x) + std::clamp(t, 0.0, 1.0) * double(q.x - p.x);
      };
      const double a = x_at(low), b = x_at(high);
      if (p.x != q.x) {
        left = std::max(left, int128(std::min(a, b)) - 1);
        right = std::min(right, int128(std::max(a, b)) + 1);
      }
    }
    take_between(row, left - obstacle.grown, right + obstacle.grown);
  }

  void take_between(std::size_t row, int128 left, int128 right) {
    const auto first = std::upper_bound(x_.begin(), x_.end(), left);
    for (std::size_t c = first == x_.begin() ? 0 : std::size_t(first - x_.begin()) - 1; c < columns() && x_[c] < right;
         ++c)
      if (x_[c + 1] > left) taken_[row * columns() + c] = 1;
  }

  /// Cells that no edge enters lie within where their middle does.
  void take_inside(std::size_t row, const Polygon& shape) {
    const double middle = (double(y_[row]) + double(y_[row + 1])) / 2;
    std::vector<std::pair<double, int>> ends;
    for (const Ring& ring : shape.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const LatticePoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
        const double py = double(p.y), qy = double(q.y);
        if ((py <= middle) == (qy <= middle)) continue;
        ends.emplace_back(double(p.x) + (middle - py) / (qy - py) * (double(q.x) - double(p.x)), py > qy ? 1 : -1);
      }
    std::sort(ends.begin(), ends.end());
    int winding = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      winding += ends[k].second;
      if (winding != 0) take_middles(row, ends[k].first, ends[k + 1].first);
    }
  }

  void take_middles(std::size_t row, double left, double right) {
    for (std::size_t c = 0; c < columns(); ++c) {
      const double middle = (double(x_[c]) + double(x_[c + 1])) / 2;
      if (middle > left && middle < right) taken_[row * columns() + c] = 1;
    }
  }

  std::vector<int128> x_, y_;
  std::vector<char> taken_;  // row by row
};

Polygon polygon_of(const LatticeBox& b) { return {{{b.low, {b.high.x, b.low.y}, b.high, {b.low.x, b.high.y}}}}; }

class Search {
 public:
  Search(const Problem& problem, const Layout& layout)
      : parts_(problem, layout, kDigits), last_(layout.sheets.size() - 1) {
    const Sheet& sheet = problem.sheets[layout.sheets[last_]];
    sheet_ = parts_.scaled(box_of(sheet));
    for (const Part& part : obstacles_of(problem, sheet)) holes_.push_back(parts_.obstacle(part));
    const int128 gap = problem.gap.over(parts_.common()), slack = parts_.slack() + 1;
    for (const Standing& hole : holes_) obstacles_.push_back({&hole, 0, hole.round != nullptr ? slack : 0});
    for (std::size_t i = 0; i < layout.items.size(); ++i) {
      const Standing& item = parts_.items()[i];
      if (layout.items[i].sheet == last_)
        obstacles_.push_back({&item, problem.gap, item.round != nullptr ? gap + slack : gap});
    }
  }

  std::optional<Remnant> run() {
    std::optional<LatticeBox> box = Cells(sheet_, obstacles_).largest();
    if (!box) return std::nullopt;
    if (!is_free(*box)) draw_in(*box);
    if (!is_free(*box)) return std::nullopt;
    push_out(*box);
    const int128 one = parts_.common();
    return Remnant{
        last_, {box->low.x, one}, {box->low.y, one}, {box->high.x - box->low.x, one}, {box->high.y - box->low.y, one}};
  }

 private:
  /// By more than doubles are off.
  void draw_in(LatticeBox& box) const {
    const int128 by = ((sheet_.high.x + sheet_.high.y) >> kBits) + 1;
    box = {{box.low.x + by, box.low.y + by}, {box.high.x - by, box.high.y - by}};
    if (box.low.x >= box.high.x || box.low.y >= box.high.y) box = sheet_;
  }

  bool is_free(const LatticeBox& box) const {
    const Polygon rectangle = polygon_of(box);
    return std::all_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& obstacle) {
      return parts_.keeps_gap(*obstacle.standing, rectangle, obstacle.gap);
    });
  }

  /// Each side in turn, as far as it goes, by halving what is left to the side of the sheet.
  void push_out(LatticeBox& box) const {
    const std::array<std::pair<int128*, int128>, 4> sides{{{&box.high.x, sheet_.high.x},
                                                           {&box.high.y, sheet_.high.y},
                                                           {&box.low.x, sheet_.low.x},
                                                           {&box.low.y, sheet_.low.y}}};
    for (const auto& [side, limit] : sides) {
      int128 good = *side, bad = limit;
      *side = limit;
      if (is_free(box)) continue;
      while (bad - good > 1 || good - bad > 1) {
        *side = good + (bad - good) / 2;
        (is_free(box) ? good : bad) = *side;
      }
      *side = good;
    }
  }

  StandingParts parts_;
  std::size_t last_;
  LatticeBox sheet_;
  std::vector<Standing> holes_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace

std::optional<Remnant> largest_remnant(const Problem& problem, const Layout& layout) {
  if (layout.sheets.empty()) return std::nullopt;
  return Search(problem, layout).run();
}

}  // namespace findspace::packing
