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

/// Of mu(B, A), or of eta1 where nothing has tolerance.
bool searched(const Real& level, const Body& a, bool mu) {
  return !a.convex() && !a.outside && (level.sign() == 0 ? a.round() : mu && level.sign() > 0);
}

}  // namespace

bool found_by_search(Which which, const Real& level, const Body& b, const Body& a) {
  const auto forth = [&](Which base, const Real& at) { return !b.outside && by_values(base, at, b, a); };
  const auto back = [&](Which base, const Real& at) {
    return !a.outside && by_values(base, at, mirrored(a), mirrored(b));
  };
  switch (which) {
    case Which::kMu:
    case Which::kH:
      return searched(level, a, true) || forth(Which::kMu, level);
    case Which::kMuBack:
    case Which::kHBack:
      return searched(level, b, true) || back(Which::kMu, level);
    case Which::kHausdorff:
      return searched(level, a, true) || searched(level, b, true) || forth(Which::kMu, level) ||
             back(Which::kMu, level);
    case Which::kEta1:
      return searched(level, a, false) || forth(Which::kEta1, level);
    case Which::kDstarBack:
      return searched(level, a, false) || forth(Which::kEta1, -level);
    case Which::kDelta1:
      return searched(level, b, false) || back(Which::kEta1, level);
    case Which::kDstar:
      return searched(level, b, false) || back(Which::kEta1, -level);
    case Which::kGamma1:
    case Which::kD1:
      return forth(Which::kGamma1, level);
    case Which::kPenetration:
      return forth(Which::kGamma1, -level);
    case Which::kEta2:
      return forth(Which::kEta2, level);
    case Which::kDelta2:
      return back(Which::kEta2, level);
    default:
      return false;
  }
}

Source ray_sign_map(Which which, const Real& level, const Body& b, const Body& a, const RayGrid& grid) {
  // A in B + p is -A + p in -B.
  const Body back_b = mirrored(a), back_a = mirrored(b);
  const RaySignMaker forth(b, a, grid), back(back_b, back_a, grid);
  const auto plus = [&] { return space::constant_rays(grid, 1); };
  const bool unsigned_one = which == Which::kD1 || which == Which::kH || which == Which::kHBack ||
                            which == Which::kDstar || which == Which::kDstarBack || which == Which::kPenetration;
  if (unsigned_one && level.sign() < 0) return plus();
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
    case Which::kD1:
      return space::cut_off_rays(forth.gamma1(level), false, level);
    case Which::kH:
      return space::cut_off_rays(forth.mu(level), false, level);
    case Which::kHBack:
      return a.outside ? plus() : space::cut_off_rays(back.mu(level), false, level);
    case Which::kDstar:
      return a.outside ? space::constant_rays(grid, -level.sign())
                       : space::cut_off_rays(back.eta1(-level), true, level);
    case Which::kDstarBack:
      return space::cut_off_rays(forth.eta1(-level), true, level);
    case Which::kPenetration:
      return space::cut_off_rays(forth.gamma1(-level), true, level);
    case Which::kDiameter: {
      if (a.outside) return plus();
      const Real own = std::max(diameter(a), diameter(b));
      if (level < own) return plus();
      const int least = compare(own, level);  // not above
      return space::mapped_rays(forth.gamma2(level), [least](int s) { return std::max(s, least); });
    }
  }
  return plus();
}

}  // namespace findspace::distance
