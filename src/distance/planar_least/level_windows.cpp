// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/level_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "distance/planar_features/near_parts.h"
#include "distance/planar_least/level_probe.h"
#include "distance/planar_least/sum_curve.h"
#include "exact/margins/planar_distance.h"
#include "plane/base/union_find.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/complex/side_by_side.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using plane::CellComplex;
using plane::Index;
using plane::Mark;
using plane::PieceBox;
using plane::Region;

namespace {

constexpr std::size_t kMostWindows = 16;
constexpr double kSmaller = 0.5;  // no sign: windows that shrink by less stay

/// On the grid, with a step around the box.
PieceBox on_grid(const PieceBox& b) {
  return {std::floor(b.x0) - 1, std::floor(b.y0) - 1, std::ceil(b.x1) + 1, std::ceil(b.y1) + 1};
}

double size(const PieceBox& b) { return (b.x1 - b.x0) + (b.y1 - b.y0); }

/// Around each connected piece of the cells with marks > 0.
std::vector<PieceBox> boxes_of(const CellComplex& c) {
  plane::UnionFind groups(Index(c.vertices.size()));
  for (const auto& e : c.edges)
    if (e.mark > 0) groups.unite(e.v0, e.v1);
  std::vector<std::optional<PieceBox>> box(c.vertices.size());
  const auto add = [&](Index v, const PieceBox& b) {
    auto& all = box[groups.find(v)];
    all = all ? plane::joined(*all, b) : b;
  };
  for (Index v = 0; v < c.vertices.size(); ++v) {
    const exact::Point& p = c.point(v);
    if (c.vertices[v].mark > 0) add(v, {p.x - p.error, p.y - p.error, p.x + p.error, p.y + p.error});
  }
  for (Index e = 0; e < c.edges.size(); ++e)
    if (c.edges[e].mark > 0) add(c.edges[e].v0, plane::edge_box(c, e));
  std::vector<PieceBox> out;
  for (const auto& b : box)
    if (b) out.push_back(*b);
  return out;
}

}  // namespace

void LevelWindows::open(std::vector<PieceBox> boxes, const Real& level, double least) {
  stages_.push_back({std::move(boxes), level});
  if (!place(least)) stages_.pop_back();
}

/// The windows of the last stage. False, and as before, where that has no gain.
bool LevelWindows::place(double least) {
  Stage& stage = stages_.back();
  for (PieceBox& b : stage.boxes) b = on_grid(b);
  stage.boxes = boxes_apart(std::move(stage.boxes));
  if (stage.boxes.size() > kMostWindows) return false;
  // Levels beside the bracket are asked for as well, but none of the other sign.
  const double most = last(stage.level), wider = least - (most - least);
  least = least > 0 ? std::max(wider, least / 2) : wider;
  const double low = rotation_ > 0 ? least : -most, high = rotation_ > 0 ? most : -least;
  std::vector<Window> windows;
  for (const PieceBox& b : stage.boxes) {
    TDistancePointer f = f_->near(b, low, high);
    if (!f) return false;
    Region filled = filled_box(b);
    const std::array<const Region*, 2> both{closed_, &filled};
    Region closed = plane::is_whole(*closed_) ? filled : plane::intersect(both);
    windows.push_back({b, std::move(filled), std::move(closed), std::move(f)});
  }
  windows_ = std::move(windows);
  least_ = least;
  return true;
}

double LevelWindows::first(const Real& level) const {
  const auto within = level.interval();
  return rotation_ > 0 ? within.lo : -within.hi;
}

double LevelWindows::last(const Real& level) const {
  const auto within = level.interval();
  return rotation_ > 0 ? within.hi : -within.lo;
}

bool LevelWindows::holds(const Stage& stage, const Real& level) const {
  return rotation_ * compare(level, stage.level) <= 0;
}

bool LevelWindows::hold(const Real& level) const { return !stages_.empty() && holds(stages_.front(), level); }

std::optional<CellComplex> LevelWindows::probe(const Real& level, const Region& over) {
  const std::size_t stages = stages_.size();
  while (!holds(stages_.back(), level)) stages_.pop_back();
  if ((first(level) < least_ || stages_.size() < stages) && !place(std::min(first(level), least_))) {
    stages_.clear();
    windows_.clear();
    return std::nullopt;
  }
  const auto rule = [this](Mark k) { return Mark(rotation_ * k < 0 ? kBeyond : k == 0 ? kOn : 0); };
  CellComplex out = CellComplex::uniform(0);
  for (const Window& w : windows_) {
    const plane::SignMap map = w.f->sign_map(level);
    const bool known = &over == closed_;
    const std::array<const CellComplex*, 3> all{&map, known ? &w.closed : &w.filled, &over};
    plane::put_beside(out, plane::overlay(std::span(all).first(known ? 2 : 3), [&](std::span<const Mark> k) {
                        return k[1] > 0 && k.back() > 0 ? rule(k[0]) : Mark(0);
                      }));
  }
  return out;
}

void LevelWindows::shrink(const CellComplex& probed, const Real& level, double least) {
  std::vector<PieceBox> boxes = boxes_of(probed);
  double before = 0, now = 0;
  for (const Window& w : windows_) before += size(w.box);
  for (const PieceBox& b : boxes) now += size(on_grid(b));
  if (windows_.empty() || now <= kSmaller * before) open(std::move(boxes), level, least);
}

}  // namespace findspace::distance
