// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The witness of a public value in words.

#include <fmt/format.h>

#include "findspace/values.h"
#include "io/draw/draw_layout.h"

namespace findspace {
namespace {

std::string shown(const Place& p) {
  std::string out;
  for (const double c : p) out += (out.empty() ? "" : ", ") + io::shown(c);
  return "(" + out + ")";
}

std::string in_words(const Feature& f) {
  const std::string of = f.part.empty() ? f.shape : fmt::format("{}, part {}", f.shape, f.part);
  switch (f.kind) {
    case Feature::Kind::kVertex:
      return fmt::format("vertex {} of {}", shown(f.points[0]), of);
    case Feature::Kind::kEdge:
      return fmt::format("edge {} to {} of {}", shown(f.points[0]), shown(f.points[1]), of);
    case Feature::Kind::kArc:
      return fmt::format("arc about {} of {}", shown(f.points[0]), of);
    case Feature::Kind::kInside:
      break;
  }
  return fmt::format("the inside of {}", of);
}

}  // namespace

std::string DistanceValue::witness() const {
  return features.size() == 2 ? fmt::format("{} and {}", in_words(features[0]), in_words(features[1])) : "";
}

}  // namespace findspace
