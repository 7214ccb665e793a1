// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/plane_scan.h"

#include "space/phi/depth_grid.h"

namespace findspace::space {

#if defined(__x86_64__)
#define FINDSPACE_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define FINDSPACE_VECTOR_CLONES
#endif

FINDSPACE_VECTOR_CLONES
Highest scan_planes(const PlaneBlock* blocks, std::size_t count, const Vector& u) {
  return scan_planes_inline(blocks, count, u);
}

FINDSPACE_VECTOR_CLONES
void scan_cells(const DepthGrid& grid, std::span<const Vector> at, std::span<double> values, std::span<int> facets) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const CellPlanes cell = grid.cell(at[i]);
    const Highest top = scan_planes_inline(cell.blocks, cell.count, at[i]);
    values[i] = top.value;
    if (!facets.empty()) facets[i] = cell.facets[top.plane];
  }
}

}  // namespace findspace::space
