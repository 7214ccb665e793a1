// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_rotations.h"

#include <fmt/format.h>

#include "io/write/write_json.h"

namespace findspace::io {

std::vector<DegreeInterval> degree_intervals(const plane::RotationMap& set) {
  std::vector<DegreeInterval> out;
  for (const plane::RotationInterval& i : plane::intervals(set)) {
    const auto [from, to] = i.degrees();
    out.push_back({from, to, i.from_in, i.to_in, i.round});
  }
  return out;
}

std::string rotations_json(const plane::RotationMap& set, const distance::OptimalValue* best) {
  std::string list;
  const auto all = degree_intervals(set);
  for (const DegreeInterval& i : all) {
    list += fmt::format("{}{{\"from\": {}, \"to\": {}, \"from_in\": {}, \"to_in\": {}}}", list.empty() ? "" : ", ",
                        json_number(i.from), json_number(i.to), i.from_in, i.to_in);
  }
  return fmt::format("{{\"empty\": {}, \"whole\": {},{} \"intervals\": [{}]}}\n", all.empty(),
                     set.at.empty() && set.everywhere != 0, best == nullptr ? "" : " " + optimum_members(*best), list);
}

}  // namespace findspace::io
