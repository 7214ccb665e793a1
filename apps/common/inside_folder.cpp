// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/inside_folder.h"

#include <algorithm>

namespace findspace::app {

bool is_inside_folder(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder);
  const std::filesystem::path whole = std::filesystem::weakly_canonical(file);
  return std::mismatch(root.begin(), root.end(), whole.begin(), whole.end()).first == root.end();
}

}  // namespace findspace::app
