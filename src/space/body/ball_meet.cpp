// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/ball_meet.h"

#include <algorithm>
#include <cassert>

namespace findspace::space {

using exact::Real;

namespace {

double distance(const RealVector& a, const RealVector& b) {
  const RealVector off = minus(a, b);
  return std::sqrt(dot(off, off).to_double());
}

}  // namespace

bool BallMeet::holds(int ball, const RealVector& p) const {
  const RealVector off = minus(p, balls_[ball].center);
  return balls_[ball].radius.sign() >= 0 && !(balls_[ball].radius * balls_[ball].radius < dot(off, off));
}

bool BallMeet::holds(const RealVector& p) const {
  for (int i = 0; i < static_cast<int>(balls_.size()); ++i) {
    if (!holds(i, p)) return false;
  }
  return true;
}

/// Of at most four balls: the nearest common point, and the spheres it was found on.
std::optional<RealVector> BallMeet::nearest_of(const std::vector<int>& few, const RealVector& p,
                                               std::vector<int>& basis) const {
  std::optional<RealVector> best;
  double least = exact::kInfinity;
  const int n = static_cast<int>(few.size());
  for (int set = 0; set < (1 << n); ++set) {
    std::vector<Ball> on;
    std::vector<int> ids;
    for (int i = 0; i < n; ++i) {
      if (set >> i & 1) {
        on.push_back(balls_[few[i]]);
        ids.push_back(few[i]);
      }
    }
    for (const RealVector& q : name_places({}, on, p)) {
      const double d = distance(q, p);
      if (d >= least) continue;
      const bool common = std::all_of(few.begin(), few.end(), [&](int i) {
        return std::find(ids.begin(), ids.end(), i) != ids.end() ? balls_[i].radius.sign() >= 0 : holds(i, q);
      });
      if (!common) continue;
      least = d;
      best = q;
      basis = ids;
    }
  }
  return best;
}

std::optional<RealVector> BallMeet::nearest(const RealVector& p) const {
  std::vector<int> basis;
  std::optional<RealVector> q = p;
  while (true) {
    // The ball from which q protrudes most. Those q was found on hold it.
    int worst = -1;
    double most = 0;
    for (int i = 0; i < static_cast<int>(balls_.size()); ++i) {
      if (std::find(basis.begin(), basis.end(), i) != basis.end() || holds(i, *q)) continue;
      const double out = distance(*q, balls_[i].center) - balls_[i].radius.to_double();
      if (worst < 0 || out > most) {
        most = out;
        worst = i;
      }
    }
    if (worst < 0) return q;
    std::vector<int> few = basis;
    few.push_back(worst);
    q = nearest_of(few, p, basis);
    if (!q) return std::nullopt;
  }
}

namespace {

/// A point on up to three spheres, given by their numbers.
struct Candidate {
  double distance = 0;
  RealVector at;
  std::vector<int> on;
  bool is_on(int ball) const { return std::find(on.begin(), on.end(), ball) != on.end(); }
};

/// Where the distance from p is extreme on one, two or three of the spheres, the least first.
std::vector<Candidate> candidates(const std::vector<Ball>& balls, const RealVector& p) {
  assert(balls.size() <= BallMeet::kMostBalls);
  std::vector<Candidate> found;
  const auto look = [&](const std::vector<int>& ids) {
    std::vector<Ball> on;
    for (const int i : ids) on.push_back(balls[std::size_t(i)]);
    for (RealVector& q : name_places({}, on, p)) found.push_back({distance(q, p), std::move(q), ids});
  };
  const int n = static_cast<int>(balls.size());
  for (int i = 0; i < n; ++i) {
    look({i});
    for (int j = i + 1; j < n; ++j) {
      look({i, j});
      for (int k = j + 1; k < n; ++k) look({i, j, k});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  return found;
}

}  // namespace

std::optional<RealVector> BallMeet::farthest(const RealVector& p) const {
  const std::vector<Candidate> found = candidates(balls_, p);
  for (auto c = found.rbegin(); c != found.rend(); ++c) {
    bool common = true;
    for (int i = 0; common && i < static_cast<int>(balls_.size()); ++i)
      common = c->is_on(i) ? balls_[std::size_t(i)].radius.sign() >= 0 : holds(i, c->at);
    if (common) return c->at;
  }
  return std::nullopt;
}

std::optional<RealVector> nearest_outside(const std::vector<Ball>& balls, const RealVector& p) {
  const auto free = [&](const RealVector& q, const Candidate* c) {
    for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
      if (c != nullptr && c->is_on(i)) continue;
      const RealVector off = minus(q, balls[std::size_t(i)].center);
      if (dot(off, off) < balls[std::size_t(i)].radius * balls[std::size_t(i)].radius) return false;
    }
    return true;
  };
  if (free(p, nullptr)) return p;
  for (const Candidate& c : candidates(balls, p)) {
    if (free(c.at, &c)) return c.at;
  }
  return std::nullopt;
}

}  // namespace findspace::space
