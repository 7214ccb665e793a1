// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public Answer: how its texts, files and values are made of what was found.
#pragma once

#include <findspace/answer.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/number/real.h"

namespace findspace {

struct Answer::Data {
  Found found = Found::kYes;
  std::vector<std::string> notes{};
  std::function<std::string(const Telling&)> text{}, json{};
  std::map<std::string, std::function<Region::Drawn(const Telling&)>, std::less<>>
      files{};                    // beside JSON, by their endings
  std::vector<exact::Real> at{};  // of a question about one position
  std::function<Check()> check{};
  std::function<std::optional<NearestPlace>()> nearest{};
  std::function<std::vector<Measured>()> measured{};
  std::function<RegionBounds()> region{};
  std::function<SpaceRegion()> space_region{};
  bool sampled = false;
  std::function<LineMap()> line_map{};
  std::function<Surface()> surface{};
  std::function<void(const Telling&, const std::function<void(std::string_view)>&)>
      json_parts{};  // where it may be long
  std::function<Optimum()> best{};
  std::function<std::vector<Interval>()> intervals{}, possible{};
  std::function<PoseMap()> poses{};
  std::optional<Explanation> explanation{};
  std::function<Placement()> placement{};
};

}  // namespace findspace
