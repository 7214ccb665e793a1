// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Gives back the memory of a list that is not read again, while other work on large sets goes on.
#pragma once

namespace findspace::plane {

template <class List>
void release(List& list) {
  list.clear();
  list.shrink_to_fit();
}

}  // namespace findspace::plane
