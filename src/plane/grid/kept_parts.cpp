// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/kept_parts.h"

#include <algorithm>
#include <cmath>

namespace findspace::plane {
namespace {

constexpr double kMostError = 0.25;  // grid steps: of each double that a piece is followed by
// Grid steps along u: more than all errors of a piece. What is off so far passes through the same heights there.
constexpr double kBeside = 1;

LatticeEdge chord(const exact::Geometry& g, const Piece& piece) {
  const exact::Point &a = g.points[piece.p0], &b = g.points[piece.p1];
  return {a.x, a.y, b.x, b.y};
}

}  // namespace

LatticeRunner::LatticeRunner(const exact::Geometry& g, const Piece& piece) : LatticeRunner(chord(g, piece)) {
  const exact::Point &a = g.points[piece.p0], &b = g.points[piece.p1];
  const auto is_near = [](double error) { return error <= kMostError; };
  if (piece.half == 0 && a.kind == exact::Point::Kind::kGrid && b.kind == exact::Point::Kind::kGrid) return;
  unsure_end_ = kSurelyBeyond;
  slack_ = kSurelyBeyond + kBeside;  // segments rise by no more than they go along
  sure_ = is_near(a.error) && is_near(b.error);
  if (piece.half == 0) return;
  const exact::SupportingCurve& circle = g.supporting_curves[piece.supporting_curve];
  half_ = piece.half;
  steep_ = reversed_ = false;
  u0_ = a.x;
  v0_ = a.y;
  u1_ = b.x;
  v1_ = b.y;
  center_u_ = circle.x().value;
  center_v_ = circle.y().value;
  radius_ = circle.z().value;
  sure_ = sure_ && is_near(circle.x().error) && is_near(circle.y().error) && is_near(circle.z().error);
}

LatticeRunner::Heights LatticeRunner::of_arc(double u, double v) const {
  const auto at = [&](double x) {
    const double d = std::abs(x - center_u_);
    return center_v_ + half_ * std::sqrt(std::max(radius_ - d, 0.0) * (radius_ + d));
  };
  Heights out{std::min(at(u), at(v)), std::max(at(u), at(v))};
  const double top = at(std::clamp(center_u_, u, v));
  return {std::min(out.low, top), std::max(out.high, top)};
}

std::int64_t LatticeRunner::depth_of_arc(const InnerMask& mask, std::int64_t line) const {
  const double first = std::max(u0_, double(mask.border(line))) - kBeside;
  const double last = std::min(u1_, double(mask.border(line + 1))) + kBeside;
  const Heights v = of_arc(first, std::max(first, last));
  const std::int64_t end = mask.line_of(v.high + slack_);
  for (std::int64_t c = mask.line_of(v.low - slack_); c <= end; ++c)
    if (mask.depth(line, c) == 0) return 0;
  return 1;  // it need not go on as it does here
}

void add_kept_parts(const LatticeRunner& run, const InnerMask& mask, Index number, std::vector<KeptPart>& out) {
  KeptPart part{number, run.steep(), run.reversed(), KeptPart::kEnd, KeptPart::kEnd};
  if (!run.is_sure()) return out.push_back(part);
  // With the lines that the piece may reach.
  const std::int64_t first = mask.line_of(run.start() - run.unsure_end());
  const std::int64_t last = mask.line_of(run.end() + run.unsure_end());
  // Of borders that may lie beyond an end none is cut.
  const auto is_near_start = [&](std::int64_t line) {
    return double(mask.border(line)) < run.start() + run.unsure_end();
  };
  const auto is_near_end = [&](std::int64_t line) { return double(mask.border(line)) > run.end() - run.unsure_end(); };
  const auto cut_at = [&](std::int64_t line) {
    while (line > first && is_near_end(line)) --line;
    return line == first || is_near_start(line) ? KeptPart::kEnd : line;
  };
  // An end on a border may be found in the line before it. There the piece has no length, and what is beside is masked.
  const auto keep = [&] {
    const auto at = [&](std::int64_t line) { return double(mask.border(line)); };
    if ((part.from == KeptPart::kEnd || at(part.from) < run.end()) &&
        (part.to == KeptPart::kEnd || at(part.to) > run.start()))
      out.push_back(part);
  };
  bool open = false;
  for (std::int64_t line = first; line <= last;) {
    std::int64_t depth = run.depth(mask, line);
    if (depth > 0 && open && is_near_start(line)) depth = 0;
    if (depth == 0 && !open) part.from = cut_at(line);
    if (depth > 0 && open) {
      part.to = is_near_end(line) ? KeptPart::kEnd : line;
      keep();
      if (part.to == KeptPart::kEnd) return;
    }
    open = depth == 0;
    line += std::max<std::int64_t>(depth, 1);
  }
  part.to = KeptPart::kEnd;
  if (open) keep();
}

}  // namespace findspace::plane
