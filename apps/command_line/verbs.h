// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs of the program: what each answers, and what runs it.
#pragma once

#include <span>
#include <string_view>

#include "common/options.h"
#include "common/reporter.h"

namespace findspace::app {

struct VerbEntry {
  const char* name;
  const char* about;
  Outcome (*run)(const Options&, Reporter&);

  bool is(std::string_view other) const { return name == other; }
  /// Under mpirun all ranks take part; of other questions rank 0 answers alone.
  bool is_shared() const { return is("map") || is("describe") || is("pack") || is("batch"); }
  /// It answers requests until its client leaves.
  bool is_service() const { return is("serve") || is("view"); }
};

/// In the order of the help.
std::span<const VerbEntry> verbs();
/// Null where there is none of this name.
const VerbEntry* find_verb(std::string_view name);

}  // namespace findspace::app
