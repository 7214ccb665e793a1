// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_witness.h"

#include <fmt/format.h>

#include "io/draw/draw_layout.h"
#include "io/write/write_json.h"

namespace findspace::io {

using exact::RealPoint;
using formula::FeatureAt;
using plane::Twofold;

namespace {

double scaled(const exact::Real& r, const Twofold& step) { return (Twofold(r) * step).value(); }

std::string feature_json(const FeatureAt& f, const Twofold& step) {
  std::string out = fmt::format("{{\"shape\": {}", json_string(f.shape));
  if (!f.part.empty()) out += fmt::format(", \"part\": {}", json_string(f.part));
  switch (f.kind) {
    case FeatureAt::Kind::kVertex:
      return out + fmt::format(", \"vertex\": {}}}", json_point(f.points[0], step));
    case FeatureAt::Kind::kEdge:
      return out + fmt::format(", \"edge\": [{}, {}]}}", json_point(f.points[0], step), json_point(f.points[1], step));
    case FeatureAt::Kind::kArc:
      return out + fmt::format(", \"arc\": {{\"center\": {}, \"radius\": {}}}}}", json_point(f.points[0], step),
                               json_number(scaled(f.radius, step)));
    case FeatureAt::Kind::kInside:
      break;
  }
  return out + ", \"inside\": true}";
}

std::string feature_words(const FeatureAt& f, const Twofold& step) {
  auto point = [&](const RealPoint& p) {
    return fmt::format("({}, {})", shown(scaled(p.x, step)), shown(scaled(p.y, step)));
  };
  const std::string of = f.part.empty() ? f.shape : fmt::format("{}, part {}", f.shape, f.part);
  switch (f.kind) {
    case FeatureAt::Kind::kVertex:
      return fmt::format("vertex {} of {}", point(f.points[0]), of);
    case FeatureAt::Kind::kEdge:
      return fmt::format("edge {} to {} of {}", point(f.points[0]), point(f.points[1]), of);
    case FeatureAt::Kind::kArc:
      return fmt::format("arc about {} of {}", point(f.points[0]), of);
    case FeatureAt::Kind::kInside:
      break;
  }
  return fmt::format("the inside of {}", of);
}

}  // namespace

std::string json_point(const RealPoint& p, const Twofold& step) {
  return fmt::format("[{}, {}]", json_number(scaled(p.x, step)), json_number(scaled(p.y, step)));
}

std::string witness_members(const formula::DistanceAt& d, const Twofold& step) {
  std::string out;
  auto add = [&](const std::string& member) { out += (out.empty() ? "" : ", ") + member; };
  if (d.nearest) add("\"nearest\": " + json_point(*d.nearest, step));
  if (d.farthest) add("\"farthest\": " + json_point(*d.farthest, step));
  if (d.witness.size() != 2) return out;
  const FeatureAt &f = d.witness[0], &g = d.witness[1];
  add(fmt::format("\"points\": [{}, {}]", json_point(f.at, step), json_point(g.at, step)));
  add(fmt::format("\"features\": [{}, {}]", feature_json(f, step), feature_json(g, step)));
  return out;
}

std::string witness_words(const formula::DistanceAt& d, const Twofold& step) {
  if (d.witness.size() != 2) return "";
  return fmt::format("{} and {}", feature_words(d.witness[0], step), feature_words(d.witness[1], step));
}

}  // namespace findspace::io
