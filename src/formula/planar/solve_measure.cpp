// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solver::measure: all distances of the moving shapes at a position.

#include <algorithm>
#include <limits>

#include "formula/language/text.h"
#include "formula/planar/solve.h"
#include "plane/base/parallel.h"

namespace findspace::formula {

using exact::RealPoint;

std::vector<Distance> Solver::all_distances() const {
  const bool over_time = world_.motion.given() && !world_.instant;
  const std::vector<Extremum> prefixes =
      over_time ? std::vector{Extremum::kInf, Extremum::kSup} : std::vector{Extremum::kNone};
  std::vector<Distance> out;
  for (const std::string& b : world_.moving)
    for (const auto& [a, region] : world_.shapes) {
      if (std::find(world_.moving.begin(), world_.moving.end(), a) != world_.moving.end()) continue;
      for (std::size_t k = 0; k < kKindCount; ++k) {
        Distance d;
        d.kind = Kind(k);
        const bool both = d.kind == Kind::kMu || d.kind == Kind::kH || d.kind == Kind::kDstar;
        for (Extremum prefix : prefixes) {
          d.prefix = prefix;
          d.first = {b};
          d.second = {a};
          out.push_back(d);
          if (both) {
            std::swap(d.first, d.second);
            out.push_back(d);
          }
        }
      }
    }
  return out;
}

namespace {

/// max(0, +-f) of another distance f, over the same time; nothing for the others.
struct Derived {
  Distance of;
  bool negated = false, cut = true;
  std::optional<Distance> other{};  // the greater of both
};

std::optional<Derived> derived(const Distance& d) {
  Derived out{d};
  switch (d.kind) {
    case Kind::kD1:
      out.of.kind = Kind::kGamma1;
      return out;
    case Kind::kD2:
      out.of.kind = Kind::kGamma2;
      out.cut = false;
      return out;
    case Kind::kH:
      out.of.kind = Kind::kMu;
      return out;
    case Kind::kPenetration:
      out.of.kind = Kind::kGamma1;
      out.negated = true;
      break;
    case Kind::kDstar:
      out.of.kind = Kind::kEta1;
      out.negated = true;
      std::swap(out.of.first, out.of.second);
      break;
    case Kind::kHausdorff:
      if (d.prefix != Extremum::kSup) return std::nullopt;
      out.of.kind = Kind::kMu;
      out.cut = false;
      out.other = out.of;
      std::swap(out.other->first, out.other->second);
      return out;
    default:
      return std::nullopt;
  }
  out.of.prefix = d.prefix == Extremum::kInf ? Extremum::kSup : Extremum::kInf;
  return out;
}

DistanceAt derived_value(const Distance& wanted, const Derived& from, const DistanceAt& base) {
  DistanceAt out;
  out.text = text(wanted);
  out.in_degrees = base.in_degrees;
  if (!base.value && !from.negated) return out;
  const double f = base.value ? *base.value : std::numeric_limits<double>::infinity();
  out.value = from.cut ? std::max(0.0, from.negated ? -f : f) : f;
  return out;
}

}  // namespace

std::vector<DistanceAt> Solver::measure(const RealPoint& position, const Formula& formula) const {
  const RealPoint p = steps(position);
  std::vector<Distance> wanted = all_distances();
  for (const SignMap& m : formula.sign_maps()) {
    if (std::find(wanted.begin(), wanted.end(), m.distance) == wanted.end()) wanted.push_back(m.distance);
  }
  std::vector<DistanceAt> out(wanted.size());
  // Over time a value is a search: it is made once for those that follow from each other.
  std::vector<std::size_t> source(wanted.size());
  const auto place = [&](const Distance& d) {
    const auto canonical = d.kind == Kind::kMu ? d : moving_first(d, world_.moving);
    return std::size_t(std::find(wanted.begin(), wanted.end(), canonical) - wanted.begin());
  };
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    source[k] = k;
    const bool searched = world_.motion.given() && !world_.instant && !roles(wanted[k]).rotating;
    const auto d = searched ? derived(wanted[k]) : std::nullopt;
    if (!d) continue;
    const bool found = place(d->of) < wanted.size() && (!d->other || place(*d->other) < wanted.size());
    if (found) source[k] = place(d->of);
  }
  plane::parallel_for(out.size(), [&](std::size_t k) {
    if (source[k] == k) out[k] = value(wanted[k], p);
  });
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (source[k] == k) continue;
    const Derived d = *derived(wanted[k]);
    out[k] = derived_value(wanted[k], d, out[source[k]]);
    if (d.other) out[k].value = std::max(*out[k].value, *out[place(*d.other)].value);
  }
  return out;
}

}  // namespace findspace::formula
