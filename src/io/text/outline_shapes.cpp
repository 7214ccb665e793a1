// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/outline_shapes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "findspace/error.h"
#include "io/text/drawing_rules.h"
#include "io/text/mended_outlines.h"
#include "io/text/quantity.h"
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
Contour expanded(Chain chain, const ReadContext& context, plane::CurveSide side, std::vector<plane::CapBox>& caps) {
  if (chain.curves.empty()) return std::move(chain.edges);
  Contour out;
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    if (!chain.curves[k]) {
      out.push_back(std::move(chain.edges[k]));
      continue;
    }
    plane::ArcChain arcs = plane::arcs_of(*chain.curves[k], context.drawing.tolerance, side);
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
};

/// Closed outlines with arcs on either side of their curves: of the closed chains in order, then of the circles.
std::vector<Contour> outlines_near(const Drawing& drawing, const ReadContext& context) {
  std::vector<Contour> outlines;
  std::vector<plane::CapBox> none;
  for (const Chain& chain : drawing.chains) {
    if (!chain.closed) continue;
    Contour outline = expanded(chain, context, plane::CurveSide::kNear, none);
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

/// Curves on the side that the rule wants; `others` are rings without curves that count in the nesting.
Rings take_rings(Drawing& drawing, ReadContext& context, const std::vector<Contour>& others) {
  const std::vector<Chain> closed = take_closed(drawing);
  Rings rings;
  for (const Chain& chain : closed)
    rings.contours.push_back(expanded(chain, context, plane::CurveSide::kNear, rings.caps));
  if (std::any_of(rings.contours.begin(), rings.contours.end(), [](const Contour& c) { return c.size() < 2; }))
    throw Error(ErrorCode::kGeometry, "a closed curve smaller than the tolerance");
  rings.material_left.resize(closed.size());
  rings.curved = std::any_of(closed.begin(), closed.end(), [](const Chain& c) { return !c.curves.empty(); });
  if (rings.curved && context.drawing.curves != CurveRule::kNear) {
    std::vector<Contour> all = rings.contours;
    all.insert(all.end(), others.begin(), others.end());
    const std::vector<std::size_t> depths = plane::nesting_depths(all);
    for (std::size_t k = 0; k < closed.size(); ++k) {
      if (closed[k].curves.empty()) continue;
      const bool material_left = (plane::orientation(all[k]) > 0) == (depths[k] % 2 == 0);
      rings.material_left[k] = material_left;
      const bool left = material_left == (context.drawing.curves == CurveRule::kInside);
      const auto side = left ? plane::CurveSide::kLeft : plane::CurveSide::kRight;
      rings.contours[k] = expanded(closed[k], context, side, rings.caps);
    }
  }
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
    Contour edges = expanded(chain, context, plane::CurveSide::kNear, none);
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

/// Outer rings with their holes, as they are or mended.
std::vector<ShapePtr> nested_parts(const Rings& rings, ReadContext& context, const std::string& place) {
  std::vector<ShapePtr> parts;
  try {
    for (plane::RingSet& set : plane::nest_rings(rings.contours, context.grid.step_size())) {
      context.repeated_points += set.repeated_points;
      parts.push_back(rings_shape(std::move(set.contours), place));
    }
  } catch (const Error& fault) {
    return mended_parts(rings, fault, context, place);
  }
  return parts;
}

void add_areas(Drawing& drawing, ReadContext& context, const std::string& place, std::vector<ShapePtr>& all) {
  std::vector<Contour> discs;
  for (const Disc& disc : drawing.discs) discs.push_back(ring_of(disc, context));
  Rings rings = take_rings(drawing, context, discs);
  std::vector<Contour>& contours = rings.contours;
  std::move(discs.begin(), discs.end(), std::back_inserter(contours));
  auto add = [&](ShapePtr shape) {
    all.push_back(with_caps(std::move(shape), rings.caps, context.drawing.curves, place));
  };
  if (auto cells = plane::region_of_touching_rings(contours, plane::RingRule::kEvenOdd))
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
    add_areas(drawing, context, place, all);
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
  explicit OuterOutlines(std::vector<Contour> outlines)
      : outlines_(std::move(outlines)), around_(plane::rings_around(outlines_)) {
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
  const OuterOutlines outer(outlines_near(drawing, context));
  std::vector<PartDrawing> parts(outer.size());
  std::size_t k = 0;
  for (Chain& chain : take_closed(drawing)) {
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

void append(Drawing& all, const Drawing& more) {
  all.chains.insert(all.chains.end(), more.chains.begin(), more.chains.end());
  all.discs.insert(all.discs.end(), more.discs.begin(), more.discs.end());
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
}

ShapePtr polygon_of(Drawing drawing, ReadContext& context, const std::string& place) {
  Outlines rings;
  rings.rule = plane::RingRule::kHoles;
  for (Chain& chain : take_closed(drawing)) rings.contours.push_back(std::move(chain.edges));
  if (auto cells = plane::region_of_touching_rings(rings.contours, rings.rule))
    return cells_shape(*std::move(cells), place);
  try {
    plane::RingSet set = plane::make_rings(rings.contours, context.grid.step_size());
    context.repeated_points += set.repeated_points;
    return rings_shape(std::move(set.contours), place);  // formats disagree about the direction of rings: no note
  } catch (const Error& fault) {
    return united(mended_parts(rings, fault, context, place), place);
  }
}

}  // namespace findspace::io
