// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/local_sum.h"

#include <algorithm>
#include <limits>

namespace findspace::plane {
namespace {

bool in(Mark m) { return m > 0; }
bool out(Mark m) { return m <= 0; }

Window box(const std::vector<GridFace>& faces) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  Window w{kFar, kFar, -kFar, -kFar};
  for (const GridFace& f : faces)
    for (const GridCorner& c : f.corners) {
      w.x0 = std::min(w.x0, c.at.x), w.x1 = std::max(w.x1, c.at.x);
      w.y0 = std::min(w.y0, c.at.y), w.y1 = std::max(w.y1, c.at.y);
    }
  return w;
}

bool is_unbounded(const std::vector<GridFace>& faces) {
  return std::any_of(faces.begin(), faces.end(), [](const GridFace& f) { return f.unbounded; });
}

/// Where the boundary of the sum lies, and a step more on every side.
std::optional<Window> boundary_box(const std::vector<GridFace>& p, const std::vector<GridFace>& q) {
  if (p.empty() || q.empty()) return std::nullopt;
  const Window a = box(p), b = box(q);
  if (is_unbounded(q)) return boundary_box(q, p);
  // A set that leaves out a box holds all of its sum but where the other one fits into that box.
  const bool all = is_unbounded(p);
  Window w{a.x0 + (all ? b.x1 : b.x0) - 1, a.y0 + (all ? b.y1 : b.y0) - 1, a.x1 + (all ? b.x0 : b.x1) + 1,
           a.y1 + (all ? b.y0 : b.y1) + 1};
  if (w.x1 - w.x0 < 2 || w.y1 - w.y0 < 2) return std::nullopt;
  return w;
}

}  // namespace

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
  return made({a, in}, {b, in, true});
}

std::shared_ptr<const LocalSum> LocalSum::containment(const Region& a, const Region& b) {
  return made({a, out, false, false}, {b, in, true});
}

bool LocalSum::holds(const exact::RealPoint& p) const {
  exact::Geometry g;
  SolidSum solid(a_, b_, index_);
  return solid.holds(g, g.add_real_point(p.x, p.y));
}

SignMap LocalSum::map(const Window& w) const {
  SolidSum solid(a_, b_, index_);
  return window_sum(index_, w, [&](exact::Geometry& g, Index point) { return solid.holds(g, point); });
}

}  // namespace findspace::plane
