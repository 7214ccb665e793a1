// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_space/space_map.h"

#include "io/write/write_json_space.h"
#include "space/box/box_topology.h"

namespace findspace::app {
namespace {

space::ConvexSet applied(const std::string& operation, space::ConvexSet set) {
  if (operation == "interior") return interior(std::move(set));
  if (operation == "closure") return closure(std::move(set));
  if (operation == "regularize") return closure(interior(std::move(set)));
  if (operation == "complement") return complement(std::move(set));
  if (operation == "boundary") return boundary(set);
  return set;
}

space::BoxComplex applied(const std::string& operation, space::BoxComplex set) {
  if (operation == "interior") return space::interior(set);
  if (operation == "closure") return space::closure(set);
  if (operation == "regularize") return space::regularized(set);
  if (operation == "complement") return space::complement(set);
  if (operation == "boundary") return space::boundary(set);
  return set;
}

}  // namespace

SpaceMap space_map(const Session& session, const formula::SpaceSolver& solver, const formula::Formula& formula,
                   bool flat) {
  const auto goal = session.goal();
  formula::RegionQuery query{{}, {}, flat};
  if (goal) {
    query.objective = goal->objective;
    query.sense = goal->sense;
  }
  formula::SpaceRegion found = formula::solve_region(solver, formula, query);
  SpaceMap out;
  out.way = found.way;
  if (out.way == distance::Way::kLines) return out;
  out.extreme = found.extreme;
  const std::string& apply = session.options().apply;
  if (out.way == distance::Way::kConvex) {
    out.convex = applied(apply, std::move(found.convex->set));
    out.step = found.convex->step;
  } else {
    out.boxes = applied(apply, std::move(found.boxes)).simplified();
  }
  return out;
}

std::string space_map_json(const Session& session, const SpaceMap& map) {
  const distance::OptimalValue* extreme = map.extreme ? &*map.extreme : nullptr;
  if (map.way == distance::Way::kConvex)
    return io::space_json(*map.convex, space::summarize(*map.convex, map.step), map.step, session.unit(), extreme);
  return io::space_json(map.boxes, space::summarize(map.boxes, session.step()), session.step(), session.unit(),
                        extreme);
}

}  // namespace findspace::app
