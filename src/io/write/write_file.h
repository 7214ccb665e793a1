// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Files written whole, and all or none: each text goes to a temporary file beside its target; when all are there,
// devices and pipes get theirs, and the temporary files are renamed over their targets. A reader never sees half a
// file, and a failure leaves what was there before (but for one of renaming, of which only a change of the folders
// meanwhile is left as a cause). Keywords: atomic write, rename.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/text/spool.h"

namespace findspace::io {

struct FileText {
  std::filesystem::path path;
  std::string text;
  std::function<void(const Sink&)> make = {};  // gives what is too long for memory, instead of the text
};

/// Throws Error(kFile) with the path and the system's reason. A file that is replaced keeps its mode; a read-only one
/// is not replaced.
void write_files(const std::vector<FileText>& files);

/// What write_files has done: nothing yet, a part of what goes to a device, or some of the files, each whole.
enum class Written { kNothing, kPart, kFiles };

/// For a process that ends within write_files, from a signal handler too: removes its temporary files.
Written remove_unfinished_files() noexcept;

}  // namespace findspace::io
