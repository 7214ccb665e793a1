// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/hull_wrap.h"

#include <optional>
#include <utility>

namespace findspace::plane {
namespace {

using exact::Real;

/// Does the line of support, turning counter-clockwise from direction `from`, take direction p before q? -1, 0, +1.
int compare_turn(const RealVector& from, const RealVector& p, const RealVector& q) {
  auto half = [&](const RealVector& d) {
    int side = cross(from, d).sign();
    return side > 0 || (side == 0 && dot(from, d).sign() > 0) ? 0 : 1;
  };
  int hp = half(p), hq = half(q);
  return hp != hq ? hp - hq : -cross(p, q).sign();
}

/// Is u in the arc's directions, its last one left out?
bool sweeps(const HullElement& e, const RealVector& u) {
  if (!e.arc()) return true;
  int from_low = cross(e.low, u).sign();
  if (from_low == 0) return dot(e.low, u).sign() > 0;
  return from_low > 0 && cross(u, e.high).sign() > 0;
}

/// The common line of support on which the rolling line passes from one element to the other.
struct Contact {
  std::size_t element;
  RealVector direction;      // of travel, any length
  RealVector leaves, meets;  // places on both elements
  bool smooth;               // the same place
};

class Wrapping {
 public:
  Wrapping(const std::vector<HullElement>& elements, std::size_t corners) : elements_(elements), corners_(corners) {}

  std::vector<HullCurve> run() {
    if (elements_.size() < 2) return {};
    std::size_t at = 0;
    RealVector direction{Real(0), Real(-1)}, place = elements_[0].center;
    do {
      Contact next = contact_after(at, direction);
      // Where the line rolls on an arc, it moves along it; the place of a corner is the corner.
      if (elements_[at].arc() && !(next.leaves == place)) curves_.push_back({place, at, {}});
      if (!next.smooth) curves_.push_back({next.leaves, HullCurve::kSide, next.direction});
      place = std::move(next.meets);
      direction = std::move(next.direction);
      at = next.element;
    } while (curves_.empty() || !(place == elements_[0].center));
    return std::move(curves_);
  }

 private:
  Contact contact_after(std::size_t at, const RealVector& direction) const {
    std::optional<Contact> best;
    auto see = [&](std::size_t k) {
      std::optional<Contact> c = contact(at, k);
      if (c && (!best || better(direction, *c, *best))) best = std::move(c);
    };
    if (!elements_[at].arc() && corners_ > 1) see(at + 1 == corners_ ? 0 : at + 1);  // of all corners, only the next
    for (std::size_t k = elements_[at].arc() ? 0 : corners_; k < elements_.size(); ++k) see(k);
    return *best;  // there always is one: the end of an arc, the next corner, or an arc that begins at the only corner
  }

  /// The line with both circles on its left, which touches first `at` and then k.
  std::optional<Contact> contact(std::size_t at, std::size_t k) const {
    const HullElement &g = elements_[at], &h = elements_[k];
    if (k == at) return std::nullopt;
    // A normal u of length 1 with w.u = s has the same line of support at both.
    RealVector w = h.center - g.center;
    Real s = g.radius - h.radius, length2 = dot(w, w);
    int tolerance = compare(length2, s * s);
    if (length2.sign() == 0 || tolerance < 0) return std::nullopt;
    Real root = tolerance == 0 ? Real(0) : sqrt(length2 - s * s);
    bool parallel = s.sign() == 0;  // the line is parallel to w
    RealVector normal = parallel ? right_normal(w) : s * w - root * left_normal(w);
    RealVector direction = left_normal(normal);
    if (!sweeps(h, normal)) return std::nullopt;
    if (g.arc() && !sweeps(g, normal) && !is_end(g, normal)) return std::nullopt;
    // A smaller circle inside that of `at` takes over only where the arc ends.
    if (tolerance == 0 && s.sign() > 0 && !is_end(g, normal)) return std::nullopt;
    Contact c{k, std::move(direction), g.center, h.center, tolerance == 0};
    RealVector unit = (Real(1) / (parallel ? root : length2)) * normal;
    if (tolerance == 0 && !h.arc())
      c.leaves = h.center;
    else if (g.arc())
      c.leaves = g.center + g.radius * unit;
    if (tolerance == 0)
      c.meets = c.leaves;
    else if (h.arc())
      c.meets = h.center + h.radius * unit;
    return c;
  }

  static bool is_end(const HullElement& e, const RealVector& u) {
    return cross(e.high, u).sign() == 0 && dot(e.high, u).sign() > 0;
  }

  /// The one met first; on one line the last along it; at one place the largest circle, which is ahead after that.
  bool better(const RealVector& from, const Contact& c, const Contact& d) const {
    int turn = compare_turn(from, c.direction, d.direction);
    if (turn != 0) return turn < 0;
    int ahead = dot(c.meets - d.meets, c.direction).sign();
    if (ahead != 0) return ahead > 0;
    return compare(elements_[c.element].radius, elements_[d.element].radius) > 0;
  }

  const std::vector<HullElement>& elements_;
  std::size_t corners_;
  std::vector<HullCurve> curves_;
};

}  // namespace

std::vector<HullCurve> wrap(const std::vector<HullElement>& elements, std::size_t corners) {
  return Wrapping(elements, corners).run();
}

}  // namespace findspace::plane
