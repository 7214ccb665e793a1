// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What options accept, as messages for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::app {

/// What is wrong with a time limit, or nothing. The system's clock takes no more than 1e9.
std::string seconds(const std::string& text);
/// What is wrong with a number of threads, or nothing.
std::string thread_count(const std::string& text);
/// "500M": a whole number, with K, M, G or T for the powers of 1024; nothing where it is none, or 0.
std::optional<std::uint64_t> size_of(const std::string& text);
/// What is wrong with such a size, or nothing.
std::string size_text(const std::string& text);

/// What is wrong with a length of a packing, the size of its sheets, angles separated by commas, a tilt from 0 to 180
/// degrees, a seed, or a unit; or nothing.
std::string length_text(const std::string& text);
std::string sheet_text(const std::string& text);
std::string angles_text(const std::string& text);
std::string tilt_text(const std::string& text);
std::string seed_text(const std::string& text);
std::string unit_text(const std::string& text);

/// "; did you mean 'map'?", or "" where no name is near.
std::string meant(const std::string& word, const std::vector<std::string>& names);

/// Of the files that a verb other than pack can write, whatever the scene.
std::vector<std::string> endings_of(std::string_view verb);

}  // namespace findspace::app
