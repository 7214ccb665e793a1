// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Copies that a layout leaves out, with the reason: in the plane and in space.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace findspace::packing {

struct LeftOut {
  std::size_t part = 0;
  int copies = 0;
  std::string why;
};

/// What is missing of each part, where so many copies are placed. `fits`: whether a part fits a container at all; what
/// does not is `too_large`.
template <class Part, class Fits>
std::vector<LeftOut> left_out_of(const std::vector<Part>& parts, const std::vector<int>& placed, const Fits& fits,
                                 const char* too_large) {
  std::vector<LeftOut> result;
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (const int missing = parts[part].demand - placed[part]; missing > 0)
      result.push_back({part, missing, fits(part) ? "no container was found for it" : too_large});
  return result;
}

}  // namespace findspace::packing
