// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/distance_sum.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/formula.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "findspace/error.h"
#include "plane/base/real_vector.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator+;
using plane::operator-;

namespace {

constexpr std::size_t kMostForms = 256, kMostBoxes = 6000;

/// weight * form, of a reflected summand with its gradient turned round.
SmoothForm scaled(const SmoothForm& f, double weight, bool reflected) {
  const double turn = reflected ? -weight : weight;
  SmoothForm out{weight * f.value, turn * f.gx, turn * f.gy, weight * f.below, weight * f.above};
  if (weight < 0) std::swap(out.below, out.above);
  return out;
}

SmoothForm sum(const SmoothForm& a, const SmoothForm& b) {
  return {a.value + b.value, a.gx + b.gx, a.gy + b.gy, a.below + b.below, a.above + b.above};
}

double size(const RealPoint& p) { return std::abs(near_value(p.x)) + std::abs(near_value(p.y)); }

bool same(const SmoothForm& a, const SmoothForm& b) {
  return a.value == b.value && a.gx == b.gx && a.gy == b.gy && a.below == b.below && a.above == b.above;
}

}  // namespace

DistanceSum::DistanceSum(std::vector<Summand> summands) : summands_(std::move(summands)) {
  for (Summand& s : summands_) {
    rate_ += std::abs(near_value(s.weight));
    while (const auto there = s.f->elsewhere()) {
      s.by = s.by + there->by;
      s.f = TDistancePointer(s.f, &there->in);
    }
  }
}

std::optional<int> DistanceSum::infinite(const RealPoint& p) const {
  int sign = 0;
  for (const Summand& s : summands_) {
    const auto v = s.f->value(place(s, p));
    if (v && !v->minus_infinity) continue;
    const int own = v ? -s.weight.sign() : s.weight.sign();
    if (sign != 0 && sign != own) return std::nullopt;
    sign = own;
  }
  return sign;
}

std::optional<DistanceSum::Growth> DistanceSum::growth_beyond(const RealPoint& p) const {
  Growth out;
  for (const Summand& s : summands_) {
    const auto v = s.f->value(place(s, p));
    if (!v || v->minus_infinity) return Growth{};
    const Enclosure within = v->bounds();
    if (v->proven && v->value.sign() == 0) continue;  // where shapes are apart
    const int sign = within.lower && within.lower->sign() > 0 ? 1 : within.upper && within.upper->sign() < 0 ? -1 : 0;
    if (sign == 0) return std::nullopt;
    if (s.weight.sign() == sign) {
      out.rising += abs(s.weight);
      continue;
    }
    out.falling += abs(s.weight);
    const Enclosure start = s.f->value(place(s, RealPoint{})).value().bounds();
    const auto& least = s.weight.sign() > 0 ? start.lower : start.upper;
    if (!least) return std::nullopt;
    out.start += s.weight * *least;
  }
  return out;
}

DistanceSum DistanceSum::negated() const {
  DistanceSum out = *this;
  for (Summand& s : out.summands_) s.weight = -s.weight;
  return out;
}

double DistanceSum::displacement() const {
  double out = 0;
  for (const Summand& s : summands_) out = std::max(out, size(s.by));
  return out;
}

RealPoint DistanceSum::place(const Summand& s, const RealPoint& p) const { return s.reflected ? s.by - p : p + s.by; }

std::optional<PlanarAnswer> DistanceSum::answer(const RealPoint& p) const {
  PlanarAnswer out = exact_answer(Real(), Way::kMap);
  Real lower, upper;
  for (const Summand& s : summands_) {
    const auto v = s.f->value(place(s, p));
    if (!v || v->minus_infinity) return infinite(p) == -1 ? std::optional(lowest_answer(Way::kMap)) : std::nullopt;
    out.value = out.value + s.weight * v->value;
    if (!v->proven) {
      out.set_unproven();
      out.error += std::abs(near_value(s.weight)) * (v->enclosed ? v->error : v->slack());
    }
    const Enclosure within = v->bounds();
    if (!within.lower || !within.upper) return std::nullopt;
    const bool grows = s.weight.sign() > 0;
    lower = lower + s.weight * (grows ? *within.lower : *within.upper);
    upper = upper + s.weight * (grows ? *within.upper : *within.lower);
  }
  if (!out.proven) out.enclosed = Enclosure{std::move(lower), std::move(upper)};
  return out;
}

std::optional<Real> DistanceSum::value(const RealPoint& p) const {
  auto found = answer(p);
  return found && !found->minus_infinity ? std::optional(std::move(found->value)) : std::nullopt;
}

std::optional<int> DistanceSum::sign(const RealPoint& p, const Real& level) const {
  const auto found = answer(p);
  if (!found) return infinite(p) == 1 ? std::optional(1) : std::nullopt;
  if (found->minus_infinity) return -1;
  const Enclosure within = found->bounds();
  const int low = compare(*within.lower, level), high = compare(*within.upper, level);
  return low == high ? std::optional(low) : std::nullopt;
}

/// The only thing known: the summand changes no faster than the position.
std::vector<SmoothForm> DistanceSum::loose(double value, double weight, double radius) const {
  SmoothForm out;
  out.value = weight * value;
  out.above = std::abs(weight) * radius;
  out.below = -out.above;
  return {out};
}

