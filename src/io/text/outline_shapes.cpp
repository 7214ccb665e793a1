// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/outline_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "findspace/error.h"
#include "io/text/drawing_rules.h"
#include "io/text/mended_outlines.h"
#include "io/text/quantity.h"
#include "plane/build/curve_nesting.h"
#include "plane/build/touching_rings.h"
#include "plane/contour/contour.h"
#include "plane/contour/nesting_depths.h"
#include "plane/curve/curve_arcs.h"

namespace findspace::io {

using exact::Real;
using plane::Contour;
using plane::ContourEdge;
using plane::Shape;
using plane::ShapePtr;

namespace {

Shape make(Shape::Kind kind, const std::string& place) {
  Shape shape;
  shape.kind = kind;
  shape.place = place;
  return shape;
}

ShapePtr share(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

ShapePtr rings_shape(std::vector<Contour> contours, const std::string& place) {
  Shape shape = make(Shape::Kind::kRings, place);
  shape.contours = std::move(contours);
  return share(std::move(shape));
}

ShapePtr cells_shape(plane::Region cells, const std::string& place) {
  Shape shape = make(Shape::Kind::kCells, place);
  shape.cells = std::make_shared<const plane::Region>(std::move(cells));
  return share(std::move(shape));
}

Contour ring_of(const Disc& disc, ReadContext& context) {
  auto radius = static_cast<std::int64_t>(round(disc.radius));
  double moved = std::abs((disc.radius - Real(radius)).to_double());
  context.rounding.add(moved, 0);
  if (radius == 0) throw Error(ErrorCode::kGeometry, "a circle smaller than a grid step");
  return plane::circle_ring(disc.center, radius);
}

/// The chain with arcs in place of its curves; the boxes beside it are added to `caps`.
Contour expanded(Chain chain, double bound, plane::CurveSide side, std::vector<plane::CapBox>& caps) {
  if (chain.curves.empty()) return std::move(chain.edges);
  Contour out;
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    if (!chain.curves[k]) {
      out.push_back(std::move(chain.edges[k]));
      continue;
    }
    plane::ArcChain arcs = plane::arcs_of(*chain.curves[k], bound, side);
    std::move(arcs.edges.begin(), arcs.edges.end(), std::back_inserter(out));
    caps.insert(caps.end(), arcs.caps.begin(), arcs.caps.end());
  }
  return out;
}

void count_curves(const Chain& chain, std::size_t edges, ReadContext& context) {
  const auto curves = std::count_if(chain.curves.begin(), chain.curves.end(), [](const auto& c) { return bool(c); });
  if (curves == 0) return;
  CurveLog& log = context.curves;
  log.curves += curves;
  log.arcs += static_cast<std::int64_t>(edges + static_cast<std::size_t>(curves)) - std::int64_t(chain.edges.size());
  log.bound = std::max(log.bound, context.drawing.tolerance);
  const std::string word =
      context.drawing.curves == CurveRule::kNear ? "on either side" : std::string(name(context.drawing.curves));
  if (log.sides.find(word) == std::string::npos) log.sides += (log.sides.empty() ? "" : ", ") + word;
}

/// The rings of closed chains, and the boxes that the side of their curves needs beside them.
struct Rings : Outlines {
  std::vector<plane::CapBox> caps;
  plane::RingRule rule = plane::RingRule::kEvenOdd;

