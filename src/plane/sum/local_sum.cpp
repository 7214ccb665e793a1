// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/local_sum.h"

#include <algorithm>

namespace findspace::plane {
namespace {

GridBox around_both(const GridBox& a, const GridBox& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

LocalSum::LocalSum(Operand a, Operand b, GridFaces p, GridFaces q)
    : a_(a),
      b_(b),
      p_(std::move(p)),
      q_(std::move(q)),
      index_({p_, a.cells.geometry}, {q_, b.cells.geometry}),
      bounds_(boundary_box(p_, q_)),
      many_(convex_faces(p_.size() > q_.size() ? p_ : q_)) {
  for (const Convex& one : convex_faces(p_.size() > q_.size() ? q_ : p_)) {
    if (!few_) few_ = {one.box, 0, 0};
    few_ = {around_both(few_->box, one.box), few_->faces + 1, few_->corners + one.corners};
  }
}

std::vector<LocalSum::Convex> LocalSum::convex_faces(const GridFaces& faces) {
  std::vector<Convex> out;
  out.reserve(faces.size());
  for (const GridFace& face : faces)
    if (face.is_convex()) out.push_back({box_of({&face, 1}), 1, face.corners.size()});
  return out;
}

/// In a pair of convex faces every edge goes with one corner of the other.
bool LocalSum::surely_has(std::size_t curves, const GridBox& w) const {
  if (!few_) return false;
  const GridBox& by = few_->box;
  std::size_t found = 0;
  return std::any_of(many_.begin(), many_.end(), [&](const Convex& one) {
    const GridBox& box = one.box;
    if (box.x0 + by.x0 >= w.x0 && box.x1 + by.x1 <= w.x1 && box.y0 + by.y0 >= w.y0 && box.y1 + by.y1 <= w.y1)
      found += one.corners * few_->faces + few_->corners;
    return found >= curves;
  });
}

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
