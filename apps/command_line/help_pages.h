// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What `findspace help` and the ends of `--help` say: short pages for a terminal of 100 columns. The words of formulas
// and units come from findspace/vocabulary.h.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::app {

/// A line of a list: `name`, and from column 30 on `text`, wrapped at 100 columns.
std::string help_entry(std::string_view name, std::string_view text);

/// The end of a help text: examples of one verb, or of all ("").
std::string help_examples(std::string_view verb);

/// "um, mm, cm, m, in or mil".
std::string unit_list();

struct HelpTopic {
  std::string_view name;
  std::string_view about;
  std::string (*page)();
};

std::span<const HelpTopic> help_topics();

}  // namespace findspace::app
