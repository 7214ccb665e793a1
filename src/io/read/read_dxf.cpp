// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// DXF drawings (ASCII): LINE, LWPOLYLINE and POLYLINE with bulges, CIRCLE, ARC, POINT, INSERT of blocks. Lines, arcs
// and open polylines whose ends are the same grid point are joined; closed outlines nest by the even-odd rule, so a
// circle inside an outline is a hole. What stays open is a polyline, and a note says so. Splines, ellipses and regions
// are refused; texts, dimensions and hatches are left out with a note, and a z other than 0 is, with a note. Unit:
// $INSUNITS. Source: AutoCAD DXF reference (2012).
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "findspace/error.h"
#include "io/read/read_dxf_groups.h"
#include "io/read/read_file.h"
#include "io/text/outline_shapes.h"
#include "io/text/read_transform.h"
#include "io/text/scene_reader.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::ShapePtr;

constexpr int kMostBlockDepth = 16;

std::optional<Real> millimetres(const DxfDocument& document) {
  switch (document.units.value_or(0)) {
    case 0:
      return std::nullopt;
    case 1:
      return Real::ratio(254, 10);
    case 2:
      return Real::ratio(3048, 10);
    case 4:
      return Real(1);
    case 5:
      return Real(10);
    case 6:
      return Real(1000);
    case 8:
      return Real::ratio(254, 10000000);
    case 9:
      return Real::ratio(254, 10000);
    case 13:
      return Real::ratio(1, 1000);
    case 14:
      return Real(100);
    default:
      throw Error(ErrorCode::kUnsupported,
                  fmt::format("$INSUNITS {} is no unit that is read; state \"unit\" beside the file", *document.units),
                  document.name);
  }
}

class DxfReader {
 public:
  DxfReader(const DxfDocument& document, const FileChoice& choice, ReadContext& context, const Real& scale)
      : document_(document), choice_(choice), context_(context), outline_(context, scale) {}

  std::vector<ShapePtr> read() {
    for (const DxfEntity& entity : document_.entities) draw(entity, Affine{}, entity.layer(), 0);
    std::vector<ShapePtr> parts = joined();
    if (parts.empty() && choice_.layer) refuse_layer();
    for (const auto& [type, count] : left_out_) {
      context_.notes.push_back(fmt::format("{}: {} {} left out", document_.name, count, type));
    }
    if (raised_ > 0) {
      context_.notes.push_back(fmt::format("{}: {} {} a z other than 0, read as seen from above", document_.name,
                                           raised_, raised_ == 1 ? "entity has" : "entities have"));
    }
    return parts;
  }

 private:
  std::vector<ShapePtr> joined() try {
    Drawing drawing = outline_.take();
    join_open_chains(drawing, context_.grid.step_size());
    if (const int n = open_chains(drawing); n > 0) {
      context_.notes.push_back(fmt::format("{}: {} open {} read as {}, without an inside", document_.name, n,
                                           n == 1 ? "outline is" : "outlines are",
                                           n == 1 ? "a polyline" : "polylines"));
    }
    return parts_of(std::move(drawing), context_, document_.name);
  } catch (const Error& e) {
    throw e.within(document_.name);
  }

  void refuse_layer() const {
    std::string hint = choice("layers", *choice_.layer, {layers_.begin(), layers_.end()});
    throw Error(ErrorCode::kUnknownName,
                fmt::format("there is no layer '{}' with a shape in it{}", *choice_.layer, hint), document_.name);
  }

  void draw(const DxfEntity& entity, const Affine& map, std::string_view layer, int depth) {
    layers_.insert(std::string(layer));
    if (entity.type == "INSERT") return insert(entity, map, layer, depth);
    if (choice_.layer && layer != *choice_.layer) return;
    if (document_.flags(entity, 67) == 1) return;  // paper space: the frame around the drawing
    try {
      draw_one(entity, map);
    } catch (const Error& e) {
      if (e.place().find(document_.name) != std::string::npos) throw;
      throw e.within(document_.place(entity));
    }
  }

  void draw_one(const DxfEntity& e, const Affine& map) {
    Placed out(map, outline_);
    check_flat(e);
    if (e.type == "LINE") {
      out.move_to(number(e, 10), number(e, 20));
      out.line_to(number(e, 11), number(e, 21));
      out.finish();
    } else if (e.type == "CIRCLE") {
      out.circle(number(e, 10), number(e, 20), number(e, 40));
    } else if (e.type == "ARC") {
      arc(e, out);
    } else if (e.type == "POINT") {
      out.point(number(e, 10), number(e, 20));
    } else if (e.type == "LWPOLYLINE") {
      light_polyline(e, out);
    } else if (e.type == "POLYLINE") {
      polyline(e, out);
    } else {
      return other(e);
    }
    raised_ += is_raised(e) ? 1 : 0;
  }

  /// Whether some height of it is not 0: its own, that of a line's end, or of a vertex.
  bool is_raised(const DxfEntity& e) const {
    for (const int code : {30, 31, 38})
      if (document_.number(e, code, 0).sign() != 0) return true;
    return std::any_of(e.vertices.begin(), e.vertices.end(), [&](const DxfEntity& v) { return is_raised(v); });
  }

  Real number(const DxfEntity& e, int code) const { return document_.number(e, code); }

