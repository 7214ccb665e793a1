// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_signs.h"

#include <algorithm>

#include "distance/rays/ray_sign_maker.h"
#include "distance/rays/value_rays.h"
#include "distance/solid/solid_pair.h"

namespace findspace::distance {
namespace {

using exact::Real;
using space::Body;
using space::RayGrid;
using Source = space::RaySourcePointer;

}  // namespace

Source ray_sign_map(Which which, const Real& level, const Body& b, const Body& a, const RayGrid& grid) {
  const auto plus = [&] { return space::constant_rays(grid, 1); };
  if (const auto cut = cut_off_of(which)) {
    if (level.sign() < 0) return plus();
    return space::cut_off_rays(ray_sign_map(cut->base, cut->negated ? -level : level, b, a, grid), cut->negated, level);
  }
  // A in B + p is -A + p in -B.
  const Body back_b = mirrored(a), back_a = mirrored(b);
  const RaySignMaker forth(b, a, grid), back(back_b, back_a, grid);
  switch (which) {
    case Which::kGamma1:
      return forth.gamma1(level);
    case Which::kGamma2:
      return forth.gamma2(level);
    case Which::kEta1:
      return forth.eta1(level);
    case Which::kEta2:
      return forth.eta2(level);
    case Which::kDelta1:
      return a.outside ? plus() : back.eta1(level);
    case Which::kDelta2:
      return a.outside ? plus() : back.eta2(level);
    case Which::kMu:
      return forth.mu(level);
    case Which::kMuBack:
      return a.outside ? plus() : back.mu(level);
    case Which::kHausdorff: {
      if (a.outside || level.sign() < 0) return plus();
      std::vector<Source> both;
      both.push_back(forth.mu(level));
      both.push_back(back.mu(level));
      return space::greatest_rays(std::move(both));
    }
    case Which::kDiameter: {
      if (a.outside) return plus();
      const Real own = std::max(diameter(a), diameter(b));
      if (level < own) return plus();
      const int least = compare(own, level);  // not above
      return space::mapped_rays(forth.gamma2(level), [least](int s) { return std::max(s, least); });
    }
    default:
      break;
  }
  return plus();
}

}  // namespace findspace::distance
