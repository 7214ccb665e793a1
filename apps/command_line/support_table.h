// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The support table: which question is answered how for which kind of shape, and at what cost. docs/support.md is
// printed from it (`findspace help support --markdown`), and tests/support/claims.py asks every cell of the program.
#pragma once

#include <string>

namespace findspace::app {

/// The table for a terminal of 100 columns: under each question the answers, with the kinds of shapes that get them.
std::string support_page();

/// The same as docs/support.md.
std::string support_markdown();

}  // namespace findspace::app
