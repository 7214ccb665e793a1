// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// DXF drawings, ASCII or binary: LINE, LWPOLYLINE and POLYLINE with bulges, CIRCLE, ARC, ELLIPSE, SPLINE, SOLID, POINT,
// INSERT of blocks, in rows and columns too. Open ones are joined where ends meet or the gap is allowed; closed
// outlines nest by the even-odd rule, so a circle inside an outline is a hole. A HATCH is read where nothing else is
// drawn: it fills outlines that are drawn beside it. Solids and regions are refused. Texts, dimensions, what is
// invisible, widths of polylines and a z other than 0 are left out with a note; paper space is passed over. Layers that
// are off or frozen are read, with a note. Unit: $INSUNITS. Source: AutoCAD DXF reference (2012).
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "findspace/error.h"
#include "io/read/read_dxf_entities.h"
#include "io/read/read_file.h"
#include "io/text/file_kind.h"
#include "io/text/outline_shapes.h"
#include "io/text/quantity.h"
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
      throw Error(
          ErrorCode::kUnsupported,
          fmt::format("$INSUNITS {} is not a unit that is read; state \"unit\" beside the file", *document.units),
          document.name);
  }
}

class DxfReader {
 public:
  DxfReader(const DxfDocument& document, const FileChoice& choice, ReadContext& context, const Real& scale)
      : document_(document), choice_(choice), context_(context), outline_(context, scale) {}

  std::vector<ShapePtr> read() {
    for (const DxfEntity& entity : document_.entities) draw(entity, Affine{}, {entity.layer(), {}, 0, false});
    draw_hatches();
    std::vector<ShapePtr> parts = closed_parts(outline_.take(), context_, document_.name);
    if (parts.empty() && choice_.layer) refuse_layer();
    for (const auto& [type, count] : left_out_) {
      const bool text = type == "TEXT" || type == "MTEXT";
      context_.notes.push_back(fmt::format("{}: {} {} left out{}", document_.name, count, type,
                                           text ? "; a CAD program turns text into outlines" : ""));
    }
    note(raised_, "entity has", "entities have", "a z other than 0, read as seen from above");
    note(wide_, "polyline has", "polylines have", "a width, left out: the line in the middle is read");
    note(invisible_, "invisible entity is", "invisible entities are", "left out");
    note(hidden_, "entity comes", "entities come", "from layers that are off or frozen; \"layer\" chooses a layer");
    note(external_, "insert of another drawing is", "inserts of other drawings are", "left out");
    return parts;
  }

 private:
  /// What an entity stands in.
  struct Around {
    std::string_view layer;  // its own, or where that is 0 the one of the block
    std::string_view block;  // the name of the part
    int depth = 0;
    bool hidden = false;  // by the layer of a block that no one asked for
  };

  struct Hatch {
    const DxfEntity* entity;
    Affine map;
    std::string name;
    bool hidden;  // by its layer
  };

  void note(int count, const char* one, const char* several, const char* what) const {
    if (count == 0) return;
    context_.notes.push_back(fmt::format("{}: {} {} {}", document_.name, count, count == 1 ? one : several, what));
  }

  void refuse_layer() const {
    std::string hint = choice("layers", *choice_.layer, {layers_.begin(), layers_.end()});
    throw Error(ErrorCode::kUnknownName,
                fmt::format("there is no layer '{}' with a shape in it{}", *choice_.layer, hint), document_.name);
  }

  void draw(const DxfEntity& entity, const Affine& map, Around around) {
    const std::string_view layer = around.layer;
    layers_.insert(std::string(layer));
    const bool inserts = entity.type == "INSERT";
    if (document_.flags(entity, 67) == 1 || entity.type == "SEQEND")
      return;  // paper space: the frame around the drawing
    if (!inserts && choice_.layer && !same_dxf_name(layer, *choice_.layer)) return;
    if (document_.flags(entity, 60) == 1) {
      ++invisible_;
      return;
    }
    const DxfNames& hiding = inserts ? document_.frozen_layers : document_.hidden_layers;
    around.hidden = !choice_.layer && (around.hidden || hiding.contains(layer));
    if (inserts) return insert(entity, map, around);
    outline_.set_name(std::string(!quantity_in(around.block) && quantity_in(layer) ? layer : around.block));
    placed(entity, [&] { draw_one(entity, map, around.hidden); });
  }

  /// Errors get the place of the entity.
  template <class Action>
  void placed(const DxfEntity& entity, Action action) {
    try {
      action();
    } catch (const Error& e) {
      if (e.place().find(document_.name) != std::string::npos) throw;
      throw e.within(document_.place(entity));
    }
  }

