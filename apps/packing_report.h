// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A verdict about a layout in words and as JSON.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/nesting/read_nesting.h"
#include "options.h"
#include "packing/proof/verify.h"

namespace findspace::app {

/// The height, gap and edge of the command line.
io::NestingWishes nesting_wishes(const Options& options);

/// A layout of the problem to begin with: JSON, or an SVG of sparrow; `most` bytes. Throws Error.
packing::Layout start_layout(const packing::Problem& problem, const std::filesystem::path& path, std::uint64_t most);

std::string verdict_text(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);
std::string verdict_json(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);

}  // namespace findspace::app
