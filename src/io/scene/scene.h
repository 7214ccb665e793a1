// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene as its file states it: shapes on the exact grid, which of them moves, and the question. Nothing is computed
// here: shapes are trees (plane/contour/shape.h), formulas are texts with their place, for the parser of the layer
// `formula`. The format is described in docs/scene.md. Mistakes are findspace::Error with a place such as "shape
// 'board', vertex 3 (scene.json:12:5)". Keywords: input file, JSON, DXF, SVG, WKT, GeoJSON.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/number/real.h"
#include "findspace/files.h"
#include "io/text/formula_text.h"
#include "io/text/units.h"
#include "plane/base/work_budget.h"
#include "plane/contour/shape.h"
#include "planning/order/orientation.h"
#include "space/shape/rotation.h"

namespace findspace::io {

struct Board;

/// How a shape of space is rotated, and in the scene's words.
struct Orientation {
  space::Rotation rotation;
  std::string text;
};

/// What the map ranges over.
struct Free {
  enum class Kind { kPosition, kLine, kAngle, kTime, kPose };
  Kind kind = Kind::kPosition;
  GridPosition through{};                 // kLine
  GridPosition direction{};               // kLine: integers without a common factor, not all 0
  GridPosition about{};                   // kAngle, kPose: the point the moving shape rotates about
  std::vector<exact::Real> angles;        // kPose: degrees, in the order given
  std::vector<Orientation> orientations;  // kPose in space, instead of angles
};

/// The movement of one shape over the time of the scene: straight legs between way points.
struct Movement {
  std::string shape;
  std::vector<GridPosition> path;   // at least one; added to where the shape is drawn
  std::vector<exact::Real> times;   // one a way point, ascending
  std::vector<exact::Real> angles;  // degrees, one a way point
};

struct Motion {
  exact::Real start, end;           // start < end
  std::vector<Movement> movements;  // in the order of the file
  bool given() const { return !movements.empty(); }
};

/// What has one position in a placement: a shape, or several that move together.
struct PlacedBody {
  std::string name;  // the shape's, or "A1+A2"
  std::vector<std::string> shapes;
  std::vector<planning::Orientation> angles{planning::Orientation{}};  // allowed, about the pole, in the order given
  int count = 1;                                                       // how many of it are placed
};

/// The placement of several shapes (docs/scene.md, "place").
struct Placement {
  enum class Method { kSequential, kSimultaneous };
  std::vector<PlacedBody> bodies;
  FormulaText each, pairs;
  std::vector<FormulaText> constraints, minimize;
  Method method = Method::kSequential;
  struct Near {
    std::string name;
    int copy = 0;
    std::vector<exact::Real> at;         // in the scene's unit
    std::optional<exact::Real> degrees;  // nothing: any angle that is allowed
  };
  std::vector<Near> near{};  // these come first, each as near to its place as it goes; no file says so
  bool given() const { return !bodies.empty(); }
};

struct Scene {
  std::string file;  // as messages call it
  int dimension = 2;
  std::optional<Unit> unit;
  Grid grid;
  std::vector<plane::ShapePtr> shapes;  // named, in the order of the file
  std::vector<std::string> moving;      // one name, or several that move together; may be empty
  FormulaText where, minimize, maximize;
  std::vector<FormulaText> conditions;  // of a `where` that is a list: `where` is all of them, joined
  Free free;
  Motion motion;
  Placement place;
  bool y_down = false;                                     // the y axis runs downwards in pictures
  bool named_only = false;                                 // many shapes: only those that formulas name are built
  std::optional<std::vector<std::string>> all_shapes;      // what `all` means, where that is not all shapes
  std::vector<std::string> empty_lists;                    // names of groups without a shape that stands still
  std::map<std::string, std::vector<std::string>> groups;  // names of shapes, also of those that move
  std::shared_ptr<const Board> board;                      // where the scene is one of KiCad
  std::string moving_name;                                 // what moves, for titles; without it the names in `moving`
  GridPosition drawn_at{};                                 // the position at which `moving` stands as it was drawn
  std::uint64_t work_limit = plane::kUsualWorkBudget;      // of each shape and each formula (plane/base/work_budget.h)
  std::vector<std::string> notes;  // what the reader of the result should know: points rounded, rings reversed

  /// What moves, in words: "U3", "A1, A2".
  std::string moving_text() const;
  /// Whether angles are asked for and told against the coordinates: on a board, whose y axis runs downwards, they count
  /// counter-clockwise as it is seen.
  bool mirrors_angles() const { return board != nullptr; }
  /// Degrees from the x axis to the y axis as they are told, and those that are asked for as degrees from the x axis to
  /// the y axis. The angles of `free` and of placed bodies are the latter.
  exact::Real seen(const exact::Real& degrees) const { return mirrors_angles() ? -degrees : degrees; }
  /// The shape of that name, or null.
  plane::ShapePtr find(std::string_view name) const;
  /// The same; throws Error(kUnknownName) that proposes the nearest name.
  plane::ShapePtr shape(std::string_view name) const;
};

/// Throws Error. Shapes in files are looked for beside the scene. The scene itself need not lie in the root.
Scene read_scene(const std::filesystem::path& path, const ReadOptions& options = {});
/// A scene from memory: `folder` is where its files are, `name` what messages call it.
/// A result with exact cells is the scene of that set alone, called as its file is without the ending.
Scene read_scene_text(std::string_view text, const std::filesystem::path& folder, const std::string& name,
                      const ReadOptions& options = {});

/// The scene of one shape alone, given as the JSON that would stand under its name; places count from its beginning.
Scene read_shape_text(std::string_view text, const exact::Real& grid, const std::filesystem::path& folder,
                      const std::string& name, const ReadOptions& options = {});

}  // namespace findspace::io
