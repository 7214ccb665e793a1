// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/sum_mask.h"

#include <algorithm>
#include <cmath>

#include "plane/complex/broad_phase.h"
#include "plane/complex/extent.h"
#include "plane/grid/prune_inside.h"

namespace findspace::plane {
namespace {

constexpr double kManySumCrossings = 100'000, kManyACurve = 10;
constexpr std::size_t kMostPairs = 1000;                           // of parts
constexpr double kFarthestOfMask = double(std::int64_t{1} << 42);  // grid steps: of lattice_runs.h
constexpr double kLinesOfMask = 5.5, kFewestLines = 64, kMostLines = 4000;
constexpr double kLeastSide = 16;    // grid steps
constexpr double kWordsOfMask = 10;  // for each crossing
constexpr double kBesideWindow = 4;  // grid steps: more than extents are off
// Grid steps, of an enclosure: a cell keeps a distance of eight times this from outlines, and points move it by less.
constexpr double kWidestPlace = 0x1p-5;  // no sign: there is no mask where one is wider

/// Of a part whose arcs are made of chords.
struct PartOutline {
  Outline edges;
  bool round = false;
  bool sure = true;  // doubles are near enough to the coordinates
};

struct Spot {
  double x, y;
};

Spot spot(const Position& p) { return {p.approx_x(), p.approx_y()}; }

bool is_narrow(const exact::Interval& i) { return i.hi - i.lo <= kWidestPlace; }
bool is_sure(const Position& p) {
  return p.grid() || (is_narrow(p.real->x.interval()) && is_narrow(p.real->y.interval()));
}

/// Chords, and beside each a box that holds its piece of the arc, walked on both sides so that it counts for nothing:
/// no cell that meets the arc is free of these edges, as boxes are lower than cells.
void add_arc(const Step& s, double side, Outline& out) {
  const Spot from = spot(s.from), to = spot(s.to), c = spot(s.center);
  const double r = std::hypot(from.x - c.x, from.y - c.y), whole = 2 * std::acos(-1.0);
  const double start = std::atan2(from.y - c.y, from.x - c.x), end = std::atan2(to.y - c.y, to.x - c.x);
  double sweep = s.ccw ? end - start : start - end;
  if (sweep < 0) sweep += whole;
  if (sweep > whole * 3 / 4) sweep = 0;  // steps are half circles at most: a short one, rounded
  const double chords = std::max(1.0, std::ceil(sweep * std::sqrt(r / side)));
  const double step = (s.ccw ? sweep : -sweep) / chords, rise = r * (1 - std::cos(step / 2)) + 1;
  Spot at = from;
  for (double k = 1; k <= chords; ++k) {
    const double middle = start + (k - 1) * step + step / 2, angle = start + k * step;
    const Spot next = k == chords ? to : Spot{c.x + r * std::cos(angle), c.y + r * std::sin(angle)};
    const double dx = rise * std::cos(middle), dy = rise * std::sin(middle);
    const LatticeEdge up{at.x, at.y, at.x + dx, at.y + dy}, along{up.x1, up.y1, next.x + dx, next.y + dy},
        down{along.x1, along.y1, next.x, next.y};
    out.insert(out.end(), {{at.x, at.y, next.x, next.y}, up, up, along, along, down, down});
    at = next;
  }
}

PartOutline outline(const Part& part, double side) {
  PartOutline out;
  for (const Path& path : part.paths)
    for (const Step& s : path.steps) {
      out.round |= s.arc;
      out.sure &= is_sure(s.from) && (!s.arc || is_sure(s.center));
      if (s.arc)
        add_arc(s, side, out.edges);
      else
        out.edges.push_back({s.from.approx_x(), s.from.approx_y(), s.to.approx_x(), s.to.approx_y()});
    }
  return out;
}

PieceBox nothing() { return {INFINITY, INFINITY, -INFINITY, -INFINITY}; }

/// Around ends of steps: certainly no larger than the part.
void add_ends(const Part& part, PieceBox& box) {
  const auto add = [&](const Position& p) {
    const exact::Interval x = p.real_x().interval(), y = p.real_y().interval();
    box = joined(box, {x.hi, y.hi, x.lo, y.lo});
  };
  for (const Path& path : part.paths) {
    if (path.lonely) add(*path.lonely);
    for (const Step& s : path.steps) add(s.from);
  }
}

PieceBox ends_of(const Operand& b) {
  PieceBox box = nothing();
  b.each_solid_part([&](const Part& part) { add_ends(part, box); });
  for (const Part& part : b.flat_parts()) add_ends(part, box);
  return box;
}

/// Up to a frame farther out than the other set is large; nothing where only single points are missing.
void add_frame(double far, Outline& out) {
  if (out.empty()) return;
  PieceBox box = nothing();
  for (const LatticeEdge& e : out) box = joined(box, {e.x0, e.y0, e.x0, e.y0});
  const double x0 = box.x0 - far, y0 = box.y0 - far, x1 = box.x1 + far, y1 = box.y1 + far;
  out.insert(out.end(), {{x0, y0, x1, y0}, {x1, y0, x1, y1}, {x1, y1, x0, y1}, {x0, y1, x0, y0}});
}

/// Beyond it everything is in the sum of an unbounded set, of whose complement no box is larger than that of its
/// boundary.
std::optional<PieceBox> window(const Operand& a, const PieceBox& b) {
  if (!a.wanted(a.cells.faces[0].mark)) return std::nullopt;
  const auto box = extent(a.cells);
  if (!box || b.x0 > b.x1) return std::nullopt;
  const PieceBox hole = a.mirrored ? PieceBox{-box->x1, -box->y1, -box->x0, -box->y0} : *box;
  return PieceBox{hole.x0 + b.x1 - kBesideWindow, hole.y0 + b.y1 - kBesideWindow, hole.x1 + b.x0 + kBesideWindow,
                  hole.y1 + b.y0 + kBesideWindow};
}

/// Of the curves as far as they lie in the box.
CurveExtent extent_within(const ConvolutionBuilder& c, const PieceBox& box) {
  const exact::Geometry& g = c.curves.geometry;
  PieceBox all = nothing();
  CurveExtent out;
  for (const Piece& piece : c.curves.pieces) {
    PieceBox b = box_of(g, piece, 0);
    if (!b.meets(box)) continue;
    b = {std::max(b.x0, box.x0), std::max(b.y0, box.y0), std::min(b.x1, box.x1), std::min(b.y1, box.y1)};
    all = joined(all, b);
    ++out.count;
    out.length += std::sqrt((b.x1 - b.x0) * (b.x1 - b.x0) + (b.y1 - b.y0) * (b.y1 - b.y0));
  }
  if (out.count > 0) {
    out.width = all.x1 - all.x0;
    out.height = all.y1 - all.y0;
  }
  return out;
}

/// What a mask is made of, but for the size of its cells.
struct Frame {
  PieceBox ends;                   // of b
  std::optional<PieceBox> within;  // beyond it everything is inside

