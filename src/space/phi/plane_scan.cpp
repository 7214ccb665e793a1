// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/plane_scan.h"

#include "space/phi/depth_grid.h"

namespace findspace::space {
namespace {

/// The loops compiled for one width of vector registers.
struct Scans {
  Highest (*planes)(const PlaneBlock*, std::size_t, const Vector&);
  LineStretch (*line)(const PlaneBlock*, std::size_t, const Vector&, const Vector&, double, double);
  void (*cells)(const DepthGrid&, std::span<const Vector>, std::span<double>, std::span<int>);
};

__attribute__((always_inline)) inline void scan_cells_inline(const DepthGrid& grid, std::span<const Vector> at,
                                                             std::span<double> values, std::span<int> facets) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const CellPlanes cell = grid.cell(at[i]);
    const Highest top = scan_planes_inline(cell.blocks, cell.count, at[i]);
    values[i] = top.value;
    if (!facets.empty()) facets[i] = cell.facets[top.plane];
  }
}

// The machine's registers are asked for here and not by the attribute target_clones: clang 14 makes one function of the
// clones, for the first of its targets, and a machine without that one stops at an illegal instruction.
#define FINDSPACE_SCANS(NAME, TARGET)                                                                             \
  TARGET Highest NAME##_planes(const PlaneBlock* blocks, std::size_t count, const Vector& u) {                    \
    return scan_planes_inline(blocks, count, u);                                                                  \
  }                                                                                                               \
  TARGET LineStretch NAME##_line(const PlaneBlock* blocks, std::size_t count, const Vector& u, const Vector& way, \
                                 double raised, double level) {                                                   \
    return scan_line_inline(blocks, count, u, way, raised, level);                                                \
  }                                                                                                               \
  TARGET void NAME##_cells(const DepthGrid& grid, std::span<const Vector> at, std::span<double> values,           \
                           std::span<int> facets) {                                                               \
    scan_cells_inline(grid, at, values, facets);                                                                  \
  }

FINDSPACE_SCANS(plain, )
#if defined(__x86_64__)
FINDSPACE_SCANS(avx2, __attribute__((target("avx2"))))
FINDSPACE_SCANS(avx512, __attribute__((target("avx512f"))))
#endif

#undef FINDSPACE_SCANS

Scans scans_of(VectorUnit unit) {
#if defined(__x86_64__)
  if (unit == VectorUnit::kAvx512) return {avx512_planes, avx512_line, avx512_cells};
  if (unit == VectorUnit::kAvx2) return {avx2_planes, avx2_line, avx2_cells};
#endif
  return {plain_planes, plain_line, plain_cells};
}

const Scans& fastest_scans() {
  static const Scans scans = scans_of(vector_units().back());
  return scans;
}

}  // namespace

std::vector<VectorUnit> vector_units() {
  std::vector<VectorUnit> units{VectorUnit::kPlain};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) units.push_back(VectorUnit::kAvx2);
  if (__builtin_cpu_supports("avx512f")) units.push_back(VectorUnit::kAvx512);
#endif
  return units;
}

Highest scan_planes(const PlaneBlock* blocks, std::size_t count, const Vector& u) {
  return fastest_scans().planes(blocks, count, u);
}

LineStretch scan_line(const PlaneBlock* blocks, std::size_t count, const Vector& u, const Vector& way, double raised,
                      double level) {
  return fastest_scans().line(blocks, count, u, way, raised, level);
}

LineStretch scan_line_on(VectorUnit unit, const PlaneBlock* blocks, std::size_t count, const Vector& u,
                         const Vector& way, double raised, double level) {
  return scans_of(unit).line(blocks, count, u, way, raised, level);
}

Highest scan_planes_on(VectorUnit unit, const PlaneBlock* blocks, std::size_t count, const Vector& u) {
  return scans_of(unit).planes(blocks, count, u);
}

void scan_cells(const DepthGrid& grid, std::span<const Vector> at, std::span<double> values, std::span<int> facets) {
  fastest_scans().cells(grid, at, values, facets);
}

}  // namespace findspace::space
