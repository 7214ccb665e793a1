// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_sheets.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"

namespace findspace::space {
namespace {

/// One component of a cross product of exact doubles: two roundings of products, one of the difference.
struct Component {
  double value = 0, error = 0;
};

Component component(double a, double b, double c, double d) {
  const double p = a * b, q = c * d;
  return {p - q, margin::kRoundings4 * (std::fabs(p) + std::fabs(q))};
}

/// -n / m with the errors of both, m certain to be nonzero.
Component slope(const Component& n, const Component& m) {
  const double value = -n.value / m.value;
  return {value, (n.error + std::fabs(value) * m.error) / (std::fabs(m.value) - m.error) +
                     margin::kRoundings4 * std::fabs(value)};
}

Sheet make_sheet(const RayFacet& facet) {
  Sheet s;
  s.facet = facet;
  s.low = s.high = facet.corner[0].y;
  std::int64_t left = facet.corner[0].x, right = left;
  for (int k = 1; k < facet.corners; ++k) {
    s.low = std::min(s.low, facet.corner[k].y);
    s.high = std::max(s.high, facet.corner[k].y);
    left = std::min(left, facet.corner[k].x);
    right = std::max(right, facet.corner[k].x);
  }
  const Approx3 a = exact::approx(facet.along()), b = exact::approx(facet.across());
  const Component z = component(a.x, b.y, a.y, b.x);
  const int up = std::fabs(z.value) > 2 * z.error ? (z.value > 0 ? 1 : -1) : exact::sign(facet.normal().z);
  s.jump = -up * facet.weight;
  if (std::fabs(z.value) <= 2 * z.error) {
    s.slack = 2 * margin::kCoarseHeight;  // vertical or nearly: exactly where needed
    return s;
  }
  const Component x = slope(component(a.y, b.z, a.z, b.y), z), y = slope(component(a.z, b.x, a.x, b.z), z);
  s.slope_x = x.value;
  s.slope_y = y.value;
  const double dx = static_cast<double>(right - left), dy = static_cast<double>(s.high - s.low);
  const double size =
      std::fabs(x.value) * dx + std::fabs(y.value) * dy + std::fabs(static_cast<double>(facet.corner[0].z));
  s.slack = 2 * (x.error * dx + y.error * dy) + margin::kRoundings8 * size;
  return s;
}

}  // namespace

exact::Fraction Sheet::height_exactly(std::int64_t x, std::int64_t y) const {
  const Wide3 n = facet.normal();
  const Point& p = facet.corner[0];
  const int128 top = n.x * (p.x - x) + n.y * (p.y - y) + n.z * p.z;
  return n.z > 0 ? exact::Fraction{top, n.z} : exact::Fraction{-top, -n.z};
}

bool Sheet::meets_displaced(std::int64_t x, std::int64_t y) const {
  int seen = 0;
  for (int k = 0; k < facet.corners; ++k) {
    const Point &p = facet.corner[k], &q = facet.corner[k + 1 == facet.corners ? 0 : k + 1];
    const int s = exact::sign_turn_displaced(p, q, x, y);
    if (s == 0 || (seen != 0 && s != seen)) return false;
    seen = s;
  }
  return true;
}

Sheets::Sheets(std::vector<RayFacet> facets, const RayGrid& grid) : grid_(grid) {
  sheets_.reserve(facets.size());
  for (const RayFacet& f : facets) sheets_.push_back(make_sheet(f));
  sort_into_rows();
}

void Sheets::sort_into_rows() {
  const auto rows = [&](const Sheet& s) {
    const std::int64_t from = s.low - grid_.v, to = s.high - grid_.v;
    const std::int64_t first = from <= 0 ? 0 : (from + grid_.dv - 1) / grid_.dv;
    const std::int64_t last = to < 0 ? -1 : std::min<std::int64_t>(to / grid_.dv, grid_.nv - 1);
    return std::pair(first, last);
  };
  first_.assign(grid_.nv + 1, 0);
  for (const Sheet& s : sheets_) {
    const auto [first, last] = rows(s);
    for (std::int64_t j = first; j <= last; ++j) ++first_[j + 1];
  }
  for (int j = 0; j < grid_.nv; ++j) first_[j + 1] += first_[j];
  of_row_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < sheets_.size(); ++k) {
    const auto [first, last] = rows(sheets_[k]);
    for (std::int64_t j = first; j <= last; ++j) of_row_[next[j]++] = static_cast<int>(k);
  }
}

bool Sheets::section(int sheet, int j, Section& section) const {
  const RayFacet& f = sheets_[sheet].facet;
  const std::int64_t y = grid_.v_at(j);
  int ends = 0;
  section.x_error = section.z_error = 0;
  for (int k = 0; k < f.corners; ++k) {
    const Point *p = &f.corner[k], *q = &f.corner[k + 1 == f.corners ? 0 : k + 1];
    if ((p->y > y) == (q->y > y)) continue;
    if (p->y > y) std::swap(p, q);  // p below or in the row, q above
    const double part = static_cast<double>(y - p->y) / static_cast<double>(q->y - p->y);
    const double px = static_cast<double>(p->x), pz = static_cast<double>(p->z);
    const double width = static_cast<double>(q->x - p->x), rise = static_cast<double>(q->z - p->z);
    const double x = px + part * width;
    // Three roundings of the product, one of the sum.
    const double x_error = margin::kRoundings8 * (std::fabs(width) + std::fabs(px));
    section.x_error = std::max(section.x_error, x_error);
    section.z_error = std::max(section.z_error, margin::kRoundings8 * (std::fabs(rise) + std::fabs(pz)));
    section.x[ends] = x;
    section.z[ends] = pz + part * rise;
    const double step = static_cast<double>(grid_.du);
    const auto near = static_cast<std::int64_t>(std::llround((x - static_cast<double>(grid_.u)) / step));
    const std::int64_t line = grid_.u + near * grid_.du;
    int side = static_cast<double>(line) > x ? 1 : -1;
    if (std::fabs(static_cast<double>(line) - x) <= x_error) side = -exact::sign_turn(p->x, p->y, q->x, q->y, line, y);
    section.tie[ends] = side == 0 && near >= 0 && near < grid_.nu ? static_cast<int>(near) : -1;
    section.column[ends] = clamp_column(side >= 0 ? near : near + 1);
    if (++ends == 2) break;
  }
  if (ends < 2) return false;
  if (section.column[0] > section.column[1] ||
      (section.column[0] == section.column[1] && section.x[0] > section.x[1])) {
    std::swap(section.x[0], section.x[1]);
    std::swap(section.z[0], section.z[1]);
    std::swap(section.column[0], section.column[1]);
  }
  return true;
}

}  // namespace findspace::space
