// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_free_sector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exact/margins/plane.h"
#include "plane/rotation/curve_meetings.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;
using Kind = ContactPair::Kind;

namespace {

constexpr std::size_t kFew = 14;
constexpr double kNarrow = 0.01;  // no sign: radians, sectors are not halved below

}  // namespace

/// dot(v, rotated w) = c.
FreeSector::Equation FreeSector::rotated_dot(const RealVector& v, const RealVector& w, Real c, bool back) {
  return {plane::dot(v, w), plane::cross(w, v), std::move(c), back};
}

/// |v - rotated w| = r.
FreeSector::Equation FreeSector::rotated_gap(const RealVector& v, const RealVector& w, const Real& r) {
  return rotated_dot(Real(2) * v, w, plane::dot(v, v) + plane::dot(w, w) - r * r);
}

FreeSector::FreeSector(const FreeQuestion& question, const ContactTies& ties, double middle, double half)
    : q_(question), ties_(ties), middle_(middle), half_(half), level_(question.level.to_double()) {}

void FreeSector::run(std::vector<ContactPair> pairs) {
  if (!q_.far) {
    std::erase_if(pairs, [&](const ContactPair& k) {
      return q_.curves.rough(k, middle_).least() > level_ + MeetingSpots::travel(q_.curves, k, half_) + q_.tolerance;
    });
  }
  if (pairs.size() > kFew && half_ > kNarrow) return halve(pairs);
  pairs_ = std::move(pairs);
  for (const ContactPair& k : pairs_) {
    forms_.push_back(q_.curves.sector(k, middle_));
    const auto same = [&](const ContactPair& m) { return ties_.alike(k, m); };
    alike_.push_back(std::size_t(std::find_if(pairs_.begin(), pairs_.end(), same) - pairs_.begin()));
  }
  spots_ = MeetingSpots(q_, pairs_, middle_, half_);
  const std::size_t n = pairs_.size();
  for (std::size_t i = 0; i < n; ++i) {
    q_.way ? single_on_way(i) : single(i);
    for (std::size_t k = i + 1; k < n; ++k) {
      touching(i, k);
      if (!spots_.may_meet(i, k)) continue;
      if (q_.way) {
        corner_on_way(i, k);
        continue;
      }
      if (spots_.may_meet_at_level(i, k)) corner(i, k);
      if (ties_.never_cross(pairs_[i], pairs_[k])) continue;
      for (std::size_t m = k + 1; m < n; ++m)
        if (spots_.may_meet(i, k, m) && !ties_.never_cross(pairs_[i], pairs_[m]) &&
            !ties_.never_cross(pairs_[k], pairs_[m]))
          meeting(i, k, m);
    }
  }
}

void FreeSector::halve(const std::vector<ContactPair>& pairs) {
  for (double side : {-0.5, 0.5}) {
    FreeSector half(q_, ties_, middle_ + side * half_, half_ / 2);
    half.run(q_.curves.pairs(pairs, half.middle_, half.half_));
    std::move(half.found.begin(), half.found.end(), std::back_inserter(found));
  }
}

/// Whether F can have a part within `tolerance` of s, at that angle.
bool FreeSector::possible(double angle, RoughPoint s, double tolerance) const {
  if (!q_.far && std::abs(s) > level_ + tolerance) return false;  // far: F may come into being anywhere
  return !surely_meets(q_.rotating.rotated(std::polar(1.0, angle)), q_.open, s, q_.either_way, tolerance);
}

bool FreeSector::in_sector(double angle) const {
  return std::abs(std::remainder(angle - middle_, 2 * kPi)) <= half_ + margin::kSectorSlack;
}

void FreeSector::add(ExactAngle t) {
  const double d = exact::Angle{t, Real()}.degrees();
  if (in_sector(d * kPi / 180)) found.push_back({d, std::move(t)});
}

/// One contact, exactly the level away in the direction in which B goes free (far: against it).
void FreeSector::single(std::size_t i) {
  const ContactPair& k = pairs_[i];
  const auto witness = [&](double angle) {
    const RoughCurve c = q_.curves.rough(k, angle);
    const RoughPoint u = c.line ? c.normal : std::abs(c.center) > q_.tolerance ? c.center / std::abs(c.center) : 1.0;
    for (double side : {1.0, -1.0}) {
      const RoughPoint s = side * level_ * u;
      if (std::abs(c.line ? dot(c.normal, s) - c.offset() : std::abs(s - c.center) - std::abs(c.radius)) <=
              q_.tolerance &&
          c.holds(s, q_.tolerance) && possible(angle, s, q_.tolerance))
        return true;
    }
    return false;
  };
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = q_.curves.fixed().rounds[k.fixed], &b = q_.curves.rotating().rounds[k.rotating];
    const Real rho = a.radius + b.radius;
    return solve(rotated_gap(a.center, b.center, q_.far ? rho + q_.level : rho - q_.level), witness);
  }
  if (!q_.far) solve(line_equation(k, q_.level), witness);
}

