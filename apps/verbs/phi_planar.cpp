// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `phi` in the plane: what shape_phi.h finds, as its convex parts or as the curves of its overlap region.
#include <findspace/error.h>
#include <fmt/format.h>

#include <array>

#include "common/asked_numbers.h"
#include "distance/planar/shape_phi.h"
#include "io/write/write_json.h"
#include "io/write/write_planar_phi.h"
#include "plane/query/summary.h"
#include "verbs/phi_command.h"

namespace findspace::app {
namespace {

using exact::Real;
using exact::RealPoint;

std::array<plane::Region, 2> regions_of(const Session& session) {
  const Options& o = session.options();
  std::vector<plane::Region> shapes =
      session.regions({session.scene().shape(o.shapes[0]), session.scene().shape(o.shapes[1])});
  return {std::move(shapes[0]), std::move(shapes[1])};
}

plane::Region overlap_of(const Session& session, const distance::PhiCurves& curves) {
  session.reporter().stage("the contact curve");
  return curves.overlap();
}

std::string title_of(const Session& session) {
  return fmt::format("Phi-function of {} and {}", session.options().shapes[0], session.options().shapes[1]);
}

std::string picture(const Session& session, const distance::PhiCurves& curves, const plane::Region& overlap,
                    const std::optional<RealPoint>& at) {
  const Options& o = session.options();
  const plane::Summary summary = plane::summarize(overlap, session.step());
  io::Picture picture;
  picture.title = title_of(session);
  picture.subtitle = fmt::format("positions of {} where the two overlap; gamma12 is the boundary", o.shapes[1]);
  picture.step = session.step();
  picture.unit = session.unit();
  picture.region = &overlap;
  picture.summary = &summary;
  picture.fixed = {{o.shapes[0], &*curves.a()}};
  picture.moving = {{o.shapes[1], &*curves.b()}};
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

Outcome outcome_of_parts(const Session& session, const distance::PhiParts& parts) {
  const Options& options = session.options();
  for (const auto& [name, count] : {std::pair{options.shapes[0], parts.a}, std::pair{options.shapes[1], parts.b}})
    if (count > 1) session.reporter().note(fmt::format("{}: {} convex parts", name, count));
  io::PlanarPhiReport report;
  report.first = options.shapes[0];
  report.second = options.shapes[1];
  report.phi = &parts.phi;
  report.parts_second = static_cast<int>(parts.b);
  report.step = parts.unit;
  if (options.at) {
    const std::vector<Real> at = asked_anywhere(session, 2);
    report.at = RealPoint{at[0], at[1]};
    const RealPoint u{report.at->x / report.step, report.at->y / report.step};
    report.value = parts.phi.at(u);
    report.limits = phi_limits(options, report.value->at.normalised * report.step.to_double(),
                               [&](const Real& rho) { return parts.phi.compare_distance(u, rho / report.step); });
  }
  const auto svg = [&] {
    auto [first, second] = regions_of(session);
    const distance::PhiCurves curves(std::move(first), std::move(second));
    return picture(session, curves, overlap_of(session, curves), report.at);
  };
  return finish(
      session, [&] { return io::planar_phi_json(report); }, [&] { return io::planar_phi_table(report); }, svg);
}

struct CurveValue {
  RealPoint at;  // in the scene's unit
  space::PlanarAt phi;
  std::vector<io::PhiLimit> limits;
};

CurveValue curve_value(const Session& session, const distance::ShapePhi& phi) {
  const RealPoint at = asked_position(session);
  CurveValue value{at, phi.at(at).at, {}};
  value.limits = phi_limits(session.options(), value.phi.normalised,
                            [&](const Real& rho) { return phi.compare_distance(at, rho); });
  return value;
}

std::string curve_json(const Session& session, const plane::Region& overlap, const std::optional<CurveValue>& value) {
  const plane::Summary summary = plane::summarize(overlap, session.step());
  std::string out = fmt::format("{{\"dimension\":2,\"form\":\"curves\",\"overlap\":{}",
                                io::region_json(overlap, summary, session.step(), session.unit()));
  if (value) {
    const space::PlanarAt& phi = value->phi;
    out += fmt::format(
        ",\n\"at\":{{\"position\":[{},{}],\"phi\":{},\"normalised\":{},\"distance\":{},\"state\":\"{}\",\"gradient\":",
        value->at.x.text(), value->at.y.text(), phi.phi, phi.normalised, phi.distance, io::state_name(phi.state));
    const bool defined = phi.gradient.x != 0 || phi.gradient.y != 0;  // not on the curve itself
    out += defined ? fmt::format("[{},{}]", phi.gradient.x, phi.gradient.y) : "null";
    out += io::limits_json(value->limits) + "}";
  }
  return out + "}\n";
}

std::string curve_table(const Session& session, const plane::Region& overlap, const std::optional<CurveValue>& value) {
  const plane::Summary summary = plane::summarize(overlap, session.step());
  std::string out = fmt::format("{}: the boundary of a region of positions with area {} and {} components\n",
                                title_of(session), summary.area.value_or(0), summary.components.size());
  if (!value) return out;
  out += fmt::format("\nat ({}, {}): {}, Phi = {}\n", value->at.x.text(), value->at.y.text(),
                     io::state_name(value->phi.state), value->phi.phi);
  return out + io::limits_table(value->limits);
}

Outcome outcome_of_curves(const Session& session, const distance::ShapePhi& phi) {
  const distance::PhiCurves& curves = *phi.curves();
  const plane::Region overlap = overlap_of(session, curves);
  std::optional<CurveValue> value;
  if (session.options().at) value = curve_value(session, phi);
  return finish(
      session, [&] { return curve_json(session, overlap, value); },
      [&] { return curve_table(session, overlap, value); },
      [&] { return picture(session, curves, overlap, value ? std::optional(value->at) : std::nullopt); });
}

}  // namespace

Outcome planar_phi(const Session& session) {
  check_outputs(session.options(), {".json", ".txt", ".svg"});
  const Options& o = session.options();
  const distance::ShapePhi phi(*session.scene().shape(o.shapes[0]), *session.scene().shape(o.shapes[1]), session.step(),
                               [&] { return regions_of(session); });
  return phi.parts() != nullptr ? outcome_of_parts(session, *phi.parts()) : outcome_of_curves(session, phi);
}

}  // namespace findspace::app
