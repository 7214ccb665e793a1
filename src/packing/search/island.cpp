// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/island.h"

namespace findspace::packing {

template class IslandOf<PlaneKit>;

}  // namespace findspace::packing
