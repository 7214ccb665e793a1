// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/measure.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/at_position.h"
#include "formula/language/text.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/swing.h"
#include "plane/base/parallel.h"

namespace findspace::formula {

using distance::PlanarAnswer;
using exact::Real;
using exact::RealPoint;

namespace {

/// What is 0 where a distance along a direction is, and has two features there.
distance::Which touching(distance::Which w) {
  using distance::Which;
  if (w == Which::kEta1 || w == Which::kEta2) return Which::kMu;
  return w == Which::kDelta1 || w == Which::kDelta2 ? Which::kMuBack : Which::kD1;
}

/// The features of a witness, whose points are in grid steps.
std::vector<FeatureAt> named_features(const PreparedWorld& world, const Roles& r,
                                      const std::vector<distance::Feature>& witness, const RealPoint& p) {
  const auto pair = world.pair(r.names);
  std::vector<FeatureAt> out;
  for (const distance::Feature& f : witness)
    out.push_back(named_feature(f, f.of_moving ? pair->pair().moving() : pair->pair().fixed(),
                                f.of_moving ? r.names.first : r.names.second, world.world().shapes, world.world().parts,
                                p, world.step()));
  return out;
}

/// Whether a witness with one point of each shape is the other way round than the arguments.
bool exchanged(const Distance& wanted, const Roles& r, const std::vector<distance::Feature>& witness) {
  return wanted.first == r.names.second && !witness.empty() && witness[0].of_moving != witness[1].of_moving;
}

/// Of an answer in grid steps, its witness in the order of the arguments.
DistanceAt named_answer(const PreparedWorld& world, const Distance& wanted, const Roles& r, PlanarAnswer m,
                        const RealPoint& p) {
  if (exchanged(wanted, r, m.witness)) std::swap(m.witness[0], m.witness[1]);
  std::vector<FeatureAt> features = named_features(world, r, m.witness, p);
  DistanceAt out = distance_at(text(wanted), distance::in_scene(m, world.step()));
  out.features = std::move(features);
  return out;
}

/// Of a distance along a direction, that has a nearest position: the features that touch there.
DistanceAt with_contact(const PreparedWorld& world, const Distance& wanted, const Roles& r, PlanarAnswer v,
                        const RealPoint& p) {
  const RealPoint there = *v.nearest;
  const auto m = world.pair(r.names)->measure(touching(r.which()), there);
  if (!m || m->witness.size() != 2 || m->witness[0].of_moving == m->witness[1].of_moving)
    return named_answer(world, wanted, r, std::move(v), p);
  v.witness = m->witness;
  if (exchanged(wanted, r, v.witness)) std::swap(v.witness[0], v.witness[1]);
  std::vector<FeatureAt> features = named_features(world, r, v.witness, there);
  // The moving one's feature, back from where they touch.
  for (distance::Feature& f : v.witness) {
    if (f.of_moving) f.at = {f.at.x + p.x - there.x, f.at.y + p.y - there.y};
  }
  DistanceAt out = distance_at(text(wanted), distance::in_scene(v, world.step()));
  out.features = std::move(features);
  return out;
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

std::optional<distance::SceneAnswer> without_witness(std::optional<distance::SceneAnswer> answer) {
  if (!answer) return answer;
  answer->witness.clear();
  answer->nearest.reset();
  return answer;
}

/// Not below 0, though the value it follows from may be without a bound below.
std::optional<distance::SceneAnswer> bounded_by_zero(std::optional<distance::SceneAnswer> v) {
  if (!v || !v->enclosed) return v;
  distance::Enclosure& ends = *v->enclosed;
  if (!ends.lower) ends.lower = Real();
  if (ends.upper) v->error = (*ends.upper - *ends.lower).to_double();
  return v;
}

DistanceAt derived_value(const Distance& wanted, const Derived& from, const DistanceAt& base) {
  std::optional<distance::SceneAnswer> v = without_witness(base.answer);
  if (from.cut) v = bounded_by_zero(distance::cut_off(std::move(v), from.negated));
  DistanceAt out = distance_at(text(wanted), std::move(v));
  out.in_degrees = base.in_degrees;
  return out;
}

/// Over time a value is a search: it is made once for those that follow from each other.
std::optional<Derived> derived_over_time(const PreparedWorld& world, const Distance& wanted) {
  const bool searched = world.motion().given() && !world.world().instant;
  return searched && wanted.mode != Mode::kRotation ? derived(wanted) : std::nullopt;
}

/// In the order of names that all_distances() has.
Distance as_listed(const PreparedWorld& world, const Distance& d) {
  return d.kind == Kind::kMu ? d : moving_first(d, world.world().moving);
}

/// Those that are not wanted, and that none follows from that is.
void leave_out_others(const PreparedWorld& world, std::vector<Distance>& wanted, const WantedText& is_wanted) {
  std::vector<Distance> needed;
  for (const Distance& d : wanted) {
    if (!is_wanted(text(d))) continue;
    needed.push_back(d);
    const auto from = derived_over_time(world, d);
    if (!from) continue;
    needed.push_back(as_listed(world, from->of));
    if (from->other) needed.push_back(as_listed(world, *from->other));
  }
  std::erase_if(wanted, [&](const Distance& d) { return std::find(needed.begin(), needed.end(), d) == needed.end(); });
}

}  // namespace

DistanceAt ranged_answer(const PreparedWorld& world, const Distance& wanted,
                         const std::optional<distance::ValueRange>& v) {
  const Roles r = world.roles(wanted);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  DistanceAt out = distance_at(text(wanted), std::nullopt);
  out.in_degrees = rotation;
  if (!v) return out;
  const double unit = rotation ? 1 : world.step().to_double(), value = shown_value(world, *v, r) * unit;
  if (value == exact::kInfinity) {
    out.refused = "nothing is known of the value here";
    return out;
  }
  const auto end = [&](double x) { return std::isinf(x) ? std::nullopt : std::optional(Real::from_double(x * unit)); };
  distance::SceneAnswer answer;
  answer.way = distance::Way::kSearch;
  if (v->low != v->high) answer.set_unproven();
  answer.minus_infinity = std::isinf(value);
  if (!answer.minus_infinity) answer.value = Real::from_double(value);
  answer.error = answer.proven ? 0 : (v->high - v->low) * unit;
  answer.enclosed = distance::Enclosure{end(v->low), end(v->high)};
  out.way = answer.way;
  out.answer = std::move(answer);
  return out;
}

DistanceAt distance_at(const PreparedWorld& world, const Distance& wanted, const RealPoint& p) {
  const Roles r = world.roles(wanted);
  const bool rotation = r.wanted.mode == Mode::kRotation;
  if (const auto rest = r.rotating ? at_rest(world, wanted, p) : std::nullopt) {
    DistanceAt out = distance_at(*rest->world, rest->distance, rest->at);
    return distance_at(text(wanted), without_witness(std::move(out.answer)));
  }
  if (r.rotating || (rotation && world.motion().given()))
    return ranged_answer(world, wanted, rotation_value(world, r, p));
  const bool plain = !world.motion().given() && r.wanted.mode == Mode::kPlain;
  auto v = plain ? world.pair(r.names)->measure(r.which(), p) : position_function(world, wanted)->value(p);
  DistanceAt out = !v                                               ? distance_at(text(wanted), std::nullopt)
                   : plain || !v->nearest || world.motion().given() ? named_answer(world, wanted, r, *std::move(v), p)
                                                                    : with_contact(world, wanted, r, *std::move(v), p);
  out.in_degrees = wanted.mode == Mode::kRotation;
  return out;
}

DistanceAt plain_distance_at(const PreparedWorld& world, const Distance& wanted, distance::PlanarAnswer answer,
                             const RealPoint& p) {
  return named_answer(world, wanted, world.roles(wanted), std::move(answer), p);
}

std::vector<DistanceAt> measure_at(const PreparedWorld& world, const RealPoint& p, const Formula& formula,
                                   const WantedText& is_wanted) {
  std::vector<Distance> wanted = all_distances(world.world());
  for (const SignMap& m : formula.sign_maps()) {
    if (std::find(wanted.begin(), wanted.end(), m.distance) == wanted.end()) wanted.push_back(m.distance);
  }
  if (is_wanted) leave_out_others(world, wanted, is_wanted);
  std::vector<DistanceAt> out(wanted.size());
  std::vector<std::size_t> source(wanted.size());
  const auto place = [&](const Distance& d) {
    return std::size_t(std::find(wanted.begin(), wanted.end(), as_listed(world, d)) - wanted.begin());
  };
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    source[k] = k;
    const auto d = derived_over_time(world, wanted[k]);
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
    if (!out[source[k]].refused.empty() || (d.other && !out[place(*d.other)].refused.empty())) {
      out[k] = distance_at(world, wanted[k], p);
      continue;
    }
    out[k] = derived_value(wanted[k], d, out[source[k]]);
    if (!d.other) continue;
    const std::optional<distance::SceneAnswer>& other = out[place(*d.other)].answer;
    if (out[k].answer && other)
      out[k].answer = distance::greater(*std::move(out[k].answer), *other);
    else
      out[k] = distance_at(text(wanted[k]), std::nullopt);  // +infinity, as one of both is
  }
  return out;
}

}  // namespace findspace::formula
