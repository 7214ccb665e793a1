// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The angles at which the least or greatest distance of a free position can cross a level (turned_free.h). Guarantee:
// all of them, some too many; ascending, no two within 1e-9 degrees unless both are exact and different. Cost: the
// circle is cut into sectors until few curves are left in each; there pairs and triples. Keywords: critical
// orientation.
#pragma once

#include "plane/contact_curves.h"

namespace findspace::plane {

struct FreeEvent {
  double degrees = 0;
  exact::Turn turn;
  bool exact = true;  // else the turn is near a root of higher degree
};

struct FreeQuestion {
  const ContactCurves& curves;
  const RoughSet& turning;  // B
  const RoughSet& open;     // O
  bool either_way;          // surely_meets
  exact::Real level;
  bool far;
  double room;  // lengths below it are nothing to the filter
};

std::vector<FreeEvent> free_events(const FreeQuestion& question);

}  // namespace findspace::plane