/// The angles at which the line of a pair is `away` from the origin.
FreeSector::Equation FreeSector::line_equation(const ContactPair& k, const Real& away) const {
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = q_.curves.fixed().edges[k.fixed];
    const RoundFeature& b = q_.curves.rotating().rounds[k.rotating];
    const RealVector n = exact_normal(a);
    return rotated_dot(n, b.center, plane::dot(n, a.p) + times_length(b.radius - away, n));
  }
  const RoundFeature& a = q_.curves.fixed().rounds[k.fixed];
  const EdgeFeature& b = q_.curves.rotating().edges[k.rotating];
  const RealVector n = exact_normal(b);
  return rotated_dot(n, a.center, times_length(a.radius - away, n) + plane::dot(n, b.p), true);
}

/// Two curves that touch with opposite normals: a gap with no play, a corner on an edge.
void FreeSector::touching(std::size_t i, std::size_t j) {
  const ContactPair *k = &pairs_[i], *m = &pairs_[j];
  if (k->kind != Kind::kRounds) std::swap(k, m);
  const bool lines = k->kind != Kind::kRounds;
  const auto witness = [&](double angle) {
    const RoughCurve c = q_.curves.rough(*k, angle), d = q_.curves.rough(*m, angle);
    if (lines) return opposite(c, d);
    RoughPoint u = d.line ? -d.normal : d.center - c.center;
    if (!d.line) {
      if (std::abs(u) <= q_.tolerance) return true;  // two circles in one
      u /= std::abs(u);
      if (!c.allows(u, margin::kOneDirectionAtRoot) && c.allows(-u, margin::kOneDirectionAtRoot)) u = -u;
    }
    const RoughPoint s = c.center + c.radius * u;
    return c.allows(u, margin::kOneDirectionAtRoot) &&
           (d.line ? d.holds(s, q_.tolerance) : d.allows(-u, margin::kOneDirectionAtRoot)) &&
           possible(angle, s, q_.tolerance);
  };
  if (lines) return parallel_lines(*k, *m, witness);
  const RoundFeature &a = q_.curves.fixed().rounds[k->fixed], &b = q_.curves.rotating().rounds[k->rotating];
  const Real rho = a.radius + b.radius;
  if (m->kind == Kind::kRounds) {
    const RoundFeature &c = q_.curves.fixed().rounds[m->fixed], &d = q_.curves.rotating().rounds[m->rotating];
    return solve(rotated_gap(a.center - c.center, b.center - d.center, rho + c.radius + d.radius), witness);
  }
  if (m->kind == Kind::kFixedEdge) {
    const EdgeFeature& e = q_.curves.fixed().edges[m->fixed];
    const RoundFeature& r = q_.curves.rotating().rounds[m->rotating];
    const RealVector n = exact_normal(e);
    const Real c = plane::dot(n, a.center - e.p) - times_length(rho + r.radius, n);
    return solve(rotated_dot(n, b.center - r.center, c), witness);
  }
  const RoundFeature& r = q_.curves.fixed().rounds[m->fixed];
  const EdgeFeature& e = q_.curves.rotating().edges[m->rotating];
  const RealVector n = exact_normal(e);
  const Real c = plane::dot(n, b.center - e.p) - times_length(rho + r.radius, n);
  solve(rotated_dot(n, a.center - r.center, c, true), witness);
}

/// Segments of one line, with opposite normals, of which some part may lie in F.
bool FreeSector::opposite(const RoughCurve& c, const RoughCurve& d) const {
  if (dot(c.normal, d.normal) > -1 + margin::kOneDirectionAtRoot ||
      std::abs(c.offset() + d.offset()) > q_.tolerance * 10)
    return false;
  if (!q_.far && std::max(c.least(), d.least()) > level_ + q_.tolerance) return false;
  const RoughPoint way = (c.q - c.p) / std::abs(c.q - c.p);
  const double from = dot(way, d.p - c.p), to = dot(way, d.q - c.p), length = std::abs(c.q - c.p);
  return std::max(from, to) >= -q_.tolerance && std::min(from, to) <= length + q_.tolerance;
}

template <class Witness>
void FreeSector::parallel_lines(const ContactPair& k, const ContactPair& m, Witness witness) {
  if (k.kind != m.kind) return edge_along_edge(k, m, witness);
  const bool back = k.kind == Kind::kTurningEdge;
  const auto& edges = back ? q_.curves.rotating().edges : q_.curves.fixed().edges;
  const EdgeFeature &e = edges[back ? k.rotating : k.fixed], &f = edges[back ? m.rotating : m.fixed];
  if (e.nx * f.nx + e.ny * f.ny > -1 + margin::kOneDirectionAtRoot) return;
  const RealVector n = exact_normal(e), o = exact_normal(f);
  if (plane::cross(n, o).sign() != 0) return;
  const auto& rounds = back ? q_.curves.fixed().rounds : q_.curves.rotating().rounds;
  const RoundFeature &r = rounds[back ? k.fixed : k.rotating], &t = rounds[back ? m.fixed : m.rotating];
  // Over n: offsets times the length, the second by n / -|o|.
  const Real ratio = plane::dot(n, o) / plane::dot(o, o);
  const Real c = plane::dot(n, e.p) - ratio * plane::dot(o, f.p) + times_length(r.radius + t.radius, n);
  solve(rotated_dot(n, r.center - t.center, c, back), witness);
}

