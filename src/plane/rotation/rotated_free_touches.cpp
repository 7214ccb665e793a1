// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/margins/plane.h"
#include "plane/rotation/rotated_free_finders.h"

namespace findspace::plane {

using exact::Real;
using Kind = ContactPair::Kind;

void find_single(FreeSector& sector, std::size_t i) {
  const FreeQuestion& q = sector.question();
  const ContactPair& k = sector.pairs()[i];
  const auto witness = [&](double angle) {
    const RoughCurve c = q.curves.rough(k, angle);
    const RoughPoint u = c.line ? c.normal : std::abs(c.center) > q.tolerance ? c.center / std::abs(c.center) : 1.0;
    for (double side : {1.0, -1.0}) {
      const RoughPoint s = side * sector.level() * u;
      if (std::abs(c.line ? dot(c.normal, s) - c.offset() : std::abs(s - c.center) - std::abs(c.radius)) <=
              q.tolerance &&
          c.holds(s, q.tolerance) && sector.possible(angle, s, q.tolerance))
        return true;
    }
    return false;
  };
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = q.curves.fixed().rounds[k.fixed], &b = q.curves.rotating().rounds[k.rotating];
    const Real rho = a.radius + b.radius;
    return sector.solve(rotated_gap(a.center, b.center, q.far ? rho + q.level : rho - q.level), witness);
  }
  if (!q.far) sector.solve(line_equation(q.curves, k, q.level), witness);
}

namespace {

/// Segments of one line, with opposite normals, of which some part may lie in F.
bool opposite(const FreeSector& sector, const RoughCurve& c, const RoughCurve& d) {
  const FreeQuestion& q = sector.question();
  if (dot(c.normal, d.normal) > -1 + margin::kOneDirectionAtRoot ||
      std::abs(c.offset() + d.offset()) > q.tolerance * margin::kRotatedSum)
    return false;
  if (!q.far && std::max(c.least(), d.least()) > sector.level() + q.tolerance) return false;
  const RoughPoint way = (c.q - c.p) / std::abs(c.q - c.p);
  const double from = dot(way, d.p - c.p), to = dot(way, d.q - c.p), length = std::abs(c.q - c.p);
  return std::max(from, to) >= -q.tolerance && std::min(from, to) <= length + q.tolerance;
}

template <class Witness>
void edge_along_edge(FreeSector& sector, const ContactPair& k, const ContactPair& m, Witness witness) {
  const FreeQuestion& q = sector.question();
  const bool swap = k.kind == Kind::kTurningEdge;
  const RealVector n = exact_normal(q.curves.fixed().edges[(swap ? m : k).fixed]),
                   o = exact_normal(q.curves.rotating().edges[(swap ? k : m).rotating]);
  const double angle = std::atan2(rough(n.y), rough(n.x)) - std::atan2(rough(o.y), rough(o.x));
  if (!sector.holds(angle) || !witness(angle)) return;
  const Real length = sqrt(plane::dot(n, n) * plane::dot(o, o));
  sector.add({plane::dot(o, n) / length, plane::cross(o, n) / length}, AngleDepth::kClosed);
}

template <class Witness>
void parallel_lines(FreeSector& sector, const ContactPair& k, const ContactPair& m, Witness witness) {
  const FreeQuestion& q = sector.question();
  if (k.kind != m.kind) return edge_along_edge(sector, k, m, witness);
  const bool back = k.kind == Kind::kTurningEdge;
  const auto& edges = back ? q.curves.rotating().edges : q.curves.fixed().edges;
  const EdgeFeature &e = edges[back ? k.rotating : k.fixed], &f = edges[back ? m.rotating : m.fixed];
  if (e.nx * f.nx + e.ny * f.ny > -1 + margin::kOneDirectionAtRoot) return;
  const RealVector n = exact_normal(e), o = exact_normal(f);
  if (plane::cross(n, o).sign() != 0) return;
  const auto& rounds = back ? q.curves.fixed().rounds : q.curves.rotating().rounds;
  const RoundFeature &r = rounds[back ? k.fixed : k.rotating], &t = rounds[back ? m.fixed : m.rotating];
  // Over n: offsets times the length, the second by n / -|o|.
  const Real ratio = plane::dot(n, o) / plane::dot(o, o);
  const Real c = plane::dot(n, e.p) - ratio * plane::dot(o, f.p) + times_length(r.radius + t.radius, n);
  sector.solve(rotated_dot(n, r.center - t.center, c, back), witness);
}

}  // namespace

void find_touching(FreeSector& sector, std::size_t i, std::size_t j) {
  const FreeQuestion& q = sector.question();
  const ContactPair *k = &sector.pairs()[i], *m = &sector.pairs()[j];
  if (k->kind != Kind::kRounds) std::swap(k, m);
  const bool lines = k->kind != Kind::kRounds;
  const auto witness = [&](double angle) {
    const RoughCurve c = q.curves.rough(*k, angle), d = q.curves.rough(*m, angle);
    if (lines) return opposite(sector, c, d);
    RoughPoint u = d.line ? -d.normal : d.center - c.center;
    if (!d.line) {
      if (std::abs(u) <= q.tolerance) return true;  // two circles in one
      u /= std::abs(u);
      if (!c.allows(u, margin::kOneDirectionAtRoot) && c.allows(-u, margin::kOneDirectionAtRoot)) u = -u;
    }
    const RoughPoint s = c.center + c.radius * u;
    return c.allows(u, margin::kOneDirectionAtRoot) &&
           (d.line ? d.holds(s, q.tolerance) : d.allows(-u, margin::kOneDirectionAtRoot)) &&
           sector.possible(angle, s, q.tolerance);
  };
  if (lines) return parallel_lines(sector, *k, *m, witness);
  const RoundFeature &a = q.curves.fixed().rounds[k->fixed], &b = q.curves.rotating().rounds[k->rotating];
  const Real rho = a.radius + b.radius;
  if (m->kind == Kind::kRounds) {
    const RoundFeature &c = q.curves.fixed().rounds[m->fixed], &d = q.curves.rotating().rounds[m->rotating];
    return sector.solve(rotated_gap(a.center - c.center, b.center - d.center, rho + c.radius + d.radius), witness);
  }
  if (m->kind == Kind::kFixedEdge) {
    const EdgeFeature& e = q.curves.fixed().edges[m->fixed];
    const RoundFeature& r = q.curves.rotating().rounds[m->rotating];
    const RealVector n = exact_normal(e);
    const Real c = plane::dot(n, a.center - e.p) - times_length(rho + r.radius, n);
    return sector.solve(rotated_dot(n, b.center - r.center, c), witness);
  }
  const RoundFeature& r = q.curves.fixed().rounds[m->fixed];
  const EdgeFeature& e = q.curves.rotating().edges[m->rotating];
  const RealVector n = exact_normal(e);
  const Real c = plane::dot(n, b.center - e.p) - times_length(rho + r.radius, n);
  sector.solve(rotated_dot(n, a.center - r.center, c, true), witness);
}

}  // namespace findspace::plane
