// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/round_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

#include "distance/search/lp_bound.h"
#include "distance/search/round_solid.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {
namespace {

using exact::kInfinity;
using space::Vector;

/// A line, by where it meets the plane across the direction.
using RunLine = std::array<double, 2>;
/// Numbers at the corners of a triangle, of a function that is linear on it.
using RunValues = std::array<double, 3>;

/// A height over the plane of lines, linear.
struct RunHeight {
  double first = 0, second = 0, rest = 0;
  double at(const RunLine& y) const { return first * y[0] + second * y[1] + rest; }
};

/// What a line has of a convex set: it may be in it between the outer ends, and is between the inner ones.
struct RunChord {
  double outer_from = kInfinity, outer_to = -kInfinity, from = kInfinity, to = -kInfinity;
  double apart = 0;                     // no place of the line is nearer to the set
  std::vector<RunHeight> below, above;  // that the set lies between, over all lines
  bool met() const { return outer_from <= outer_to; }
  bool inside() const { return from < to; }
};

/// A line with its chords of the sets near it.
struct RunCorner {
  RunLine at{};
  std::vector<RunChord> chords;  // by number of the set
};
using RunCornerPointer = std::shared_ptr<const RunCorner>;

/// What is greatest on a triangle, at most, and by which weights of the corners.
struct RunBound {
  double value = 0;
  RunValues weights{1, 0, 0};
};

struct RunTriangle {
  std::array<RunCornerPointer, 3> corners;
  std::vector<int> sets;
  RunBound bound;
  double rank = 0;  // of the bound: among those as good the larger is first
  double longest = 0;
  bool operator<(const RunTriangle& other) const {
    return rank != other.rank ? rank < other.rank : longest < other.longest;
  }
};

RunValues less(const RunValues& a, const RunValues& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double most_of(const RunValues& v) { return std::max({v[0], v[1], v[2]}); }

/// The greatest that the least of the columns, of which there is one, is on the triangle.
RunBound most_of_least(const std::vector<RunValues>& columns) {
  std::vector<Column> all;
  for (const RunValues& c : columns) all.push_back({c[0], c[1], c[2], c[2]});
  const LpBound found = bounding_lp(std::move(all), std::nullopt);
  RunBound out{found.value, {found.rows[0], found.rows[1], found.rows[2] + found.rows[3]}};
  for (const RunValues& c : columns) out.value = std::min(out.value, most_of(c));
  return out;
}

class RoundRunSearch {
 public:
  explicit RoundRunSearch(const RoundRunQuery& query) : query_(query), unit_(query.unit) {
    first_ = distance::across(unit_);
    second_ = space::cross(unit_, first_);
    const Vector& low = query.box.low;
    const Vector& high = query.box.high;
    size_ = space::size_of(low) + space::size_of(high) + 1;
    noise_ = margin::kRayNoise * size_;
    for (int k = 0; k < 8; ++k) {
      const Vector p{(k & 1) != 0 ? low.x : high.x, (k & 2) != 0 ? low.y : high.y, (k & 4) != 0 ? low.z : high.z};
      const std::array<double, 3> at{space::dot(first_, p), space::dot(second_, p), space::dot(unit_, p)};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ends_[axis][0] = std::min(ends_[axis][0], at[axis] - 2 * noise_);
        ends_[axis][1] = std::max(ends_[axis][1], at[axis] + 2 * noise_);
      }
    }
  }

  RoundRun run() {
    std::vector<int> all(query_.sets.size());
    std::iota(all.begin(), all.end(), 0);
    std::array<RunCornerPointer, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) corner[k] = made({ends_[0][k & 1], ends_[1][k >> 1]}, all);
    add({corner[0], corner[1], corner[2]}, all, kInfinity);
    add({corner[3], corner[1], corner[2]}, all, kInfinity);
    queue_.run(
        plane::allowed(kMostRunCells),
        [&](const RunTriangle& top) { return top.bound.value <= best_.length + enough() || plane::cells_left() <= 0; },
        [&](const RunTriangle& top) {
          plane::count_cell();
          divide(top);
        });
    best_.bound = std::max(best_.length, dropped_);
    for (const RunTriangle& left : queue_.left()) best_.bound = std::max(best_.bound, left.bound.value);
    best_.bound += noise_;
    return best_;
  }

 private:
  double enough() const { return margin::kRayCertain * size_; }

  Vector place(const RunLine& y, double t) const {
    return space::plus(space::plus(space::scaled(y[0], first_), space::scaled(y[1], second_)), space::scaled(t, unit_));
  }

