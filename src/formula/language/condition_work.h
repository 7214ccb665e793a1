// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the conditions of a formula may cost, counted before any of them is asked. A cell of a map of many levels of one
// distance is asked for all of them, so the n-th that differs costs n units of work. Distances of other shapes are told
// apart sooner: obstacles may be very many. Keywords: budget, limit, levels.
#pragma once

#include <cstdint>

#include "formula/language/formula.h"

namespace findspace::formula {

/// Throws Error(kLimit) where the conditions cost more than `limit` units. A formula that is joined of others is to be
/// charged as a whole.
void charge_conditions(const Formula& formula, std::uint64_t limit);

}  // namespace findspace::formula
