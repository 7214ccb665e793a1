// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a way that was tried says about the input. Another way is tried after a refusal that is the limit of a way. A
// fault of the input, such as a mesh that crosses itself, ends the question. Cost: none. Keywords: expected, result
// type.
#pragma once

#include <utility>

#include "exact/number/tried.h"

namespace findspace::formula {

/// The same; throws the error of a refusal that is a fault of the input.
template <class T>
exact::Tried<T> throwing_faults(exact::Tried<T> tried) {
  if (!tried && tried.refusal().fault()) throw tried.refusal().error;
  return tried;
}

}  // namespace findspace::formula
