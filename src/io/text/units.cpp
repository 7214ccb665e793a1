// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/units.h"

#include <fmt/format.h>

#include "findspace/error.h"

namespace findspace::io {
namespace {

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
  return i;
}

}  // namespace

Unit parse_unit(std::string_view name) {
  if (auto unit = formula::find_unit(name)) return *unit;
  throw Error(ErrorCode::kUnknownName,
              fmt::format("unknown unit '{}'; the units are {}", name, fmt::join(formula::kUnitNames, ", ")));
}

std::size_t scan_number(std::string_view text) {
  std::size_t start = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t i = skip_digits(text, start);
  std::size_t digits = i - start;
  if (i < text.size() && text[i] == '.') {
    std::size_t end = skip_digits(text, i + 1);
    digits += end - i - 1;
    i = end;
  }
  if (digits == 0) return 0;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t sign = i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-') ? 1 : 0;
    std::size_t end = skip_digits(text, i + 1 + sign);
    if (end > i + 1 + sign) i = end;
  }
  return i;
}

std::string show(double value) { return fmt::format("{:.10g}", value == 0 ? 0.0 : value); }

}  // namespace findspace::io
