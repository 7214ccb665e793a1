// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts that found no place on the sheets: each attempt adds one of them, or puts it in the place of less valuable
// ones, and separates what overlaps then. Guarantee: the value of a layout never falls, and it has no overlaps, in
// doubles. Cost: a separation an attempt. Keywords: knapsack, most valuable choice.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "packing/search/first_layout.h"

namespace findspace::packing {

/// One attempt with its own random numbers; nothing where it fails.
std::optional<FirstLayout> filled(const FieldTable& table, const Row& row, const std::vector<double>& values,
                                  const FirstLayout& from, std::uint64_t seed, std::uint64_t& work);

}  // namespace findspace::packing
