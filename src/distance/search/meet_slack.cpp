// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/meet_slack.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_columns.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostMeetSteps = 24;
constexpr std::size_t kFew = 6;  // sets that the place may be as deep in

/// y with w . y = first + second * t for each row, in the span of the rows, as start + t * slope.
struct Line {
  Vector start, slope;
};
struct Row {
  Vector w;
  double first, second;
};

std::optional<Line> solved(std::span<const Row> rows) {
  std::array<Vector, 3> dual;
  double det = 1;
  if (rows.size() == 1) {
    dual[0] = rows[0].w;
    det = space::dot(rows[0].w, rows[0].w);
  } else if (rows.size() == 2) {
    const Vector c = space::cross(rows[0].w, rows[1].w);
    dual[0] = space::cross(rows[1].w, c);
    dual[1] = space::cross(c, rows[0].w);
    det = space::dot(c, c);
  } else if (rows.size() == 3) {
    for (std::size_t k = 0; k < 3; ++k) dual[k] = space::cross(rows[(k + 1) % 3].w, rows[(k + 2) % 3].w);
    det = space::dot(rows[0].w, dual[0]);
  }
  if (det == 0) return std::nullopt;  // no sign: places are tested
  Line out;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    out.start = space::plus(out.start, space::scaled(rows[k].first / det, dual[k]));
    out.slope = space::plus(out.slope, space::scaled(rows[k].second / det, dual[k]));
  }
  return out;
}

class LeastSlack {
 public:
  LeastSlack(std::span<const MeetSet> sets, const Tetrahedron& about) : sets_(sets), about_(about) {
    best_.value = -exact::kInfinity;
    for (const MeetSet& set : sets_) {
      if (set.plane()) add(set, {});
      for (const Vector& v : about_) size_ = std::max(size_, std::fabs(set.beyond(v)));
    }
  }

  MeetSlack run(const Vector& start) {
    offer(start);
    touch(start);
    for (int step = 0; step < kMostMeetSteps; ++step) {
      const HighestPlace high = highest_place(columns_, about_);
      const Vector& x = high.place;
      const double bound = high.value;
      const double value = offer(x);
      if (bound - best_.value <= margin::kMeetEnough * size_ || all_planes()) break;
      finish(x, bound, bound - value, start);
      touch(x);
      touch(best_.place);
      if (bound - best_.value <= margin::kMeetEnough * size_) break;
    }
    return best_;
  }

 private:
  bool all_planes() const {
    return std::all_of(sets_.begin(), sets_.end(), [](const MeetSet& s) { return s.plane(); });
  }

  /// How deep in the set the corners are, by the tangent at x.
  void add(const MeetSet& set, const Vector& x) {
    Column c{};
    if (set.grown) {
      const Touching at = (*set.grown)(x - set.at);
      for (std::size_t v = 0; v < 4; ++v) c[v] = -at.value - space::dot(at.slope, about_[v] - x);
    } else if (!set.ball) {
      for (std::size_t v = 0; v < 4; ++v) c[v] = -set.beyond(about_[v]);
    } else {
      const Vector off = x - set.at;
      const double d = space::length(off);
      for (std::size_t v = 0; v < 4; ++v) c[v] = set.by - (d > 0 ? space::dot(off, about_[v] - set.at) / d : 0);
    }
    columns_.push_back(c);
  }

  void touch(const Vector& x) {
    for (const MeetSet& set : sets_) {
      if (!set.plane()) add(set, x);
    }
  }

  double offer(const Vector& x) {
    if (!std::isfinite(x.x + x.y + x.z)) return -exact::kInfinity;  // sets that no place is as deep in
    double least = exact::kInfinity;
    for (const MeetSet& set : sets_) least = std::min(least, -set.beyond(x));
    if (least > best_.value) best_ = {least, x};
    return least;
  }

