// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb `phi`, in the plane and in space.

#include <findspace/error.h>
#include <findspace/phi.h>
#include <fmt/format.h>

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"

namespace findspace::app {
namespace {

std::optional<Number> limit_of(const std::optional<std::string>& text, const char* option) {
  if (!text) return std::nullopt;
  if (const auto rho = decimal(*text); rho && *rho >= 0) return rho;
  throw Error(ErrorCode::kUsage, fmt::format("{} wants a decimal number >= 0, not '{}'", option, *text));
}

PhiQuestion limits_of(const Options& options) {
  PhiQuestion question;
  question.least = limit_of(options.min_distance, "--min-distance");
  question.greatest = limit_of(options.max_distance, "--max-distance");
  if (question.least && question.greatest && *question.least > *question.greatest)
    throw Error(ErrorCode::kUsage,
                fmt::format("--min-distance {} is more than --max-distance {}: no distance is allowed",
                            *options.min_distance, *options.max_distance));
  return question;
}

void note_parts(const Session& session, const std::string& name, std::size_t parts, const Shape::Rounded& rounded) {
  if (parts > 1) session.reporter().note(fmt::format("{}: {} convex parts", name, parts));
  if (rounded.points == 0) return;
  const std::string unit = session.scene().unit();
  session.reporter().note(fmt::format("{}: {} vertices of convex parts rounded, by at most {:.3g}{}{}", name,
                                      rounded.points, rounded.largest, unit.empty() ? "" : " ", unit));
}

}  // namespace

Outcome run_phi_verb(const Options& options, Reporter& reporter) {
  if ((options.min_distance || options.max_distance) && !options.at)
    throw Error(ErrorCode::kUsage, "--min-distance and --max-distance need the position of --at");
  PhiQuestion question = limits_of(options);
  const Session session(options, reporter);
  std::vector<std::string> endings{".json", ".txt", ".svg"};
  if (session.in_space()) endings.insert(endings.end() - 1, {".obj", ".off", ".stl"});
  check_outputs(options, endings);
  question.a = options.shapes[0];
  question.b = options.shapes[1];
  question.unit = session.scene().unit();
  const Shape a = session.scene().shape(question.a), b = session.scene().shape(question.b);
  const Phi phi(a, b);
  note_parts(session, question.a, phi.parts_of_a(), phi.rounded_of_a());
  note_parts(session, question.b, phi.parts_of_b(), phi.rounded_of_b());
  if (options.at) {
    question.at = asked_coordinates(session, session.in_space() ? 3 : 2);
    if (phi.form() == Phi::Form::kCurves) asked_position(session);  // refuses what is too far away
  }
  Writers writers;
  for (const std::string& ending : endings) writers.emplace(ending, [&, ending] { return phi.text(ending, question); });
  write_outputs(options, writers);
  if (options.json) return {phi.text(".json", question), kDone};
  return {options.outputs.empty() ? phi.text(".txt", question) : "", kDone};
}

}  // namespace findspace::app
