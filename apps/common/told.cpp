// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/told.h"

#include "common/session.h"

namespace findspace::app {

Outcome told(const Session& session, const Answer& answer) {
  const Options& options = session.options();
  const Telling telling{options.all || !options.only.empty(), options.explain, options.exact, options.dxf};
  Writers writers;
  for (const std::string& ending : answer.endings())
    writers.emplace(ending, [&, ending] {
      Region::Drawn file = answer.file(ending, telling);
      if (!file.lost.empty()) session.reporter().note(file.lost);
      return std::move(file.text);
    });
  write_outputs(options, writers);
  const Answer::Found found = answer.found();
  return {options.json ? answer.json(telling) : answer.text(telling), found == Answer::Found::kYes  ? kDone
                                                                      : found == Answer::Found::kNo ? kEmpty
                                                                                                    : kLimit};
}

}  // namespace findspace::app
