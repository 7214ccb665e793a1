// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Public placements as text and as pictures.

#include "api/plan/placement_data.h"
#include "io/write/write_placement.h"

namespace findspace {

std::string Placement::json() const {
  const auto written = [&](const auto& problem, const auto& found, const exact::Real& step) {
    return std::visit(
        [&](const auto& f) { return io::placement_json(io::placement_result(problem, f), step, data_->unit); }, found);
  };
  if (!data_->in_plane && !data_->in_space) return data_->told.json;
  return data_->in_plane ? written(data_->planar, *data_->in_plane, data_->planar.world.step)
                         : written(data_->solid, *data_->in_space, data_->solid.step);
}

namespace {

template <class Step, class V>
const planning::PosesOf<V>& poses_of(const planning::SequenceOf<Step, V>& found) {
  return found.poses;
}
template <class Positions, class V>
const planning::PosesOf<V>& poses_of(const planning::TogetherOf<Positions, V>& found) {
  return found.witness;
}

}  // namespace

std::string Placement::svg() const {
  const auto drawn = [&](const auto& problem, const auto& found) {
    io::PlacementPicture picture{"Placement, one after another", {}, {}, data_->unit, {}, false};
    if (found.index() == 1) picture.title = "Placement, all at once";
    picture.fixed = io::standing_still(problem, data_->names);
    return std::visit([&](const auto& f) { return io::placement_svg(problem, poses_of(f), picture); }, found);
  };
  if (!data_->in_plane && !data_->in_space) return data_->told.svg;
  return data_->in_plane ? drawn(data_->planar, *data_->in_plane) : drawn(data_->solid, *data_->in_space);
}

}  // namespace findspace
