// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/grid_sum.h"

#include "plane/complex/observe_pieces.h"
#include "plane/grid/convex_sum.h"
#include "plane/grid/merged_curves.h"
#include "plane/grid/prune_inside.h"
#include "plane/grid/star_sum.h"
#include "plane/grid/transversal_sum.h"

namespace findspace::plane {
SignMap grid_sum(const GridOperand& a, const GridOperand& b, const InsideTest& decides) {
  if (a.faces.empty() || b.faces.empty()) return CellComplex::uniform(1);
  if (a.faces.size() == 1 && b.faces.size() == 1 && a.faces[0].is_convex() && b.faces[0].is_convex())
    return convex_sum({a.faces[0], a.geometry}, {b.faces[0], b.geometry});
  const bool unbounded = has_unbounded(a.faces) || has_unbounded(b.faces);
  std::optional<GridBox> within;  // where what is not in the sum lies
  if (unbounded && !(within = boundary_box(a.faces, b.faces))) return CellComplex::uniform(-1);
  CoveredCurves covered(a.faces, b.faces);
  ReducedConvolution curves = reduced_convolution(a, b, within, unbounded ? nullptr : &covered);
  observe_pieces("convolution", "reduced convolution of two sets on the grid", curves.geometry, curves.pieces);
  const InsideTest inside = [&](exact::Geometry& g, Index point) {
    const exact::Point& p = g.points[point];
    if (covered.prepared() && covered.covers({p.x - p.error, p.y - p.error, p.x + p.error, p.y + p.error})) return true;
    return decides(g, point);
  };
  const bool bounded_pair = a.faces.size() == 1 && b.faces.size() == 1 && !unbounded;
  if (bounded_pair)
    if (auto sum = star_sum(curves)) return *std::move(sum);
  if (merging_pays(curves)) curves = merged_curves(std::move(curves));
  if (!curves.mask) curves.mask = mask_that_pays(curves, a, b);
  if (curves.mask) curves = prune_inside(std::move(curves));
  if (bounded_pair)
    if (auto sum = transversal_sum(curves, inside)) return *std::move(sum);
  Arena arena(curves.pieces.size());
  Arrangement arrangement = arrange(std::move(curves.geometry), std::move(curves.pieces), {}, arena.memory());
  return labelled_sum(std::move(arrangement), curves.sides, unbounded, inside);
}

}  // namespace findspace::plane
