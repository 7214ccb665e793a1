// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The library of CAD files, loaded when it is first asked for and never let go. Keywords: plugin, dlopen.
#pragma once

#include <string>

#include "io/cad/cad_model.h"

namespace findspace::io {

/// Its function, or null where there is none. `why`: what the system says of one that is there and cannot be loaded.
ReadCad* cad_reader(std::string* why = nullptr);

}  // namespace findspace::io
