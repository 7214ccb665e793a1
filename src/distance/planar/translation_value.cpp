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

/// The stop of the least (or greatest) way whose place, or a place beside it, is wanted.
template <class Wanted>
const Section::Stop* end_of_wanted(const Section& line, bool both_ways, bool greatest, const Wanted& wanted) {
  const Section::Stop* best = nullptr;
  Mark before = line.before;
  for (const Section::Stop& stop : line.stops) {
    const int side = stop.t.sign();
    const bool ahead = both_ways || side >= 0, behind = both_ways || side > 0;
    const bool ends = (ahead && (wanted(stop.at) || wanted(stop.after))) || (behind && wanted(before));
    before = stop.after;
    if (ends && (best == nullptr || (greatest ? abs(best->t) < abs(stop.t) : abs(stop.t) < abs(best->t)))) best = &stop;
  }
  return best;
}

std::optional<TranslationValue> nearest_change(const Section& line, bool both_ways) {
  const Mark here = mark_at_start(line);
  if (here == 0) return TranslationValue{};
  // The stretch that holds the start is not wanted, so the nearest wanted place is, or lies beside, a stop.
  const Section::Stop* best =
      end_of_wanted(line, both_ways, false, [here](Mark m) { return here > 0 ? m <= 0 : m >= 0; });
  if (best != nullptr) return TranslationValue{best->t, here, false};
  if (here > 0) return std::nullopt;
  return TranslationValue{exact::Real(), -1, true};
}

std::optional<TranslationValue> farthest_place(const Section& line, bool both_ways) {
  const bool bounded = line.before > 0 && (line.stops.empty() || line.stops.back().after > 0);
  const Section::Stop* best = bounded ? end_of_wanted(line, both_ways, true, [](Mark m) { return m <= 0; }) : nullptr;
  if (best == nullptr) return std::nullopt;
  return TranslationValue{best->t, 1, false};
}

/// What is not known taken for that.
Section read_as(Section line, Mark unknown) {
  const auto read = [unknown](Mark& m) {
    if (m == 0) m = unknown;
  };
  read(line.before);
  for (Section::Stop& stop : line.stops) {
    read(stop.at);
    read(stop.after);
  }
  return line;
}

}  // namespace

std::optional<TranslationValue> translation_value(const Section& line, bool farthest, bool both_ways) {
  return farthest ? farthest_place(line, both_ways) : nearest_change(line, both_ways);
}

TranslationBounds translation_bounds(const Section& line, bool farthest, bool both_ways) {
  // With more of O and of C the nearest change is less, the farthest place more.
  TranslationBounds out{translation_value(read_as(line, -1), farthest, both_ways),
                        translation_value(read_as(line, 1), farthest, both_ways)};
  if (farthest) std::swap(out.lower, out.upper);
  return out;
}

int TranslationBounds::sign(const exact::Real& level, bool farthest) const {
  if (farthest && bool(lower) != bool(upper)) return 0;
  const int low = sign_of(lower, level);
  return low == sign_of(upper, level) ? low : 0;
}

int sign_of(const std::optional<TranslationValue>& value, const exact::Real& level) {
  if (!value) return 1;
  return value->lowest ? -1 : compare(value->value(), level);
}

}  // namespace findspace::distance
