// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <libqhull_r/qhull_ra.h>

#include <stdexcept>

#include "phi_rivals.h"

namespace phi_bench {

Built build_with_qhull(const Body& a, const Body& b) {
  const double start = now();
  std::vector<coordT> points;
  points.reserve(a.vertices.size() * b.vertices.size() * 3);
  for (const auto& v : a.vertices) {
    for (const auto& w : b.vertices) points.insert(points.end(), {v[0] - w[0], v[1] - w[1], v[2] - w[2]});
  }
  qhT state;
  qhT* qh = &state;
  qh_zero(qh, nullptr);
  char options[] = "qhull";
  if (qh_new_qhull(qh, 3, static_cast<int>(points.size() / 3), points.data(), False, options, nullptr, nullptr) != 0) {
    throw std::runtime_error("qhull failed");
  }
  const int facets = qh->num_facets;
  const double seconds = now() - start;
  qh_freeqhull(qh, qh_ALL);
  int curlong = 0, totlong = 0;
  qh_memfreeshort(qh, &curlong, &totlong);
  return {seconds, facets};
}

}  // namespace phi_bench
