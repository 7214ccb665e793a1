// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "findspace/space_region.h"

#include <limits>

#include "api/query/space_region_data.h"

namespace findspace {

SpaceRegion World::solve_space(const Formula& formula) const {
  const formula::SpaceSolver& solver = data_->space("a region of space");
  return api::limited(data_->options, [&] {
    formula::SpaceRegion found = formula::solve_region(solver, data_->formula(formula.text()), {});
    if (found.way == distance::Way::kLines)
      throw Error(ErrorCode::kUnsupported,
                  "the region is neither made of boxes nor a convex polytope; ask for positions or lines of it");
    const exact::Real step = found.convex ? found.convex->step : data_->grid.step();
    if (!found.convex) found.boxes = found.boxes.simplified();
    space::SpaceSummary summary =
        found.convex ? space::summarize(found.convex->set, step) : space::summarize(found.boxes, step);
    return SpaceRegion(std::make_shared<const SpaceRegion::Data>(
        SpaceRegion::Data{std::move(found), step, unit(), std::move(summary), query(formula)}));
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
bool SpaceRegion::contains(const Point3& p) const { return data_->query.holds(p); }
void SpaceRegion::contains(std::span<const Position3> positions, std::span<bool> inside) const {
  data_->query.holds(positions, inside);
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
