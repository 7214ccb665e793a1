// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <ccd/ccd.h>

#include "phi_rivals.h"

namespace phi_bench {
namespace {

struct Placed {
  const Body* body;
  std::array<double, 3> at;
};

/// A plain scan over the vertices; walking the edges instead pays off only from some hundred vertices on.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto* placed = static_cast<const Placed*>(object);
  const std::array<double, 3>* best = nullptr;
  double most = 0;
  for (const auto& v : placed->body->vertices) {
    const double h = v[0] * direction->v[0] + v[1] * direction->v[1] + v[2] * direction->v[2];
    if (best == nullptr || h > most) {
      best = &v;
      most = h;
    }
  }
  ccdVec3Set(point, (*best)[0] + placed->at[0], (*best)[1] + placed->at[1], (*best)[2] + placed->at[2]);
}

}  // namespace

DepthQuery depth_with_ccd(const Body& a, const Body& b) {
  return [&a, &b](const std::array<double, 3>& u) {
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = support;
    ccd.support2 = support;
    ccd.max_iterations = 500;
    ccd.epa_tolerance = 1e-6;
    const Placed p{&a, {0, 0, 0}}, q{&b, u};
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    return ccdGJKPenetration(&p, &q, &ccd, &depth, &direction, &position) == 0 ? static_cast<double>(depth) : 0.0;
  };
}

}  // namespace phi_bench
