// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// An answer of the public headers as the outcome of a verb: its files are written, its text is printed.
#pragma once

#include <findspace/answer.h>

#include "common/options.h"

namespace findspace::app {

class Session;

/// What a file does not say is noted.
Outcome told(const Session& session, const Answer& answer);

}  // namespace findspace::app
