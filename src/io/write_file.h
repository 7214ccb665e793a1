// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Files written whole or not at all: the text goes to a temporary file beside the target, which is then renamed over
// it. A reader never sees half a file, and a failure leaves what was there before. Keywords: atomic write, rename.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "io/spool.h"

namespace findspace::io {

/// Throws Error(kFile) with the path and the system's reason.
void write_file(const std::filesystem::path& path, std::string_view text);
/// The same for what `make` gives piece by piece.
void write_file(const std::filesystem::path& path, const std::function<void(const Sink&)>& make);

}  // namespace findspace::io
