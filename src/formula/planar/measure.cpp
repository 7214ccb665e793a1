// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formula/language/text.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/rotation_values.h"
#include "plane/base/parallel.h"

namespace findspace::formula {

using exact::RealPoint;

namespace {

/// What is 0 where a distance along a direction is, and has two features there.
distance::Which touching(distance::Which w) {
  using distance::Which;
  if (w == Which::kEta1 || w == Which::kEta2) return Which::kMu;
  return w == Which::kDelta1 || w == Which::kDelta2 ? Which::kMuBack : Which::kD1;
}

/// The witness of a measured distance, in the order of the arguments.
std::vector<FeatureAt> named_features(const PreparedWorld& world, const Distance& wanted, const Roles& r,
                                      const distance::Measured& m, const RealPoint& p) {
  const auto pair = world.pair(r.names);
  std::vector<FeatureAt> out;
  for (const distance::Feature& f : m.witness)
    out.push_back(named_feature(f, f.of_moving ? pair->pair().moving() : pair->pair().fixed(),
                                f.of_moving ? r.names.first : r.names.second, world.world().shapes, world.world().parts,
                                p));
  bool rotated = wanted.first == r.names.second && !out.empty() && m.witness[0].of_moving != m.witness[1].of_moving;
  if (rotated) std::swap(out[0], out[1]);
  return out;
}

void add_measured(const PreparedWorld& world, DistanceAt& out, const Distance& wanted, const Roles& r,
                  const distance::Measured& m, const RealPoint& p) {
  out.value = m.minus_infinity ? -std::numeric_limits<double>::infinity() : (m.value * world.step()).to_double();
  out.nearest = m.nearest;
  out.farthest = m.farthest;
  out.witness = named_features(world, wanted, r, m, p);
}

/// Of a distance along a direction, that has a nearest position: the features that touch there.
void add_contact(const PreparedWorld& world, DistanceAt& out, const Distance& wanted, const Roles& r,
                 const RealPoint& p) {
  const RealPoint& there = *out.nearest;
  const auto m = world.pair(r.names)->measure(touching(r.which()), there);
  if (!m || m->witness.size() != 2 || m->witness[0].of_moving == m->witness[1].of_moving) return;
  out.witness = named_features(world, wanted, r, *m, there);
  // The moving one's feature, back from where they touch.
  FeatureAt& moving = out.witness[m->witness[0].of_moving != (wanted.first == r.names.second) ? 0 : 1];
  moving.at = {moving.at.x + p.x - there.x, moving.at.y + p.y - there.y};
}

std::vector<Distance> all_distances(const World& world) {
  const bool over_time = world.motion.given() && !world.instant;
  const std::vector<Extremum> prefixes =
      over_time ? std::vector{Extremum::kInf, Extremum::kSup} : std::vector{Extremum::kNone};
  std::vector<Distance> out;
  for (const std::string& b : world.moving)
    for (const auto& [a, region] : world.shapes) {
      if (std::find(world.moving.begin(), world.moving.end(), a) != world.moving.end()) continue;
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

DistanceAt distance_at(const PreparedWorld& world, const Distance& wanted, const RealPoint& p) {
  DistanceAt out;
  out.text = text(wanted);
  out.in_degrees = wanted.mode == Mode::kRotation;
  const Roles r = world.roles(wanted);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  if (r.rotating || (rotation && world.motion().given())) {
    const auto v = rotation_value(world, r, p);
    const double unit = rotation ? 1 : world.step().to_double();
    if (v) {
      out.value = shown_value(world, *v, r) * unit;
      out.bound = v->low == v->high ? 0 : (v->high - v->low) * unit;
    }
    return out;
  }
  if (!world.motion().given() && r.wanted.mode == Mode::kPlain) {
    if (const auto m = world.pair(r.names)->measure(r.which(), p)) add_measured(world, out, wanted, r, *m, p);
    return out;
  }
  auto v = position_function(world, wanted)->value(p);
  if (v && v->minus_infinity)
    out.value = -std::numeric_limits<double>::infinity();
  else if (v) {
    out.value = (v->value * world.step()).to_double();
    out.nearest = v->nearest;
  }
  if (out.nearest && !world.motion().given()) add_contact(world, out, wanted, r, p);
  return out;
}

std::vector<DistanceAt> measure_at(const PreparedWorld& world, const RealPoint& p, const Formula& formula) {
  std::vector<Distance> wanted = all_distances(world.world());
  for (const SignMap& m : formula.sign_maps()) {
    if (std::find(wanted.begin(), wanted.end(), m.distance) == wanted.end()) wanted.push_back(m.distance);
  }
  std::vector<DistanceAt> out(wanted.size());
  // Over time a value is a search: it is made once for those that follow from each other.
  std::vector<std::size_t> source(wanted.size());
  const auto place = [&](const Distance& d) {
    const auto canonical = d.kind == Kind::kMu ? d : moving_first(d, world.world().moving);
    return std::size_t(std::find(wanted.begin(), wanted.end(), canonical) - wanted.begin());
  };
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    source[k] = k;
    const bool searched = world.motion().given() && !world.world().instant && !world.roles(wanted[k]).rotating;
    const auto d = searched ? derived(wanted[k]) : std::nullopt;
    if (!d) continue;
    const bool found = place(d->of) < wanted.size() && (!d->other || place(*d->other) < wanted.size());
    if (found) source[k] = place(d->of);
  }
  plane::parallel_for(out.size(), [&](std::size_t k) {
    if (source[k] == k) out[k] = distance_at(world, wanted[k], p);
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
