// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What packing in the plane and in space share: options of the command line, how a search goes on, a verdict about a
// layout in words and as JSON.
#pragma once

#include <findspace/packing.h>
#include <findspace/solid_packing.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/options.h"

namespace findspace::app {

/// How the command line has the problem of that name read.
PackReading pack_reading(const Options& options, const std::string& name);

/// The limits, the seed and the threads of the command line; the search ends where an end is asked for.
findspace::Options search_options(const Options& options);

/// The other processes of a search, or null.
PackPeers* peers_of(const Options& options);

/// A layout of the problem to begin with: JSON, or an SVG of sparrow; `most` bytes. Throws Error.
PackLayout start_layout(const Packing& packing, const std::filesystem::path& path, std::uint64_t most);
SolidPackLayout start_layout(const SolidPacking& packing, const std::filesystem::path& path, std::uint64_t most);

/// A better layout, and a search under way; `size` is what is made small: "length".
std::string better_text(const PackProgress& state, std::string_view size);
std::string progress_text(const PackProgress& state, std::string_view size);

/// How large a layout is: "length" of a strip or the last sheet, "height" of solids.
struct LayoutSize {
  std::string_view word;
  const Number& value;
};
inline LayoutSize size_of(const PackLayout& layout) { return {"length", layout.length}; }
inline LayoutSize size_of(const SolidPackLayout& layout) { return {"height", layout.height}; }

/// A layout of so many items, checked.
std::string verdict_text(std::size_t items, const LayoutSize& size, const PackVerdict& verdict);
std::string verdict_json(std::size_t items, const LayoutSize& size, const PackVerdict& verdict);

}  // namespace findspace::app
