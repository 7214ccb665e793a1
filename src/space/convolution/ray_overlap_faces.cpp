// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/face_overlap.h"
#include "space/convolution/ray_overlap.h"

namespace findspace::space {

bool faces_overlap(const RayBody& a, int f, const RayBody& b, int g, const RayPlace& p) {
  return faces::overlap<exact::RaisedPoint>(a, f, b, g, p.whole, p.by);
}

}  // namespace findspace::space
