// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Many solids packed onto a floor, as low as can be, or into few containers, boxes or others; where they do not all fit
// these, the most valuable choice of them. A solid has flat faces, is a ball, or a union of such. Every layout that is
// handed out is proved: no two interiors meet, gaps and edges are kept, by exact signs on the shapes given. How low or
// few is the result of a search, not proved. The units are those of the shapes. Cost: as much time as is allowed.
// Keywords: three-dimensional packing, container loading, open dimension, bin packing, knapsack.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "findspace/number.h"
#include "findspace/options.h"
#include "findspace/packing.h"
#include "findspace/shape.h"
#include "findspace/surface.h"

namespace findspace {

/// How a solid stands: its point q goes to the rows times q. The rows are those of an exact rotation.
struct Orientation {
  /// Decimals, or fractions "3/5".
  std::array<std::array<Number, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// (w, x, y, z) of any length but 0, Error(kBadValue): its matrix has rational entries.
  static Orientation quaternion(const Number& w, const Number& x, const Number& y, const Number& z);
  /// Counter-clockwise about an axis. Error(kBadValue) unless it is a multiple of 90 degrees; a quaternion of small
  /// numbers is near to any other.
  static Orientation about(Shape::Axis axis, const Number& degrees);
  /// All 24 that take axes to axes, and the four of them about z.
  static std::vector<Orientation> right_angles();
  static std::vector<Orientation> upright();
};

/// A kind of solid.
struct PackSolid {
  /// How layouts call it.
  std::string name;
  /// Of space: with flat faces, a ball, or a union of such. Its grid has a decimal step.
  Shape shape;
  /// How many copies are wanted.
  int count = 1;
  /// How it may stand; as it is given where there are none.
  std::vector<Orientation> orientations = {};
  /// Of a copy, where not all fit; without it its volume.
  std::optional<Number> value = {};
};

/// A kind of container, from (0, 0, 0) to (width, depth, height), or of a shape of its own.
struct PackContainer {
  /// How layouts call it.
  std::string name;
  /// Along x, y and z; 0 where it has a shape.
  Number width = 0, depth = 0, height = 0;
  /// How many there are.
  int count = 1;
  /// Of one; the cheapest for their volume are used first. Given for all kinds or for none.
  std::optional<Number> cost = {};
  /// What it holds where that is no box: a bounded solid with flat faces, convex or not, a ball, or made of these but
  /// for unions with balls. It is moved so that its box begins at (0, 0, 0): so positions in it count.
  std::optional<Shape> shape = {};
};

/// A copy that stands already, and counts as one of its part.
struct FixedSolid {
  /// Its kind.
  std::string part;
  /// Its point q goes to at + orientation q, exactly.
  Point3 at = {0, 0, 0};
  /// One of those allowed.
  Orientation orientation = {};
  /// The kind of container; without containers nothing.
  std::string container = {};
  /// Which of that kind, from 1 on.
  int number = 1;
};

/// What is to be packed: into the containers, or upon a floor where there are none.
struct SolidPackProblem {
  /// How files call it.
  std::string name = {};
  /// Of the floor, along x and y: 0 <= x <= width, 0 <= y <= depth, 0 <= z. The height is sought.
  Number width = 0, depth = 0;
  /// Instead of a floor.
  std::vector<PackContainer> containers = {};
  /// All kinds of solids.
  std::vector<PackSolid> parts = {};
  /// The least distance of any two solids.
  Number gap = 0;
  /// The least distance of a solid to the walls, the floor and the lid.
  Number edge = 0;
  /// Wider gaps of some pairs.
  std::vector<PackGap> gaps = {};
  /// What holds for any two copies.
  std::string where = {};
  /// Conditions of some pairs.
  std::vector<PackCondition> conditions = {};
  /// Solids that stay together: in one container, and at most so far apart. On a floor the distance must be given.
  std::vector<PackGroup> groups = {};
  /// Solids that stand already. A container with one is always used.
  std::vector<FixedSolid> fixed = {};
};

/// A copy of a solid: its point q goes to at + orientation q.
struct PlacedSolid {
  /// Its kind.
  std::string part;
  /// From 1 on.
  int copy = 1;
  /// Which of the layout's containers, from 0 on.
  std::size_t container = 0;
  /// One of those allowed.
  Orientation orientation = {};
  /// Exactly: decimals, or fractions "17/3".
  Point3 at = {0, 0, 0};
};

/// A layout.
struct SolidPackLayout {
  /// Of the last container what is used.
  Number height = 0;
  /// Where the solids are.
  std::vector<PlacedSolid> items = {};
  /// What is not there.
  std::vector<LeftOutPart> left_out = {};
  /// The kinds of the containers that are used.
  std::vector<std::string> containers = {};
  /// Volume of the solids over that of the containers, the last one up to the height.
  double density = 0;
  /// No layout is lower, as far as the search proved it; in containers none of all solids uses fewer.
  Number lower_bound = 0;
  /// The limit that ended the search; nothing where it ended by itself, or all of its work was done.
  std::optional<Limit> met = {};
  /// How it was found: after so many seconds, by a search of that seed on so many threads.
  double seconds = 0;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// A packing problem of solids that is put on its grid once, for many questions. Immutable, cheap to copy; asking from
/// many threads is safe. Error where a shape is none that is packed, stands on the floor in no orientation, has too
/// many digits, a name is unknown, or fixed solids overlap or lie outside.
class SolidPacking {
 public:
  /// Of values.
  explicit SolidPacking(const SolidPackProblem& problem);
  /// The JSON of docs/nesting.md, "Solids". Error(kSyntax) with line and column.
  static SolidPacking json(std::string_view text, const PackReading& reading = {});
  /// Whether JSON is such a problem, not one of the plane. Error(kSyntax) where it is no JSON.
  static bool is_stated_in(std::string_view json, const std::string& name = "problem");

