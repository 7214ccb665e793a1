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

/// "; did you mean 'map'?", or "" where no name is near.
std::string meant(const std::string& word, const std::vector<std::string>& names);

/// Of the files that a verb can write, whatever the scene.
std::vector<std::string> endings_of(std::string_view verb);

}  // namespace findspace::app
