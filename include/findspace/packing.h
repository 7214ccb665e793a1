// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Many parts packed into a short strip, a small box, or onto few sheets; where they do not all fit the sheets, the most
// valuable choice of them. Every layout that is handed out is proved: no two interiors meet, gaps and edges are kept,
// by exact signs on the shapes given. How short or few is the result of a search, not proved. The units are those of
// the numbers given. Cost: as much time as is allowed. Keywords: nesting, irregular strip packing, bin packing, cutting
// stock, knapsack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "findspace/files.h"
#include "findspace/number.h"
#include "findspace/options.h"
#include "findspace/pack_search.h"
#include "findspace/shape.h"

namespace findspace {

/// A kind of part: rings, or any closed bounded shape of the plane without curves or points beside its areas. Arcs stay
/// arcs: the search looks at tangents and chords of them, the proof at the shape itself.
struct PackPart {
  /// How layouts call it.
  std::string name;
  /// Simple polygons: the outline, then holes, in which other parts may lie.
  std::vector<Ring> rings;
  /// How many copies are wanted.
  int count = 1;
  /// Degrees, counter-clockwise about the part's own origin.
  std::vector<Number> angles = {0};
  /// Whether it may be turned over.
  bool mirrored = false;
  /// Of a copy, where not all fit; without it its area.
  std::optional<Number> value = {};
  /// Instead of rings.
  std::optional<Shape> shape = {};
  /// Degrees by which each copy may be off one of the angles, from 0 to 180. The search keeps to the angles; its layout
  /// is then made shorter by rotating the parts a little.
  Number tilt = 0;

  /// A part of any shape.
  static PackPart of(std::string name, Shape shape, int count = 1);
};

/// What some parts may not enter, or may not leave.
struct PackZone {
  /// The outline, then holes.
  std::vector<Ring> rings;
  /// Names of the parts that must stay out, or
  std::vector<std::string> keeps_out;
  /// names of the parts that lie within it.
  std::vector<std::string> holds = {};
  /// Instead of rings.
  std::optional<Shape> shape = {};
};

/// A kind of sheet. The box of its outline begins at (0, 0).
struct PackSheet {
  /// How layouts call it.
  std::string name;
  /// The outline, then holes.
  std::vector<Ring> rings;
  /// How many there are.
  int count = 1;
  /// Of one; the cheapest for their area are used first. Given for all kinds or for none.
  std::optional<Number> cost = {};
  /// Zones on it.
  std::vector<PackZone> zones = {};
  /// Instead of rings.
  std::optional<Shape> shape = {};

  /// A rectangular one.
  static PackSheet rectangle(std::string name, const Number& width, const Number& height, int count = 1);
};

/// A least distance of copies of two kinds, where it is more than the gap of all.
struct PackGap {
  /// Names of parts.
  std::string first, second;
  /// The distance.
  Number gap = 0;
};

/// What holds for two copies beside their gap: a formula of docs/formula.md, such as "gap(self, other) <= 8". On
/// different sheets two parts are infinitely far apart.
struct PackCondition {
  /// Names of parts: `self` is a copy of the first, `other` one of the second. Of one part it holds both ways.
  std::string first, second;
  /// The formula.
  std::string where;
};

/// Parts that stay together.
struct PackGroup {
  /// Names of parts: any two copies of them lie on one sheet,
  std::vector<std::string> parts;
  /// and at most this far apart. On a strip or in a box it must be given.
  std::optional<Number> within = {};
};

/// A copy that stands where it stands. It counts as one of its part's.
struct FixedPart {
  /// Its kind.
  std::string part;
  /// Where its origin is.
  Number x = 0, y = 0;
  /// Degrees, any.
  Number angle = 0;
  /// Whether it is turned over.
  bool mirrored = false;
  /// The kind of sheet that it lies on, if there are sheets, and which of that kind, from 1 on.
  std::string sheet = {};
  /// See there.
  int number = 1;
};

/// What is to be packed: onto the sheets, or into a strip 0 <= y <= height where there are none.
struct PackProblem {
  /// How files call it.
  std::string name = {};
  /// Of the strip.
  Number height = 0;
  /// Instead of a strip.
  std::vector<PackSheet> sheets = {};
  /// Instead of either: a rectangle of the least area, whose height is sought as well.
  bool box = false;
  /// All kinds of parts.
  std::vector<PackPart> parts = {};
  /// The least distance of any two parts.
  Number gap = 0;
  /// The least distance of a part to the sides of the strip, or to the outline and holes of its sheet.
  Number edge = 0;
  /// Wider gaps of some pairs.
  std::vector<PackGap> gaps = {};
  /// What holds for any two copies, of two parts one way, of one part both ways: a formula as in a PackCondition.
  std::string where = {};
  /// Conditions of some pairs.
  std::vector<PackCondition> conditions = {};
  /// Parts that stay together.
  std::vector<PackGroup> groups = {};
  /// Parts that stand already.
  std::vector<FixedPart> fixed = {};
};

/// A copy of a part: its point q goes to (x, y) + R M q. M turns x into -x where mirrored, R turns by the angle.
struct PlacedPart {
  /// Its kind.
  std::string part;
  /// From 1 on.
  int copy = 1;
  /// Which of the layout's sheets, from 0 on.
  std::size_t sheet = 0;
  /// Degrees.
  Number angle = 0;
  /// Whether it is turned over.
  bool mirrored = false;
  /// Exactly: a decimal, or a fraction "17/3".
  Number x = 0, y = 0;
};

/// Copies that are not in a layout.
struct LeftOutPart {
  /// Their kind.
  std::string part;
  /// How many.
  int copies = 0;
  /// The reason.
  std::string why;
};

/// The largest rectangle along the axes that the last sheet has left, by exact signs.
struct PackRemnant {
  /// Which of the layout's sheets, from 0 on.
  std::size_t sheet = 0;
  /// Its lower left corner.
  Number x = 0, y = 0;
  /// Its size.
  Number width = 0, height = 0;
};

/// A layout.
struct PackLayout {
  /// Of the strip; of the last sheet what is used.
  Number length = 0;
  /// Where the parts are.
  std::vector<PlacedPart> items = {};
  /// What is not there.
  std::vector<LeftOutPart> left_out = {};
  /// The kinds of the sheets that are used.
  std::vector<std::string> sheets = {};
  /// Of the box, where one is sought.
  Number height = 0;
  /// Area of the parts over the area of the strip, box or sheets, the last sheet up to the length.
  double density = 0;
  /// On sheets, where something is left.
  std::optional<PackRemnant> remnant = {};
  /// The limit that ended the search; nothing where it ended by itself, or all of its work was done.
  std::optional<Limit> met = {};
  /// How it was found: after so many seconds, by a search of that seed on so many threads.
  double seconds = 0;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// A packing problem that is put on its grid once, for many questions. Immutable, cheap to copy; asking from many
/// threads is safe. Error where a part is not a simple polygon, is higher than the strip, a name is unknown, or the
/// fixed parts overlap.
class Packing {
 public:
  /// Of values.
  explicit Packing(const PackProblem& problem);
  /// The nesting JSON of docs/nesting.md. Error(kSyntax) with line and column.
  static Packing json(std::string_view text, const PackReading& reading = {});
  /// A drawing that sparrow writes has shapes and a layout both. Its parts may stand at the angles at which they stand.
  static std::pair<Packing, PackLayout> sparrow(std::string_view svg, const std::string& name = "layout");

