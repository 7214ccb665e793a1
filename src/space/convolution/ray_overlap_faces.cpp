// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/face_overlap.h"
#include "space/convolution/ray_overlap.h"

namespace findspace::space {

bool faces_overlap(const RayBody& a, int f, const RayBody& b, int g, const RayPlace& p) {
  return faces::overlap<exact::RaisedPoint>(a, f, b, g, p.whole, p.by);
}

bool faces_back_to_back(const RayBody& body, int f, int g) {
  const Approx3 &n = body.normal_approx[static_cast<std::size_t>(f)],
                &m = body.normal_approx[static_cast<std::size_t>(g)];
  if (n.x * m.x + n.y * m.y + n.z * m.z >= 0) return false;
  for (int k = 0; k < 3; ++k) {
    if (exact::sign_volume(body.corner(f, 0), body.corner(f, 1), body.corner(f, 2), body.corner(g, k)) != 0)
      return false;
  }
  using Spot = exact::RaisedPoint;
  const faces::Placed<Spot> first(body, f, {}, false), second(body, g, {}, false);
  return faces::overlap_in_plane(faces::Pair<Spot, exact::Fraction>{first, second, {0, 1}, {}, {}});
}

}  // namespace findspace::space