  /// As it was given, in values.
  const SolidPackProblem& problem() const;
  /// What was changed in meshes.
  const std::vector<std::string>& notes() const;
  /// How many copies of all solids are wanted.
  std::size_t copies() const;
  /// No layout upon the floor is lower, by volumes and the tallest solid; in containers none of all solids uses fewer.
  Number lower_bound() const;

  /// As pack() below.
  std::optional<SolidPackLayout> search(const Options& options = {.seconds = 10},
                                        const PackSearch<SolidPackLayout>& search = {}) const;
  /// By exact signs.
  PackVerdict verdict(const SolidPackLayout& layout) const;
  /// The layout with one of its solids put there in its container, and the others out of its way. Where it is free
  /// there, it stands there exactly and nothing else moves; else it may be moved a little too, and upon a floor the
  /// height may grow. Nothing where the others cannot make room, it is fixed, or a fixed solid is missing.
  std::optional<SolidPackLayout> moved(const SolidPackLayout& layout, std::size_t item, const Point3& at) const;

  /// A layout of this problem from JSON. Error(kSyntax) with line and column.
  SolidPackLayout layout(std::string_view json, const std::string& name = "layout") const;
  /// As the functions below.
  std::string json(const SolidPackLayout& layout) const;
  std::string svg(const SolidPackLayout& layout) const;
  std::string file(const SolidPackLayout& layout, std::string_view ending) const;
  Surface surface(const SolidPackLayout& layout) const;
  /// A solid, counted as in problem().parts, about its origin, not turned. Balls become inscribed polyhedra.
  Surface outline(std::size_t part) const;
  /// What a container holds, counted as in problem().containers; its box begins at (0, 0, 0). Of a union all of its
  /// convex parts, and where balls bound it or are cut out of it, these or those parts without the cuts.
  Surface inside(std::size_t container) const;

  struct Data;
  explicit SolidPacking(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// The best layout found. Nothing where no solid is wanted, none fits a container, or no layout was found in which all
/// conditions hold. The search ends by itself where no layout can be lower; else after the options' seconds or work,
/// and without both where no better layout comes for long. Of up to ten solids of flat faces that can stand in up to
/// 1024 ways, branch and bound proves that within a ten millionth of the height, as far as the options allow. With a
/// limit of work alone the result depends on the seed only. `better` hears of each better layout at once; what it
/// throws ends the search. Error where a shape is none that is packed, stands on the floor in no orientation, has too
/// many digits, or a name is unknown.
std::optional<SolidPackLayout> pack(const SolidPackProblem& problem, const Options& options = {.seconds = 10},
                                    const std::function<void(const SolidPackLayout&)>& better = {});

/// What is wrong with a layout, a sentence each; nothing where it is feasible, by exact signs.
std::vector<std::string> layout_faults(const SolidPackProblem& problem, const SolidPackLayout& layout);

/// The JSON of docs/nesting.md, "Solids", as a problem; files of items are looked for in the folder, or in the current
/// one. Error(kSyntax) with line and column.
SolidPackProblem solid_pack_problem(std::string_view json, const std::string& folder = {});

/// A layout as the JSON of docs/nesting.md.
std::string layout_json(const SolidPackProblem& problem, const SolidPackLayout& layout);
/// A view from above, with the containers.
std::string layout_svg(const SolidPackProblem& problem, const SolidPackLayout& layout);
/// As a file: ".3mf" and ".glb" hold each kind once with where its copies stand, ".obj" a group a copy; ".stl", ".ply",
/// ".off" and ".step" one surface, ".svg" a picture of it. Error(kUnsupported) for another ending. Balls become
/// inscribed polyhedra.
std::string layout_file(const SolidPackProblem& problem, const SolidPackLayout& layout, std::string_view ending);
/// All copies as one surface; containers stand side by side along x.
Surface layout_surface(const SolidPackProblem& problem, const SolidPackLayout& layout);

}  // namespace findspace
