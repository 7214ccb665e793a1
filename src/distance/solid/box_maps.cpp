// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/solid/box_maps.h"

#include <findspace/error.h>

#include <algorithm>
#include <utility>

#include "space/box/box_operations.h"
#include "space/box/box_topology.h"

namespace findspace::distance {

using exact::Real;
using exact::Tried;
using space::BoxComplex;
using space::dot;
using space::Interval;
using space::IntervalBox;
using space::Mark;
using space::RealVector;

namespace {

BoxComplex either(const BoxComplex& a, const BoxComplex& b) {
  return overlay(std::array<const BoxComplex*, 2>{&a, &b}, [](std::span<const Mark> m) { return Mark(m[0] || m[1]); });
}

/// -1 on `open`, 0 on the rest of `closed`, +1 elsewhere.
BoxComplex sign_map_of(const BoxComplex& open, const BoxComplex& closed) {
  return overlay(std::array<const BoxComplex*, 2>{&open, &closed}, [](std::span<const Mark> m) {
    return Mark(m[0] ? -1 : m[1] ? 0 : 1);
  });
}

BoxComplex gamma_map(const BoxComplex& b, const BoxComplex& a) {
  const BoxComplex back = mirrored(b);
  return sign_map_of(either(sum(interior(a), back), sum(a, interior(back))), sum(a, back));
}

/// B + p in A, and in its interior.
BoxComplex eta_map(const BoxComplex& b, const BoxComplex& a) {
  const BoxComplex back = mirrored(b), outside = complement(a);
  return sign_map_of(complement(sum(closure(outside), back)), complement(sum(outside, back)));
}

/// The box less t on every side; nothing if that is empty. Open if `open`.
std::optional<BoxComplex> shrunk(const IntervalBox& box, const Real& t, bool open) {
  IntervalBox out = box;
  for (Interval& i : out) {
    if (i.from) *i.from += t;
    if (i.to) *i.to -= t;
    i.from_in = i.to_in = !open;
    if (i.from && i.to && (*i.to < *i.from || (open && !(*i.from < *i.to)))) return std::nullopt;
  }
  return BoxComplex::of_boxes(std::array<IntervalBox, 1>{out});
}

bool is_open(const IntervalBox& box) {
  return std::all_of(box.begin(), box.end(), [](const Interval& i) {
    return !i.from_in && !i.to_in && !(i.from && i.to && !(*i.from < *i.to));
  });
}

std::size_t slot(Which base) { return base == Which::kGamma1 ? 0 : base == Which::kEta1 ? 1 : 2; }

}  // namespace

BoxMaps::BoxMaps(BoxComplex b, BoxComplex a) : b_(std::move(b)), a_(std::move(a)) {
  if (b_.empty() || a_.empty()) throw Error(ErrorCode::kGeometry, "a shape of the scene is empty");
}

const Tried<BoxMaps::Signs>& BoxMaps::signs(Which base) const {
  return signs_[slot(base)].of([&] { return made(base); });
}

Tried<BoxMaps::Signs> BoxMaps::made(Which base) const {
  BoxComplex map = base == Which::kGamma1 ? gamma_map(b_, a_)
                   : base == Which::kEta1 ? eta_map(b_, a_)
                                          : mirrored(eta_map(a_, b_));
  Tried<BoxComplex> checked = std::move(map).checked();
  if (!checked) return checked.refusal();
  Signs s;
  s.map = checked->simplified();
  s.closed = s.map.remarked([](Mark m) { return Mark(m <= 0); }).boxes();
  s.rest = s.map.remarked([](Mark m) { return Mark(m >= 0); }).boxes();
  s.defined = !s.closed.empty();
  const std::vector<IntervalBox> negative = s.map.remarked([](Mark m) { return Mark(m < 0); }).simplified().boxes();
  s.has_negative = !negative.empty();
  // Of a set that is no such union some of the boxes would be flat.
  if (std::all_of(negative.begin(), negative.end(), is_open)) s.negative = negative;
  return s;
}

Tried<BoxComplex> BoxMaps::base_map(Which base, const Real& level) const {
  const Tried<Signs>& found = signs(base);
  if (!found) return found.refusal();
  const Signs& s = *found;
  if (!s.defined) return BoxComplex({}, 1);
  if (level.sign() == 0) return s.map;
  if (level.sign() > 0)
    return exact::Refusal(
        "at a level above 0 the positions have round edges, which the exact map of boxes does not hold");
  if (!s.has_negative) return BoxComplex({}, 1);
  if (s.negative.empty())
    return exact::Refusal(
        "at a level below 0 the positions have round edges, which the exact map of boxes does not hold");
  std::optional<BoxComplex> map;
  for (const IntervalBox& box : s.negative) {
    const auto open = shrunk(box, -level, true), closed = shrunk(box, -level, false);
    if (!closed) continue;
    BoxComplex one = sign_map_of(open ? *open : BoxComplex(), *closed);
    map = map ? overlay(std::array<const BoxComplex*, 2>{&*map, &one},
                        [](std::span<const Mark> m) { return std::min(m[0], m[1]); })
              : std::move(one);
  }
  return map ? std::move(*map).checked() : BoxComplex({}, 1);
}

Tried<BoxComplex> BoxMaps::sign_map(Which which, const Real& level) const {
  if (const auto d = cut_off_of(which)) {  // at a level: the map of the base, perhaps with marks turned
    if (level.sign() < 0) return BoxComplex({}, 1);
    if (d->base != Which::kMu && d->base != Which::kMuBack) {
      const Tried<Signs>& found = signs(d->base);
      if (!found) return found.refusal();
      if (!found->defined) return BoxComplex({}, d->negated ? Mark(-level.sign()) : Mark(1));
    }
    const int turn = d->negated ? -1 : 1;
    const bool above = level.sign() > 0;
    const Tried<BoxComplex> map = sign_map(d->base, d->negated ? -level : level);
    if (!map) return map;
    return map->remarked([=](Mark m) { return Mark(above ? turn * m : turn * m > 0); });
  }
  switch (which) {
    case Which::kGamma1:
    case Which::kEta1:
    case Which::kDelta1:
      return base_map(which, level);
    case Which::kMu:  // not above 0 they agree with eta1 and delta1
    case Which::kMuBack:
      if (level.sign() <= 0) return base_map(which == Which::kMu ? Which::kEta1 : Which::kDelta1, level);
      break;
    case Which::kHausdorff: {
      if (level.sign() < 0) return BoxComplex({}, 1);
      if (level.sign() > 0) break;
      const Tried<BoxComplex> forth = base_map(Which::kEta1, level), back = base_map(Which::kDelta1, level);
      if (!forth || !back) return (forth ? back : forth).refusal();
      return overlay(std::array<const BoxComplex*, 2>{&*forth, &*back},
                     [](std::span<const Mark> m) { return std::max(m[0], m[1]); })
          .checked();
    }
    default:
      break;
  }
  return exact::Refusal("the positions have round edges, which the exact map of boxes does not hold");
}

std::optional<Answer> BoxMaps::signed_value(const Signs& s, const RealVector& p) {
  if (!s.defined) return std::nullopt;
  Answer out;
  const Mark sign = s.map.mark(p);
  if (sign == 0) return out;
  const auto q = nearest(sign < 0 ? s.rest : s.closed, p);
  if (!q) {
    out.minus_infinity = true;
    return out;
  }
  const RealVector off = space::minus(*q, p);
  const Real d = sqrt(dot(off, off));
  out.value = sign < 0 ? -d : d;
  if (d.sign() != 0) out.nearest = q;
  return out;
}

std::optional<Answer> BoxMaps::farthest_value(const Signs& s, const RealVector& p) {
  const auto q = farthest(s.closed, p);
  if (!q) return std::nullopt;
  Answer out;
  const RealVector off = space::minus(*q, p);
  out.value = sqrt(dot(off, off));
  return out;
}

TriedAnswer BoxMaps::signed_value(Which base, const RealVector& p) const {
  const Tried<Signs>& s = signs(base);
  if (!s) return s.refusal();
  return signed_value(*s, p);
}

TriedAnswer BoxMaps::farthest_value(Which base, const RealVector& p) const {
  const Tried<Signs>& s = signs(base);
  if (!s) return s.refusal();
  return farthest_value(*s, p);
}

TriedAnswer BoxMaps::diameter(const RealVector& p) const {
  TriedAnswer most = farthest_value(Which::kGamma1, p);
  for (const BoxComplex* own : {&a_, &b_}) {
    if (!most || !*most) continue;
    TriedAnswer diameter = BoxMaps(*own, *own).farthest_value(Which::kGamma1, {});
    if (!diameter || !*diameter || (*most)->value < (*diameter)->value) most = std::move(diameter);
  }
  return most;
}

/// Of B in A, or of A in B: then positions are those of A.
class BoxMaps::Side : public PairSide {
 public:
  Side(const BoxMaps& maps, bool back) : maps_(maps), back_(back) {}

