// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The library of CAD files, loaded when it is first asked for and never let go. Keywords: plugin, dlopen.
#pragma once

#include "io/cad/cad_model.h"

namespace findspace::io {

/// Its function, or null where it cannot be loaded.
ReadCad* cad_reader();

}  // namespace findspace::io