  /// The half space in which the set lies, by its function at x, as a height.
  void add_height(const Touching& g, const Vector& x, RunChord& chord) const {
    const double slope = space::dot(g.slope, unit_);
    if (std::fabs(slope) <= margin::kAlongFace) return;
    const double rest = g.value - space::dot(g.slope, x) - noise_;
    const RunHeight height{-space::dot(g.slope, first_) / slope, -space::dot(g.slope, second_) / slope, -rest / slope};
    (slope > 0 ? chord.above : chord.below).push_back(height);
  }

  /// From an end of the line to where the set may begin: Newton, which stays outside. Where the slope turns, the line
  /// misses the set, or tangents from both sides tell how far it passes.
  struct Reached {
    double t = 0;
    Touching g;
    bool turned = false;
  };
  Reached reached(const TouchingConstraint& set, const RunLine& y, double start, double sense, RunChord& chord) const {
    Reached out{start, {}, false};
    for (int k = 0; k < kMostSteps; ++k) {
      out.g = set(place(y, out.t));
      add_height(out.g, place(y, out.t), chord);
      if (out.g.value <= noise_) return out;
      const double slope = sense * space::dot(out.g.slope, unit_);
      if (slope <= margin::kAlongFace) {
        out.turned = true;
        return out;
      }
      out.t -= sense * out.g.value / slope;
      if (sense * (out.t - start) < ends_[2][0] - ends_[2][1]) {
        out.turned = true;
        return out;
      }
    }
    return out;
  }

  /// Tangents from both sides: no place of the line has less than where they meet.
  double apart(const TouchingConstraint& set, const RunLine& y, RunChord& chord) const {
    double from = ends_[2][0], to = ends_[2][1];
    Touching left = set(place(y, from)), right = set(place(y, to));
    double bound = 0;
    for (int k = 0; k < kMostSteps; ++k) {
      const double a = space::dot(left.slope, unit_), b = space::dot(right.slope, unit_);
      if (a >= 0) return std::max(bound, left.value - noise_);
      if (b <= 0) return std::max(bound, right.value - noise_);
      const double t = std::clamp((left.value - right.value + b * to - a * from) / (b - a), from, to);
      bound = std::max(bound, left.value + a * (t - from) - noise_);
      const Touching middle = set(place(y, t));
      add_height(middle, place(y, t), chord);
      if (middle.value - bound <= 4 * noise_ || !(from < t && t < to)) break;
      const bool falls = space::dot(middle.slope, unit_) < 0;
      (falls ? left : right) = middle;
      (falls ? from : to) = t;
    }
    return bound;
  }

  RunChord chord(const TouchingConstraint& set, const RunLine& y) const {
    RunChord out;
    const Reached top = reached(set, y, ends_[2][1], 1, out), bottom = reached(set, y, ends_[2][0], -1, out);
    if (top.turned || bottom.turned || bottom.t > top.t) {
      out.apart = apart(set, y, out);
      return out;
    }
    out.outer_from = bottom.t;
    out.outer_to = top.t;
    const double whole = top.t - bottom.t;
    const auto inner = [&](double end, double sense) {
      for (double by = 4 * noise_; by < whole; by *= 2) {
        if (set(place(y, end - sense * by)).value < -noise_) return end - sense * by;
      }
      return sense * -kInfinity;
    };
    out.to = inner(top.t, 1);
    out.from = inner(bottom.t, -1);
    return out;
  }

  RunCornerPointer made(const RunLine& y, const std::vector<int>& sets) {
    auto out = std::make_shared<RunCorner>();
    out->at = y;
    out->chords.resize(query_.sets.size());
    for (const int k : sets) out->chords[at(k)] = chord(query_.sets[at(k)], y);
    offer(*out, sets);
    return out;
  }

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  void offer(const RunCorner& corner, const std::vector<int>& sets) {
    std::vector<std::pair<double, double>> stretches;
    for (const int k : sets) {
      const RunChord& c = corner.chords[at(k)];
      if (query_.between ? c.met() : c.inside())
        stretches.push_back(query_.between ? std::pair(c.outer_from, c.outer_to) : std::pair(c.from, c.to));
    }
    if (stretches.empty()) return;
    std::sort(stretches.begin(), stretches.end());
    double from = stretches[0].first, to = stretches[0].second;
    const auto take = [&](double a, double b) {
      if (b - a <= best_.length) return;
      best_.length = b - a;
      best_.middle = place(corner.at, a + (b - a) / 2);
    };
    for (const auto& [a, b] : stretches) {
      if (a >= to && query_.between) take(to, a);
      if (a >= to) from = a;
      to = std::max(to, b);
      if (!query_.between) take(from, to);
    }
  }