  bool on_sides() const { return !material_left.empty(); }
};

/// Closed outlines with arcs on either side of their curves: of the closed chains in order, then of the circles.
std::vector<Contour> outlines_near(const Drawing& drawing, const ReadContext& context) {
  std::vector<Contour> outlines;
  std::vector<plane::CapBox> none;
  for (const Chain& chain : drawing.chains) {
    if (!chain.closed) continue;
    Contour outline = expanded(chain, context.drawing.tolerance, plane::CurveSide::kNear, none);
    if (outline.size() < 2) outline = chain.edges;
    outlines.push_back(std::move(outline));
  }
  for (const Disc& disc : drawing.discs)
    outlines.push_back(plane::circle_ring(disc.center, std::max<std::int64_t>(1, std::int64_t(round(disc.radius)))));
  return outlines;
}

std::vector<Chain> take_closed(Drawing& drawing) {
  std::vector<Chain> closed;
  for (Chain& chain : drawing.chains)
    if (chain.closed) closed.push_back(std::move(chain));
  std::erase_if(drawing.chains, [](const Chain& c) { return c.closed; });
  return closed;
}

bool is_curved(const Chain& chain) {
  return std::any_of(chain.curves.begin(), chain.curves.end(), [](const auto& c) { return bool(c); });
}

/// How the closed chains truly lie, of which rings are within the tolerance; those behind are circles.
plane::CurveNesting nesting_of(const std::vector<Chain>& closed, const std::vector<Contour>& rings, double tolerance) {
  std::vector<plane::NearRing> near;
  for (std::size_t k = 0; k < rings.size(); ++k)
    near.push_back({rings[k], k < closed.size() && is_curved(closed[k]) ? tolerance : 0});
  return {std::move(near), [&closed](std::size_t k) {
            std::vector<plane::CapBox> none;
            return plane::NearRing{expanded(closed[k], plane::kLeastBound, plane::CurveSide::kNear, none),
                                   plane::kLeastBound};
          }};
}

[[noreturn]] void refuse_thin(const ReadContext& context) {
  throw Error(ErrorCode::kGeometry, "a closed curve, or the wall between two, is thinner than the tolerance, " +
                                        context.length_text(context.drawing.tolerance) + ": a smaller one may help");
}

/// Which rings are holes by the even-odd rule.
std::vector<bool> holes_among(plane::CurveNesting& nesting, const ReadContext& context) {
  const auto around = nesting.around();
  if (!around) refuse_thin(context);
  std::vector<bool> holes;
  for (const std::vector<std::size_t>& others : *around) holes.push_back(others.size() % 2 != 0);
  return holes;
}

/// Puts curves on the side that the rule wants. `rings` are the closed chains within the tolerance, and circles.
void put_on_sides(Rings& rings, const std::vector<Chain>& closed, const ReadContext& context) {
  const double tolerance = context.drawing.tolerance;
  plane::CurveNesting nesting = nesting_of(closed, rings.contours, tolerance);
  if (rings.is_hole.empty()) rings.is_hole = holes_among(nesting, context);
  rings.material_left.resize(rings.contours.size());
  for (std::size_t k = 0; k < closed.size(); ++k) {
    if (!is_curved(closed[k])) continue;
    const auto way = nesting.orientation(k);
    if (!way) {
      plane::make_rings({rings.contours[k]}, context.grid.step_size());  // says where the ring crosses itself
      refuse_thin(context);
    }
    const bool material_left = (*way > 0) != rings.is_hole[k];
    rings.material_left[k] = material_left;
    const bool left = material_left == (context.drawing.curves == CurveRule::kInside);
    const auto side = left ? plane::CurveSide::kLeft : plane::CurveSide::kRight;
    rings.contours[k] = expanded(closed[k], tolerance, side, rings.caps);
  }
}

/// The closed chains with curves on the side that the rule wants, then the circles.
Rings take_rings(Drawing& drawing, ReadContext& context, std::vector<Contour> circles, plane::RingRule rule) {
  const std::vector<Chain> closed = take_closed(drawing);
  Rings rings;
  rings.rule = rule;
  for (const Chain& chain : closed) {
    rings.contours.push_back(expanded(chain, context.drawing.tolerance, plane::CurveSide::kNear, rings.caps));
    if (is_curved(chain) && rings.contours.back().size() < 2)
      throw Error(ErrorCode::kGeometry, "a closed curve smaller than the tolerance");
  }
  std::move(circles.begin(), circles.end(), std::back_inserter(rings.contours));
  if (rule == plane::RingRule::kHoles)
    for (std::size_t k = 0; k < rings.contours.size(); ++k) rings.is_hole.push_back(k > 0);
  rings.curved = std::any_of(closed.begin(), closed.end(), is_curved);
  if (rings.curved && context.drawing.curves != CurveRule::kNear) put_on_sides(rings, closed, context);
  for (std::size_t k = 0; k < closed.size(); ++k) count_curves(closed[k], rings.contours[k].size(), context);
  context.curves.caps += std::int64_t(rings.caps.size());
  return rings;
}

ShapePtr box_shape(const plane::CapBox& box, const std::string& place) {
  const auto [a, b] = box;
  Contour ring;
  for (const plane::GridPoint& p : {a, {b.x, a.y}, b, {a.x, b.y}}) ring.push_back({.start = p});
  return rings_shape({std::move(ring)}, place);
}

/// The shape joined with the boxes, or less their insides.
ShapePtr with_caps(ShapePtr shape, const std::vector<plane::CapBox>& caps, CurveRule rule, const std::string& place) {
  if (caps.empty()) return shape;
  const bool outside = rule == CurveRule::kOutside;
  Shape all = make(outside ? Shape::Kind::kUnion : Shape::Kind::kDifference, place);
  all.children.push_back(std::move(shape));
  for (const plane::CapBox& cap : caps) {
    ShapePtr box = box_shape(cap, place);
    if (!outside) {
      Shape inside = make(Shape::Kind::kInterior, place);
      inside.children.push_back(std::move(box));
      box = share(std::move(inside));
    }
    all.children.push_back(std::move(box));
  }
  return share(std::move(all));
}

void add_lines_and_points(Drawing drawing, ReadContext& context, const std::string& place, std::vector<ShapePtr>& all) {
  for (Chain& chain : drawing.chains) {
    std::vector<plane::CapBox> none;
    Contour edges = expanded(chain, context.drawing.tolerance, plane::CurveSide::kNear, none);
    count_curves(chain, edges.size(), context);
    if (chain.closed) edges.push_back(ContourEdge{.start = edges[0].start});
    Shape shape = make(Shape::Kind::kPolyline, place);
    shape.contours.push_back(plane::make_chain(std::move(edges), context.repeated_points));
    all.push_back(share(std::move(shape)));
  }
  if (!drawing.points.empty()) {
    Shape shape = make(Shape::Kind::kPoints, place);
    shape.points = std::move(drawing.points);
    all.push_back(share(std::move(shape)));
  }
}

}  // namespace

ShapePtr united(std::vector<ShapePtr> parts, const std::string& place, bool collection) {
  if (parts.size() == 1) return parts[0];
  Shape shape = make(Shape::Kind::kUnion, place);
  shape.children = std::move(parts);
  shape.collection = collection;
  return share(std::move(shape));
}

namespace {

bool is_one_disc(const Drawing& drawing) {
  return drawing.discs.size() == 1 &&
         std::none_of(drawing.chains.begin(), drawing.chains.end(), [](const Chain& c) { return c.closed; });
}

std::vector<ShapePtr> mended_parts(const Outlines& outlines, const Error& fault, ReadContext& context,
                                   const std::string& place) {
  std::vector<ShapePtr> parts;
  for (plane::MendedPart& part : mended_outlines(outlines, fault, context, place).parts)
    parts.push_back(part.cells ? cells_shape(*std::move(part.cells), place)
                               : rings_shape(std::move(part.rings), place));
  return parts;
}

/// Outer rings with their holes, as the rule says; formats disagree about the direction of rings: no note.
std::vector<plane::RingSet> ring_sets(const Rings& rings, double step) {
  if (rings.rule == plane::RingRule::kHoles) return {plane::make_rings(rings.contours, step)};
  return plane::nest_rings(rings.contours, step);
}

bool is_flat(const Rings& rings, std::size_t k) {
  const Contour& ring = rings.contours[k];
  return ring.size() == 2 && !ring[0].arc && !ring[1].arc;
}

/// Whether a valid ring runs the other way round than its curves.
bool is_turned(const Rings& rings, std::size_t k) {
  return ((plane::orientation(rings.contours[k]) > 0) != rings.is_hole[k]) != rings.material_left[k];
}

/// Leaves out rings of curves so thin that moving them inwards has closed them up. Whether there were any.
bool leave_out(bool (*closed_up)(const Rings&, std::size_t), Rings& rings, ReadContext& context,
               const std::string& place) {
  const bool outside = context.drawing.curves == CurveRule::kOutside;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < rings.contours.size(); ++k) {
    if (rings.material_left[k] && closed_up(rings, k)) {
      if (rings.is_hole[k] != outside) refuse_thin(context);
      continue;
    }
    if (kept != k) rings.contours[kept] = std::move(rings.contours[k]);
    rings.material_left[kept] = rings.material_left[k];
    rings.is_hole[kept++] = rings.is_hole[k];
  }
  const std::size_t count = rings.contours.size() - kept;
  if (count == 0) return false;
  rings.contours.resize(kept);
  rings.material_left.resize(kept);
  rings.is_hole.resize(kept);
  if (kept == 0 || (rings.rule == plane::RingRule::kHoles && rings.is_hole[0])) refuse_thin(context);
  context.notes.push_back(fmt::format("{}: {} {}{} left out, thinner than the tolerance", place, count,
                                      outside ? "hole" : "part", count == 1 ? "" : "s"));
  return true;
}

/// Valid rings on a side lie in each other as their curves do, but for those that are closed up.
std::vector<plane::RingSet> on_sides(std::vector<plane::RingSet> sets, Rings& rings, ReadContext& context,
                                     const std::string& place) {
  if (leave_out(is_turned, rings, context, place)) sets = ring_sets(rings, context.grid.step_size());
  if (rings.rule == plane::RingRule::kHoles) return sets;
  const std::vector<std::size_t> depths = plane::nesting_depths(rings.contours);
  for (std::size_t k = 0; k < depths.size(); ++k)
    if ((depths[k] % 2 != 0) != rings.is_hole[k]) refuse_thin(context);
  return sets;
}

/// Outer rings with their holes, as they are or mended.
std::vector<ShapePtr> nested_parts(Rings& rings, ReadContext& context, const std::string& place) {
  if (rings.on_sides()) leave_out(is_flat, rings, context, place);
  std::vector<plane::RingSet> sets;
  try {
    sets = ring_sets(rings, context.grid.step_size());
  } catch (const Error& fault) {
    return mended_parts(rings, fault, context, place);
  }
  if (rings.on_sides()) sets = on_sides(std::move(sets), rings, context, place);
  std::vector<ShapePtr> parts;
  for (plane::RingSet& set : sets) {
    context.repeated_points += set.repeated_points;
    parts.push_back(rings_shape(std::move(set.contours), place));
  }
  return parts;
}

void add_areas(Drawing& drawing, ReadContext& context, const std::string& place, plane::RingRule rule,
               std::vector<ShapePtr>& all) {
  std::vector<Contour> circles;
  for (const Disc& disc : drawing.discs) circles.push_back(ring_of(disc, context));
  Rings rings = take_rings(drawing, context, std::move(circles), rule);
  auto add = [&](ShapePtr shape) {
    all.push_back(with_caps(std::move(shape), rings.caps, context.drawing.curves, place));
  };
  if (!rings.on_sides())
    if (auto cells = plane::region_of_touching_rings(rings.contours, rule))
      return add(cells_shape(*std::move(cells), place));
  std::vector<ShapePtr> parts = nested_parts(rings, context, place);
  if (!rings.caps.empty()) return add(united(std::move(parts), place));
  std::move(parts.begin(), parts.end(), std::back_inserter(all));
}

}  // namespace

