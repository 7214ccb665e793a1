// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set as it counts in a Minkowski sum. Guarantee: exact. Cost: that of its parts (boundary.h). Keywords: operand.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "plane/complex/boundary.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {

/// A set whose sums are asked for; which marks belong to it; whether it is to be reflected through the origin.
struct Operand {
  const CellComplex& cells;
  bool (*wanted)(Mark);
  bool mirrored = false;
  bool flat = true;                                      // with its parts that have no interior
  const std::optional<GridFaces>* known_grid = nullptr;  // grid(), where it has been made

  std::vector<Part> solid_parts() const { return oriented(face_parts(cells, wanted)); }
  /// Calls `use` with one solid part after another, none of them kept.
  template <class Use>
  void each_solid_part(Use&& use) const {
    for (const Face& f : cells.faces) {
      if (!wanted(f.mark)) continue;
      Part part = face_part(cells, f, wanted);
      use(mirrored ? plane::mirrored(std::move(part)) : std::move(part));
    }
  }
  std::vector<Part> flat_parts() const {
    return flat ? oriented(plane::flat_parts(cells, wanted)) : std::vector<Part>();
  }
  std::optional<GridFaces> grid(Memory memory = kHeap) const { return grid_faces(cells, wanted, mirrored, memory); }

 private:
  std::vector<Part> oriented(std::vector<Part> parts) const;
};

}  // namespace findspace::plane
