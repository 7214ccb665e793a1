// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_witness.h"

#include <fmt/format.h>

#include "api/query/world_data.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_json.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {

using formula::FeatureAt;

namespace {

double rounded(const exact::Real& r) { return plane::Twofold(r).value(); }

template <class Number>
std::string joined(const distance::Coordinates& p, const Number& number) {
  std::string out;
  for (const exact::Real& c : p) out += (out.empty() ? "" : ", ") + number(rounded(c));
  return out;
}

std::string feature_json(const FeatureAt& f) {
  std::string out = fmt::format("{{\"shape\": {}", json_string(f.shape));
  if (!f.part.empty()) out += fmt::format(", \"part\": {}", json_string(f.part));
  switch (f.kind) {
    case FeatureAt::Kind::kVertex:
      return out + fmt::format(", \"vertex\": {}}}", json_point(f.points[0]));
    case FeatureAt::Kind::kEdge:
      return out + fmt::format(", \"edge\": [{}, {}]}}", json_point(f.points[0]), json_point(f.points[1]));
    case FeatureAt::Kind::kArc:
      return out + fmt::format(", \"arc\": {{\"center\": {}, \"radius\": {}}}}}", json_point(f.points[0]),
                               json_number(rounded(f.radius)));
    case FeatureAt::Kind::kInside:
      break;
  }
  return out + ", \"inside\": true}";
}

}  // namespace

std::string json_point(const distance::Coordinates& p) { return "[" + joined(p, json_number) + "]"; }

std::string shown_point(const distance::Coordinates& p) { return "(" + joined(p, shown) + ")"; }

std::string witness_members(const formula::DistanceAt& d) {
  std::string out;
  if (!d.answer) return out;
  auto add = [&](const std::string& member) { out += (out.empty() ? "" : ", ") + member; };
  if (d.answer->nearest) add("\"nearest\": " + json_point(*d.answer->nearest));
  if (d.answer->farthest) add("\"farthest\": " + json_point(*d.answer->farthest));
  const auto& points = d.answer->witness;
  if (points.size() == 2) add(fmt::format("\"points\": [{}, {}]", json_point(points[0].at), json_point(points[1].at)));
  if (d.features.size() == 2)
    add(fmt::format("\"features\": [{}, {}]", feature_json(d.features[0]), feature_json(d.features[1])));
  return out;
}

std::string witness_words(const formula::DistanceAt& d) {
  DistanceValue value;
  value.features = api::features_of(d);
  return value.witness();
}

}  // namespace findspace::io
