// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/separation.h"

namespace findspace::packing {

template class SeparationOf<PlaneKit>;

}  // namespace findspace::packing