template <class Witness>
void FreeSector::edge_along_edge(const ContactPair& k, const ContactPair& m, Witness witness) {
  const bool swap = k.kind == Kind::kTurningEdge;
  const RealVector n = exact_normal(q_.curves.fixed().edges[(swap ? m : k).fixed]),
                   o = exact_normal(q_.curves.rotating().edges[(swap ? k : m).rotating]);
  const double angle = std::atan2(rough(n.y), rough(n.x)) - std::atan2(rough(o.y), rough(o.x));
  if (!in_sector(angle) || !witness(angle)) return;
  const Real length = sqrt(plane::dot(n, n) * plane::dot(o, o));
  add({plane::dot(o, n) / length, plane::cross(o, n) / length});
}

const ExactSectorCurve& FreeSector::exact_form(std::size_t i, int quarters) {
  exact_forms_.resize(4 * pairs_.size());
  auto& form = exact_forms_[std::size_t(quarters & 3) * pairs_.size() + i];
  if (!form) form = q_.curves.exact_sector(pairs_[i], quarters & 3);
  return *form;
}

template <class Find>
void FreeSector::Solved::look(Find find) {
  if (std::exchange(looked, true)) return;
  for (const RootPlace& place : find()) places.emplace_back(place, false);
}

/// Two curves that meet exactly the level away.
void FreeSector::corner(std::size_t i, std::size_t k) {
  const double span = std::tan(half_ / 2) * (1 + margin::kSectorSlack),
               reach = 4 * std::max(spots_.travel(i), spots_.travel(k)) / half_;
  const auto polynomial = [&](int quarters) {
    const auto [f, g] = corner_lines(exact_form(alike_[i], quarters), exact_form(alike_[k], quarters), q_.level);
    const auto m = plane::meeting(f, g);
    return m.w.is_zero() ? exact::RotationPolynomial() : corner_polynomial(m, q_.level);
  };
  const std::size_t first = alike_[i], second = alike_[k];
  Solved& solved = solved_[{std::min(first, second), std::max(first, second), pairs_.size()}];
  solved.look([&] { return corner_places(forms_[first], forms_[second], level_, span); });
  for (auto& [place, done] : solved.places) {
    if (done) continue;
    const double angle = middle_ + 2 * std::atan(place.u), tolerance = 10 * q_.tolerance + place.tolerance * reach;
    const RoughCurve c = q_.curves.rough(pairs_[i], angle), d = q_.curves.rough(pairs_[k], angle);
    const std::vector<RoughMeeting> all = rough_meetings(c, d, q_.tolerance);
    const auto witness = [&](const RoughMeeting& m) {
      const double near = 10 * m.off + tolerance;
      return std::abs(std::abs(m.at) - level_) <= near && c.holds(m.at, near) && d.holds(m.at, near) &&
             possible(angle, m.at, near);
    };
    done = place.tolerance > margin::kWideRootPlace || std::any_of(all.begin(), all.end(), witness);
    if (done) add_roots(place, polynomial);
  }
}

/// Three curves that meet in one point, B being held there.
void FreeSector::meeting(std::size_t i, std::size_t k, std::size_t m) {
  const double span = std::tan(half_ / 2) * (1 + margin::kSectorSlack),
               reach = 4 * std::max({spots_.travel(i), spots_.travel(k), spots_.travel(m)}) / half_;
  std::array<std::size_t, 3> key{alike_[i], alike_[k], alike_[m]};
  std::sort(key.begin(), key.end());
  const auto polynomial = [&](int quarters) {
    const auto all = ordered(exact_form(key[0], quarters), exact_form(key[1], quarters), exact_form(key[2], quarters));
    const auto [f, g] = meeting_lines(all);
    const auto at = plane::meeting(f, g);
    return !all[0]->line && at.w.is_zero() ? exact::RotationPolynomial() : meeting_polynomial(*all[0], at);
  };
  Solved& solved = solved_[key];
  solved.look([&] { return meeting_places(forms_[key[0]], forms_[key[1]], forms_[key[2]], span); });
  for (auto& [place, done] : solved.places) {
    if (done) continue;
    const double angle = middle_ + 2 * std::atan(place.u), tolerance = 100 * q_.tolerance + place.tolerance * reach;
    const std::array<RoughCurve, 3> c{q_.curves.rough(pairs_[i], angle), q_.curves.rough(pairs_[k], angle),
                                      q_.curves.rough(pairs_[m], angle)};
    const auto s = place.tolerance > margin::kWideRootPlace ? std::nullopt : rough_meeting(c, tolerance);
    done = place.tolerance > margin::kWideRootPlace || (s && possible(angle, *s, tolerance));
    if (done) add_roots(place, polynomial);
  }
}

}  // namespace findspace::plane
