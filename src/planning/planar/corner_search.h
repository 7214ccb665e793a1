// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One complete placement, where no better method decides: body after body is tried at the corners of what those before
// it leave (and at one more position of it), with backtracking. Guarantee: what is found satisfies every condition
// exactly, those on coordinates included; finding nothing proves nothing. Cost: a few regions for each try; at most
// 3,000 tries, or the limit. Keywords: backtracking, depth-first search, bottom-left.
#pragma once

#include "planning/order/choose.h"
#include "planning/order/relations.h"

namespace findspace::planning {

/// All poses, or nothing.
std::optional<Poses> search_corners(const Relations& relations, const Limit& limit);

}  // namespace findspace::planning
