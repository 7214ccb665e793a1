// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/mesh_crossing.h"

#include <algorithm>

#include "plane/base/parallel.h"
#include "space/convolution/ray_overlap.h"

namespace findspace::space {
namespace {

constexpr std::size_t kFacesAtOnce = 4096;

/// How many corners two faces share, and where the last of them is in each.
struct SharedCorners {
  int count = 0, in_f = 0, in_g = 0;
};

SharedCorners shared_corners(const RayBody& body, int f, int g) {
  const auto &p = body.faces[static_cast<std::size_t>(f)], &q = body.faces[static_cast<std::size_t>(g)];
  SharedCorners out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (p[static_cast<std::size_t>(i)] == q[static_cast<std::size_t>(j)]) out = {out.count + 1, i, j};
  return out;
}

/// Whether the boxes of a segment and of a triangle are apart.
bool apart(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  const auto along = [&](std::int64_t Point::*axis) {
    const std::int64_t least = std::min({a.*axis, b.*axis, c.*axis}), most = std::max({a.*axis, b.*axis, c.*axis});
    return std::max(p.*axis, q.*axis) < least || std::min(p.*axis, q.*axis) > most;
  };
  return along(&Point::x) || along(&Point::y) || along(&Point::z);
}

/// Whether the side of face f that is opposite to its corner k passes through face g, inside both. It ends at no corner
/// of g.
bool pierces(const RayBody& body, int f, int k, int g) {
  const Point &p = body.corner(f, (k + 1) % 3), &q = body.corner(f, (k + 2) % 3);
  const Point &a = body.corner(g, 0), &b = body.corner(g, 1), &c = body.corner(g, 2);
  if (apart(p, q, a, b, c)) return false;
  if (exact::sign_volume(a, b, c, p) * exact::sign_volume(a, b, c, q) >= 0) return false;
  const int s = exact::sign_volume(p, q, a, b);
  return s != 0 && exact::sign_volume(p, q, b, c) == s && exact::sign_volume(p, q, c, a) == s;
}

bool cross(const RayBody& body, int f, int g) {
  const SharedCorners shared = shared_corners(body, f, g);
  if (shared.count == 0) return faces_overlap(body, f, body, g, RayPlace{{}, {0, 1}});
  // Around a common corner edges and angles are those of one solid. Only what passes through counts: the side opposite
  // to a single one.
  return shared.count == 1 && (pierces(body, f, shared.in_f, g) || pierces(body, g, shared.in_g, f));
}

}  // namespace

std::optional<std::array<int, 2>> crossing_faces(const RayBody& body) {
  const BoxTree tree(body);
  const std::size_t faces = body.faces.size();
  std::vector<int> other(faces, -1);
  plane::parallel_for((faces + kFacesAtOnce - 1) / kFacesAtOnce, [&](std::size_t block) {
    for (std::size_t f = block * kFacesAtOnce; f < std::min(faces, (block + 1) * kFacesAtOnce); ++f) {
      const int face = static_cast<int>(f);
      GridBox box{body.corner(face, 0), body.corner(face, 0)};
      for (int k = 1; k < 3; ++k) {
        const Point& p = body.corner(face, k);
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
      }
      int least = -1;
      tree.any_meeting(box, [&](int g) {
        if (g > face && (least < 0 || g < least) && cross(body, face, g)) least = g;
        return false;
      });
      other[f] = least;
    }
  });
  for (std::size_t f = 0; f < faces; ++f) {
    if (other[f] >= 0) return std::array<int, 2>{static_cast<int>(f), other[f]};
  }
  return std::nullopt;
}

}  // namespace findspace::space