  /// The places that are as deep in each of some sets that bound the slack near x.
  void finish(const Vector& x, double bound, double gap, const Vector& start) {
    std::vector<std::pair<double, const MeetSet*>> near;
    std::vector<MeetSet> local;
    local.reserve(2 * sets_.size());
    for (const MeetSet& set : sets_) {
      const double deep = -set.beyond(x);
      if (!set.grown) {
        near.emplace_back(deep, &set);
        continue;
      }
      for (const MeetSet& one : like(set, x)) near.emplace_back(deep, &local.emplace_back(one));
    }
    std::sort(near.begin(), near.end());
    while (near.size() > kFew || (near.size() > 1 && near.back().first > near.front().first + 4 * gap)) near.pop_back();
    starts_.assign(1, start);
    for (const auto& one : near) {
      if (one.second->ball && one.first < bound) starts_.push_back(drawn_in(*one.second, x, bound));
    }
    for (unsigned mask = 1; mask < 1u << near.size(); ++mask) {
      std::array<const MeetSet*, 4> some{};
      std::size_t count = 0;
      for (std::size_t k = 0; k < near.size() && count < 5; ++k) {
        if (!(mask >> k & 1)) continue;
        if (count < 4) some[count] = near[k].second;
        ++count;
      }
      if (count <= 4) offer_between({some.data(), count}, bound);
    }
  }

  /// Of a place that is not as deep in the ball as the bound, one that is deeper by twice what it lacks: where planes
  /// leave a thin plate, the places of the linear program are all outside the ball.
  static Vector drawn_in(const MeetSet& ball, const Vector& x, double bound) {
    const Vector off = x - ball.at;
    const double d = space::length(off), lacks = d - (ball.by - bound);
    return d > 0 ? space::plus(ball.at, space::scaled(std::max(0.0, 1 - 2 * lacks / d), off)) : x;
  }

  /// What a grown set is like at x: the half-space behind its tangent, and out of its core the ball about the nearest
  /// place of that.
  static std::vector<MeetSet> like(const MeetSet& set, const Vector& x) {
    const Touching at = (*set.grown)(x - set.at);
    if (!(space::length(at.slope) > 0)) return {};
    std::vector<MeetSet> out{{false, at.slope, at.value - space::dot(at.slope, x)}};
    if (at.value > -set.by) out.push_back({true, x - space::scaled(at.value + set.by, at.slope), set.by});
    return out;
  }

  void offer_between(std::span<const MeetSet* const> some, double bound) {
    const MeetSet* first = nullptr;
    std::array<Row, 3> rows{};
    std::size_t count = 0;
    for (const MeetSet* set : some) {
      if (set->ball && !first) first = set;
    }
    if (!first) {
      for (const Vector& from : starts_) offer_below(some, bound, from);
      return;
    }
    for (const MeetSet* set : some) {
      if (set == first) continue;
      const Vector w = set->ball ? set->at - first->at : set->at;
      if (set->ball)
        rows[count++] = {w, (space::dot(w, w) - set->by * set->by + first->by * first->by) / 2, set->by - first->by};
      else
        rows[count++] = {w, -(set->by + space::dot(w, first->at)), -1};
    }
    if (const auto line = solved({rows.data(), count})) offer_on(*first, *line);
  }

  /// The place as deep as the bound below planes that is nearest to `start`: the linear program's own is any of those.
  void offer_below(std::span<const MeetSet* const> planes, double bound, const Vector& start) {
    std::array<Row, 3> rows{};
    if (planes.size() > rows.size()) return;
    for (std::size_t k = 0; k < planes.size(); ++k) rows[k] = {planes[k]->at, -planes[k]->beyond(start) - bound, 0};
    if (const auto line = solved({rows.data(), planes.size()})) offer(space::plus(start, line->start));
  }

  /// Where the line start + t * slope from the centre is t inside the ball.
  void offer_on(const MeetSet& ball, const Line& line) {
    const double a = space::dot(line.slope, line.slope) - 1, b = space::dot(line.start, line.slope) + ball.by,
                 c = space::dot(line.start, line.start) - ball.by * ball.by, square = b * b - a * c;
    if (square < 0) return;  // no sign: a place that is not offered
    const double q = -(b + std::copysign(std::sqrt(square), b));
    for (const double t : {q / a, c / q}) {
      if (std::isfinite(t)) offer(space::plus(ball.at, space::plus(line.start, space::scaled(t, line.slope))));
    }
  }

  std::span<const MeetSet> sets_;
  const Tetrahedron& about_;
  double size_ = 0;
  std::vector<Column> columns_;
  std::vector<Vector> starts_;  // near which places below planes are offered
  MeetSlack best_;
};

}  // namespace

MeetSlack meet_slack(std::span<const MeetSet> sets, const Tetrahedron& about, const Vector& start) {
  return LeastSlack(sets, about).run(start);
}

}  // namespace findspace::distance
