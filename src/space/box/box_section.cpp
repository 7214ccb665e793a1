// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/box/box_section.h"

namespace findspace::space {

using exact::Real;

plane::Section section(const BoxComplex& set, const RealVector& through, const RealVector& direction) {
  Axis places;
  for (std::size_t k = 0; k < 3; ++k) {
    if (direction[k].sign() == 0) continue;
    for (const Real& c : set.at()[k]) places.push_back((c - through[k]) / direction[k]);
  }
  sort_axis(places);
  const auto mark = [&](const Real& t) { return set.mark(along(through, t, direction)); };
  const Real half = Real::ratio(1, 2);
  plane::Section out{places.empty() ? mark(Real()) : mark(places.front() - Real(1)), {}};
  Mark last = out.before;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Mark at = mark(places[k]),
               after = mark(k + 1 < places.size() ? (places[k] + places[k + 1]) * half : places[k] + Real(1));
    if (at == last && after == last) continue;
    out.stops.push_back({places[k], at, after});
    last = after;
  }
  return out;
}

}  // namespace findspace::space
