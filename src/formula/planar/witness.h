// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Witnesses in the scene's terms: which vertex, edge or arc of which shape, and of which part of a collection, attains
// a distance. A collection counts as the union of its parts (distances.md 5); the part that decides is the one on which
// the point lies. Cost: linear in the parts' cells, exact for those alone whose boxes are near. Keywords: closest
// features, contact, report.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "distance/answer/answer.h"
#include "formula/language/position_answers.h"
#include "plane/complex/shared_region.h"

namespace findspace::formula {

using Shapes = std::map<std::string, plane::SharedRegion>;
/// The named parts of the shapes that are collections, in order.
using Parts = std::map<std::string, std::vector<std::pair<std::string, plane::Region>>>;

/// `f` as a feature of one of the shapes with the given names, which stand at `p` if they move: both in grid steps of
/// `step` scene units.
FeatureAt named_feature(const distance::Feature& f, const plane::Region& region, const std::vector<std::string>& names,
                        const Shapes& shapes, const Parts& parts, const exact::RealPoint& p, const exact::Real& step);

}  // namespace findspace::formula