std::vector<ShapePtr> parts_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all;
  if (is_one_disc(drawing)) {
    Shape shape = make(Shape::Kind::kDisc, place);
    shape.points = {drawing.discs[0].center};
    shape.amount = drawing.discs[0].radius;
    all.push_back(share(std::move(shape)));
  } else {
    add_areas(drawing, context, place, plane::RingRule::kEvenOdd, all);
  }
  add_lines_and_points(std::move(drawing), context, place, all);
  return all;
}

ShapePtr lines_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all;
  add_lines_and_points(std::move(drawing), context, place, all);
  return united(std::move(all), place);
}

ShapePtr shape_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all = parts_of(std::move(drawing), context, place);
  if (all.empty()) throw Error(ErrorCode::kGeometry, "an outline that draws nothing");
  return united(std::move(all), place);
}

namespace {

/// Whether each outline that lies in no other is a part.
bool splits(const Drawing& drawing, const ReadContext& context) {
  if (context.drawing.parts) return context.drawing.parts == PartRule::kOutlines;
  const auto counted = [](const auto& one) { return quantity_in(one.name).has_value(); };
  return context.quantities && (std::any_of(drawing.chains.begin(), drawing.chains.end(), counted) ||
                                std::any_of(drawing.discs.begin(), drawing.discs.end(), counted));
}

/// Which outlines belong together: those that lie in no other or in a hole, each with its holes.
class OuterOutlines {
 public:
  /// `around`: which of the others go round each.
  OuterOutlines(std::vector<Contour> outlines, std::vector<std::vector<std::size_t>> around)
      : outlines_(std::move(outlines)), around_(std::move(around)) {
    for (const Contour& outline : outlines_) edges_ += outline.size();
    for (std::size_t k = 0; k < outlines_.size(); ++k)
      outer_.push_back(around_[k].size() % 2 == 0 ? k : innermost(around_[k]));
  }

