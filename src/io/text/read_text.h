// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A whole file as bytes: the only place that opens files to read them. Guarantee: all bytes up to the end of the file,
// or an Error. Only regular files are opened, so that nothing waits and nothing is endless. Keywords: fstat, FIFO,
// symbolic link, directory traversal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "findspace/text.h"
#include "plane/base/of_thread.h"

namespace findspace::io {

using findspace::read_standard_input;
using findspace::read_text;

/// Gives the text that the function reads, or another process's: one that reads files for several.
using TextReader = std::function<std::string(const std::function<std::string()>& read)>;

/// While it lives, this thread gets all texts of files by way of the reader. Null: it reads them itself.
using ReadTextBy = plane::OfThread<const TextReader>;

}  // namespace findspace::io