  /// `hidden`: by its layer, that no one asked for.
  void draw_one(const DxfEntity& e, const Affine& map, bool hidden) {
    static const std::set<std::string_view> refused{"REGION", "3DFACE", "3DSOLID", "MESH",
                                                    "BODY",   "MLINE",  "HELIX",   "SURFACE"};
    if (draw_dxf_entity(document_, e, map, outline_)) {
      raised_ += is_raised(document_, e) ? 1 : 0;
      wide_ += has_width(document_, e) ? 1 : 0;
      hidden_ += hidden ? 1 : 0;
      drawn_any_ = true;
    } else if (refused.count(e.type) > 0) {
      throw Error(ErrorCode::kUnsupported, fmt::format("{} is not read; lines and curves in the plane are", e.type));
    } else if (e.type == "HATCH") {
      hatches_.push_back({&e, map, outline_.name(), hidden});
    } else {
      ++left_out_[std::string(e.type)];
    }
  }

  /// Hatches where nothing else is drawn.
  void draw_hatches() {
    if (drawn_any_ && !hatches_.empty()) left_out_["HATCH"] += static_cast<int>(hatches_.size());
    if (drawn_any_) return;
    for (const Hatch& hatch : hatches_) {
      outline_.set_name(hatch.name);
      hidden_ += hatch.hidden ? 1 : 0;
      placed(*hatch.entity, [&] { draw_dxf_hatch(document_, *hatch.entity, hatch.map, outline_); });
    }
  }

  void insert(const DxfEntity& e, const Affine& map, const Around& around) {
    if (around.depth >= kMostBlockDepth)
      throw Error(ErrorCode::kUnsupported, "blocks nested more than 16 deep, or in themselves", document_.place(e));
    const DxfGroup* name = e.find(2);
    auto block = name ? document_.blocks.find(name->value) : document_.blocks.end();
    if (block == document_.blocks.end())
      throw Error(ErrorCode::kUnknownName, "it inserts an unknown block", document_.place(e));
    constexpr int kExternal = 4 | 8;
    const bool elsewhere = block->second.entities.empty();
    if (elsewhere && (document_.flags(block->second.head, 70) & kExternal) != 0) ++external_;
    const bool keeps = quantity_in(around.block) || block->first.starts_with('*');
    const Around within{around.layer, keeps ? around.block : std::string_view(block->first), around.depth + 1,
                        around.hidden};
    placed(e, [&] {
      raised_ += is_raised(document_, e) ? 1 : 0;
      const DxfEntity& head = block->second.head;
      const Affine base = map * dxf_plane(document_, e) *
                          Affine::translation(document_.number(e, 10), document_.number(e, 20)) *
                          Affine::rotation(document_.number(e, 50, 0));
      const Affine inner = Affine::scaling(document_.number(e, 41, 1), document_.number(e, 42, 1)) *
                           Affine::translation(-document_.number(head, 10, 0), -document_.number(head, 20, 0));
      const int columns = std::max(1, document_.flags(e, 70)), rows = std::max(1, document_.flags(e, 71));
      const Real dx = document_.number(e, 44, 0), dy = document_.number(e, 45, 0);
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          draw_block(block->second, base * Affine::translation(dx * Real(column), dy * Real(row)) * inner, within);
    });
  }

  void draw_block(const DxfBlock& block, const Affine& map, Around within) {
    if (block.entities.empty()) count_inserted();
    const std::string_view layer = within.layer;
    for (const DxfEntity& entity : block.entities) {
      count_inserted();
      within.layer = entity.layer() == "0" ? layer : entity.layer();
      draw(entity, map, within);
    }
  }

  void count_inserted() {
    if (++inserted_ > kMaxInserted)
      throw Error(ErrorCode::kUnsupported, "more than a million blocks and entities in them");
  }

  static constexpr int kMaxInserted = 1000000;  // nested blocks could multiply without end

  const DxfDocument& document_;
  const FileChoice& choice_;
  ReadContext& context_;
  Outline outline_;
  std::set<std::string> layers_;
  std::map<std::string, int> left_out_;
  int raised_ = 0, wide_ = 0, invisible_ = 0, hidden_ = 0, external_ = 0;
  int inserted_ = 0;
  bool drawn_any_ = false;
  std::vector<Hatch> hatches_;
};

}  // namespace

ShapePtr read_dxf(std::string_view text, const std::string& name, const FileChoice& choice, ReadContext& context) {
  refuse_choice(choice.id.has_value(), "id", "DXF; choose by \"layer\" or \"index\"", name);
  DxfDocument document = read_dxf_document(without_byte_order_mark(text), name);
  Real scale = file_scale(choice.unit ? std::nullopt : millimetres(document), name, choice, context);
  return chosen(DxfReader(document, choice, context, scale).read(), name, choice);
}

}  // namespace findspace::io