  /// Entities drawn on a plane other than z = 0 seen from above.
  void check_flat(const DxfEntity& e) const {
    if (compare(document_.number(e, 230, 1), Real(1)) == 0) return;
    throw Error(ErrorCode::kUnsupported, "its plane is rotated (extrusion direction other than 0, 0, 1)");
  }

  void other(const DxfEntity& e) {
    static const std::set<std::string_view> refused{"SPLINE", "ELLIPSE", "REGION", "3DFACE", "SOLID", "3DSOLID",
                                                    "TRACE",  "MESH",    "BODY",   "MLINE",  "HELIX", "SURFACE"};
    if (refused.count(e.type) > 0)
      throw Error(ErrorCode::kUnsupported, fmt::format("{} is not read; only lines and circular arcs are", e.type));
    ++left_out_[std::string(e.type)];
  }

  void arc(const DxfEntity& e, Placed& out) {
    Real x = number(e, 10), y = number(e, 20), r = number(e, 40), from = number(e, 50), to = number(e, 51);
    if (r.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
    Real sweep = to - from;
    sweep = sweep - Real(360) * Real(floor(sweep / Real(360)));
    if (sweep.sign() == 0) return out.circle(x, y, r);
    Direction a = direction(from), b = direction(to);
    out.move_to(x + r * a.cosine, y + r * a.sine);
    out.arc_to(r, Real(180) < sweep, true, x + r * b.cosine, y + r * b.sine);
    out.finish();
  }

  struct Vertex {
    Real x, y, bulge;
  };

  void run(const std::vector<Vertex>& v, bool closed, Placed& out) {
    if (v.size() < 2) throw Error(ErrorCode::kGeometry, "a polyline of fewer than two vertices");
    out.move_to(v[0].x, v[0].y);
    for (std::size_t i = 1; i < v.size(); ++i) out.bulge_to(v[i - 1].bulge, v[i].x, v[i].y);
    if (!closed) return out.finish();
    if (v.back().bulge.sign() != 0) out.bulge_to(v.back().bulge, v[0].x, v[0].y);
    out.close();
  }

  void light_polyline(const DxfEntity& e, Placed& out) {
    std::vector<Vertex> v;
    for (const DxfGroup& group : e.groups) {
      if (group.code == 10) v.push_back({document_.number(group), 0, 0});
      if (v.empty()) continue;
      if (group.code == 20) v.back().y = document_.number(group);
      if (group.code == 42) v.back().bulge = document_.number(group);
    }
    run(v, (document_.flags(e, 70) & 1) != 0, out);
  }

  void polyline(const DxfEntity& e, Placed& out) {
    constexpr int kCurveFitOrMesh = 2 | 4 | 8 | 16 | 64;
    int flags = document_.flags(e, 70);
    if ((flags & kCurveFitOrMesh) != 0) throw Error(ErrorCode::kUnsupported, "a 3D or curve-fitted POLYLINE");
    std::vector<Vertex> v;
    for (const DxfEntity& vertex : e.vertices) {
      v.push_back({number(vertex, 10), number(vertex, 20), document_.number(vertex, 42, 0)});
    }
    run(v, (flags & 1) != 0, out);
  }

  void insert(const DxfEntity& e, const Affine& map, std::string_view layer, int depth) {
    if (depth >= kMostBlockDepth)
      throw Error(ErrorCode::kUnsupported, "blocks nested more than 16 deep, or in themselves", document_.place(e));
    const DxfGroup* name = e.find(2);
    auto block = name ? document_.blocks.find(name->value) : document_.blocks.end();
    if (block == document_.blocks.end())
      throw Error(ErrorCode::kUnknownName, "it inserts an unknown block", document_.place(e));
    if (document_.flags(e, 70) > 1 || document_.flags(e, 71) > 1) {
      throw Error(ErrorCode::kUnsupported, "an array of blocks (several rows or columns)", document_.place(e));
    }
    check_flat(e);
    raised_ += is_raised(e) ? 1 : 0;
    const DxfEntity& head = block->second.head;
    Affine own = map * Affine::translation(number(e, 10), number(e, 20)) *
                 Affine::rotation(document_.number(e, 50, 0)) *
                 Affine::scaling(document_.number(e, 41, 1), document_.number(e, 42, 1)) *
                 Affine::translation(-document_.number(head, 10, 0), -document_.number(head, 20, 0));
    for (const DxfEntity& inner : block->second.entities) {
      if (++drawn_ > kMaxInserted)
        throw Error(ErrorCode::kUnsupported, "more than a million entities in blocks", document_.place(e));
      draw(inner, own, inner.layer() == "0" ? layer : inner.layer(), depth + 1);
    }
  }

  static constexpr int kMaxInserted = 1000000;  // nested blocks could multiply without end

  const DxfDocument& document_;
  const FileChoice& choice_;
  ReadContext& context_;
  Outline outline_;
  std::set<std::string> layers_;
  std::map<std::string, int> left_out_;
  int raised_ = 0;
  int drawn_ = 0;
};

}  // namespace

ShapePtr read_dxf(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  refuse_choice(choice.id.has_value(), "id", "DXF; choose by \"layer\" or \"index\"", name);
  DxfDocument document = read_dxf_document(text, name);
  Real scale = file_scale(choice.unit ? std::nullopt : millimetres(document), name, choice, context);
  return chosen(DxfReader(document, choice, context, scale).read(), name, choice);
}

}  // namespace findspace::io
