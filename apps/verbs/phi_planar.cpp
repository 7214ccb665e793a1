// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `phi` in the plane. Unions of polygons and discs go by their convex parts; every other body (arcs that bound
// no disc, irrational vertices) by its exact overlap region, whose signed distance gamma1 is a normalised Phi-function.
#include <findspace/error.h>
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "common/asked_numbers.h"
#include "distance/planar/at_position.h"
#include "io/write/write_json.h"
#include "io/write/write_planar_phi.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "verbs/phi_command.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;

/// The two bodies as closed sets, and the open set of positions where they overlap.
struct Overlap {
  plane::Region first, second, region;
};

Overlap overlap_of(const Session& session) {
  const Options& o = session.options();
  std::vector<plane::Region> shapes =
      session.regions({session.scene().shape(o.shapes[0]), session.scene().shape(o.shapes[1])});
  Overlap overlap{plane::closure(std::move(shapes[0])), plane::closure(std::move(shapes[1])), {}};
  session.reporter().stage("the contact curve");
  overlap.region = plane::remark(plane::contact_map(overlap.first, overlap.second),
                                 [](plane::Mark m) { return plane::Mark(m < 0); });
  return overlap;
}

std::string title_of(const Session& session) {
  return fmt::format("Phi-function of {} and {}", session.options().shapes[0], session.options().shapes[1]);
}

std::string picture(const Session& session, const Overlap& overlap, const std::optional<RealPoint>& at) {
  const Options& o = session.options();
  const plane::Summary summary = plane::summarize(overlap.region, session.step());
  io::Picture picture;
  picture.title = title_of(session);
  picture.subtitle = fmt::format("positions of {} where the two overlap; gamma12 is the boundary", o.shapes[1]);
  picture.step = session.step();
  picture.unit = session.unit();
  picture.region = &overlap.region;
  picture.summary = &summary;
  picture.fixed = {{o.shapes[0], &overlap.first}};
  picture.moving = {{o.shapes[1], &overlap.second}};
  if (at) picture.position = plane::Place{at->x.to_double(), at->y.to_double()};
  return io::picture_svg(picture);
}

/// Texts that are made when they are asked for.
Outcome finish(const Session& session, const std::function<std::string()>& json,
               const std::function<std::string()>& table, const std::function<std::string()>& svg) {
  const Options& options = session.options();
  write_outputs(options, {{".json", json}, {".txt", table}, {".svg", svg}});
  if (options.json) return {json(), kDone};
  return {options.outputs.empty() ? table() : "", kDone};
}

/// The bodies as convex parts, where they are unions of polygons and discs.
std::optional<Outcome> by_parts(const Session& session) {
  const Options& options = session.options();
  const io::Scene& scene = session.scene();
  const double step = scene.grid.step_size();
  const auto p = space::planar_parts(*scene.shape(options.shapes[0]), step);
  const auto q = space::planar_parts(*scene.shape(options.shapes[1]), step);
  if (!p || !q) return std::nullopt;
  const exact::int128 multiple = exact::int128(p->scale / std::gcd(p->scale, q->scale)) * q->scale;
  if (multiple > space::kCoordinateLimit) return std::nullopt;
  const auto scale = static_cast<std::int64_t>(multiple);
  const auto ps = space::at_scale(*p, scale), qs = space::at_scale(*q, scale);
  if (!ps || !qs) return std::nullopt;
  for (const auto& [name, parts] : {std::pair{options.shapes[0], ps->size()}, std::pair{options.shapes[1], qs->size()}})
    if (parts > 1) session.reporter().note(fmt::format("{}: {} convex parts", name, parts));
  const space::PlanarPhiUnion phi(*ps, *qs);
  io::PlanarPhiReport report;
  report.first = options.shapes[0];
  report.second = options.shapes[1];
  report.phi = &phi;
  report.parts_second = static_cast<int>(qs->size());
  report.step = session.step() / Real(scale);
  if (options.at) {
    const std::vector<Real> at = asked_anywhere(session, 2);
    report.at = RealPoint{at[0], at[1]};
    const RealPoint u{report.at->x / report.step, report.at->y / report.step};
    report.value = phi.at(u);
    report.limits = phi_limits(options, report.value->at.normalised * report.step.to_double(),
                               [&](const Real& rho) { return phi.compare_distance(u, rho / report.step); });
  }
  return finish(
      session, [&] { return io::planar_phi_json(report); }, [&] { return io::planar_phi_table(report); },
      [&] { return picture(session, overlap_of(session), report.at); });
}

