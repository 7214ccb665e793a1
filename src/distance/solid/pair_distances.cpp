// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/pair_distances.h"

#include "space/polytope/real_vector.h"

namespace findspace::distance {

namespace {

/// max(0, v), or max(0, -v) if `negated`.
TriedAnswer cut(TriedAnswer v, bool negated) {
  if (!v) return v;
  return cut_off(*std::move(v), negated);
}

}  // namespace

Which exchanged(Which which) {
  switch (which) {
    case Which::kEta1:
      return Which::kDelta1;
    case Which::kDelta1:
      return Which::kEta1;
    case Which::kEta2:
      return Which::kDelta2;
    case Which::kDelta2:
      return Which::kEta2;
    case Which::kMu:
      return Which::kMuBack;
    case Which::kMuBack:
      return Which::kMu;
    case Which::kH:
      return Which::kHBack;
    case Which::kHBack:
      return Which::kH;
    case Which::kDstar:
      return Which::kDstarBack;
    case Which::kDstarBack:
      return Which::kDstar;
    default:
      return which;
  }
}

std::optional<CutOff> cut_off_of(Which which) {
  switch (which) {
    case Which::kD1:
      return CutOff{Which::kGamma1, false};
    case Which::kPenetration:
      return CutOff{Which::kGamma1, true};
    case Which::kH:
      return CutOff{Which::kMu, false};
    case Which::kHBack:
      return CutOff{Which::kMuBack, false};
    case Which::kDstar:
      return CutOff{Which::kDelta1, true};
    case Which::kDstarBack:
      return CutOff{Which::kEta1, true};
    default:
      return std::nullopt;
  }
}

TriedAnswer PairDistances::clearance(Inner inner, const SpacePosition& p) const { return cut(fit(inner, p), true); }

TriedAnswer PairDistances::hausdorff(const SpacePosition& p) const {
  TriedAnswer back = protrusion(Inner::kA, p, Depth::kSign);
  if (!back || !*back) return back;
  TriedAnswer forth = protrusion(Inner::kB, p, Depth::kSign);
  if (!forth || !*forth) return forth;
  return (*forth)->value < (*back)->value ? back : forth;
}

TriedAnswer PairDistances::exchanged_back(TriedAnswer v, const SpacePosition& p) {
  if (!v || !*v) return v;
  if ((*v)->nearest) (*v)->nearest = space::negated(*(*v)->nearest);
  exchange_roles(**v, p);
  return v;
}

TriedAnswer PairDistances::try_value(Which which, const SpacePosition& p) const {
  switch (which) {
    case Which::kGamma1:
      return gap(p, Depth::kValue);
    case Which::kD1:
      return cut(gap(p, Depth::kSign), false);
    case Which::kPenetration:
      return cut(gap(p, Depth::kValue), true);
    case Which::kGamma2:
      return reach(p);
    case Which::kDiameter:
      return diameter(p);
    case Which::kEta1:
      return fit(Inner::kB, p);
    case Which::kDelta1:
      return fit(Inner::kA, p);
    case Which::kDstarBack:
      return clearance(Inner::kB, p);
    case Which::kDstar:
      return clearance(Inner::kA, p);
    case Which::kEta2:
      return farthest_fit(Inner::kB, p);
    case Which::kDelta2:
      return farthest_fit(Inner::kA, p);
    case Which::kMu:
      return protrusion(Inner::kB, p, Depth::kValue);
    case Which::kMuBack:
      return protrusion(Inner::kA, p, Depth::kValue);
    case Which::kH:
      return cut(protrusion(Inner::kB, p, Depth::kSign), false);
    case Which::kHBack:
      return cut(protrusion(Inner::kA, p, Depth::kSign), false);
    case Which::kHausdorff:
      return hausdorff(p);
  }
  return std::nullopt;
}

}  // namespace findspace::distance
