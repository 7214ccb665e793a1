// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The text of a scene with other values under some of its keys: everything else stays as it was written, comments too.
// Keywords: round trip, editing in place.
#pragma once

#include <string>
#include <vector>

namespace findspace::io {

/// `text` is a scene that was read; the value of a key is a string, or a list of strings where it has several. Without
/// a value the key is taken out. Throws Error where the text is none.
std::string edited_scene(const std::string& text, const std::string& key, const std::vector<std::string>& values);

}  // namespace findspace::io
