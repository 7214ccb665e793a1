// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/tracing.h"

#include <algorithm>

namespace findspace::plane {
namespace {

using exact::int128;
using Line = Tracing::Line;
using Turn = Tracing::Turn;

/// The turn from one step to the next; `turns`: by more than nothing.
Turn vertex_turn(const Step& in, const Step& out, bool flat, bool& turns) {
  Turn t{.center = &out.from};
  int c = cross_sign(in.end, out.start);
  turns = c != 0;
  if (c != 0) {
    t.sign = std::int8_t(c);
  } else if (dot_sign(in.end, out.start) < 0) {
    // Back along the same tangent: a cusp of the set (left turn) or of its complement, or the tip of a slit (right
    // turn). The end of a curve that is a set of its own is always passed on the left.
    t.half_turn = turns = true;
    t.sign = flat || compare_curvature(in.reversed(), out) > 0 ? 1 : -1;
  }
  return t;
}

Turn arc_turn(const Step& s) { return {.center = &s.center, .arc = &s, .sign = std::int8_t(s.ccw ? 1 : -1)}; }

Line empty_line(const Direction& d, const Position& p) { return {&d, &p, &p, true}; }

/// A point by itself (+1), or one missing from its surroundings (-1).
Tracing around_point(const Position& p, std::int8_t sign) {
  static const Direction east{1, 0, nullptr}, west{-1, 0, nullptr};
  Turn half{.center = &p, .sign = sign, .half_turn = true};
  return {.lines = {empty_line(east, p), empty_line(west, p)}, .turns = {half, half}, .sorted = {}};
}

}  // namespace

Tracing Tracing::from(const Path& path, bool flat) {
  if (path.lonely) return around_point(*path.lonely, flat ? 1 : -1);
  Tracing out;
  const auto& steps = path.steps;
  out.lines.reserve(steps.size() + 1);
  out.turns.reserve(steps.size() + 1);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step &s = steps[k], &n = steps[k + 1 == steps.size() ? 0 : k + 1];
    if (s.arc) {
      if (out.lines.size() == out.turns.size()) out.lines.push_back(empty_line(s.start, s.from));
      out.turns.push_back(arc_turn(s));
    } else {
      out.lines.push_back({&s.start, &s.from, &s.to});
    }
    bool turns;
    Turn t = vertex_turn(s, n, flat, turns);
    if (turns || (!s.arc && !n.arc)) {
      if (out.lines.size() == out.turns.size()) out.lines.push_back(empty_line(s.end, s.to));
      out.turns.push_back(t);
    }
  }
  if (out.lines.size() > out.turns.size())
    out.turns.push_back({.center = &steps[0].from});  // runs smoothly into the arc at the start
  return out;
}

namespace {

struct Entry {
  std::int64_t x, y;  // of a grid direction
  const Direction* direction;
  Tracing* path;
  Index line;
  std::uint8_t odd, lower;  // lower: angle in [180, 360)
  bool grid;
};

void collect(std::vector<Tracing>& paths, std::uint8_t odd, std::vector<Entry>& all) {
  for (Tracing& p : paths)
    for (Index k = 0; k < p.size(); ++k) {
      const Direction& d = *p.lines[k].direction;
      all.push_back({d.x, d.y, &d, &p, k, odd, std::uint8_t(is_lower(d)), d.grid()});
    }
}

/// compare_angle, with nothing to look up for grid directions.
int compare(const Entry& p, const Entry& q) {
  if (p.lower != q.lower) return int(p.lower) - int(q.lower);
  if (!p.grid || !q.grid) return -cross_sign(*p.direction, *q.direction);
  int128 left = int128(p.x) * q.y, right = int128(p.y) * q.x;
  return (left < right) - (left > right);
}

void set_interval(const Tracing& p, Index k, Index keys, Turn& t) {
  Index from = p.lines[k].key, to = p.lines[p.line_after(k)].key;
  t.low = t.sign > 0 ? from : to;
  Index high = t.sign > 0 ? to : from;
  t.length = high >= t.low ? high - t.low : high + keys - t.low;
}

}  // namespace

Index assign_keys(std::vector<Tracing>& a, std::vector<Tracing>& b) {
  std::vector<Entry> all;
  std::size_t count = 0;
  for (auto* side : {&a, &b})
    for (Tracing& p : *side) {
      count += p.size();
      p.sorted.reserve(p.size());
    }
  all.reserve(count);
  collect(a, 0, all);
  collect(b, 1, all);
  std::sort(all.begin(), all.end(), [](const Entry& p, const Entry& q) {
    int c = compare(p, q);
    return c != 0 ? c < 0 : p.line < q.line;  // within one path in its own order
  });
  Index rank = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k > 0 && compare(all[k - 1], all[k]) != 0) ++rank;
    Tracing& p = *all[k].path;
    Line& line = p.lines[all[k].line];
    line.key = 2 * rank + all[k].odd;
    if (line.empty) continue;
    line.place = Index(p.sorted.size());
    p.sorted.push_back(all[k].line);
  }
  Index keys = 2 * (rank + 1);
  for (auto* side : {&a, &b})
    for (Tracing& p : *side)
      for (Index k = 0; k < p.size(); ++k) set_interval(p, k, keys, p.turns[k]);
  return keys;
}

}  // namespace findspace::plane