  void divide(const RunTriangle& cell) {
    if (cell.bound.value <= best_.length) return;
    if (cell.longest <= 4 * noise_) {
      dropped_ = std::max(dropped_, cell.bound.value);
      return;
    }
    try_line(cell);
    std::size_t across = 0;
    while (edge(cell.corners, across) < cell.longest) ++across;
    const RunCornerPointer &top = cell.corners[across], &a = cell.corners[(across + 1) % 3],
                           &b = cell.corners[(across + 2) % 3];
    const RunCornerPointer middle = made({(a->at[0] + b->at[0]) / 2, (a->at[1] + b->at[1]) / 2}, cell.sets);
    add({top, a, middle}, cell.sets, cell.bound.value);
    add({top, b, middle}, cell.sets, cell.bound.value);
  }

  /// The line that the bound is taken on, which may pass a corner of the positions, and two a little aside.
  void try_line(const RunTriangle& cell) {
    for (const double aside : {0.0, kAside, kAside * kAside}) {
      RunLine y{};
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = cell.bound.weights[c] + aside * (1.0 / 3 - cell.bound.weights[c]);
        for (std::size_t k = 0; k < 2; ++k) y[k] += weight * cell.corners[c]->at[k];
      }
      made(y, cell.sets);
    }
  }

  /// The side that is across from a corner.
  static double edge(const std::array<RunCornerPointer, 3>& corners, std::size_t k) {
    return apart_of(*corners[(k + 1) % 3], *corners[(k + 2) % 3]);
  }

  static double apart_of(const RunCorner& a, const RunCorner& b) {
    return std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]);
  }

  void add(const std::array<RunCornerPointer, 3>& corners, const std::vector<int>& sets, double bound) {
    RunTriangle cell{corners, sets, {}, 0, std::max({edge(corners, 0), edge(corners, 1), edge(corners, 2)})};
    std::erase_if(cell.sets, [&](int k) { return passes(cell, k); });
    cell.bound = query_.between ? between(cell) : within(cell);
    cell.bound.value = std::min({cell.bound.value, bound, ends_[2][1] - ends_[2][0]});
    cell.rank = std::ceil(cell.bound.value / enough());
    if (cell.bound.value > best_.length) queue_.push(std::move(cell));
  }

  /// No line of the triangle meets the set.
  static bool passes(const RunTriangle& cell, int k) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double far = std::max(apart_of(*cell.corners[c], *cell.corners[(c + 1) % 3]),
                                  apart_of(*cell.corners[c], *cell.corners[(c + 2) % 3]));
      if (cell.corners[c]->chords[at(k)].apart > far * margin::kUpward) return true;
    }
    return false;
  }

  /// Heights that a set lies between, at the corners.
  struct Heights {
    std::vector<RunValues> below, above;
  };
  static void keep_nearest(std::vector<RunValues>& heights, double sense) {
    const auto mean = [&](const RunValues& v) { return sense * (v[0] + v[1] + v[2]); };
    std::sort(heights.begin(), heights.end(),
              [&](const RunValues& a, const RunValues& b) { return mean(a) < mean(b); });
    if (heights.size() > kMostHeights) heights.resize(kMostHeights);
  }
  static Heights heights(const RunTriangle& cell, int k) {
    Heights out;
    const auto add = [&](const std::vector<RunHeight>& all, std::vector<RunValues>& to) {
      for (const RunHeight& h : all)
        to.push_back({h.at(cell.corners[0]->at), h.at(cell.corners[1]->at), h.at(cell.corners[2]->at)});
    };
    for (const RunCornerPointer& corner : cell.corners) {
      add(corner->chords[at(k)].below, out.below);
      add(corner->chords[at(k)].above, out.above);
    }
    keep_nearest(out.below, -1);
    keep_nearest(out.above, 1);
    return out;
  }

  /// Whether some line of the triangle may have a place of the one that is not above one of the other.
  static bool reaches(const Heights& a, const Heights& b) {
    for (const RunValues& up : a.above) {
      for (const RunValues& down : b.below) {
        if (most_of(less(up, down)) < 0) return false;
      }
    }
    return true;
  }

  /// Of stretches within the union: sets that may meet on some line are taken to meet on all.
  RunBound within(RunTriangle& cell) const {
    std::vector<Heights> sets;
    std::vector<int> kept;
    for (const int k : cell.sets) {
      Heights h = heights(cell, k);
      if (!reaches(h, h)) continue;
      kept.push_back(k);
      sets.push_back(std::move(h));
    }
    cell.sets = kept;
    std::vector<std::size_t> group(sets.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (std::size_t i = 0; i < sets.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (group[i] == group[k] || !reaches(sets[i], sets[k]) || !reaches(sets[k], sets[i])) continue;
        std::replace(group.begin(), group.end(), std::size_t(group[i]), std::size_t(group[k]));
      }
    }
    RunBound bound;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      for (std::size_t k = 0; k < sets.size(); ++k) {
        if (group[i] == group[k]) take(longest(sets[k].below, sets[i].above, bound.value), bound);
      }
    }
    return bound;
  }

  static void take(const RunBound& next, RunBound& bound) {
    if (next.value > bound.value) bound = next;
  }

  /// From the highest of some heights to the lowest of others, if that is more than `least`.
  RunBound longest(const std::vector<RunValues>& from, const std::vector<RunValues>& to, double least) const {
    std::vector<RunValues> columns;
    for (const RunValues& b : to) {
      for (const RunValues& a : from) {
        columns.push_back(less(b, a));
        if (most_of(columns.back()) <= std::max(least, best_.length)) return {most_of(columns.back())};
      }
    }
    return columns.empty() ? RunBound{kInfinity} : most_of_least(columns);
  }

  /// Of stretches between the sets: those that are met by all lines of the triangle are above the stretch or below it.
  RunBound between(const RunTriangle& cell) const {
    struct Blocking {
      RunValues from, to;  // all lines of the triangle are in the set between these
      Heights heights;
    };
    std::vector<Blocking> sets;
    for (const int k : cell.sets) {
      const auto chord_of = [&](std::size_t c) -> const RunChord& { return cell.corners[c]->chords[at(k)]; };
      if (!chord_of(0).inside() || !chord_of(1).inside() || !chord_of(2).inside()) continue;
      sets.push_back({{chord_of(0).from, chord_of(1).from, chord_of(2).from},
                      {chord_of(0).to, chord_of(1).to, chord_of(2).to},
                      heights(cell, k)});
    }
    if (sets.empty()) return {kInfinity};
    // Stretches that no set is below, then those just above each set.
    std::vector<RunValues> lowest;
    const double bottom = ends_[2][0];
    for (const Blocking& s : sets) lowest.push_back(less(s.from, {bottom, bottom, bottom}));
    RunBound bound = most_of_least(lowest);
    for (const Blocking& last : sets) take(above(last, sets), bound);
    return bound;
  }

  template <class Blocking>
  RunBound above(const Blocking& last, const std::vector<Blocking>& sets) const {
    const double top = ends_[2][1];
    std::vector<RunValues> from{last.to}, to{{top, top, top}};
    for (const Blocking& s : sets) {
      if (&s == &last) continue;
      const bool can_follow = most_of(less(s.from, last.to)) > 0;
      const bool can_end_before = std::all_of(last.heights.above.begin(), last.heights.above.end(),
                                              [&](const RunValues& h) { return most_of(less(h, s.to)) >= 0; });
      if (!can_follow && !can_end_before) return {};
      if (!can_end_before) to.push_back(s.from);
      if (!can_follow) from.push_back(s.to);
    }
    std::vector<RunValues> columns;
    for (const RunValues& b : to) {
      for (const RunValues& a : from) columns.push_back(less(b, a));
    }
    return most_of_least(columns);
  }

  static constexpr int kMostSteps = 60;
  static constexpr std::size_t kMostHeights = 6;
  static constexpr double kAside = 1.0 / 4096;  // no sign: lines that are tried

  const RoundRunQuery& query_;
  Vector unit_, first_, second_;
  double size_ = 0, noise_ = 0, dropped_ = 0;
  std::array<std::array<double, 2>, 3> ends_{
      {{kInfinity, -kInfinity}, {kInfinity, -kInfinity}, {kInfinity, -kInfinity}}};
  plane::Subdivision<RunTriangle> queue_;
  RoundRun best_;
};

}  // namespace

RoundRun longest_round_run(const RoundRunQuery& query) { return RoundRunSearch(query).run(); }

}  // namespace findspace::distance
