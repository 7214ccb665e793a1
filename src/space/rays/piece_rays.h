// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ray map of a union of simple convex pieces (line_pieces.h): - in the interior of a piece (and on planes that
// count as inside), 0 on the rest of the closed pieces, + elsewhere; or of their intersection: - in all interiors, 0 on
// the rest of it. So levels of distances to polyhedra keep their true round surface. Guarantee: exact, ties included:
// doubles with running bounds first, real numbers where these cannot tell. Cost: some tens of nanoseconds a piece and
// line in its box; a tie costs microseconds. Keywords: ray casting, dexel.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "exact/planar/approx.h"
#include "space/rays/line_pieces.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

class PieceRays : public RaySource, private RayRoots {
 public:
  enum class Of { kUnion, kIntersection };

  /// Coordinates of the pieces in 1/scale grid steps. An intersection of no pieces is everything.
  PieceRays(const std::vector<LinePiece>& pieces, std::int64_t scale, const RayGrid& grid, Of of = Of::kUnion);
  /// Piece k is made when it is needed, by any thread, and not kept: of many that takes less memory.
  using Maker = std::function<LinePiece(std::size_t k)>;
  PieceRays(std::size_t count, const Maker& piece, std::int64_t scale, const RayGrid& grid, Of of = Of::kUnion);

  const RayGrid& grid() const override { return grid_; }
  exact::Tried<RayRow> try_row(int j) const override;
  bool apart(int j) const override { return of_ == Of::kUnion && of_row(j).empty(); }

  /// Whether a line of the grid may meet the box, given in 1/scale grid steps.
  static bool any_line(const RayGrid& grid, const Vector& low, const Vector& high, std::int64_t scale);

 private:
  /// Columns and rows of lines.
  struct Lines {
    int first_column = 0, last_column = -1, first_row = 0, last_row = -1;
    bool none() const { return last_column < first_column || last_row < first_row; }
  };
  /// A piece for numbers of type T, its axes exchanged so that the lines run along z, in parts of a grid step.
  template <class T>
  struct Aligned {
    std::vector<std::array<T, 4>> planes;
    std::array<T, 3> base{}, direction{};
    T length{}, square{};
  };
  struct Piece {
    Aligned<exact::Real> exact;
    Aligned<exact::Approx> near;
    std::vector<std::int8_t> rise;  // the sign of each plane's z
    std::vector<char> held;         // as of the LinePiece
    bool round = false, held_round = false, cylinder = false, upright = false;
    Lines lines;
    double low = 0, high = 0;  // along the lines it is between these
  };
  /// What a line meets of a piece. kTouch: no inner point.
  enum class Meets : std::int8_t { kNothing, kTouch, kInside, kUnresolved };
  /// Where it ends, whether it holds that place as an inner one.
  template <class T>
  struct Bound {
    bool bounded = false, held = false;
    T at{};
  };
  template <class T>
  struct Span {
    Meets meets = Meets::kNothing;
    Bound<T> low{}, high{};
  };
  /// An end of what a line meets.
  struct End {
    double value = 0, error = 0;  // infinite where there is none
    int piece = -1;
    std::int8_t which = 0;
    bool held = false;
  };
  struct Stretch {
    End low, high;
    bool inside = false;
    int piece = -1;
  };
  class RowStretches;

  template <class T>
  static bool narrow(Bound<T>& end, const T& at, int side, bool holds, bool any_held);
  template <class T>
  static Span<T> meet(const Piece& piece, const Aligned<T>& data, const T& x, const T& y);
  template <class T>
  static void meet_round(const Piece& piece, const Aligned<T>& data, const T& x, const T& y, Span<T>& span);
  Span<exact::Real> meet_exactly(int piece, int i, int j) const;
  bool stretch(int piece, int i, int j, Stretch& out) const;
  std::span<const int> of_row(int j) const;
  static bool surely_before(const End& a, const End& b);
  static void join_sure(std::vector<Stretch>& all);
  int compare_ends(const End& a, const End& b, int i, int j) const;
  exact::Real root(int patch, int which, int i, int j) const override;
  RayPosition position(const End& e, int i, int j) const;
  std::vector<Stretch> united(std::vector<Stretch> all, bool open, int i, int j) const;
  std::vector<Stretch> common(const std::vector<Stretch>& all, bool open, int i, int j) const;
  void put(const std::vector<Stretch>& stretches, int i, int j, RayRow& row) const;

  std::array<exact::Real, 3> components(const RealVector& v) const;
  static Lines find_lines(const RayGrid& grid, const Vector& low, const Vector& high, std::int64_t scale);
  Piece aligned(const LinePiece& from, std::int64_t scale) const;
  void list_rows();

  RayGrid grid_;
  Of of_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_;
  std::vector<int> of_row_;
};

}  // namespace findspace::space
