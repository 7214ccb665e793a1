// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/text/mended_outlines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace findspace::io {
namespace {

using plane::RingMender;

constexpr double kRounded = 4;  // grid steps: two points, each rounded by up to one

bool narrow(const RingMender& mender, bool curved, const DrawingUse& rules) {
  return mender.width() <= rules.mend.value_or(std::max({kRounded, rules.join, curved ? 2 * rules.tolerance : 0}));
}

bool has_long_spikes(const RingMender& mender, const DrawingUse& rules) {
  return mender.spike() > rules.mend.value_or(std::max(rules.join, rules.tolerance));
}

/// Curves lie on the side that they were made for, and holes are those that are known.
bool keeps_order(const RingMender& mender, const Outlines& outlines) {
  for (std::size_t k = 0; k < outlines.is_hole.size(); ++k)
    if (mender.is_hole(k) != outlines.is_hole[k]) return false;
  for (std::size_t k = 0; k < outlines.material_left.size(); ++k)
    if (outlines.material_left[k] && mender.set_on_left(k) != outlines.material_left[k]) return false;
  return true;
}

/// The round number above that is 1, 2 or 5 times a power of ten.
double round_up(double steps) {
  double decade = 1;
  while (decade * 10 < steps) decade *= 10;
  for (const double digit : {1, 2, 5})
    if (digit * decade >= steps) return digit * decade;
  return 10 * decade;
}

/// The width that would do, if it is not far from what is allowed.
std::optional<double> enough(const RingMender& mender, const ReadContext& context) {
  const double least = std::max(mender.width(), mender.spike());
  if (least > 100 * std::max(context.drawing.join, context.drawing.tolerance)) return std::nullopt;
  return round_up(least);
}

/// The fault with what would help.
Error advised(const Error& fault, const std::string& advice) {
  Error named(fault.code(), fmt::format("{}; {}", fault.message(), advice), fault.place());
  for (const auto& [x, y] : fault.geometry()) named.at(x, y);
  return named;
}

[[noreturn]] void refuse(const RingMender& mender, const Outlines& outlines, const Error& fault,
                         const ReadContext& context) {
  const bool leaves_nothing = mender.mended().parts.empty(), in_order = keeps_order(mender, outlines);
  if (outlines.curved && (leaves_nothing || (!in_order && narrow(mender, true, context.drawing))))
    throw advised(fault, fmt::format("of curves within {}: a smaller tolerance may help",
                                     context.length_text(context.drawing.tolerance)));
  const auto least = in_order && !leaves_nothing ? enough(mender, context) : std::nullopt;
  if (!least) throw fault;
  const std::string width =
      fmt::format("{:.10g}{}", *least * context.grid.step_size(), context.unit ? formula::name(*context.unit) : "");
  throw advised(fault, fmt::format("--{} {} mends it", context.drawing.mend ? "mend" : "join", width));
}

void note(const plane::MendedRings& mended, bool lines, ReadContext& context, const std::string& name) {
  if (mended.places == 0) {
    context.notes.push_back(fmt::format("{}: outlines touch, and are taken as they are drawn", name));
    return;
  }
  context.notes.push_back(
      fmt::format("{}: outlines cross in {}, the longest {} at {}: overlaps are joined, {}", name,
                  mended.places == 1 ? "1 place" : fmt::format("{} places", mended.places),
                  context.length_text(mended.longest), context.point_text(mended.place[0], mended.place[1]),
                  lines ? "loops are left out, spikes are lines" : "loops and spikes are left out"));
}

}  // namespace

plane::MendedRings mended_outlines(const Outlines& outlines, const Error& fault, ReadContext& context,
                                   const std::string& name) {
  std::size_t edges = 0;
  for (const plane::Contour& ring : outlines.contours) edges += ring.size();
  context.work.charge(edges, "outlines that cross");
  const RingMender mender(outlines.contours);
  const bool lines = has_long_spikes(mender, context.drawing);
  if (!keeps_order(mender, outlines) || !narrow(mender, outlines.curved, context.drawing) ||
      (lines && !context.drawing.open_lines))
    refuse(mender, outlines, fault, context);
  plane::MendedRings mended = mender.mended();
  if (lines) mended.parts.push_back({{}, mender.spikes()});
  if (mended.parts.empty()) refuse(mender, outlines, fault, context);
  note(mended, lines, context, name);
  return mended;
}

}  // namespace findspace::io
