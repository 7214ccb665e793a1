// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How many of a part are wanted, as names in drawings say it: "bracket x12". Keywords: quantity, layer name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace findspace::io {

struct Quantity {
  std::string name;
  int count = 1;  // from 0 to 1000000
};

/// A name and how many, with a blank, '_' or '-' between them; nothing where a name does not end so.
std::optional<Quantity> quantity_in(std::string_view name);

}  // namespace findspace::io
