// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/smooth_form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "distance/planar_features/voronoi_cells.h"
#include "exact/margins/planar_distance.h"

namespace findspace::distance {

using plane::Index;
using plane::Mark;

SmoothForm ring_form(double x, double y, double cx, double cy, double r, int scale, double radius) {
  const double dx = x - cx, dy = y - cy, d = plain_length(dx, dy);
  SmoothForm out;
  out.value = scale * (d - r);
  if (d > 0) {
    out.gx = scale * dx / d;
    out.gy = scale * dy / d;
  }
  // A cone lies above its tangent planes, and by no more than its curvature says, nor than two of its slopes.
  const double bent = d > radius ? std::min(radius * radius / (2 * (d - radius)), 2 * radius) : 2 * radius;
  (scale > 0 ? out.above : out.below) = scale * bent;
  return out;
}

struct BoundaryForms::Features {
  std::vector<BoundaryFeature> list;
  VoronoiCells cells;
};

BoundaryForms::BoundaryForms(const plane::SignMap& base, int sign) : base_(base), sign_(sign) {
  auto list = features(base, [sign](Mark m) { return m * sign <= 0; });
  VoronoiCells cells(base, list);
  all_ = std::make_unique<const Features>(Features{std::move(list), std::move(cells)});
}

BoundaryForms::~BoundaryForms() = default;

double BoundaryForms::nearest(double x, double y) const {
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryFeature& s : all_->list) least = std::min(least, s.distance(x, y));
  return least;
}

void BoundaryForms::add_forms(double x, double y, double radius, std::vector<SmoothForm>& out) const {
  const double size = std::abs(x) + std::abs(y) + radius;
  const double reach = nearest(x, y) + 2 * radius + size * margin::kLostByDoubles;
  const double room = radius + size * margin::kLostByDoubles;
  for (Index k = 0; k < all_->list.size(); ++k) {
    const BoundaryFeature& s = all_->list[k];
    if (s.distance(x, y) > reach || all_->cells.out_of_reach(k, x, y, room)) continue;
    if (!s.is_vertex()) {
      add_edge(s, x, y, radius, out);
      continue;
    }
    out.push_back(ring_form(x, y, s.x0, s.y0, 0, sign_, radius));
    out.back().curve = [this, &s] { return near_level_curve(base_, s, 0, 0, sign_); };
  }
}

/// An edge between inside and outside has one form on both sides; one that hangs free has its own for each.
void BoundaryForms::add_edge(const BoundaryFeature& s, double x, double y, double radius,
                             std::vector<SmoothForm>& out) const {
  const Index left = 2 * s.cell.index;
  const Mark on_left = base_.faces[base_.face(left)].mark, on_right = base_.faces[base_.face(left + 1)].mark;
  const bool between = on_left * on_right < 0;
  if (s.arc) {
    for (const int scale : {1, -1}) {
      // An upper half is run through with the outside on its left.
      if (between && (scale > 0) != ((s.half > 0) == (on_left > 0))) continue;
      out.push_back(ring_form(x, y, s.cx, s.cy, s.r, scale, radius));
      const bool left = (scale > 0) == (s.half > 0);
      out.back().curve = [this, &s, left] { return level_curve_beside(base_, s.cell.index, left); };
    }
    return;
  }
  const double length = plain_length(s.x1 - s.x0, s.y1 - s.y0);
  double nx = (s.y0 - s.y1) / length, ny = (s.x1 - s.x0) / length;  // to the left
  const double height = nx * (x - s.x0) + ny * (y - s.y0);
  const bool turn = between ? on_left < 0 : (height < 0) == (sign_ > 0);
  if (turn) {
    nx = -nx;
    ny = -ny;
  }
  SmoothForm form;
  form.value = turn ? -height : height;
  form.gx = nx;
  form.gy = ny;
  if (!between) (sign_ > 0 ? form.above : form.below) = sign_ * 2 * std::max(0.0, radius - std::abs(height));
  form.curve = [this, &s, turn] { return level_curve_beside(base_, s.cell.index, !turn); };
  out.push_back(std::move(form));
}

}  // namespace findspace::distance
