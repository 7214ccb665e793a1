// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/told.h"

#include "common/session.h"

namespace findspace::app {
namespace {

ExitStatus status_of(const Answer& answer) {
  switch (answer.found()) {
    case Answer::Found::kYes:
      return kDone;
    case Answer::Found::kNo:
      return kEmpty;
    case Answer::Found::kUndecided:
      break;
  }
  return answer.sampled() ? kDone : kLimit;  // no limit came first: the lines were all asked
}

}  // namespace

Outcome told(const Session& session, const Answer& answer) {
  const Options& options = session.options();
  const Telling telling{options.all || !options.only.empty(), options.explain, options.exact, options.dxf};
  Writers writers;
  Streams streams;
  const auto json = [answer, telling](const TextSink& sink) { answer.write(".json", sink, telling); };
  for (const std::string& ending : answer.endings()) {
    if (answer.written_in_parts() && ending == ".json") {
      streams.emplace(ending, json);
      continue;
    }
    writers.emplace(ending, [&, ending] {
      Region::Drawn file = answer.file(ending, telling);
      if (!file.lost.empty()) session.reporter().note(file.lost);
      return std::move(file.text);
    });
  }
  write_outputs(options, writers, streams);
  const ExitStatus status = status_of(answer);
  if (options.json && answer.written_in_parts()) return {{}, status, json};
  return {options.json ? answer.json(telling) : answer.text(telling), status};
}

}  // namespace findspace::app
