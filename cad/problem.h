// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Why a CAD file or a solid of it is refused, as this library throws it within itself. Keywords: error.
#pragma once

#include <string>

#include "io/cad/cad_model.h"

namespace findspace::cad {

struct Problem {
  io::CadProblem what;
};
[[noreturn]] inline void fail(io::CadFault fault, const std::string& message) { throw Problem{{fault, message}}; }

}  // namespace findspace::cad
