// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for a low container of solids (solid_search.h) that ends in a proof where there are few of them: a short
// search, then branch and bound (solid_proof/least_height.h), which finds better layouts itself, then search again if
// that did not come to its end. The layout states the bound that was proved. Guarantee: those of the two. Cost: as long
// as allowed; without limits the proof ends after some minutes.
#pragma once

#include "packing/solid_search/solid_search.h"

namespace findspace::packing {

/// As search_solids().
std::optional<SolidLayout> search_solids_to_proof(const SolidProblem& problem, const SolidSearchOptions& options,
                                                  const SolidSearchEvents& events, const StopWish& stop);

}  // namespace findspace::packing
