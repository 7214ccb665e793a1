// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A first look at the text of a STEP or IGES file, before Open CASCADE sees it: it ends as such a file ends, and each
// value is one. Words that are no value, such as nan, and numbers too large for a part, make Open CASCADE run without
// end or crash. Cost: linear. Keywords: ISO 10303-21, IGES 5.3, validation.
#pragma once

#include <string>

namespace findspace::cad {

/// Throw Problem, with the entity and the line.
void check_step_text(const std::string& bytes);
void check_iges_text(const std::string& bytes);

}  // namespace findspace::cad
