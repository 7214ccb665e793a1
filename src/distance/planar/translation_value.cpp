// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/planar/translation_value.h"

namespace findspace::distance {
namespace {

using plane::Mark;
using plane::Section;

Mark mark_at_start(const Section& line) {
  Mark now = line.before;
  for (const Section::Stop& stop : line.stops) {
    const int side = stop.t.sign();
    if (side >= 0) return side == 0 ? stop.at : now;
    now = stop.after;
  }
  return now;
}

}  // namespace

std::optional<TranslationValue> nearest_change(const Section& line, bool both_ways) {
  const Mark here = mark_at_start(line);
  if (here == 0) return TranslationValue{};
  // O is open and C closed, so the first place outside O, or in C, is a stop.
  const Section::Stop* best = nullptr;
  for (const Section::Stop& stop : line.stops) {
    const bool wanted = here > 0 ? stop.at <= 0 : stop.at >= 0;
    if (!wanted || (!both_ways && stop.t.sign() < 0)) continue;
    if (best == nullptr || abs(stop.t) < abs(best->t)) best = &stop;
  }
  if (best != nullptr) return TranslationValue{best->t, here, false};
  if (here > 0) return std::nullopt;
  return TranslationValue{exact::Real(), -1, true};
}

std::optional<TranslationValue> farthest_place(const Section& line, bool both_ways) {
  const Section::Stop* best = nullptr;
  for (const Section::Stop& stop : line.stops) {
    if (stop.at > 0 || (!both_ways && stop.t.sign() < 0)) continue;
    if (best == nullptr || abs(best->t) < abs(stop.t)) best = &stop;
  }
  if (best == nullptr) return std::nullopt;
  return TranslationValue{best->t, 1, false};
}

}  // namespace findspace::distance
