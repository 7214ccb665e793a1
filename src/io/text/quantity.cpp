// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/quantity.h"

#include <charconv>

namespace findspace::io {

std::optional<Quantity> quantity_in(std::string_view name) {
  constexpr std::string_view kBetween = " _-";
  constexpr int kMost = 1000000;
  const std::size_t times = name.find_last_not_of("0123456789");
  if (times == std::string_view::npos || times + 1 == name.size() || times < 2) return std::nullopt;
  if ((name[times] != 'x' && name[times] != 'X') || kBetween.find(name[times - 1]) == std::string_view::npos)
    return std::nullopt;
  const std::size_t last = name.find_last_not_of(kBetween, times - 1);
  int count = 0;
  const auto [end, error] = std::from_chars(name.data() + times + 1, name.data() + name.size(), count);
  if (last == std::string_view::npos || error != std::errc{} || count > kMost) return std::nullopt;
  return Quantity{std::string(name.substr(0, last + 1)), count};
}

}  // namespace findspace::io
