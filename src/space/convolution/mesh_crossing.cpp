// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/mesh_crossing.h"

#include <algorithm>

#include "plane/base/parallel.h"
#include "space/convolution/ray_overlap.h"

namespace findspace::space {
namespace {

constexpr std::size_t kFacesAtOnce = 4096;

bool share_corner(const RayBody& body, int f, int g) {
  const auto &p = body.faces[static_cast<std::size_t>(f)], &q = body.faces[static_cast<std::size_t>(g)];
  return std::any_of(p.begin(), p.end(), [&](int v) { return std::find(q.begin(), q.end(), v) != q.end(); });
}

/// Whether edge k of face f passes through face g, inside both. One that ends at a corner of g does not.
bool pierces(const RayBody& body, int f, int k, int g) {
  const auto &ends = body.faces[static_cast<std::size_t>(f)], &other = body.faces[static_cast<std::size_t>(g)];
  const auto of_other = [&](int v) { return std::find(other.begin(), other.end(), v) != other.end(); };
  if (of_other(ends[static_cast<std::size_t>(k)]) || of_other(ends[static_cast<std::size_t>((k + 1) % 3)]))
    return false;
  const Point &p = body.corner(f, k), &q = body.corner(f, (k + 1) % 3);
  const Point &a = body.corner(g, 0), &b = body.corner(g, 1), &c = body.corner(g, 2);
  if (exact::sign_volume(a, b, c, p) * exact::sign_volume(a, b, c, q) >= 0) return false;
  const int s = exact::sign_volume(p, q, a, b);
  return s != 0 && exact::sign_volume(p, q, b, c) == s && exact::sign_volume(p, q, c, a) == s;
}

bool cross(const RayBody& body, int f, int g) {
  // Around a common corner edges and angles are those of one solid; only what passes through counts.
  if (!share_corner(body, f, g)) return faces_overlap(body, f, body, g, RayPlace{{}, {0, 1}});
  for (int k = 0; k < 3; ++k) {
    if (pierces(body, f, k, g) || pierces(body, g, k, f)) return true;
  }
  return false;
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
