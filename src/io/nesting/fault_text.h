// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is wrong with a layout, as a sentence.
#pragma once

#include <string>

#include "packing/proof/verify.h"

namespace findspace::io {

/// "bracket#3"
std::string item_name(const packing::Problem& problem, const packing::Layout& layout, std::size_t item);
std::string fault_text(const packing::Problem& problem, const packing::Layout& layout, const packing::Fault& fault);

}  // namespace findspace::io
