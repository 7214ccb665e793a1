// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/space_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "api/query/space_region_data.h"
#include "plane/base/parallel.h"
#include "space/body/open_union.h"
#include "space/box/box_operations.h"
#include "space/box/box_topology.h"

namespace findspace {

namespace {

space::ConvexSet applied(std::string_view operation, space::ConvexSet set) {
  if (operation == "interior") return interior(std::move(set));
  if (operation == "closure") return closure(std::move(set));
  if (operation == "regularize") return closure(interior(std::move(set)));
  if (operation == "complement") return complement(std::move(set));
  if (operation == "boundary") return boundary(set);
  return set;
}

space::BoxComplex applied(std::string_view operation, space::BoxComplex set) {
  if (operation == "interior") return space::interior(set);
  if (operation == "closure") return space::closure(set);
  if (operation == "regularize") return space::regularized(set);
  if (operation == "complement") return space::complement(set);
  if (operation == "boundary") return space::boundary(set);
  return set;
}

/// -1, 0 or 1: inside the grown convex set, on its frontier or outside. A flat one is all frontier.
int side_of(const space::ConvexSet& set, const space::RealVector& p) {
  if (set.region.empty()) return 1;
  int sign = -1;
  for (const space::HalfSpace& plane : set.region.planes()) sign = std::max(sign, plane.value(p).sign());
  if (set.radius.sign() == 0) return sign;
  const auto near = space::nearest_in(set.region.planes(), p);
  const space::RealVector off = space::minus(*near, p);
  return (space::dot(off, off) - set.radius * set.radius).sign();
}

formula::RegionQuery query_of(const World::Data& world, const SpaceQuestion& question) {
  if (!question.minimize.empty() && !question.maximize.empty())
    throw Error(ErrorCode::kBadValue, "\"minimize\" and \"maximize\": one objective is meant");
  formula::RegionQuery out;
  const std::string& text = question.minimize.empty() ? question.maximize : question.minimize;
  if (text.empty()) return out;
  out.objective = formula::parse_objective(text, world.context);
  out.sense = question.minimize.empty() ? distance::Sense::kMaximum : distance::Sense::kMinimum;
  return out;
}

}  // namespace

namespace api {

formula::SpaceRegion solved_in_space(const formula::SpaceSolver& solver, const formula::Formula& formula,
                                     const formula::RegionQuery& query, std::string_view apply) {
  static constexpr std::array<std::string_view, 6> kKnown{"",         "interior",   "closure",
                                                          "boundary", "regularize", "complement"};
  if (std::find(kKnown.begin(), kKnown.end(), apply) == kKnown.end())
    throw Error(ErrorCode::kBadValue,
                fmt::format("apply: {} is none of interior, closure, boundary, regularize and complement", apply));
  formula::SpaceRegion found = formula::solve_region(solver, formula, query);
  if (found.convex)
    found.convex->set = applied(apply, std::move(found.convex->set));
  else if (found.way == distance::Way::kBoxes)
    found.boxes = applied(apply, std::move(found.boxes)).simplified();
  return found;
}

space::SpaceSummary summary_of(const formula::SpaceRegion& region, const exact::Real& step) {
  return region.convex ? space::summarize(region.convex->set, region.convex->step)
                       : space::summarize(region.boxes, step);
}

}  // namespace api

SpaceRegion::Data::Data(formula::SpaceRegion found, const exact::Real& grid_step, std::string of, Query asked,
                        SpaceQuestion wanted)
    : region(std::move(found)),
      step(region.convex ? region.convex->step : grid_step),
      unit(std::move(of)),
      summary(api::summary_of(region, grid_step)),
      query(std::move(asked)),
      question(std::move(wanted)) {}

bool SpaceRegion::Data::contains(const distance::Coordinates& at) const {
  const space::RealVector p{at[0] / step, at[1] / step, at[2] / step};
  if (!region.convex) return region.boxes.mark(p) != 0;
  const int side = side_of(region.convex->set, p);
  return side < 0 ? region.convex->set.inside : side > 0 ? region.convex->set.outside : region.convex->set.frontier;
}

SpaceRegion World::solve_space(const Formula& formula, const SpaceQuestion& question) const {
  const formula::SpaceSolver& solver = data_->space("a region of space");
  const formula::RegionQuery asked = query_of(*data_, question);
  return api::limited(data_->options, [&] {
    formula::SpaceRegion found = api::solved_in_space(solver, data_->formula(formula.text()), asked, question.apply);
    if (found.way == distance::Way::kLines)
      throw Error(ErrorCode::kUnsupported,
                  "the region is neither made of boxes nor a convex polytope; ask for positions or lines of it");
    return SpaceRegion(std::make_shared<const SpaceRegion::Data>(std::move(found), data_->grid.step(), unit(),
                                                                 query(formula), question));
  });
}

SpaceRegion::Form SpaceRegion::form() const { return data_->region.convex ? Form::kConvex : Form::kBoxes; }
bool SpaceRegion::empty() const { return data_->summary.empty; }
bool SpaceRegion::whole() const { return data_->summary.whole; }
bool SpaceRegion::bounded() const { return data_->summary.bounded; }
bool SpaceRegion::open() const { return data_->summary.open; }
bool SpaceRegion::closed() const { return data_->summary.closed; }
std::optional<double> SpaceRegion::volume() const { return data_->summary.volume; }
std::size_t SpaceRegion::components() const { return data_->summary.components.size(); }

std::optional<SpaceRegion::Bounds3> SpaceRegion::bounds() const {
  const auto& box = data_->summary.bbox;
  return box ? std::optional(Bounds3{box->low, box->high}) : std::nullopt;
}

const Query& SpaceRegion::query() const { return data_->query; }
const SpaceQuestion& SpaceRegion::question() const { return data_->question; }
bool SpaceRegion::contains(const Point3& p) const {
  return data_->contains(api::place_of(data_->query.world().data(), p));
}
void SpaceRegion::contains(std::span<const Position3> positions, std::span<bool> inside) const {
  if (inside.size() != positions.size()) throw Error(ErrorCode::kBadValue, "as many answers as positions are wanted");
  const World::Data& world = data_->query.world().data();
  constexpr std::size_t kBlock = 1024;
  const std::size_t blocks = (positions.size() + kBlock - 1) / kBlock;
  api::Progress progress(world.options, blocks);
  api::limited(world.options, [&] {
    plane::parallel_for(blocks, [&](std::size_t b) {
      for (std::size_t k = b * kBlock; k < std::min(positions.size(), (b + 1) * kBlock); ++k)
        inside[k] = data_->contains(api::place_of(world, positions[k]));
      progress.add();
    });
    return true;
  });
}

std::vector<SpaceRegion::Box> SpaceRegion::boxes() const {
  std::vector<Box> out;
  if (form() == Form::kConvex) return out;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const space::IntervalBox& box : data_->region.boxes.boxes()) {
    Box& b = out.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      b.low[k] = box[k].from ? (*box[k].from * data_->step).to_double() : -kInfinite;
      b.high[k] = box[k].to ? (*box[k].to * data_->step).to_double() : kInfinite;
      b.low_belongs[k] = box[k].from_in;
      b.high_belongs[k] = box[k].to_in;
    }
  }
  return out;
}

}  // namespace findspace
