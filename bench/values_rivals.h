// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The rivals of values_bench: two polygons that are prepared as the rival keeps them, then asked again and again.
#pragma once

#include <functional>

#include "inputs.h"

namespace bench {

struct ValueRival {
  std::function<double()> distance;            // between the sets; empty: has none
  std::function<double()> hausdorff;           // between the vertices and edges, at the vertices only
  std::function<double()> directed_hausdorff;  // from the first to the second, likewise
};

ValueRival geos_values(const Polygon& a, const Polygon& b);
ValueRival boost_values(const Polygon& a, const Polygon& b);

}  // namespace bench
