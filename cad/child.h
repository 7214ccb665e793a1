// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A CAD file that another process holds. Open CASCADE may crash on damaged files, so it runs in a child of this process
// and answers through a socket; where it dies, that is a message. Guarantee: no crash of the child is one of the
// caller; the child ends with the file, and with the process. Cost: a fork, and one copy of what is asked for.
// Keywords: fork, sandbox, socketpair.
#pragma once

#include <functional>
#include <memory>

#include "io/cad/cad_model.h"

namespace findspace::cad {

using ReadHere = std::function<std::unique_ptr<io::CadFile>(io::CadProblem&)>;

/// Runs `read` in a child. Null and a problem where it finds one, or dies.
std::unique_ptr<io::CadFile> read_in_child(const ReadHere& read, io::CadProblem& problem);

}  // namespace findspace::cad
