// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/board_pad.h"

#include <fmt/format.h>

#include <cmath>

#include "io/text/outline_shapes.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;

struct Size {
  Real x, y;
};

Size size_of(const Sexpr& list) { return {list.item(0).number(), list.item(1).number()}; }

ShapePtr node(Shape::Kind kind, std::vector<ShapePtr> children, const std::string& place) {
  Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  shape.place = place;
  return std::make_shared<const Shape>(std::move(shape));
}

/// A rectangle about the origin whose corners are rounded with `radius`, which may be half of a side: an oval.
void draw_round(const Size& size, const Real& radius, Placed& out) {
  const Real x = size.x / Real(2), y = size.y / Real(2);
  const Real ix = x - radius, iy = y - radius;
  const Real corner[4][2] = {{ix, iy}, {-ix, iy}, {-ix, -iy}, {ix, -iy}};
  const int way[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  for (int k = 0; k < 4; ++k) {
    const auto at = [&](const int* w, int c) { return corner[k][c] + Real(w[c]) * radius; };
    const Real fx = at(way[k], 0), fy = at(way[k], 1), tx = at(way[k + 1], 0), ty = at(way[k + 1], 1);
    k == 0 ? out.move_to(fx, fy) : out.line_to(fx, fy);
    out.arc_to(radius, false, true, tx, ty);
  }
  out.close();
}

/// `delta`: of a trapezoid, how much longer one side is than the other.
void draw_corners(const Size& size, const Size& delta, Placed& out) {
  const Real x = size.x / Real(2), y = size.y / Real(2), dx = delta.y / Real(2), dy = delta.x / Real(2);
  out.move_to(-x + dx, -y - dy);
  out.line_to(x - dx, -y + dy);
  out.line_to(x + dx, y - dy);
  out.line_to(-x - dx, y + dy);
  out.close();
}

/// The rounded rectangle with the corners cut off that (chamfer ...) names.
void draw_chamfered(const Sexpr& pad, const Size& size, const Real& radius, const Real& cut, Placed& out) {
  const char* const names[4] = {"bottom_right", "bottom_left", "top_left", "top_right"};
  const int sign[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const auto chamfer = pad.find("chamfer");
  for (int k = 0; k < 4; ++k) {
    const bool cuts = chamfer && chamfer->has_word(names[k]);
    const Real& in = cuts ? cut : radius;
    const Real sx(sign[k][0]), sy(sign[k][1]), x = size.x / Real(2), y = size.y / Real(2);
    const Size along{sx * x, sy * (y - in)}, across{sx * (x - in), sy * y};
    const Size &from = k % 2 == 0 ? along : across, &to = k % 2 == 0 ? across : along;
    k == 0 ? out.move_to(from.x, from.y) : out.line_to(from.x, from.y);
    if (in.sign() == 0) continue;
    if (cuts)
      out.line_to(to.x, to.y);
    else
      out.arc_to(radius, false, true, to.x, to.y);
  }
  out.close();
}

Real lesser(const Size& size) { return size.x < size.y ? size.x : size.y; }

Real ratio_of(const Sexpr& pad, std::string_view key) {
  const auto ratio = pad.find(key);
  return ratio ? ratio->item(0).number() : Real(0);
}

void check_size(const Sexpr& pad, const Size& size) {
  if (size.x.sign() <= 0 || size.y.sign() <= 0) pad.fail(ErrorCode::kBadValue, "the size of a pad must be more than 0");
}

void draw_rounded(const Sexpr& pad, const Size& size, Placed& out) {
  const Real radius = ratio_of(pad, "roundrect_rratio") * lesser(size);
  const Real cut = ratio_of(pad, "chamfer_ratio") * lesser(size);
  const Real half = lesser(size) / Real(2);
  if (radius.sign() < 0 || half < radius || cut.sign() < 0 || half < cut)
    pad.fail(ErrorCode::kBadValue, "a corner of a pad is rounded or cut by more than half of its side");
  if (cut.sign() > 0) return draw_chamfered(pad, size, radius, cut, out);
  radius.sign() == 0 ? draw_corners(size, {}, out) : draw_round(size, radius, out);
}

/// The outline of a pad that is not a custom one, or of the anchor of one.
void draw_outline(const Sexpr& pad, const std::string& kind, const Size& size, Placed& out) {
  if (kind == "circle") return out.circle(0, 0, size.x / Real(2));
  if (kind == "rect") return draw_corners(size, {}, out);
  if (kind == "roundrect") return draw_rounded(pad, size, out);
  if (kind == "oval") {
    if (compare(size.x, size.y) == 0) return out.circle(0, 0, size.x / Real(2));
    return draw_round(size, lesser(size) / Real(2), out);
  }
  if (kind != "trapezoid") pad.fail(ErrorCode::kUnsupported, fmt::format("a pad of the unknown shape '{}'", kind));
  const auto delta = pad.find("rect_delta");
  draw_corners(size, delta ? size_of(*delta) : Size{}, out);
}

/// What shape the anchor of a custom pad has.
std::string anchor_of(const Sexpr& pad) {
  const auto options = pad.find("options");
  const auto anchor = options ? options->find("anchor") : std::nullopt;
  return anchor ? anchor->item(0).text() : "circle";
}

Real width_of(const Sexpr& primitive) {
  const auto width = primitive.find("width");
  return width ? width->item(0).number() : Real(0);
}

/// One primitive of a custom pad: its outline or chain, grown by half its width.
ShapePtr primitive(const Sexpr& item, const Affine& map, ReadContext& context) {
  Graphics graphics(context);
  if (!graphics.add(item, map)) item.fail(ErrorCode::kUnsupported, "an unknown primitive of a custom pad");
  const Real half = context.grid.steps(width_of(item) / Real(2));
  const auto fill = item.find("fill");
  const bool empty = fill && (fill->has_word("none") || fill->has_word("no"));
  const bool polygon = item.is("gr_poly");
  ShapePtr shape = graphics.filled(item.place(), polygon || (half.sign() == 0) || (fill && !empty));
  if (half.sign() == 0) return shape;
  Shape grown;
  grown.kind = Shape::Kind::kOffset;
  grown.amount = half;
  grown.children = {std::move(shape)};
  grown.place = item.place();
  return std::make_shared<const Shape>(std::move(grown));
}

ShapePtr custom(const Sexpr& pad, const Size& size, const Affine& map, ReadContext& context) {
  Outline outline(context);
  Placed out(map, outline);
  draw_outline(pad, anchor_of(pad), size, out);
  std::vector<ShapePtr> parts{shape_of(outline.take(), context, pad.place())};
  if (const auto primitives = pad.find("primitives"))
    primitives->each([&](const Sexpr& item) {
      if (item.is_list()) parts.push_back(primitive(item, map, context));
    });
  return parts.size() == 1 ? parts[0] : node(Shape::Kind::kUnion, std::move(parts), pad.place());
}

void include_box(const Extent& box, double margin, Extent& out) {
  out.include(box.low[0] - margin, box.low[1] - margin);
  out.include(box.high[0] + margin, box.high[1] + margin);
}

/// What draw_outline() draws.
void include_outline(const Sexpr& pad, const std::string& kind, Extent& out) {
  const Size size = size_of(pad.need("size"));
  double x = size.x.to_double() / 2, y = kind == "circle" ? x : size.y.to_double() / 2;
  if (const auto delta = pad.find("rect_delta"); delta && kind == "trapezoid") {
    const Size longer = size_of(*delta);
    x += std::abs(longer.y.to_double()) / 2;
    y += std::abs(longer.x.to_double()) / 2;
  }
  out.include(-x, -y);
  out.include(x, y);
}

void include_primitives(const Sexpr& pad, Extent& out) {
  const auto primitives = pad.find("primitives");
  if (!primitives) return;
  primitives->each([&](const Sexpr& item) {
    ReadContext aside;  // points that are rounded count once, with the copper
    Graphics graphics(aside);
    if (!item.is_list() || !graphics.add(item, Affine{})) return;
    if (const Extent drawn = graphics.extent(); !drawn.empty()) include_box(drawn, width_of(item).to_double() / 2, out);
  });
}

std::optional<Sexpr> offset_of(const Sexpr& pad) {
  const auto drill = pad.find("drill");
  return drill ? drill->find("offset") : std::nullopt;
}

/// (drill 0.8), (drill oval 1 2), with or without (offset ...).
ShapePtr hole_of(const Sexpr& pad, const Sexpr& drill, const Affine& map, ReadContext& context) {
  std::vector<Real> sizes;
  drill.each([&](const Sexpr& item) {
    if (!item.is_list() && item.text() != "oval") sizes.push_back(item.number());
  });
  if (sizes.empty()) return nullptr;
  const Size size{sizes[0], sizes.size() > 1 ? sizes[1] : sizes[0]};
  if (size.x.sign() == 0) return nullptr;
  check_size(pad, size);
  Outline outline(context);
  Placed out(map, outline);
  draw_outline(pad, "oval", size, out);
  return shape_of(outline.take(), context, drill.place());
}

}  // namespace

Real angle_of(const Sexpr& at) {
  const std::vector<Sexpr> items = at.items();
  for (std::size_t k = 2; k < items.size(); ++k)
    if (!items[k].is_list() && items[k].text() != "unlocked") return items[k].number();
  return 0;
}

Affine placement_of(const Sexpr& at) {
  return Affine::translation(at.item(0).number(), at.item(1).number()) * Affine::rotation(-angle_of(at));
}

PadShapes read_pad(const Sexpr& pad, const Affine& footprint, ReadContext& context) {
  const Sexpr at = pad.need("at");
  const Real x = at.item(0).number(), y = at.item(1).number();
  const Affine centre =
      Affine::translation(footprint.x_of(x, y), footprint.y_of(x, y)) * Affine::rotation(-angle_of(at));
  const auto drill = pad.find("drill"), offset = offset_of(pad);
  const Affine map = offset ? centre * Affine::translation(offset->item(0).number(), offset->item(1).number()) : centre;
  const Size size = size_of(pad.need("size"));
  check_size(pad, size);
  PadShapes out;
  const std::string kind = pad.item(2).text();
  if (kind == "custom") {
    out.copper = custom(pad, size, map, context);
  } else {
    Outline outline(context);
    Placed placed(map, outline);
    draw_outline(pad, kind, size, placed);
    out.copper = shape_of(outline.take(), context, pad.place());
  }
  if (drill) out.hole = hole_of(pad, *drill, centre, context);
  return out;
}

Extent pad_extent(const Sexpr& pad) {
  Extent out;
  const std::string kind = pad.item(2).text();
  const bool custom = kind == "custom";
  include_outline(pad, custom ? anchor_of(pad) : kind, out);
  if (custom) include_primitives(pad, out);
  if (const auto offset = offset_of(pad))
    for (std::size_t k = 0; k < 2; ++k) {
      const double by = offset->item(k).number().to_double();
      out.low[k] += by;
      out.high[k] += by;
    }
  return out;
}

ShapePtr disc(plane::GridPoint center, const Real& radius, const std::string& place) {
  Shape shape;
  shape.kind = Shape::Kind::kDisc;
  shape.points = {center};
  shape.amount = radius;
  shape.place = place;
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr stroke(plane::Contour chain, const Real& width, const std::string& place) {
  const Real half = width / Real(2);
  if (chain.size() == 2 && chain[0].start == chain[1].start && !chain[0].arc) return disc(chain[0].start, half, place);
  Shape line, grown;
  line.kind = Shape::Kind::kPolyline;
  line.contours.push_back(std::move(chain));
  line.place = grown.place = place;
  grown.kind = Shape::Kind::kOffset;
  grown.amount = half;
  grown.children = {std::make_shared<const Shape>(std::move(line))};
  return std::make_shared<const Shape>(std::move(grown));
}

}  // namespace findspace::io
