// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The connected components of a region and of its complement as point sets, and how they lie in one another. Two cells
// of one mark belong together where one is in the closure of the other; a vertex meets the faces around it directly.
// The components of both kinds form a tree rooted at the one that contains the unbounded face (the plane is
// unicoherent), so every other component lies in one hole of its parent. Cost: linear. Source: distances.md 8.1;
// Kuratowski, Topology II, 57.
#pragma once

#include <vector>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

struct Connection {
  std::vector<Index> faces, edges, vertices;  // cell -> component
  std::vector<Mark> mark;                     // component -> mark of its cells; component 0 has the unbounded face
  std::vector<int> holes;                     // component -> number of the components that lie directly in it

  Index count() const { return Index(mark.size()); }
};

Connection connect(const Region& s);

}  // namespace findspace::plane
