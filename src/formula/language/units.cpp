// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/units.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace findspace::formula {
namespace {

// Nanometres; the inch is 25.4 mm by definition since 1959.
constexpr std::array<std::int64_t, 6> kNanometres{1'000, 1'000'000, 10'000'000, 1'000'000'000, 25'400'000, 25'400};

/// As people spell them.
constexpr std::array<std::pair<std::string_view, Unit>, 8> kOtherNames{{{"mils", Unit::kMil},
                                                                        {"thou", Unit::kMil},
                                                                        {"inch", Unit::kInch},
                                                                        {"inches", Unit::kInch},
                                                                        {"micron", Unit::kMicrometre},
                                                                        {"microns", Unit::kMicrometre},
                                                                        {"metre", Unit::kMetre},
                                                                        {"meter", Unit::kMetre}}};

}  // namespace

std::optional<Unit> find_unit(std::string_view text) {
  if (text == "\u00b5m" || text == "\u03bcm") return Unit::kMicrometre;  // micro sign, Greek mu
  for (const auto& [word, unit] : kOtherNames)
    if (text == word) return unit;
  const auto place = std::find(kUnitNames.begin(), kUnitNames.end(), text);
  if (place == kUnitNames.end()) return std::nullopt;
  return static_cast<Unit>(place - kUnitNames.begin());
}

std::string_view name(Unit unit) { return kUnitNames[static_cast<std::size_t>(unit)]; }

exact::Real factor(Unit from, Unit to) {
  return exact::Real::ratio(kNanometres[static_cast<std::size_t>(from)], kNanometres[static_cast<std::size_t>(to)]);
}

}  // namespace findspace::formula