  TriedAnswer gap(const RealVector& p, Depth) const override { return maps_.signed_value(Which::kGamma1, p); }
  TriedAnswer reach(const RealVector& p) const override { return maps_.farthest_value(Which::kGamma1, p); }
  TriedAnswer diameter(const RealVector& p) const override { return maps_.diameter(p); }
  TriedAnswer fit(const RealVector& p) const override {
    if (!back_) return maps_.signed_value(Which::kEta1, p);
    return exchanged_back(maps_.signed_value(Which::kDelta1, space::negated(p)), p);
  }
  TriedAnswer farthest_fit(const RealVector& p) const override {
    return back_ ? maps_.farthest_value(Which::kDelta1, space::negated(p)) : maps_.farthest_value(Which::kEta1, p);
  }
  TriedAnswer protrusion(const RealVector&, Depth) const override {
    return exact::Refusal("how far a set of boxes protrudes from another is not read off the map of boxes");
  }

 private:
  const BoxMaps& maps_;
  bool back_;
};

PairDistances BoxMaps::distances() const {
  return {std::make_shared<const Side>(*this, false), std::make_shared<const Side>(*this, true)};
}

Tried<std::optional<BoxMaps::Least>> BoxMaps::least(Which which) const {
  if (which != Which::kGamma1 && which != Which::kEta1 && which != Which::kDelta1) return std::nullopt;
  const Tried<Signs>& s = signs(which);
  if (!s) return s.refusal();
  std::optional<Least> found = least(*s);
  if (!found) return found;
  Tried<BoxComplex> at = std::move(found->at).checked();
  if (!at) return at.refusal();
  found->at = *std::move(at);
  return found;
}

std::optional<BoxMaps::Least> BoxMaps::least(const Signs& s) {
  if (!s.defined) return Least{Real(), space::BoxComplex()};
  if (!s.has_negative) return Least{Real(), s.map.remarked([](Mark m) { return Mark(m <= 0); })};
  if (s.negative.empty()) return std::nullopt;
  std::optional<Real> deepest;
  for (const IntervalBox& box : s.negative) {
    std::optional<Real> half;
    for (const Interval& i : box) {
      if (!i.from || !i.to) continue;
      const Real h = (*i.to - *i.from) / Real(2);
      if (!half || h < *half) half = h;
    }
    if (!half) return std::nullopt;
    if (!deepest || *deepest < *half) deepest = half;
  }
  BoxComplex at;
  for (const IntervalBox& box : s.negative) {
    if (const auto middle = shrunk(box, *deepest, false)) at = either(at, *middle);
  }
  return Least{-*deepest, std::move(at)};
}

}  // namespace findspace::distance