  /// As it was given, in values.
  const PackProblem& problem() const;
  /// What was changed or left unread in JSON.
  const std::vector<std::string>& notes() const;
  /// How many copies of all parts are wanted.
  std::size_t copies() const;
  /// No layout in the strip is shorter; on sheets none of all parts uses fewer, by areas; no box has a smaller area.
  Number lower_bound() const;

  /// As pack() below.
  std::optional<PackLayout> search(const Options& options = {.seconds = 10},
                                   const PackSearch<PackLayout>& search = {}) const;
  /// By exact signs.
  PackVerdict verdict(const PackLayout& layout) const;
  /// Error(kBadValue) unless a search can begin with the layout. Every copy that is wanted is in it, or said to be left
  /// out. Fixed parts stand where they stand. No more sheets are used than there are, and each item is on one of them.
  void check_start(const PackLayout& layout) const;
  /// The layout with one of its items put there, its origin on the grid, and the others out of its way. A strip or a
  /// box may become longer; on sheets it stays on the one that the layout says, and no other is taken. Nothing where
  /// they cannot make room. Error(kBadValue) for a part that is fixed, and for a layout that check_start() refuses.
  std::optional<PackLayout> moved(const PackLayout& layout, std::size_t item, const Position& at) const;

  /// A layout of this problem from JSON. Error(kSyntax) with line and column.
  PackLayout layout(std::string_view json, const std::string& name = "layout") const;
  /// A layout as the JSON of docs/nesting.md, as a drawing with a page a sheet, and as one to cut: outlines on the
  /// layers "cut" and "sheet", arcs as bulges.
  std::string json(const PackLayout& layout) const;
  std::string svg(const PackLayout& layout) const;
  std::string dxf(const PackLayout& layout, DxfVersion version = DxfVersion::kR12) const;
  /// A part, counted as in problem().parts, as SVG path data about its origin, y downwards.
  std::string outline(std::size_t part) const;
  /// A kind of sheet, counted as in problem().sheets, in the same way: its outline and holes.
  std::string sheet_outline(std::size_t sheet) const;
  /// All zones on a kind of sheet, in the same way; empty where there are none.
  std::string sheet_zones(std::size_t sheet) const;

  struct Data;
  explicit Packing(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// The best layout found. Nothing where no part is wanted, none fits a sheet, or no layout was found in which all
/// conditions hold. It has no items where no place was found on a sheet for any part that would fit. Of the options:
/// searches side by side on all threads; the search ends after its seconds or its work, and without both where no
/// better layout comes for long. With a limit of work alone the result depends on the seed and the number of threads
/// only. `better` hears of each better layout at once; what it throws ends the search. Error where a part is not a
/// simple polygon, is higher than the strip, a name is unknown, or the fixed parts overlap.
std::optional<PackLayout> pack(const PackProblem& problem, const Options& options = {.seconds = 10},
                               const std::function<void(const PackLayout&)>& better = {});

/// What is wrong with a layout, a sentence each; nothing where it is feasible, by exact signs.
std::vector<std::string> layout_faults(const PackProblem& problem, const PackLayout& layout);

/// The nesting JSON of docs/nesting.md as a problem. Error(kSyntax) with line and column.
PackProblem pack_problem(std::string_view json);

/// A layout as the JSON of docs/nesting.md, and as a drawing.
std::string layout_json(const PackProblem& problem, const PackLayout& layout);
/// A page a sheet.
std::string layout_svg(const PackProblem& problem, const PackLayout& layout);

}  // namespace findspace