  std::size_t size() const { return outer_.size(); }
  /// The one that the outline belongs to: itself, or where it is a hole the innermost around it.
  std::size_t of(std::size_t outline) const { return outer_[outline]; }
  /// The one that has such a point in it or in its holes.
  std::optional<std::size_t> about(std::span<const plane::GridPoint> points, plane::WorkBudget& work) const {
    constexpr std::size_t kEdges = 100;  // a unit of work
    for (const plane::GridPoint& p : points) {
      work.charge(1 + edges_ / kEdges, "open lines among so many outlines");
      std::vector<std::size_t> about;
      for (std::size_t k = 0; k < outlines_.size(); ++k)
        if (plane::encloses(outlines_[k], p)) about.push_back(k);
      if (!about.empty()) return outer_[innermost(about)];
    }
    return std::nullopt;
  }

 private:
  std::size_t innermost(const std::vector<std::size_t>& about) const {
    return *std::max_element(about.begin(), about.end(),
                             [this](std::size_t a, std::size_t b) { return around_[a].size() < around_[b].size(); });
  }

  std::vector<Contour> outlines_;
  std::vector<std::vector<std::size_t>> around_;
  std::vector<std::size_t> outer_;
  std::size_t edges_ = 0;
};

struct PartDrawing {
  std::string name;
  Drawing drawing;
};

/// Open lines and points go to the part that they lie in; those that lie in none are the last.
void give_lines_and_points(Drawing drawing, const OuterOutlines& outer, plane::WorkBudget& work,
                           std::vector<PartDrawing>& parts) {
  Drawing apart;
  const auto home = [&](const std::vector<plane::GridPoint>& points) -> Drawing& {
    const std::optional<std::size_t> about = outer.about(points, work);
    return about ? parts[*about].drawing : apart;
  };
  for (Chain& chain : drawing.chains) {
    std::vector<plane::GridPoint> corners;
    for (const plane::ContourEdge& edge : chain.edges) corners.push_back(edge.start);
    home(corners).chains.push_back(std::move(chain));
  }
  for (const plane::GridPoint& p : drawing.points) home({p}).points.push_back(p);
  parts.push_back({{}, std::move(apart)});
}

bool is_empty(const Drawing& drawing) {
  return drawing.chains.empty() && drawing.discs.empty() && drawing.points.empty();
}

/// A drawing for each outline that is no hole, with its holes and what is drawn in it.
std::vector<PartDrawing> by_outline(Drawing drawing, ReadContext& context) {
  std::vector<Contour> outlines = outlines_near(drawing, context);
  std::vector<Chain> closed = take_closed(drawing);
  std::optional<std::vector<std::vector<std::size_t>>> around;
  if (std::any_of(closed.begin(), closed.end(), is_curved))
    around = nesting_of(closed, outlines, context.drawing.tolerance).around();
  if (!around) around = plane::rings_around(outlines);
  const OuterOutlines outer(std::move(outlines), *std::move(around));
  std::vector<PartDrawing> parts(outer.size());
  std::size_t k = 0;
  for (Chain& chain : closed) {
    if (outer.of(k) == k) parts[k].name = chain.name;
    parts[outer.of(k++)].drawing.chains.push_back(std::move(chain));
  }
  for (Disc& disc : drawing.discs) {
    if (outer.of(k) == k) parts[k].name = disc.name;
    parts[outer.of(k++)].drawing.discs.push_back(std::move(disc));
  }
  drawing.discs.clear();
  give_lines_and_points(std::move(drawing), outer, context.work, parts);
  std::erase_if(parts, [](const PartDrawing& p) { return is_empty(p.drawing); });
  return parts;
}

/// Of outlines that cross it is not known which of them are holes.
void refuse_crossing(const Drawing& drawing, const ReadContext& context, const std::string& name) {
  ReadContext aside = context;
  parts_of(drawing, aside, name);
}

}  // namespace

