// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/read_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "exact/margins/boards.h"
#include "io/board/board_pad.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::GridPoint;
using plane::Shape;
using plane::ShapePtr;

/// The layers of a footprint that count.
struct Layers {
  explicit Layers(ReadContext& context)
      : front(context, kCourtyardGap), back(context, kCourtyardGap), body(context), silk(context) {}
  Graphics front, back;  // courtyards
  Graphics body, silk;   // in the footprint's own coordinates
};

/// All the points of its contours, to tell two courtyards apart.
std::multiset<GridPoint> points_of(const std::vector<ShapePtr>& shapes) {
  std::multiset<GridPoint> out;
  for (const ShapePtr& s : shapes) {
    out.insert(s->points.begin(), s->points.end());
    for (const plane::Contour& c : s->contours)
      for (const plane::ContourEdge& e : c) out.insert(e.start);
  }
  return out;
}

/// Calls visit(item, layer) for what the footprint draws.
template <class Visit>
void each_graphic(const Sexpr& footprint, const LayerNames& names, Visit visit) {
  footprint.each([&](const Sexpr& item) {
    if (!item.is_list() || item.head().substr(0, 3) != "fp_") return;
    if (const auto layer = item.find("layer")) visit(item, names(layer->item(0).text()));
  });
}

void read_outlines(const Sexpr& footprint, const Affine& map, const LayerNames& names, Layers& layers,
                   Graphics& edges) {
  each_graphic(footprint, names, [&](const Sexpr& item, const std::string& layer) {
    if (layer == "F.CrtYd") layers.front.add(item, map);
    if (layer == "B.CrtYd") layers.back.add(item, map);
    if (layer == "Edge.Cuts") edges.add(item, map);
  });
}

/// What only stands in for a courtyard. Dots, such as a circle of radius 0, are no part of a body.
void read_body(const Sexpr& footprint, const LayerNames& names, Layers& layers) {
  each_graphic(footprint, names, [&](const Sexpr& item, const std::string& layer) {
    const bool fab = layer == "F.Fab" || layer == "B.Fab", silk = layer == "F.SilkS" || layer == "B.SilkS";
    if (item.is("fp_curve") || (!fab && !silk)) return;
    try {
      (fab ? layers.body : layers.silk).add(item, Affine{});
    } catch (const Error& dot) {
      if (dot.code() != ErrorCode::kGeometry) throw;
    }
  });
}

/// What a pad covers of the footprint's own plane, turned by any angle.
void include_pad(const Sexpr& pad, const Real& footprint_degrees, Extent& box) {
  const Sexpr at = pad.need("at");
  const double x = at.item(0).number().to_double(), y = at.item(1).number().to_double();
  const Extent own = pad_extent(pad);
  const Direction d = direction(angle_of(at) - footprint_degrees);
  const double c = d.cosine.to_double(), s = d.sine.to_double();
  for (const double px : {own.low[0], own.high[0]})
    for (const double py : {own.low[1], own.high[1]}) box.include(x + px * c + py * s, y - px * s + py * c);
}

/// Of a pad: "*.Cu" is both; solder paste and mask do not count.
Sides copper_sides(const Sexpr& pad, const LayerNames& names) {
  std::vector<std::string> layers = layers_of(pad, names);
  std::erase_if(layers, [](const std::string& l) { return !l.ends_with(".Cu"); });
  return sides_of(layers);
}

/// The box in hundredths of a millimetre, rounded outwards.
ShapePtr box_of(const Extent& box, const Affine& map, ReadContext& context, const std::string& place) {
  const auto out = [](double value, bool up) {
    const double hundredths = value * 100 + (up ? -1 : 1) * margin::kBodyBox;
    return Real::ratio(static_cast<std::int64_t>(up ? std::ceil(hundredths) : std::floor(hundredths)), 100);
  };
  const Real x[2] = {out(box.low[0], false), out(box.high[0], true)};
  const Real y[2] = {out(box.low[1], false), out(box.high[1], true)};
  Outline outline(context);
  Placed draw(map, outline);
  draw.move_to(x[0], y[0]);
  draw.line_to(x[1], y[0]);
  draw.line_to(x[1], y[1]);
  draw.line_to(x[0], y[1]);
  draw.close();
  return shape_of(outline.take(), context, place);
}

Extent body_extent(const Sexpr& footprint, const Real& degrees, const Layers& layers) {
  const Graphics& drawn = layers.body.empty() ? layers.silk : layers.body;
  Extent box = drawn.extent();
  footprint.each([&](const Sexpr& item) {
    if (item.is("pad")) include_pad(item, degrees, box);
  });
  return box;
}

bool has_pads(const Sexpr& footprint) { return footprint.find("pad").has_value(); }

