// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Lines, arcs, circles, rectangles and polygons of a board's file, and the closed outlines they make. Ends that lie no
// farther apart than a gap are joined: of the two the one stays that is met first on the way along the outline. Arcs
// are read in both notations: centre, start and angle (KiCad 5), or three points; through its three points an arc is
// exact. Bézier curves are read as segments no farther from them than kCurve; the context notes their places. Cost: O(n
// log n), and the number of open ends squared. Keywords: Edge.Cuts, courtyard.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/board/sexpr.h"
#include "io/text/outline_shapes.h"
#include "io/text/read_transform.h"

namespace findspace::io {

/// Ends of pieces that are joined, in grid steps, as KiCad does: 0.01 mm of a board's outline, 0.02 mm of a courtyard.
inline constexpr std::int64_t kGap = 10000, kCourtyardGap = 20000;
/// How far a segment may depart from the Bézier curve that it is a part of, in grid steps: 0.0001 mm.
inline constexpr std::int64_t kCurve = 100;

/// A straight or round piece of an outline.
struct Piece {
  enum class Kind { kSegment, kThrough, kRadius };
  Kind kind = Kind::kSegment;
  plane::GridPoint from, to, through;  // the last of kThrough
  exact::Real radius{};                // of kRadius, in millimetres
  bool large = false, ccw = true;      // of kRadius
};

/// A box in millimetres, for sizes alone.
struct Extent {
  double low[2] = {1, 1}, high[2] = {0, 0};
  bool empty() const { return low[0] > high[0]; }
  void include(double x, double y);
};

/// What is drawn on one layer.
class Graphics {
 public:
  explicit Graphics(ReadContext& context, std::int64_t gap = kGap) : context_(context), gap_(gap) {}

  /// Draws an item such as (fp_line ...) or (gr_arc ...) through the map. False: it is not a graphic item.
  bool add(const Sexpr& item, const Affine& map);
  /// The chain of points in (pts ...) of the item, closed.
  void add_polygon(const Sexpr& item, const Affine& map);
  /// (segment ...) or (arc ...) of a track.
  void add_track(const Sexpr& item);
  bool empty() const { return pieces_.empty() && circles_.empty(); }
  /// The box about it.
  Extent extent() const;

  /// Closed outlines as shapes, nested by the even-odd rule; nothing where an end stays open or no area is left.
  std::optional<std::vector<plane::ShapePtr>> closed(const std::string& place);
  /// Closed outlines as the area in them if `area`, else all as curves.
  plane::ShapePtr filled(const std::string& place, bool area);
  /// The polyline of a single open piece, of tracks.
  plane::Contour chain();
  /// An end that stayed open.
  plane::GridPoint open_end() const { return open_end_; }
  /// Ends that were moved onto others by the last closed().
  int joined() const { return joined_; }

 private:
  struct Circle {
    exact::Real x, y, radius;
  };

  plane::GridPoint point(const Sexpr& xy, const Affine& map);
  void segment(plane::GridPoint from, plane::GridPoint to);
  void arc(const Sexpr& item, const Affine& map);
  void arc_about(const Sexpr& item, const Affine& map);
  void circle(const Sexpr& item, const Affine& map);
  void rectangle(const Sexpr& item, const Affine& map);
  void curve(const Sexpr& item, const Affine& map);
  void drop_doubles();
  bool may_close(const Piece& piece) const;
  std::map<std::size_t, std::size_t> partners() const;
  void join_ends();
  /// The first end of a piece at twice its index, and its second one.
  plane::GridPoint& end(std::size_t k) { return k % 2 == 0 ? pieces_[k / 2].from : pieces_[k / 2].to; }
  const plane::GridPoint& end(std::size_t k) const { return k % 2 == 0 ? pieces_[k / 2].from : pieces_[k / 2].to; }
  Drawing drawn();
  void draw(const Piece& piece, Outline& outline) const;

  ReadContext& context_;
  std::int64_t gap_;
  std::vector<Piece> pieces_;
  std::vector<Circle> circles_;
  plane::GridPoint open_end_;
  int joined_ = 0;
};

}  // namespace findspace::io