std::vector<ShapePtr> closed_parts(Drawing drawing, ReadContext& context, const std::string& name) try {
  close_outlines(drawing, context, name);
  if (!splits(drawing, context)) return parts_of(std::move(drawing), context, name);
  refuse_crossing(drawing, context, name);
  std::vector<ShapePtr> parts;
  for (PartDrawing& part : by_outline(std::move(drawing), context)) {
    Shape shape = *shape_of(std::move(part.drawing), context, name);
    shape.name = std::move(part.name);
    parts.push_back(share(std::move(shape)));
  }
  return parts;
} catch (const Error& e) {
  throw e.within(name);
}

bool any_within_another(const std::vector<Drawing>& drawings, const ReadContext& context) {
  std::vector<Contour> all;
  std::vector<std::size_t> alone;  // how deep each lies in outlines of its own drawing
  for (const Drawing& drawing : drawings) {
    const std::vector<Contour> own = outlines_near(drawing, context);
    const std::vector<std::size_t> depths = plane::nesting_depths(own);
    all.insert(all.end(), own.begin(), own.end());
    alone.insert(alone.end(), depths.begin(), depths.end());
  }
  return plane::nesting_depths(all) != alone;
}

bool encloses_alike(const Drawing& drawing, const ReadContext& context) {
  if (drawing.chains.size() < 2) return true;
  const std::vector<Contour> outlines = outlines_near(drawing, context);
  const std::vector<std::vector<std::size_t>> around = plane::rings_around(outlines);
  std::vector<int> ways;
  for (const Contour& outline : outlines) ways.push_back(plane::orientation(outline));
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    int turns = ways[k];
    for (const std::size_t outer : around[k]) turns += ways[outer];
    if ((turns != 0) != (around[k].size() % 2 == 0)) return false;
  }
  return true;
}

void append(Drawing& all, const Drawing& more) {
  all.chains.insert(all.chains.end(), more.chains.begin(), more.chains.end());
  all.discs.insert(all.discs.end(), more.discs.begin(), more.discs.end());
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
}

ShapePtr polygon_of(Drawing drawing, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> all;
  add_areas(drawing, context, place, plane::RingRule::kHoles, all);
  return united(std::move(all), place);
}

}  // namespace findspace::io
