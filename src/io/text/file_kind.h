// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a file is of the kind that its ending names, seen from how it begins. It is asked before a reader sees the
// file, because a reader's messages show words of it, and no word of a file that is not a shape may be shown
// (docs/security.md). Cost: linear in the text at most. Keywords: magic number, file signature.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace findspace::io {

/// Throws Error(kFile), which shows nothing of the text. `ending` is in small letters: one of file_endings().
void require_kind(std::string_view text, std::string_view ending, const std::string& name);

/// A mark that some editors put before a text in UTF-8 is no part of it.
std::string_view without_byte_order_mark(std::string_view text);

/// Whether shapes are read from files with that ending; in space or in the plane.
bool is_space_ending(std::string_view ending);
bool is_plane_ending(std::string_view ending);
/// All of these endings.
std::vector<std::string_view> file_endings(bool space);
/// The ending in small letters.
std::string lower_ending(const std::string& ending);

}  // namespace findspace::io
