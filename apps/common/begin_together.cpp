// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/begin_together.h"

#include <array>
#include <exception>
#include <string>

#include "findspace/error.h"
#include "findspace/team.h"

namespace findspace::app {

void begin_together(const Options& options, const std::function<void()>& begin) {
  if (options.team == nullptr) return begin();
  std::exception_ptr thrown;
  std::string fault;
  try {
    begin();
  } catch (const std::exception& e) {
    thrown = std::current_exception();
    fault = e.what();
  }
  const std::array<double, 1> cost{thrown ? 0.0 : 1.0};
  const std::string first = options.team->best_of(cost, fault);
  if (thrown) std::rethrow_exception(thrown);
  if (!first.empty()) throw Error(ErrorCode::kFile, "another process cannot begin: " + first);
}

}  // namespace findspace::app