  Frame(const Operand& a, const Operand& b) : ends(ends_of(b)), within(window(a, ends)) {}
};

std::optional<InnerMask> framed_mask(const Operand& a, const Operand& b, const Frame& frame, std::int64_t side,
                                     double effort) {
  std::vector<PartOutline> p, q;
  const double far = frame.ends.x1 - frame.ends.x0 + frame.ends.y1 - frame.ends.y0 + 4 * double(side);
  a.each_solid_part([&](const Part& part) {
    p.push_back(outline(part, double(side)));
    if (part.unbounded) add_frame(far, p.back().edges);
  });
  b.each_solid_part([&](const Part& part) { q.push_back(outline(part, double(side))); });
  const auto sure = [](const PartOutline& o) { return o.sure; };
  if (p.size() * q.size() > kMostPairs || !std::all_of(p.begin(), p.end(), sure) ||
      !std::all_of(q.begin(), q.end(), sure))
    return std::nullopt;
  std::vector<InnerMask::Pair> pairs;
  double farthest = 0;
  for (const PartOutline& x : p) {
    for (const LatticeEdge& e : x.edges) farthest = std::max({farthest, std::abs(e.x0), std::abs(e.y0)});
    for (const PartOutline& y : q) pairs.push_back({&x.edges, &y.edges, x.round, y.round});
  }
  if (!(farthest + far < kFarthestOfMask)) return std::nullopt;
  InnerMask mask(pairs, side, effort);
  if (const auto& within = frame.within)
    mask.mark_beyond(
        {mask.line_of(within->y0), mask.line_of(within->y1), mask.line_of(within->x0), mask.line_of(within->x1)});
  return mask;
}

}  // namespace

std::optional<InnerMask> mask_of_sum(const Operand& a, const Operand& b, std::int64_t side, double effort) {
  return framed_mask(a, b, Frame(a, b), side, effort);
}

std::optional<InnerMask> mask_that_pays(const ConvolutionBuilder& convolution, const Operand& a, const Operand& b) {
  if (convolution.curves.pieces.empty()) return std::nullopt;
  const PieceBox everywhere{-INFINITY, -INFINITY, INFINITY, INFINITY};
  const CurveExtent all = extent_within(convolution, everywhere);
  // Many small curves may lie close together, where no estimate sees them.
  const double crossings = std::max(estimated_crossings(all), double(all.count) * kManyACurve);
  if (!(crossings > kManySumCrossings)) return std::nullopt;
  const Frame frame(a, b);
  const CurveExtent some = frame.within ? extent_within(convolution, *frame.within) : all;
  const double lines =
      std::clamp(kLinesOfMask * std::cbrt(std::max(estimated_crossings(some), double(some.count) * kManyACurve)),
                 kFewestLines, kMostLines);
  const double side =
      std::max({std::max(some.width, some.height) / lines, std::max(all.width, all.height) / kMostLines, kLeastSide});
  if (!(side < kFarthestOfMask)) return std::nullopt;
  return framed_mask(a, b, frame, std::int64_t(std::ceil(side)), kWordsOfMask * crossings);
}

}  // namespace findspace::plane
