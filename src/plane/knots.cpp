// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/knots.h"

#include <algorithm>

namespace findspace::plane {
namespace {

/// Where an arm points, seen from another one.
enum Turn { kRight = 1, kBack = 2, kLeft = 3, kSame = 4 };

int cross_sign(const Arm& p, const Arm& q) {
  const exact::int128 cross = exact::int128(p.dx) * q.dy - exact::int128(p.dy) * q.dx;
  return (cross > 0) - (cross < 0);
}

Turn turn(const Arm& from, const Arm& to) {
  if (const int s = cross_sign(from, to); s != 0) return s < 0 ? kRight : kLeft;
  const bool same = from.dx != 0 ? (from.dx > 0) == (to.dx > 0) : (from.dy > 0) == (to.dy > 0);
  return same ? kSame : kBack;
}

/// Is p passed before q, turning clockwise from another arm?
bool comes_first(const Arm& from, const Arm& p, const Arm& q) {
  const Turn u = turn(from, p), v = turn(from, q);
  if (u != v) return u < v;
  const int s = cross_sign(p, q);
  return s != 0 ? s < 0 : p.starts && !q.starts;  // of two on one line, the one that shows an inner side
}

}  // namespace

Index& Knots::parent(Index point) {
  if (point >= knot_of_.size()) knot_of_.resize(std::max<std::size_t>(point + 1, points_), kNone);
  Index& knot = knot_of_[point];
  if (knot == kNone) same_.push_back(knot = Index(same_.size()));
  while (same_[knot] != knot) knot = same_[knot] = same_[same_[knot]];
  return same_[knot];
}

void Knots::make(Index point) { parent(point); }

void Knots::tie(Index p, Index q) {
  parent(q);  // may move the other one
  Index &u = parent(p), &v = parent(q);
  if (u < v)
    v = u;
  else
    u = v;
}

void Knots::settle(std::size_t points) {
  if (empty()) return;
  knot_of_.resize(points, kNone);
  for (Index k = 0; k < same_.size(); ++k) same_[k] = same_[k] == k ? count_++ : same_[same_[k]];
  for (Index& knot : knot_of_)
    if (knot != kNone) knot = same_[knot];
}

void Knots::group_arms() {
  first_arm_.assign(count_ + 1, 0);
  for (const Arm& arm : arms_) ++first_arm_[arm.knot + 1];
  for (Index k = 0; k < count_; ++k) first_arm_[k + 1] += first_arm_[k];
  std::pmr::vector<Index> at(first_arm_.begin(), first_arm_.end() - 1, memory_);
  std::pmr::vector<Arm> grouped(arms_.size(), Arm{}, memory_);
  for (const Arm& arm : arms_) grouped[at[arm.knot]++] = arm;
  arms_.swap(grouped);
}

const Arm& Knots::clockwise(Index knot, Index curve, Index slot) const {
  const auto all = arms(knot);
  const Arm& from = *std::find_if(all.begin(), all.end(),
                                  [&](const Arm& a) { return a.starts && a.curve == curve && a.slot == slot; });
  const Arm* best = nullptr;
  for (const Arm& arm : all)
    if (&arm != &from && (!best || comes_first(from, arm, *best))) best = &arm;
  return *best;
}

bool Knots::is_surrounded(Index knot) const {
  // A curve hides the half plane on its left. Some direction is left over if and only if the ways of the curves lie in
  // an open half plane: then there is one among them with none of the others to its right or straight behind it.
  const auto all = arms(knot);
  auto way = [](Arm a) {
    if (!a.starts) a.dx = -a.dx, a.dy = -a.dy;
    return a;
  };
  for (const Arm& a : all) {
    if (!a.hides) continue;
    const Arm first = way(a);
    const bool alone = std::all_of(all.begin(), all.end(), [&](const Arm& b) {
      if (!b.hides) return true;
      const Turn t = turn(first, way(b));
      return t == kLeft || t == kSame;
    });
    if (alone) return false;
  }
  return std::any_of(all.begin(), all.end(), [](const Arm& a) { return a.hides; });
}

}  // namespace findspace::plane
