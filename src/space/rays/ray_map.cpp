// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/ray_map.h"

#include <findspace/error.h>

#include <algorithm>

#include "plane/base/parallel.h"

namespace findspace::space {
namespace {

/// Rows in flight: enough work for many threads, little memory, and independent of their number.
constexpr int kRowsAtOnce = 32;
constexpr int kMostLines = 1 << 14;
/// Cells are even to one part in this.
constexpr std::int64_t kEven = 1 << 20;

}  // namespace

RayGrid ray_grid(const Point& low, const Point& high, int axis, int n) {
  if (n < 1 || n > kMostLines) throw Error(ErrorCode::kBadValue, "a ray map has 1 to 16384 lines each way");
  RayGrid grid;
  grid.axis = axis;
  grid.nu = grid.nv = n;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const std::int64_t width = component(high, a) - component(low, a), height = component(high, b) - component(low, b);
  std::int64_t largest = 1;
  for (const Point& p : {low, high}) {
    for (const std::int64_t c : {p.x, p.y, p.z}) largest = std::max(largest, c < 0 ? -c : c);
  }
  while (std::min(width, height) * grid.parts / n < kEven && largest * grid.parts < exact::kRayLimit / 8)
    grid.parts *= 2;
  const auto step = [&](std::int64_t size) { return std::max<std::int64_t>(1, (size * grid.parts + n - 1) / n); };
  grid.du = step(width);
  grid.dv = step(height);
  grid.u = component(low, a) * grid.parts + grid.du / 2;
  grid.v = component(low, b) * grid.parts + grid.dv / 2;
  return grid;
}

RayGrid ray_grid_by_step(const Point& low, const Point& high, int axis, std::int64_t step) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const auto lines = [&](int k) {
    const std::int64_t count = std::max<std::int64_t>((component(high, k) - component(low, k) + step - 1) / step, 1);
    if (count > kMostLines)
      throw Error(ErrorCode::kBadValue, "lines so near each other are more than 16384, which a ray map has each way");
    return static_cast<int>(count);
  };
  // Parts of a half: the middle of a cell may lie between two grid points.
  return {axis, 2, 2 * component(low, a) + step, 2 * component(low, b) + step, 2 * step, 2 * step, lines(a), lines(b)};
}

bool same_root(const RayPosition& p, const RayPosition& q) {
  return p.roots && p.roots == q.roots && p.patch == q.patch && p.which == q.which && p.i == q.i && p.j == q.j;
}

int compare_positions(const RayPosition& p, const RayPosition& q) {
  const double gap = p.value - q.value, blur = (p.radius + q.radius) * 2;
  if (gap > blur) return 1;
  if (gap < -blur) return -1;
  if (!p.roots && !q.roots) return exact::compare_fractions(p.exact, q.exact);
  if (same_root(p, q)) return 0;
  return exact::compare(p.to_real(), q.to_real());
}

std::int8_t sign_at(const RayRow& row, int i, const exact::Real& z) {
  const auto line = static_cast<std::size_t>(i);
  std::int8_t sign = row.before[line];
  for (int e = row.first[line]; e < row.first[line + 1]; ++e) {
    const RayEvent& event = row.events[static_cast<std::size_t>(e)];
    const int order = exact::compare(event.at.to_real(), z);
    if (order >= 0) return order == 0 ? event.here : sign;
    sign = event.after;
  }
  return sign;
}

void RaySource::each_row(const std::function<void(int, RayRow&&)>& take) const {
  const int rows = grid().nv;
  for (int begin = 0; begin < rows; begin += kRowsAtOnce) {
    const int count = std::min(kRowsAtOnce, rows - begin);
    std::vector<RayRow> block(count);
    plane::parallel_for(static_cast<std::size_t>(count),
                        [&](std::size_t k) { block[k] = row(begin + static_cast<int>(k)); });
    for (int k = 0; k < count; ++k) take(begin + k, std::move(block[k]));
  }
}

std::vector<RayRow> all_rows(const RaySource& source) {
  std::vector<RayRow> rows;
  rows.reserve(source.grid().nv);
  each_row(source, [&](int, RayRow&& row) { rows.push_back(std::move(row)); });
  return rows;
}

}  // namespace findspace::space
