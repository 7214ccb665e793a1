// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a file lies in a folder, links followed first: what counts is the file that would be opened.
#pragma once

#include <filesystem>

namespace findspace::app {

/// The file need not be there.
bool is_inside_folder(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace findspace::app
