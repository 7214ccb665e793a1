// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_overlap.h"

namespace findspace::space {
namespace {

using exact::Fraction;
using exact::RaisedPoint;

int128 floor_quotient(const Fraction& f) {
  const int128 q = f.numerator / f.denominator;
  return q - (f.numerator % f.denominator < 0 ? 1 : 0);
}

/// The body's corner, times 3 and moved by `by`: one frame for a centroid, which is a third of a sum of corners.
struct Probe {
  const RayBody& body;
  const BoxTree& tree;
  Point shift;       // three times the position of the body
  bool body_raised;  // whether the body's points carry the fraction, or the probing point does
  Fraction by;

  RaisedPoint corner(int f, int k) const {
    const Point& c = body.corner(f, k);
    return {{3 * c.x + shift.x, 3 * c.y + shift.y, 3 * c.z + shift.z}, body_raised};
  }

  /// Whether q lies on the closed triangle, given that it lies in its plane.
  bool on_face(int f, const RaisedPoint& q) const {
    const RaisedPoint c[3] = {corner(f, 0), corner(f, 1), corner(f, 2)};
    const Wide3& n = body.normals[f];
    const int axis = n.x != 0 ? 0 : n.y != 0 ? 1 : 2;
    const int sense = exact::sign(axis == 0 ? n.x : axis == 1 ? n.y : n.z);
    for (int k = 0; k < 3; ++k) {
      if (exact::sign_turn(c[k], c[(k + 1) % 3], q, axis, by) * sense < 0) return false;
    }
    return true;
  }

  /// Whether q lies in the interior: the sum over the faces above it, + for those that look up; not if it lies on a
  /// face.
  bool inside(const RaisedPoint& q, bool inside_out) const {
    int sum = inside_out ? 1 : 0;
    const auto third = [](std::int64_t c, bool up) { return c / 3 + (up ? 1 : -1); };
    const Point at = q.at - shift;
    const GridBox column{{third(at.x, false), third(at.y, false), third(at.z, false) - 1},
                         {third(at.x, true), third(at.y, true), std::int64_t{1} << 45}};
    const bool on = tree.any_meeting(column, [&](int f) {
      const RaisedPoint a = corner(f, 0), b = corner(f, 1), c = corner(f, 2);
      const int side = exact::sign_volume(a, b, c, q, by);
      if (side == 0 && on_face(f, q)) return true;
      const int look = exact::sign(body.normals[f].z);
      if (look == 0 || side != -look) return false;
      const auto left = [&](const RaisedPoint& p, const RaisedPoint& r) {
        return exact::sign_turn_displaced(p.at, r.at, q.at.x, q.at.y) == look;
      };
      if (left(a, b) && left(b, c) && left(c, a)) {
        sum += look;
      }
      return false;
    });
    return !on && sum > 0;
  }
};

Point sum_of_corners(const RayBody& body, int f) { return body.corner(f, 0) + body.corner(f, 1) + body.corner(f, 2); }

}  // namespace

RayPlace ray_place(std::int64_t x, std::int64_t y, const Fraction& z) {
  const int128 whole = floor_quotient(z);
  return {{x, y, static_cast<std::int64_t>(whole)}, {z.numerator - whole * z.denominator, z.denominator}};
}

bool RayOverlap::interiors_meet(const RayPlace& p, Recent& recent) const {
  constexpr std::size_t kRemembered = 8;
  auto& pairs = recent.pairs;
  for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
    if (!faces_overlap(a_, (*pair)[0], b_, (*pair)[1], p)) continue;
    std::rotate(pairs.begin(), pair, pair + 1);
    return true;
  }
  const Point beyond{0, 0, p.by.numerator != 0 ? 1 : 0};
  const bool found = any_pair(a_tree_, b_tree_, p.whole, beyond, [&](int f, int g) {
    if (!faces_overlap(a_, f, b_, g, p)) return false;
    if (pairs.size() == kRemembered) pairs.pop_back();
    pairs.insert(pairs.begin(), {f, g});
    return true;
  });
  return found || pieces_inside(p);
}

bool RayOverlap::pieces_inside(const RayPlace& p) const {
  // Everything times 3: B stands at 3 p.
  const RayPlace triple =
      ray_place(3 * p.whole.x, 3 * p.whole.y, {(p.by.denominator * p.whole.z + p.by.numerator) * 3, p.by.denominator});
  const Probe in_b{b_, b_tree_, triple.whole, true, triple.by}, in_a{a_, a_tree_, {}, false, triple.by};
  for (const int f : a_.first_face) {
    if (in_b.inside({sum_of_corners(a_, f), false}, false)) return true;
  }
  for (const int g : b_.first_face) {
    if (in_a.inside({sum_of_corners(b_, g) + triple.whole, true}, a_inside_out_)) return true;
  }
  return false;
}

}  // namespace findspace::space
