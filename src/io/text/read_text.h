// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A whole file as bytes.
#pragma once

#include <filesystem>
#include <string>

namespace findspace::io {

/// Throws Error(kFile) where it is missing, a folder, or cannot be read to its end.
std::string read_text(const std::filesystem::path& path);

}  // namespace findspace::io
