// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "verbs/phi_command.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <numeric>

#include "common/asked_numbers.h"
#include "common/commands.h"

namespace findspace::app {
namespace {

using exact::Real;

Real limit_of(const std::string& text, const char* option) {
  try {
    const Real rho = Real::parse_decimal(text);
    if (rho.sign() >= 0) return rho;
  } catch (const Error&) {
    // Said below.
  }
  throw Error(ErrorCode::kUsage, fmt::format("{} wants a decimal number >= 0, not '{}'", option, text));
}

void refuse_crossed_limits(const Options& options) {
  if (!options.min_distance || !options.max_distance) return;
  const Real least = limit_of(*options.min_distance, "--min-distance");
  const Real greatest = limit_of(*options.max_distance, "--max-distance");
  if (compare(least, greatest) <= 0) return;
  throw Error(ErrorCode::kUsage, fmt::format("--min-distance {} is more than --max-distance {}: no distance is allowed",
                                             *options.min_distance, *options.max_distance));
}

void note_parts(const Session& session, const std::string& name, const space::Body& body) {
  if (body.parts.size() > 1) session.reporter().note(fmt::format("{}: {} convex parts", name, body.parts.size()));
  if (body.rounded == 0) return;
  session.reporter().note(fmt::format("{}: {} vertices of convex parts rounded, by at most {:.3g} grid steps", name,
                                      body.rounded, body.moved));
}

space::Body body_of(const Session& session, const std::string& name) {
  space::Body body = space::body(*session.scene().shape(name));
  if (body.outside)
    throw Error(ErrorCode::kUnsupported, "a complement is not a union of convex parts",
                fmt::format("shape '{}'", name));
  note_parts(session, name, body);
  return body;
}

Writers writers(const io::PhiReport& report) {
  const std::string title = fmt::format("Phi-function of {} and {}", report.first, report.second);
  Writers out{{".json", [&] { return io::phi_json(report); }}, {".txt", [&] { return io::phi_table(report); }}};
  for (const char* ending : {".obj", ".off", ".stl", ".svg"})
    out.emplace(ending,
                [&report, title, ending] { return io::surface_text(io::phi_surface(report), title, ending, ""); });
  return out;
}

}  // namespace

std::vector<io::PhiLimit> phi_limits(const Options& options, double normalised,
                                     const std::function<int(const Real&)>& sign) {
  std::vector<io::PhiLimit> limits;
  const auto add = [&](const Real& rho, bool least) {
    const double off = normalised - rho.to_double();
    limits.push_back({least, rho, least ? off : -off, least ? sign(rho) : -sign(rho)});
  };
  if (options.min_distance) add(limit_of(*options.min_distance, "--min-distance"), true);
  if (options.max_distance) add(limit_of(*options.max_distance, "--max-distance"), false);
  return limits;
}

Outcome space_phi(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, {".json", ".txt", ".obj", ".off", ".stl", ".svg"});
  const std::string &first = options.shapes[0], &second = options.shapes[1];
  const space::Body p = body_of(session, first), q = body_of(session, second);
  const std::int64_t scale = std::lcm(p.scale, q.scale);
  const space::RoundedPhi phi(space::at_scale(p, scale).parts, space::at_scale(q, scale).parts);
  io::PhiReport report;
  report.first = first;
  report.second = second;
  report.phi = &phi;
  report.parts_second = static_cast<int>(q.parts.size());
  report.step = session.step() / Real(scale);
  if (options.at) {
    const std::vector<Real> at = asked_anywhere(session, 3);
    space::RealVector u;
    for (std::size_t k = 0; k < 3; ++k) {
      report.at[k] = at[k];
      u[k] = at[k] / report.step;
    }
    report.value = phi.at(u);
    report.limits = phi_limits(options, report.value->at.normalised * report.step.to_double(),
                               [&](const Real& rho) { return phi.compare_distance(u, rho / report.step); });
  }
  write_outputs(options, writers(report));
  if (options.json) return {io::phi_json(report), kDone};
  return {options.outputs.empty() ? io::phi_table(report) : "", kDone};
}

Outcome run_phi_verb(const Options& options, Reporter& reporter) {
  if ((options.min_distance || options.max_distance) && !options.at)
    throw Error(ErrorCode::kUsage, "--min-distance and --max-distance need the position of --at");
  refuse_crossed_limits(options);
  const Session session(options, reporter);
  return session.in_space() ? space_phi(session) : planar_phi(session);
}

}  // namespace findspace::app
