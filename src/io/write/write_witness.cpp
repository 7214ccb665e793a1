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

distance::Coordinates way_to(const distance::Coordinates& there, const distance::Coordinates& at) {
  distance::Coordinates out = there;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] -= at[k];
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

std::string witness_members(const formula::DistanceAt& d, const distance::Coordinates& at) {
  std::string out;
  if (!d.answer) return out;
  auto add = [&](const std::string& member) { out += (out.empty() ? "" : ", ") + member; };
  if (d.answer->nearest) {
    add("\"nearest\": " + json_point(*d.answer->nearest));
    add("\"by\": " + json_point(way_to(*d.answer->nearest, at)));
  }
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
  const std::string features = value.witness();
  if (!features.empty() || !d.answer || d.answer->witness.size() != 2) return features;
  return shown_point(d.answer->witness[0].at) + " and " + shown_point(d.answer->witness[1].at);
}

std::string way_words(const formula::DistanceAt& d, const distance::Coordinates& at) {
  if (!d.answer || !d.answer->nearest || at.size() != d.answer->nearest->size()) return "";
  const distance::Coordinates& there = *d.answer->nearest;
  return fmt::format("is 0 after {}, at {}", shown_point(way_to(there, at)), shown_point(there));
}

std::string amount_words(const formula::DistanceAt& d, double amount, std::string_view unit) {
  const std::string number = shown(amount);
  return d.in_degrees ? number + "°" : unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string lacks_words(const formula::AtomAt& atom, std::string_view unit) {
  const std::string amount = amount_words(atom.distance, *atom.lacks, unit);
  const distance::Enclosure ends = atom.distance.answer->bounds();
  return fmt::format("off by {}{}", ends.lower.has_value() == ends.upper.has_value() ? "" : "at least ", amount);
}

std::string nearest_words(const formula::AskedNearest& nearest, std::string_view unit) {
  if (!nearest) return "";
  if (!*nearest)
    return fmt::format("nearest feasible position: not computed: {}\n", nearest->refusal().error.message());
  const formula::NearestFeasible* near = found(nearest);
  if (near == nullptr) return "no position is feasible\n";
  const std::string away = shown(near->distance.to_double());
  return fmt::format("nearest feasible position {}, {} away{}\n", shown_point(near->at),
                     unit.empty() ? away : fmt::format("{} {}", away, unit),
                     near->attained ? "" : ", not feasible itself: the region is open there");
}

}  // namespace findspace::io
