// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/knots.h"

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

void Knots::reserve(std::size_t arms) {
  arms_.reserve(arms);
  first_arm_.assign(count_, kNone);
}

const Arm& Knots::clockwise(Index knot, Index curve, Index slot) const {
  const Arm *from = first(knot), *best = nullptr;
  while (!from->starts || from->curve != curve || from->slot != slot) from = next(*from);
  for (const Arm* arm = first(knot); arm; arm = next(*arm))
    if (arm != from && (!best || comes_first(*from, *arm, *best))) best = arm;
  return *best;
}

bool Knots::is_surrounded(Index knot) const {
  // A curve hides the half plane on its left. Some direction is left over if and only if the ways of the curves lie in
  // an open half plane: then there is one among them with none of the others to its right or straight behind it.
  auto way = [](Arm a) {
    if (!a.starts) a.dx = -a.dx, a.dy = -a.dy;
    return a;
  };
  bool any = false;
  for (const Arm* a = first(knot); a; a = next(*a)) {
    if (!a->hides) continue;
    any = true;
    const Arm rightmost = way(*a);
    bool is_rightmost = true;
    for (const Arm* b = first(knot); b && is_rightmost; b = next(*b)) {
      const Turn t = b->hides ? turn(rightmost, way(*b)) : kSame;
      is_rightmost = t == kLeft || t == kSame;
    }
    if (is_rightmost) return false;
  }
  return any;
}

}  // namespace findspace::plane
