// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/phi/plane_scan.h"

#include <array>

#include "space/phi/axis_scan.h"
#include "space/phi/depth_grid.h"

namespace findspace::space {
namespace {

/// The loops compiled for one width of vector registers.
struct Scans {
  Highest (*planes)(const PlaneBlock*, std::size_t, const Vector&);
  LineStretch (*line)(const PlaneBlock*, std::size_t, const Vector&, const Vector&, double, double);
  LineStretch (*axis)(const AxisPlanes&, double, double, double);
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
  TARGET LineStretch NAME##_axis(const AxisPlanes& planes, double x, double y, double shallow) {                  \
    return scan_axis_inline(planes, x, y, shallow);                                                               \
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
  if (unit == VectorUnit::kAvx512) return {avx512_planes, avx512_line, avx512_axis, avx512_cells};
  if (unit == VectorUnit::kAvx2) return {avx2_planes, avx2_line, avx2_axis, avx2_cells};
#endif
  return {plain_planes, plain_line, plain_axis, plain_cells};
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

LineStretch scan_axis(const AxisPlanes& planes, double x, double y, double shallow) {
  return fastest_scans().axis(planes, x, y, shallow);
}

LineStretch scan_axis_on(VectorUnit unit, const AxisPlanes& planes, double x, double y, double shallow) {
  return scans_of(unit).axis(planes, x, y, shallow);
}

AxisPlanes planes_on_axis(std::span<const PlaneBlock> planes, std::size_t axis, double level,
                          std::vector<HeightBlock>& blocks) {
  std::array<std::vector<std::array<double, 3>>, 3> kinds;  // along the axis, falling, rising
  for (const PlaneBlock& block : planes)
    for (std::size_t k = 0; k < 8; ++k) {
      if (block.d[k] == -std::numeric_limits<double>::infinity()) continue;
      const std::array<double, 3> normal{block.x[k], block.y[k], block.z[k]};
      const double slope = normal[axis], x = normal[axis == 0 ? 1 : 0], y = normal[axis == 2 ? 1 : 2];
      const bool rises = slope > level, falls = slope < -level;
      const double size = rises ? slope : falls ? -slope : 1;
      kinds[rises ? 2 : falls ? 1 : 0].push_back({x / size, y / size, block.d[k] / size});
    }
  std::array<std::uint32_t, 3> counts{};
  for (std::size_t kind = 0; kind < 3; ++kind) {
    counts[kind] = std::uint32_t((kinds[kind].size() + 7) / 8);
    for (std::size_t k = 0; k < 8 * std::size_t(counts[kind]); ++k) {
      if (k % 8 == 0) blocks.emplace_back();
      const bool is_real = k < kinds[kind].size();
      blocks.back().a[k % 8] = is_real ? kinds[kind][k][0] : 0;
      blocks.back().b[k % 8] = is_real ? kinds[kind][k][1] : 0;
      blocks.back().c[k % 8] = is_real ? kinds[kind][k][2] : -std::numeric_limits<double>::infinity();
    }
  }
  return {nullptr, counts[0], counts[1], counts[2]};
}

void scan_cells(const DepthGrid& grid, std::span<const Vector> at, std::span<double> values, std::span<int> facets) {
  fastest_scans().cells(grid, at, values, facets);
}

}  // namespace findspace::space
