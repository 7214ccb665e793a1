// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/phi_union.h"

#include <findspace/error.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace findspace::space {

double PhiUnion::Pair::at_least(const Vector& u) const {
  return std::max({low.x - u.x, u.x - high.x, low.y - u.y, u.y - high.y, low.z - u.z, u.z - high.z});
}

PhiUnion::PhiUnion(std::span<const Polytope> a, std::span<const Polytope> b) {
  if (a.empty() || b.empty()) throw Error(ErrorCode::kGeometry, "a union of polytopes needs at least one part");
  for (const Polytope& p : a) {
    for (const Polytope& q : b) {
      Pair pair{PhiFunction(p, q), {}, {}};
      pair.low = pair.high = pair.phi.vertex(0);
      for (int v = 1; v < pair.phi.surface().vertex_count(); ++v) {
        const Vector& w = pair.phi.vertex(v);
        pair.low = {std::min(pair.low.x, w.x), std::min(pair.low.y, w.y), std::min(pair.low.z, w.z)};
        pair.high = {std::max(pair.high.x, w.x), std::max(pair.high.y, w.y), std::max(pair.high.z, w.z)};
      }
      pairs_.push_back(std::move(pair));
    }
  }
}

// The box bounds the distance from below, but not the max form (phi.md 2.3), so that asks every pair.
double PhiUnion::max_form(const Vector& u) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs_) least = std::min(least, pair.phi.max_form(u));
  return least;
}

double PhiUnion::normalised(const Vector& u) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs_) {
    if (pair.at_least(u) < least) least = std::min(least, pair.phi.normalised(u));
  }
  return least;
}

int PhiUnion::sign(const Vector& u) const {
  int least = 1;
  for (const Pair& pair : pairs_) {
    if (pair.at_least(u) > 0) continue;
    least = std::min(least, pair.phi.sign(u));
    if (least < 0) break;
  }
  return least;
}

Vector PhiUnion::gradient(const Vector& u) const {
  const auto lowest = std::min_element(pairs_.begin(), pairs_.end(), [&](const Pair& p, const Pair& q) {
    return p.phi.max_form(u) < q.phi.max_form(u);
  });
  return lowest->phi.gradient(u);
}

void PhiUnion::evaluate(std::span<const Vector> at, std::span<double> values) const {
  std::vector<double> one(at.size());
  std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at.size()),
            std::numeric_limits<double>::infinity());
  for (const Pair& pair : pairs_) {
    pair.phi.evaluate(at, one);
    for (std::size_t i = 0; i < at.size(); ++i) values[i] = std::min(values[i], one[i]);
  }
}

PhiUnion::At PhiUnion::at(const RealVector& u) const {
  At best{phi_at(pairs_[0].phi, u), 0};
  double distance = best.at.distance;
  for (int k = 1; k < pair_count(); ++k) {
    PhiAt here = phi_at(pairs_[k].phi, u);
    distance = std::min(distance, here.distance);
    // States order overlap < contact < apart; next to contact they are the exact part of the comparison.
    if (here.state < best.at.state || (here.state == best.at.state && here.max_form < best.at.max_form))
      best = {std::move(here), k};
  }
  best.at.distance = distance;
  return best;
}

int PhiUnion::sign_at(const RealVector& u) const {
  int least = 1;
  for (const Pair& pair : pairs_) {
    least = std::min(least, space::sign_at(pair.phi, u));
    if (least < 0) break;
  }
  return least;
}

exact::Real PhiUnion::squared_distance(const RealVector& u) const {
  std::optional<exact::Real> best;
  for (const Pair& pair : pairs_) {
    const exact::Real d = space::squared_distance(pair.phi, u);
    if (!best || d < *best) best = d;
  }
  return *best;
}

}  // namespace findspace::space
