// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A drawing in the drawing exchange format, ASCII: closed and open polylines whose arcs are bulges, circles and points,
// on layers. R12 (AC1009) is what every program reads: polylines are POLYLINE with vertices. 2000 (AC1015) has
// LWPOLYLINE, names of layers with blanks, and the tables, blocks and objects without which programs refuse it.
// Guarantee: numbers are the shortest that read back as the same doubles. Source: AutoCAD DXF reference. Keywords:
// export, laser cutting.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/files.h"
#include "formula/language/units.h"

namespace findspace::io {

/// A corner, and the side to the next one: 0 of a segment, of an arc tan(angle / 4), positive counter-clockwise.
struct DrawnCorner {
  double x = 0, y = 0, bulge = 0;
};

class DxfWriter {
 public:
  /// Names of layers that the version does not allow are made such that it does, and that no two are the same. Entities
  /// are on these layers.
  DxfWriter(DxfVersion version, std::optional<formula::Unit> unit, std::span<const std::string> layers);

  void polyline(std::string_view layer, std::span<const DrawnCorner> corners, bool closed);
  void circle(std::string_view layer, double x, double y, double radius);
  void point(std::string_view layer, double x, double y);
  /// Ends the drawing.
  std::string take();

 private:
  void group(int code, std::string_view value);
  void group(int code, int value);
  void number(int code, double value);
  void place(double x, double y);
  void begin(std::string_view section);
  void end();
  void header(std::optional<formula::Unit> unit);
  void name_layers(std::span<const std::string> layers);
  void tables();
  void begin_table(std::string_view name, std::size_t entries);
  void table_entry(std::string_view type, std::string_view name, std::string_view kind);
  void tables_of_2000();
  void blocks();
  void objects();
  void entity(std::string_view type, std::string_view layer, std::string_view kind);
  std::string handle(int number) const;
  std::string next_handle() { return handle(next_++); }
  bool in_2000() const { return version_ == DxfVersion::k2000; }

  DxfVersion version_;
  std::map<std::string, std::string, std::less<>> layers_;
  std::string text_;
  int next_;  // handle
};

}  // namespace findspace::io
