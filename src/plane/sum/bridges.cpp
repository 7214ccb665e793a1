// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <cmath>

#include "plane/complex/boundary.h"

namespace findspace::plane {
namespace {

using exact::Real;

Direction east(bool reverse) {
  Direction d;
  d.x = reverse ? -1 : 1;
  return d;
}

int compare_xy(const Position& p, const Position& q) {
  int s = compare(p.real_x(), q.real_x());
  return s != 0 ? s : compare(p.real_y(), q.real_y());
}

Step level_step(const Position& from, const Position& to, bool to_the_left) {
  Step s;
  s.from = from;
  s.to = to;
  s.start = s.end = east(to_the_left);
  return s;
}

/// Is d strictly inside the sector that runs counter-clockwise from `from` to `to`, another direction?
bool in_sector(const Direction& from, const Direction& to, const Direction& d) {
  int c = cross_sign(from, to);
  bool left_of_from = cross_sign(from, d) > 0, right_of_to = cross_sign(d, to) > 0;
  if (c > 0) return left_of_from && right_of_to;
  if (c < 0) return left_of_from || right_of_to || (cross_sign(from, d) == 0 && dot_sign(from, d) < 0);
  return left_of_from;
}

bool agree(const Direction& p, const Direction& q) { return cross_sign(p, q) == 0 && dot_sign(p, q) > 0; }

/// The corner before step k looks into direction d: a straight ray that leaves there starts in the part. Curves that
/// leave in one direction are decided apart by how they bend.
bool looks(const std::vector<Step>& steps, std::size_t k, const Direction& d) {
  const Step &out = steps[k], &in = steps[k == 0 ? steps.size() - 1 : k - 1];
  bool along_out = agree(out.start, d), along_in = agree(-in.end, d);
  bool left_of_out = out.arc && !out.ccw, left_of_in = in.arc && !in.ccw;
  bool folded = agree(out.start, -in.end), thin = folded && compare_curvature(in.reversed(), out) > 0;
  if (along_out && along_in) return thin ? left_of_out && left_of_in : left_of_out || left_of_in;
  if (along_out) return left_of_out;
  if (along_in) return left_of_in;
  return folded ? !thin : in_sector(out.start, -in.end, d);
}

struct Hit {
  std::size_t step = 0;
  bool at_corner = false;  // at the start of the step
  Position at;
};

/// x of the inner place of a segment at height y, where the part is to its right: of the two sides of a slit, one.
std::optional<Real> inner_place(const Step& s, const Real& y) {
  if (compare(s.from.real_y(), y) <= 0 || compare(s.to.real_y(), y) >= 0) return std::nullopt;
  Real t = (y - s.from.real_y()) / Real(s.start.y);
  return s.from.real_x() + t * Real(s.start.x);
}

/// The same for an x-monotone arc.
std::optional<Real> arc_place(const Step& s, const Real& y) {
  Real dy = y - s.center.real_y(), square = s.radius * s.radius - dy * dy;
  if (square.sign() < 0 || (square.sign() == 0 && s.ccw) || dy.sign() * s.half <= 0) return std::nullopt;
  Real root = sqrt(square), x = s.ccw ? s.center.real_x() - root : s.center.real_x() + root;
  int from = compare(x, s.from.real_x()), to = compare(x, s.to.real_x());
  return from * to < 0 ? std::optional<Real>(x) : std::nullopt;
}

/// The nearest place of the path to the left of m at its height.
std::optional<Hit> nearest_left(const std::vector<Step>& steps, const Position& m) {
  std::optional<Hit> best;
  Real y = m.real_y(), x = m.real_x();
  auto take = [&](const Real& at, std::size_t k, bool corner) {
    if (compare(at, x) >= 0 || (best && compare(at, best->at.real_x()) <= 0)) return;
    if (corner && !looks(steps, k, east(false))) return;
    best = Hit{k, corner, Position::of(at, y)};
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step& s = steps[k];
    if (compare(s.from.real_y(), y) == 0) take(s.from.real_x(), k, true);
    if (auto p = s.arc ? arc_place(s, y) : inner_place(s, y)) take(*p, k, false);
  }
  return best;
}

Direction tangent_at(const Step& s, const Position& p) {
  Real up = (p.real_y() - s.center.real_y()) / s.radius, right = (p.real_x() - s.center.real_x()) / s.radius;
  return s.ccw ? Direction::of(-up, right) : Direction::of(up, -right);
}

/// Cuts step k of the path at p; the second half becomes step k + 1.
void cut(std::vector<Step>& steps, std::size_t k, const Position& p) {
  Step first = steps[k], second = steps[k];
  first.to = second.from = p;
  if (first.arc) first.end = second.start = tangent_at(first, p);
  steps[k] = first;
  steps.insert(steps.begin() + std::ptrdiff_t(k) + 1, second);
}

/// A hole's path, turned so that it starts at its lexicographically smallest point, in the corner that looks left.
struct Hole {
  std::vector<Step> steps;  // empty for a single point
  Position first;
};

Hole hole_of(const Path& path) {
  if (path.lonely) return {{}, *path.lonely};
  std::size_t best = 0;
  for (std::size_t k = 1; k < path.steps.size(); ++k) {
    int c = compare_xy(path.steps[k].from, path.steps[best].from);
    if (c < 0 || (c == 0 && looks(path.steps, k, east(true)))) best = k;
  }
  Hole h{path.steps, path.steps[best].from};
  std::rotate(h.steps.begin(), h.steps.begin() + std::ptrdiff_t(best), h.steps.end());
  return h;
}

void join(std::vector<Step>& main, Hit hit, const Hole& hole) {
  std::size_t at = hit.step;
  if (!hit.at_corner) cut(main, at++, hit.at);
  std::vector<Step> detour{level_step(hit.at, hole.first, false)};
  detour.insert(detour.end(), hole.steps.begin(), hole.steps.end());
  detour.push_back(level_step(hole.first, hit.at, true));
  main.insert(main.begin() + std::ptrdiff_t(at), detour.begin(), detour.end());
}

/// Joins the hole to the nearest path on its left; false if there is none.
bool join_left(std::vector<std::vector<Step>>& paths, const Hole& hole) {
  std::optional<Hit> best;
  std::size_t where = 0;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    auto hit = nearest_left(paths[k], hole.first);
    if (!hit || (best && compare(hit->at.real_x(), best->at.real_x()) <= 0)) continue;
    best = hit;
    where = k;
  }
  if (best) join(paths[where], *best, hole);
  return best.has_value();
}

}  // namespace

Part bridged(Part part, const Real& reach) {
  std::vector<std::vector<Step>> paths;
  std::vector<Hole> holes;
  for (std::size_t k = 0; k < part.paths.size(); ++k) {
    if (k == 0 && !part.unbounded)
      paths.push_back(part.paths[0].steps);
    else
      holes.push_back(hole_of(part.paths[k]));
  }
  std::sort(holes.begin(), holes.end(), [](const Hole& p, const Hole& q) { return compare_xy(p.first, q.first) < 0; });
  for (const Hole& hole : holes) {
    if (join_left(paths, hole)) continue;
    // Nothing to its left (the part is unbounded): a slit that leads far away.
    Position tip = Position::of(Real(exact::floor(hole.first.real_x())) - reach, hole.first.real_y());
    paths.push_back(hole.steps);
    paths.back().push_back(level_step(hole.first, tip, true));
    paths.back().push_back(level_step(tip, hole.first, false));
  }
  part.paths.clear();
  for (auto& steps : paths) part.paths.push_back({std::move(steps), std::nullopt});
  part.holes.clear();
  part.euler = 1;
  return part;
}

}  // namespace findspace::plane
