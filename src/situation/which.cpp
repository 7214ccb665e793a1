// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/which.h"

namespace findspace::situation {

using distance::Which;

Which which(Kind kind, bool second_moves) {
  switch (kind) {
    case Kind::kGamma1:
      return Which::kGamma1;
    case Kind::kGamma2:
      return Which::kGamma2;
    case Kind::kEta1:
      return Which::kEta1;
    case Kind::kEta2:
      return Which::kEta2;
    case Kind::kDelta1:
      return Which::kDelta1;
    case Kind::kDelta2:
      return Which::kDelta2;
    case Kind::kMu:
      return second_moves ? Which::kMuBack : Which::kMu;
    case Kind::kHausdorff:
      return Which::kHausdorff;
    case Kind::kD1:
      return Which::kD1;
    case Kind::kD2:
      return Which::kGamma2;
    case Kind::kH:
      return second_moves ? Which::kHBack : Which::kH;
    case Kind::kDstar:
      return second_moves ? Which::kDstarBack : Which::kDstar;
    case Kind::kDiameter:
      return Which::kDiameter;
    case Kind::kPenetration:
      return Which::kPenetration;
  }
  return Which::kGamma1;
}

}  // namespace findspace::situation
