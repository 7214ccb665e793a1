// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/local_sum.h"

namespace findspace::plane {
LocalSum::LocalSum(Operand a, Operand b, std::vector<GridFace> p, std::vector<GridFace> q)
    : a_(a),
      b_(b),
      p_(std::move(p)),
      q_(std::move(q)),
      index_({p_, a.cells.geometry}, {q_, b.cells.geometry}),
      bounds_(boundary_box(p_, q_)) {}

std::shared_ptr<const LocalSum> LocalSum::made(Operand a, Operand b) {
  auto p = a.grid();
  if (!p) return nullptr;
  auto q = b.grid();
  if (!q) return nullptr;
  return std::shared_ptr<const LocalSum>(new LocalSum(a, b, *std::move(p), *std::move(q)));
}

std::shared_ptr<const LocalSum> LocalSum::contact(const Region& a, const Region& b) {
  return made({a, is_in}, {b, is_in, true});
}

std::shared_ptr<const LocalSum> LocalSum::containment(const Region& a, const Region& b) {
  return made({a, is_out, false, false}, {b, is_in, true});
}

bool LocalSum::holds(const exact::RealPoint& p) const {
  if (!bounds_) return has_unbounded(p_) || has_unbounded(q_);
  exact::Geometry g;
  SolidSum solid(a_, b_, index_);
  return solid.holds(g, g.add_real_point(p.x, p.y));
}

SignMap LocalSum::map(const GridBox& w, std::span<const ConvolutionIndex::Curve> curves,
                      const std::function<bool(const exact::Point&)>& surely) const {
  SolidSum solid(a_, b_, index_);
  return window_sum(index_, w, curves, [&](exact::Geometry& g, Index point) {
    return (surely && surely(g.points[point])) || solid.holds(g, point);
  });
}

}  // namespace findspace::plane
