// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Units of length and the exact factors between them: every one is a whole number of nanometres, so 20mil is
// 508/1000 mm and not the nearest double.
// Keywords: unit conversion, inch, thou, micron, millimetre.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "exact/number/real.h"

namespace findspace::formula {

enum class Unit : std::uint8_t { kMicrometre, kMillimetre, kCentimetre, kMetre, kInch, kMil };

inline constexpr std::array<std::string_view, 6> kUnitNames{"um", "mm", "cm", "m", "in", "mil"};

/// The unit that `text` names (um mm cm m in mil; µm is um), if any.
std::optional<Unit> find_unit(std::string_view text);

std::string_view name(Unit unit);

/// How many `to` make one `from`, exactly.
exact::Real factor(Unit from, Unit to);

}  // namespace findspace::formula
