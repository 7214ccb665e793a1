// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A verdict about a layout in words and as JSON.
#pragma once

#include <string>

#include "packing/proof/verify.h"

namespace findspace::app {

std::string verdict_text(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);
std::string verdict_json(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict);

}  // namespace findspace::app
