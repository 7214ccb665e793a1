// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/pair_distances.h"

#include "plane/base/search_work.h"
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

Answer greatest(Answer a, Answer b) {
  const auto below = [](const Answer& x, const Answer& y) {
    return x.value.to_double() + x.slack() < y.value.to_double() - y.slack();  // by numbers
  };
  if (below(b, a)) return a;
  if (below(a, b)) return b;
  return greater(std::move(a), std::move(b));
}

TriedAnswer exchanged_back(TriedAnswer v, const SpacePosition& p) {
  if (!v || !*v) return v;
  if ((*v)->nearest) (*v)->nearest = space::negated(*(*v)->nearest);
  if ((*v)->farthest) (*v)->farthest = space::negated(*(*v)->farthest);
  exchange_roles(**v, p);
  return v;
}

TriedAnswer PairSide::clearance(const SpacePosition& p) const { return cut(fit(p), true); }

TriedAnswer PairDistances::hausdorff(const SpacePosition& p) const {
  const double most = forth_->protrudes_at_most(p);
  if (back_->protrudes_at_most(space::negated(p)) < most)
    return exchanged_back(PairDistances(back_, forth_).hausdorff(space::negated(p)), p);
  TriedAnswer back = exchanged_back(back_->protrusion(space::negated(p), PairSide::Depth::kSign), p);
  if (!back || !*back) return back;
  if (most < (*back)->value.to_double() - (*back)->error) return back;
  TriedAnswer forth = forth_->protrusion(p, PairSide::Depth::kSign);
  if (!forth || !*forth) return forth;
  return std::optional(greatest(**std::move(forth), **std::move(back)));
}

TriedAnswer PairDistances::try_value(Which which, const SpacePosition& p) const {
  using Depth = PairSide::Depth;
  const plane::SearchQuestion question;
  switch (which) {
    case Which::kGamma1:
      return forth_->gap(p, Depth::kValue);
    case Which::kD1:
      return cut(forth_->gap(p, Depth::kSign), false);
    case Which::kPenetration:
      return cut(forth_->gap(p, Depth::kValue), true);
    case Which::kGamma2:
      return forth_->reach(p);
    case Which::kDiameter:
      return forth_->diameter(p);
    case Which::kEta1:
      return forth_->fit(p);
    case Which::kDstarBack:
      return forth_->clearance(p);
    case Which::kEta2:
      return forth_->farthest_fit(p);
    case Which::kMu:
      return forth_->protrusion(p, Depth::kValue);
    case Which::kH:
      return cut(forth_->protrusion(p, Depth::kSign), false);
    case Which::kHausdorff:
      return hausdorff(p);
    case Which::kDelta1:
    case Which::kDstar:
    case Which::kDelta2:
    case Which::kMuBack:
    case Which::kHBack:
      return exchanged_back(PairDistances(back_, forth_).try_value(exchanged(which), space::negated(p)), p);
  }
  return std::nullopt;
}

namespace {

/// "B in A", or with `back` "A in B".
class SideByValues : public PairSide {
 public:
  using Value = std::function<TriedAnswer(Which, const SpacePosition&)>;
  SideByValues(Value value, bool back) : value_(std::move(value)), back_(back) {}

  TriedAnswer gap(const SpacePosition& p, Depth depth) const override {
    return asked(depth == Depth::kSign ? Which::kD1 : Which::kGamma1, p);
  }
  TriedAnswer reach(const SpacePosition& p) const override { return asked(Which::kGamma2, p); }
  TriedAnswer diameter(const SpacePosition& p) const override { return asked(Which::kDiameter, p); }
  TriedAnswer fit(const SpacePosition& p) const override { return asked(Which::kEta1, p); }
  TriedAnswer farthest_fit(const SpacePosition& p) const override { return asked(Which::kEta2, p); }
  TriedAnswer protrusion(const SpacePosition& p, Depth depth) const override {
    return asked(depth == Depth::kSign ? Which::kH : Which::kMu, p);
  }
  TriedAnswer clearance(const SpacePosition& p) const override { return asked(Which::kDstarBack, p); }

 private:
  TriedAnswer asked(Which which, const SpacePosition& p) const {
    if (!back_) return value_(which, p);
    return exchanged_back(value_(exchanged(which), space::negated(p)), p);
  }

  Value value_;
  bool back_;
};

}  // namespace

PairDistances pair_by_values(std::function<TriedAnswer(Which, const SpacePosition&)> value) {
  auto back = std::make_shared<const SideByValues>(value, true);
  return {std::make_shared<const SideByValues>(std::move(value), false), std::move(back)};
}

PairDistances exchanged(PairDistances pair) {
  return pair_by_values([pair = std::move(pair)](Which which, const SpacePosition& p) {
    return exchanged_back(pair.try_value(exchanged(which), space::negated(p)), p);
  });
}

exact::Interval PairDistances::within(Which which, const space::Vector& p) const {
  switch (which) {
    case Which::kGamma1:
      return forth_->gap_within(p);
    case Which::kGamma2:
      return forth_->reach_within(p);
    case Which::kEta1:
      return forth_->fit_within(p);
    case Which::kMu:
      return forth_->protrusion_within(p);
    case Which::kDelta1:
    case Which::kMuBack:
    case Which::kDstar:
    case Which::kHBack:
      return PairDistances(back_, forth_).within(exchanged(which), space::scaled(-1, p));
    case Which::kD1:
    case Which::kPenetration:
    case Which::kH:
    case Which::kDstarBack: {
      const CutOff cut = *cut_off_of(which);
      const exact::Interval base = within(cut.base, p), value = cut.negated ? -base : base;
      return {std::max(value.lo, 0.0), std::max(value.hi, 0.0)};
    }
    case Which::kDiameter:
    case Which::kEta2:
    case Which::kDelta2:
    case Which::kHausdorff:
      break;
  }
  return exact::whole_line();
}

}  // namespace findspace::distance
