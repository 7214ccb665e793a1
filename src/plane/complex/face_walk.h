// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Visits the faces of an arrangement one from another across edges. Cost: linear.
#pragma once

#include <utility>
#include <vector>

#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// Calls visit(h) once for every face that is reached from the given ones, all different, across edges whose half-edges
/// `crosses` takes: the face on the left of half-edge h has been visited or is given, that of its twin is new.
template <class Crosses, class Visit>
void walk_faces(const Arrangement& a, std::vector<Index> from, Crosses&& crosses, Visit&& visit) {
  std::vector<Index> first(a.face_count, kNone), next(a.face.size());  // lists of the half-edges of each face
  for (Index h = 0; h < a.face.size(); ++h) {
    next[h] = first[a.face[h]];
    first[a.face[h]] = h;
  }
  std::vector<char> known(a.face_count, 0);
  std::vector<Index> todo = std::move(from);
  todo.reserve(a.face_count);
  for (Index f : todo) known[f] = 1;
  while (!todo.empty()) {
    Index f = todo.back();
    todo.pop_back();
    for (Index h = first[f]; h != kNone; h = next[h]) {
      Index g = a.face[h ^ 1u];
      if (known[g] || !crosses(h)) continue;
      known[g] = 1;
      visit(h);
      todo.push_back(g);
    }
  }
}

/// The same for every bounded face, from the unbounded one.
template <class Visit>
void walk_faces(const Arrangement& a, Visit&& visit) {
  walk_faces(
      a, {0}, [](Index) { return true; }, visit);
}

/// Is the sector after rank s (counter-clockwise) passed when turning counter-clockwise from rank `from` to rank `to`?
inline bool passes(Index s, Index from, Index to) { return from <= to ? from <= s && s < to : s >= from || s < to; }

}  // namespace findspace::plane
