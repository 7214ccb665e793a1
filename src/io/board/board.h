// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A circuit board as its file states it: the outline, the parts with courtyards and pads, areas kept free, copper. All
// shapes are trees on the grid of KiCad, a millionth of a millimetre, in the board's own coordinates: y runs downwards.
// Nothing is computed here. Keywords: PCB, footprint, courtyard, pad, keep-out, rule area, track, via, zone.
#pragma once

#include <string>
#include <vector>

#include "plane/contour/shape.h"

namespace findspace::io {

/// The sides of the board that something is on.
struct Sides {
  bool front = false, back = false;
  bool meet(const Sides& other) const { return (front && other.front) || (back && other.back); }
  friend bool operator==(const Sides&, const Sides&) = default;
};

struct Pad {
  std::string name;  // "U3.14"
  Sides sides;       // that its copper is on
  plane::ShapePtr copper;
};

struct Part {
  std::string name;       // its reference
  std::string place;      // where the file states it
  plane::GridPoint at;    // its anchor
  exact::Real degrees{};  // as the file says: counter-clockwise as it is seen
  Sides mounted;          // the side it is soldered on
  bool locked = false;
  bool smd = false, through = false;  // as its attributes say
  Sides courtyard;                    // the sides that its body occupies
  plane::ShapePtr body;               // the union of its courtyards, or what stands in for them; null for a drawing
  bool stands_in = false;             // the body is the box about pads and outline
  bool joined = false;                // ends of its courtyards that lie apart were joined
  bool unlike = false;                // its courtyards on the two sides differ
  std::vector<Pad> pads;
};

/// Where parts must not be.
struct KeepOut {
  std::string part;  // whose footprint it belongs to; empty of the board
  std::string name;  // that no other has
  Sides sides;
  plane::ShapePtr area;
};

/// A track, a via or a zone.
struct Copper {
  std::string net;
  std::vector<std::string> layers;
  plane::ShapePtr shape;
};

/// Drilled, of a pad or a via.
struct Hole {
  std::string part;  // empty of a via
  plane::ShapePtr shape;
};

/// Footprints that the board's designer grouped.
struct PartGroup {
  std::string name;
  std::vector<std::string> parts;  // in the order of the file
};

struct Board {
  std::string file;  // as messages call it
  plane::ShapePtr outline;
  std::vector<Part> parts;
  std::vector<PartGroup> groups;  // each with a part at least, names once each
  std::vector<KeepOut> keep_outs;
  std::vector<Copper> tracks, vias, zones;
  std::vector<Hole> holes;
  std::vector<std::string> notes;  // what the reader of the result should know

  const Part* find(std::string_view name) const;
};

}  // namespace findspace::io
