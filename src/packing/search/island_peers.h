// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Other processes of a search (PackPeers), asked by one that may be alone. Keywords: island model.
#pragma once

#include <cstddef>

#include "findspace/pack_search.h"

namespace findspace::packing {

/// Null: it is alone.
inline bool any_of(PackPeers* peers, bool own) { return peers == nullptr ? own : peers->any(own); }
inline std::size_t number_of(const PackPeers* peers) { return peers == nullptr ? 0 : peers->number(); }

}  // namespace findspace::packing