struct CurveValue {
  RealPoint at;  // in the scene's unit
  double phi = 0;
  int sign = 0;
  std::optional<plane::Place> gradient;  // none on the curve itself
  std::vector<io::PhiLimit> limits;
};

CurveValue curve_value(const Session& session, const Overlap& overlap) {
  const RealPoint at = asked_position(session), p{at.x / session.step(), at.y / session.step()};
  const distance::AtPosition pair(std::make_shared<distance::ShapePair>(overlap.second, overlap.first));
  const distance::PlanarAnswer m = *pair.measure(distance::Which::kGamma1, p);
  CurveValue value{at, (m.value * session.step()).to_double(), m.value.sign(), std::nullopt, {}};
  if (m.nearest && value.sign != 0) {
    const double x = (p.x - m.nearest->x).to_double(), y = (p.y - m.nearest->y).to_double();
    const double size = std::hypot(x, y) * value.sign;
    value.gradient = plane::Place{x / size, y / size};
  }
  value.limits =
      phi_limits(session.options(), value.phi, [&](const Real& rho) { return compare(m.value * session.step(), rho); });
  return value;
}

std::string curve_json(const Session& session, const Overlap& overlap, const std::optional<CurveValue>& value) {
  const plane::Summary summary = plane::summarize(overlap.region, session.step());
  std::string out = fmt::format("{{\"dimension\":2,\"form\":\"curves\",\"overlap\":{}",
                                io::region_json(overlap.region, summary, session.step(), session.unit()));
  if (value) {
    out += fmt::format(
        ",\n\"at\":{{\"position\":[{},{}],\"phi\":{},\"normalised\":{},\"distance\":{},\"state\":\"{}\",\"gradient\":",
        value->at.x.text(), value->at.y.text(), value->phi, value->phi, value->sign > 0 ? value->phi : 0,
        io::state_name(value->sign < 0   ? space::State::kOverlap
                       : value->sign > 0 ? space::State::kApart
                                         : space::State::kContact));
    out += value->gradient ? fmt::format("[{},{}]", (*value->gradient)[0], (*value->gradient)[1]) : "null";
    out += io::limits_json(value->limits) + "}";
  }
  return out + "}\n";
}

std::string curve_table(const Session& session, const Overlap& overlap, const std::optional<CurveValue>& value) {
  const plane::Summary summary = plane::summarize(overlap.region, session.step());
  std::string out = fmt::format("{}: the boundary of a region of positions with area {} and {} components\n",
                                title_of(session), summary.area.value_or(0), summary.components.size());
  if (!value) return out;
  out += fmt::format("\nat ({}, {}): {}, Phi = {}\n", value->at.x.text(), value->at.y.text(),
                     value->sign < 0   ? "overlap"
                     : value->sign > 0 ? "apart"
                                       : "contact",
                     value->phi);
  return out + io::limits_table(value->limits);
}

Outcome by_curves(const Session& session) {
  const Overlap overlap = overlap_of(session);
  std::optional<CurveValue> value;
  if (session.options().at) value = curve_value(session, overlap);
  return finish(
      session, [&] { return curve_json(session, overlap, value); },
      [&] { return curve_table(session, overlap, value); },
      [&] { return picture(session, overlap, value ? std::optional(value->at) : std::nullopt); });
}

}  // namespace

Outcome planar_phi(const Session& session) {
  check_outputs(session.options(), {".json", ".txt", ".svg"});
  if (std::optional<Outcome> outcome = by_parts(session)) return *outcome;
  return by_curves(session);
}

}  // namespace findspace::app