/// The courtyards as they are drawn; false where there is none, or one is not closed.
bool use_courtyards(Layers& layers, Part& part, Board& board, const Grid& grid) {
  std::vector<ShapePtr> sides[2];
  for (int k = 0; k < 2; ++k) {
    Graphics& drawn = k == 0 ? layers.front : layers.back;
    if (drawn.empty()) continue;
    auto closed = drawn.closed(part.place);
    if (!closed) {
      const GridPoint p = drawn.open_end();
      board.notes.push_back(fmt::format("{}: its courtyard is not closed at ({}, {})", part.name,
                                        show(double(p.x) * grid.step_size()), show(double(p.y) * grid.step_size())));
      return false;
    }
    part.joined = part.joined || drawn.joined() > 0;
    sides[k] = *std::move(closed);
    (k == 0 ? part.courtyard.front : part.courtyard.back) = true;
  }
  if (sides[0].empty() && sides[1].empty()) return false;
  if (!sides[0].empty() && !sides[1].empty()) {
    part.unlike = points_of(sides[0]) != points_of(sides[1]);
    if (!part.unlike) sides[1].clear();
  }
  std::vector<ShapePtr> all = std::move(sides[0]);
  all.insert(all.end(), sides[1].begin(), sides[1].end());
  part.body = united(std::move(all), part.place);
  return true;
}

}  // namespace

bool has_flag(const Sexpr& item, const char* word) {
  const std::vector<Sexpr> items = item.items();
  for (std::size_t k = 1; k < items.size(); ++k)  // after a name, which may be any word
    if (!items[k].is_list() && items[k].text() == word) return true;
  const auto list = item.find(word);
  return list && !list->has_word("no");
}

std::vector<std::string> layers_of(const Sexpr& item, const LayerNames& names) {
  std::vector<std::string> out;
  for (const char* key : {"layer", "layers"})
    if (const auto list = item.find(key)) list->each([&](const Sexpr& l) { out.push_back(names(l.text())); });
  return out;
}

Sides sides_of(const std::vector<std::string>& layers) {
  Sides out;
  for (const std::string& layer : layers) {
    const bool all = layer[0] == '*' || layer.rfind("F&B", 0) == 0;
    out.front = out.front || all || layer.rfind("F.", 0) == 0;
    out.back = out.back || all || layer.rfind("B.", 0) == 0;
  }
  return out;
}

ShapePtr zone_area(const Sexpr& zone, ReadContext& context) {
  Graphics graphics(context);
  bool any = false;
  zone.each([&](const Sexpr& item) {
    if (!item.is("polygon")) return;
    graphics.add_polygon(item, Affine{});
    any = true;
  });
  if (!any || graphics.empty()) return nullptr;
  return graphics.filled(zone.place(), true);
}

bool add_keep_out(const Sexpr& zone, const std::string& part, const LayerNames& names, ReadContext& context,
                  Board& board) {
  const auto rules = zone.find("keepout");
  if (!rules) return false;
  const auto parts = rules->find("footprints");
  if (!parts || !parts->has_word("not_allowed")) return true;
  const ShapePtr area = zone_area(zone, context);
  if (!area) return true;
  const auto name = zone.find("name");
  const std::string given = name ? name->item(0).text() : "";
  std::string text = given.empty() ? "keep-out 1" : given;
  const auto taken = [&] {
    return std::any_of(board.keep_outs.begin(), board.keep_outs.end(),
                       [&](const KeepOut& k) { return k.name == text; });
  };
  for (int k = 2; taken(); ++k) text = fmt::format("{} {}", given.empty() ? "keep-out" : given, k);
  board.keep_outs.push_back({part, std::move(text), sides_of(layers_of(zone, names)), area});
  return true;
}

Part PartReader::read(const Sexpr& footprint, const std::string& name) {
  Part part;
  part.name = name;
  part.place = fmt::format("footprint '{}' ({})", name, footprint.place());
  const Sexpr at = footprint.need("at");
  const Affine map = placement_of(at);
  part.at = context.grid.nearest(map.e, map.f, context.rounding);
  part.degrees = angle_of(at);
  part.mounted = sides_of(layers_of(footprint, layer));
  part.locked = has_flag(footprint, "locked");
  const auto attributes = footprint.find("attr");
  part.smd = attributes && attributes->has_word("smd");
  footprint.each([&](const Sexpr& item) {
    if (item.is("zone")) add_keep_out(item, name, layer, context, board);
    if (!item.is("pad")) return;
    PadShapes shapes = read_pad(item, map, context);
    if (shapes.hole) board.holes.push_back({name, shapes.hole});
    const std::string pad = item.item(0).text();
    part.through = part.through || (!part.smd && item.item(1).text() == "thru_hole");
    if (!pad.empty())
      part.pads.push_back({fmt::format("{}.{}", name, pad), copper_sides(item, layer), std::move(shapes.copper)});
  });
  Layers layers(context);
  read_outlines(footprint, map, layer, layers, edges);
  if (use_courtyards(layers, part, board, context.grid)) return part;
  read_body(footprint, layer, layers);
  const Extent box = body_extent(footprint, part.degrees, layers);
  if (box.empty() || (!has_pads(footprint) && layers.body.empty())) return part;
  part.stands_in = true;
  part.unlike = false;
  part.courtyard = part.mounted;
  part.body = box_of(box, map, context, part.place);
  return part;
}

}  // namespace findspace::io