std::optional<DistanceSum::Forms> DistanceSum::forms(const RealPoint& p, double radius, std::size_t most) const {
  Forms out;
  std::size_t count = 1;
  for (const Summand& s : summands_) {
    auto forms = s.f->forms(place(s, p), radius);
    if (!forms || forms->empty()) return std::nullopt;
    std::vector<SmoothForm> kept;
    for (SmoothForm& f : *forms)
      if (std::none_of(kept.begin(), kept.end(), [&](const SmoothForm& k) { return same(k, f); }))
        kept.push_back(std::move(f));
    count *= kept.size();
    if (count > most) return std::nullopt;
    out.summands.push_back(std::move(kept));
  }
  out.all.push_back({});
  for (std::size_t k = 0; k < summands_.size(); ++k) {
    std::vector<Form> next;
    for (const Form& part : out.all)
      for (const SmoothForm& f : out.summands[k]) {
        Form both{sum(part.sum, scaled(f, near_value(summands_[k].weight), summands_[k].reflected)), part.of};
        both.of.push_back(&f);
        next.push_back(std::move(both));
      }
    out.all = std::move(next);
  }
  return out;
}

double DistanceSum::noise(const RealPoint& p, double radius) const {
  double out = 0;
  for (const Summand& s : summands_) {
    const RealPoint q = place(s, p);
    const double value = std::abs(near_value(s.f->value(q)->value));
    out += std::abs(near_value(s.weight)) * (size(q) + size(p) + value + radius);
  }
  return out * margin::kMaxMinNoise;
}

ValueRange DistanceSum::range(const RealPoint& p, double radius) const {
  const auto value = this->value(p);
  if (!value) {
    const auto sign = infinite(p);
    if (!sign)
      throw Error(ErrorCode::kUnsupported, "two distances of the sum are infinite everywhere, with opposite signs");
    return {*sign > 0 ? exact::kInfinity : -exact::kInfinity, *sign < 0 ? -exact::kInfinity : exact::kInfinity};
  }
  const double middle = near_value(*value), noise = this->noise(p, radius);
  if (radius == 0) return {middle - noise, middle + noise};
  ValueRange out{middle - rate_ * radius, middle + rate_ * radius};
  // Where a sum has too many forms in all, summands with many count as loose.
  std::vector<std::vector<SmoothForm>> parts;
  std::size_t count = 1;
  for (const Summand& s : summands_) {
    const RealPoint q = place(s, p);
    const double weight = near_value(s.weight);
    auto forms = s.f->forms(q, radius);
    std::vector<SmoothForm> part;
    if (forms && !forms->empty() && count * forms->size() <= kMostForms) {
      for (const SmoothForm& f : *forms) part.push_back(scaled(f, weight, s.reflected));
    } else {
      part = loose(near_value(s.f->value(q)->value), weight, radius);
    }
    count *= part.size();
    parts.push_back(std::move(part));
  }
  std::vector<SmoothForm> all{{}};
  for (const auto& part : parts) {
    std::vector<SmoothForm> next;
    for (const SmoothForm& a : all)
      for (const SmoothForm& b : part) next.push_back(sum(a, b));
    all = std::move(next);
  }
  ValueRange tight{exact::kInfinity, -exact::kInfinity};
  for (const SmoothForm& f : all) {
    const double slope = plain_length(f.gx, f.gy) * radius;
    tight.low = std::min(tight.low, f.value + f.below - slope);
    tight.high = std::max(tight.high, f.value + f.above + slope);
  }
  return {std::max(out.low, tight.low) - noise, std::min(out.high, tight.high) + noise};
}

void refuse_without_end() {
  throw Error(ErrorCode::kUnsupported,
              "over unbounded positions a sum is not looked for whose best value may lie infinitely far away");
}

namespace {

/// A value that F is not above somewhere in the set: the least at some of its vertices.
double known_value(const DistanceSum& f, const plane::Region& set) {
  constexpr std::size_t kVertices = 16;
  if (set.vertices.empty()) return f.range({}, 0).high;
  double least = exact::kInfinity;
  for (std::size_t v = 0; v < std::min(set.vertices.size(), kVertices); ++v)
    least = std::min(least, f.range(set.geometry.exact(set.vertices[v].point), 0).high);
  return least;
}

}  // namespace

Extremum best_position(const DistanceSum& f, const PositionBounds& s, Sense sense, double size) {
  SearchWindow window{{}, false, margin::kBestPart * size, kMostBoxes, true};
  if (const plane::Region& all = s.possible; all.faces[0].mark > 0) {
    if (sense == Sense::kMaximum) {
      Extremum out = best_position(f.negated(), s, Sense::kMinimum, size);
      out.negate();
      return out;
    }
    size += f.displacement();
    const auto growth = f.growth_beyond({Real::from_double(2 * std::ceil(size)), Real()});
    if (!growth) refuse_without_end();
    const Real slope = growth->rising - growth->falling;
    if (slope.sign() < 0 && s.certain.faces[0].mark > 0) return no_optimum<plane::Region>(sense, true);
    window.worse_outside = slope.sign() > 0;
    if (!window.worse_outside && growth->falling.sign() > 0) refuse_without_end();
    if (window.worse_outside) {
      // F >= rising * (|p| - size) + start - falling * |p| beyond: more than a position of S has.
      const double held = near_value(growth->falling) * size - near_value(growth->start);
      size += std::max(0.0, known_value(f, all) + held) / near_value(slope) * margin::kUpward;
    }
  }
  size = std::ceil(size) + 1;
  window.box = {-size, -size, size, size};
  Extremum out = best_position([&f](const RealPoint& p, double r) { return f.range(p, r); }, s, sense, window);
  out.attained = out.exists();  // values are those of certain positions
  return out;
}

}  // namespace findspace::distance
