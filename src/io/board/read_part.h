// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One footprint of a board: its courtyards, pads and what of it belongs to the board. A footprint on the back stands in
// the file as it is seen from the front, so nothing is mirrored here. Where no courtyard is drawn, or one is not
// closed, the box about pads and drawn body stands in. Keywords: footprint, module, courtyard, keep-out.
#pragma once

#include <functional>

#include "io/board/board.h"
#include "io/board/board_graphics.h"

namespace findspace::io {

/// The name that KiCad gives a layer, whatever the board calls it.
using LayerNames = std::function<std::string(const std::string&)>;

struct PartReader {
  ReadContext& context;
  LayerNames layer;
  Graphics& edges;  // gets what the footprint draws on Edge.Cuts
  Board& board;     // gets holes, keep-outs and notes

  Part read(const Sexpr& footprint, const std::string& name);
};

/// Whether the word stands in the item after its name, or (word), or (word yes).
bool has_flag(const Sexpr& item, const char* word);
/// The sides that (layer ...) or (layers ...) names: F.Cu, *.Cu, F&B.Cu.
Sides sides_of(const std::vector<std::string>& layers);
std::vector<std::string> layers_of(const Sexpr& item, const LayerNames& names);
/// A zone, which a footprint or the board may have, as its area.
plane::ShapePtr zone_area(const Sexpr& zone, ReadContext& context);
/// Adds the zone to the keep-outs if it allows no footprints; false: it is not a rule area. `part`: whose it is, or
/// empty.
bool add_keep_out(const Sexpr& zone, const std::string& part, const LayerNames& names, ReadContext& context,
                  Board& board);

}  // namespace findspace::io
