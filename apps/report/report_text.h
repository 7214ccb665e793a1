// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the text reports of the plane and of space share.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "io/draw/draw_layout.h"
#include "io/text/put.h"
#include "io/write/write_json.h"

namespace findspace::app {

using io::put;

/// "12.5 mm²" with `power` "²".
std::string size_text(double value, std::string_view unit, const char* power = "");
/// The line of a least or greatest value, if there is something to say.
std::string optimum_text(const distance::OptimalValue& best, std::string_view unit);

/// A line for each of the first components.
template <class Components, class Text>
void put_components(std::string& out, const Components& components, const Text& text) {
  constexpr std::size_t kMostListed = 20;
  const std::size_t n = std::min(components.size(), kMostListed);
  for (std::size_t i = 0; i < n; ++i) put(out, "  {:>3}  {}\n", i + 1, text(components[i]));
  if (n < components.size()) put(out, "  and {} more (--json lists all)\n", components.size() - n);
}

}  // namespace findspace::app
