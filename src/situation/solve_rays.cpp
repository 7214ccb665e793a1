// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "situation/solve_rays.h"

#include <findspace/error.h>

#include <algorithm>

#include "situation/evaluate.h"
#include "situation/text.h"
#include "space/ray_ball.h"
#include "space/ray_pair.h"

namespace findspace::situation {
namespace {

using exact::Real;
using space::BallRays;
using space::PairRays;
using space::RayGrid;
using space::RayRow;
using space::RaySolid;
using space::RaySource;

[[noreturn]] void refuse(const SignMap& map, const std::string& why) {
  throw Error(ErrorCode::kUnsupported, text(map.distance) + " has no ray map here: " + why);
}

std::vector<RaySolid> solids(const RayWorld& world, const std::vector<std::string>& names) {
  std::vector<RaySolid> all;
  for (const std::string& name : names) {
    const auto& more = world.shapes.at(name);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

/// The sign of gamma1(b + p, a) - level.
std::unique_ptr<RaySource> gap(const SignMap& map, const RaySolid& b, const RaySolid& a, const Real& level,
                               const RayGrid& grid) {
  if (b.ball() && a.ball()) refuse(map, "both shapes are balls");
  if (!b.ball() && !a.ball()) {
    if (level.sign() != 0) refuse(map, "levels other than 0 need a ball");
    return std::make_unique<PairRays>(a.surface, b.surface, grid);
  }
  const Real radius = (b.ball() ? b.radius : a.radius) + level;
  if (radius.sign() <= 0) refuse(map, "the level takes away the ball");
  // |c + p - x| for x in a, or |c - p - x| for x in b: the distance of p to a - c, or to c - b.
  return std::make_unique<BallRays>(
      b.ball() ? space::moved(a.surface, -b.center) : space::moved(space::scaled(b.surface, -1), a.center), radius,
      grid);
}

/// The sign of eta1(b + p, a) - level.
std::unique_ptr<RaySource> containment(const SignMap& map, const RaySolid& b, const RaySolid& a, const Real& level,
                                       const RayGrid& grid) {
  if (a.ball()) refuse(map, "the container is a ball");
  if (!b.ball()) {
    if (level.sign() != 0) refuse(map, "levels other than 0 need a ball");
    return std::make_unique<PairRays>(a.surface, b.surface, grid, PairRays::Side::kComplement);
  }
  if (level.sign() > 0) refuse(map, "levels above 0 are not computed");
  return std::make_unique<BallRays>(space::moved(a.surface, -b.center), b.radius - level, grid,
                                    BallRays::Side::kComplement);
}

RaySolid mirrored(RaySolid s) {
  s.surface = space::scaled(std::move(s.surface), -1);
  s.center = -s.center;
  return s;
}

/// One sign map: the least, or the greatest, of several.
struct Parts {
  std::vector<std::unique_ptr<RaySource>> sources;
  bool least = true;

  RayRow row(int j) const {
    if (sources.size() == 1) return sources[0]->row(j);
    std::vector<RayRow> rows;
    for (const auto& s : sources) rows.push_back(s->row(j));
    return space::combined(rows, [&](std::span<const std::int8_t> signs) {
      return least ? *std::min_element(signs.begin(), signs.end()) : *std::max_element(signs.begin(), signs.end());
    });
  }
};

Parts parts(const RayWorld& world, const SignMap& map, const RayGrid& grid) {
  const Distance d = moving_first(map.distance, world.moving);
  if (map.minimum) refuse(map, "-> min is not computed");
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone) refuse(map, "only translations in all directions are");
  for (const std::string& name : d.first) {
    if (std::find(world.moving.begin(), world.moving.end(), name) == world.moving.end())
      refuse(map, "the first shape stands still");
  }
  const std::vector<RaySolid> b = solids(world, d.first), a = solids(world, d.second);
  const Real level = map.level / world.step;
  Parts result;
  if (d.kind == Kind::kGamma1) {
    for (const RaySolid& s : b) {
      for (const RaySolid& t : a) result.sources.push_back(gap(map, s, t, level, grid));
    }
    if (level.sign() < 0 && result.sources.size() > 1) refuse(map, "levels below 0 need a single solid");
    return result;
  }
  const bool cover = d.kind == Kind::kDelta1;
  if (!cover && d.kind != Kind::kEta1 && d.kind != Kind::kMu)
    refuse(map, "only gamma1, eta1, delta1 and mu are computed on rays");
  const std::vector<RaySolid>&inner = cover ? a : b, &outer = cover ? b : a;
  if (outer.size() != 1) refuse(map, "the container has to be a single solid");
  result.least = false;
  for (const RaySolid& s : inner) {
    result.sources.push_back(cover ? containment(map, mirrored(s), mirrored(outer[0]), level, grid)
                                   : containment(map, s, outer[0], level, grid));
  }
  return result;
}

class RegionRays : public RaySource {
 public:
  RegionRays(const RayWorld& world, const Formula& formula, const RayGrid& grid) : formula_(formula), grid_(grid) {
    for (const SignMap& map : formula.sign_maps()) maps_.push_back(parts(world, map, grid));
    if (maps_.empty()) throw Error(ErrorCode::kUnsupported, "a constant formula has no ray map");
  }
  const RayGrid& grid() const override { return grid_; }
  RayRow row(int j) const override {
    std::vector<RayRow> rows;
    for (const Parts& map : maps_) rows.push_back(map.row(j));
    return space::combined(rows, [&](std::span<const std::int8_t> signs) {
      return static_cast<std::int8_t>(evaluate(formula_, signs) ? -1 : 1);
    });
  }

 private:
  const Formula& formula_;
  RayGrid grid_;
  std::vector<Parts> maps_;
};

}  // namespace

RayWindow window(const RayWorld& world, const Formula& formula) {
  RayWindow result;
  bool first = true;
  for (const SignMap& map : formula.sign_maps()) {
    const Distance d = moving_first(map.distance, world.moving);
    space::Point b_low, b_high, a_low, a_high;
    bool any_b = false, any_a = false;
    space::extend_box(solids(world, d.first), b_low, b_high, any_b);
    space::extend_box(solids(world, d.second), a_low, a_high, any_a);
    const auto r = static_cast<std::int64_t>(exact::floor(abs(map.level / world.step))) + 1;
    const space::Point low = a_low - b_high - space::Point{r, r, r}, high = a_high - b_low + space::Point{r, r, r};
    if (first) result = {low, high};
    first = false;
    result.low = {std::min(result.low.x, low.x), std::min(result.low.y, low.y), std::min(result.low.z, low.z)};
    result.high = {std::max(result.high.x, high.x), std::max(result.high.y, high.y), std::max(result.high.z, high.z)};
  }
  return result;
}

std::unique_ptr<RaySource> ray_region(const RayWorld& world, const Formula& formula, const RayGrid& grid) {
  return std::make_unique<RegionRays>(world, formula, grid);
}

bool holds_far_away(const Formula& formula) {
  return evaluate(formula, std::vector<std::int8_t>(formula.sign_maps().size(), 1));
}

}  // namespace findspace::situation
