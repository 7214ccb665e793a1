// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the program says beside its results, all of it on standard error: notes, errors, and on a terminal the stage it
// is in. Colour on a terminal only, and not where NO_COLOR is set (https://no-color.org).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "findspace/error.h"

namespace findspace::app {

class Reporter {
 public:
  explicit Reporter(bool quiet = false);
  /// Keeps the notes, and says nothing of stages.
  explicit Reporter(std::vector<std::string>& notes);
  ~Reporter();
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  void note(std::string_view text);
  /// Errors are said even when quiet.
  void error(std::string_view text);
  void error(const Error& error);
  /// Replaces the line that says what the program is doing; "" removes it.
  void stage(std::string_view text);

 private:
  bool quiet_, terminal_, colour_;
  bool staged_ = false;
  std::vector<std::string>* notes_ = nullptr;
};

}  // namespace findspace::app
