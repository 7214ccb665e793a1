// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene file (docs/scene.md) as values: its shapes, its world, what is free, what it asks; and the program's
// questions about it, in the program's words. Formulas may name its groups and lists. Guarantee: the same questions
// have the same answers as in the program. Cost: of reading, then that of a World, or of the question. Error: kFile,
// kSyntax and others with the place in the file. Keywords: input, project file.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/answer.h"
#include "findspace/files.h"
#include "findspace/formula.h"
#include "findspace/motion.h"
#include "findspace/options.h"
#include "findspace/shape.h"
#include "findspace/world.h"

namespace findspace {

class Board;
struct BoardQuestion;

/// How a shape of space is turned, counter-clockwise seen from the axis' positive end. Immutable, cheap to copy.
class Rotation {
 public:
  /// A quaternion "w,x,y,z" of any length but 0; an axis and degrees, "z:90" or "1,1,0:45"; or a matrix of nine
  /// numbers, row by row. Error(kSyntax) for other text, Error(kBadValue) for a zero axis and for what is not a
  /// rotation.
  static Rotation read(std::string_view text);
  /// The same, or in a scene's words.
  const std::string& text() const;
  /// Its rows, rounded.
  std::array<std::array<double, 3>, 3> matrix() const;
  /// Whether the angle is taken exactly; else the nearest one of a rational matrix, off by less than 2^-48 of itself.
  bool exact() const;

  struct Data;
  explicit Rotation(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// Where what moves is asked about.
struct Pose {
  std::vector<Number> at{};         // two coordinates, three in space; none: where it is drawn
  std::optional<Number> degrees{};  // of the plane: turned by so much first, about the scene's "about", or (0, 0)
  std::optional<Number> time{};     // an instant of the motion; nothing: over all its time
};

/// What a check is asked for.
struct CheckQuestion {
  bool nearest = true;  // the nearest feasible position too, where the position is none
  /// Something is dragged: where a corner of the region, an edge of it, or in space the nearest feasible position is no
  /// farther than this, the answer is about that one, exactly. Error(kBadValue) below 0.
  std::optional<Number> snap{};
};

/// Lines on which a map of positions in space is taken; they run through the middle of cells that cover it.
struct MapLines {
  /// Which cells about them are taken: those of places of the lines that belong; those that certainly belong as a
  /// whole; or those whose union certainly holds the map.
  enum class Side { kNone, kInner, kOuter };
  int count = 0;                       // each way, from 1 to 16384, or
  std::optional<Number> apart{};       // how far they are apart, a multiple of the grid's step
  Shape::Axis axis = Shape::Axis::kZ;  // along which they run
  bool axes = false;                   // along all three instead
  Side side = Side::kNone;             // which cells, of lines along one axis
};

/// What a map is asked for.
struct MapQuestion {
  Pose pose{};           // over angles and over time: its position
  std::string apply{};   // what is made of a region: interior closure boundary regularize complement, or nothing
  bool pictures = true;  // the answer may be drawn; else it takes less memory
  bool surface = false;  // of space: it is wanted with flat faces, which a polytope grown by a ball has not
  std::optional<MapLines> lines{};  // of space: on these; nothing: exactly, or else as many as follows
  int resolution = 0;               // of space, where there is no exact form: lines each way of each axis; 0: 128
  bool listed = true;               // of lines: JSON has them; else they take less time
  std::string before{};             // what messages put before "apply", "resolution" and "step"
};

/// What a description of a shape is asked for, in space.
struct ShapeQuestion {
  bool surface = false;             // it is wanted with flat faces, which a polytope grown by a ball has not
  std::optional<MapLines> lines{};  // on these; nothing: exactly, or on 128 lines each way of each axis
  bool listed = true;               // of lines: JSON has them; else they take less time
  std::string before{};             // what messages put before "resolution" and "step"
};

/// What a placement is asked for, besides what the scene says in "place".
struct PlaceQuestion {
  /// A body that is wanted at a place.
  struct Near {
    std::string name;                 // of the body: of a shape, or "A1+A2"
    int copy = 0;                     // from 1 where it is placed several times
    std::vector<Number> at{};         // in the scene's unit
    std::optional<Number> degrees{};  // one of its angles; nothing: any
  };
  std::vector<Near> near{};  // these come first, each as near to its place as it goes
  int lines = 0;             // of space: each way, where positions are taken on lines; 0: as usual
};

/// Immutable and cheap to copy; asking one from many threads is safe.
class Scene {
 public:
  /// Files of shapes are looked for beside it. What is not trusted may be read without files, from one folder alone, or
  /// at less cost: Error(kUnsupported), Error(kFile), Error(kLimit).
  static Scene file(const std::string& path, const ReadOptions& reading = {});
  /// The text of a scene; files of shapes are looked for in the folder. Messages call it by the name.
  static Scene json(std::string_view text, const std::string& folder = ".", const ReadOptions& reading = {},
                    const std::string& name = "scene");

  // ---- what it says
  /// By name; a group is one as well.
  const std::map<std::string, Shape>& shapes() const;
  /// One of them. Error(kUnknownName), which proposes the nearest name.
  Shape shape(std::string_view name) const;
  /// Their names in the order of the file.
  std::vector<std::string> names() const;
  /// Names of shapes by the name of a group; also of shapes that move.
  const std::map<std::string, std::vector<std::string>>& groups() const;
  /// 2 or 3.
  int dimension() const;
  /// Of lengths, or empty.
  std::string unit() const;
  /// The grid of its coordinates; whether y runs downwards in pictures.
  Grid grid() const;
  bool y_down() const;
  /// Whether its angles count clockwise as pictures show them: from the x axis to the y axis where that runs downwards.
  /// On a board they count counter-clockwise.
  bool clockwise() const;
  /// What moves, together; none where the scene does not say.
  const std::vector<std::string>& moving() const;
  /// With what moves, in time too. Error(kBadValue) where the scene does not say what does.
  const World& world() const;
  /// "where", "true" without it.
  const Formula& where() const;
  /// Whether it has a "where".
  bool asks() const;
  /// Names of the shapes that the formula speaks of, sorted.
  std::vector<std::string> used() const;
  /// "minimize" and "maximize", or empty.
  const std::string& minimize() const;
  const std::string& maximize() const;
  /// Over what its answers range.
  struct Free {
    /// Positions, those on a line, angles at a position, instants at a position, or positions at some angles.
    enum class Kind { kPosition, kLine, kAngle, kTime, kPose };
    Kind kind = Kind::kPosition;        // which of them
    std::vector<Number> through{};      // of a line: a point of it,
    std::vector<Number> direction{};    // and integers without a common factor
    std::vector<Number> about{};        // of angles and poses: what it turns about, in its own coordinates
    std::vector<Number> angles{};       // of poses of the plane: in degrees, in the order of the file
    std::vector<Rotation> rotations{};  // of poses of space, in that order
  };
  /// What that is in this scene.
  const Free& free() const;
  /// Paths of shapes that move in time.
  std::optional<Motion> motion() const;
  /// What it was read from, and the folder of its files.
  const std::string& text() const;
  const std::string& folder() const;
  /// As messages call it.
  const std::string& name() const;
  /// Of Board::scene(): the board (board.h), and what was asked; nothing of other scenes.
  std::optional<Board> board() const;
  std::optional<BoardQuestion> board_question() const;
  /// What might be opened, and at what cost.
  const ReadOptions& reading() const;
  /// What was changed on the way: points that were rounded, rings that were reversed.
  const std::vector<std::string>& notes() const;

  // ---- the same scene, changed
  /// What is asked instead of what the file says; what is not given stays.
  struct Question {
    std::optional<std::string> where{};                // of the formula language; errors stand at "where:1:5"
    std::optional<std::string> minimize{};             // an objective: instead of both of the file's
    std::optional<std::string> maximize{};             // or this one
    std::string before{};                              // what messages put before these three words
    std::optional<std::vector<std::string>> moving{};  // names of shapes
    /// Positions, or angles or instants at a position; not those of a line or of poses.
    std::optional<Free::Kind> free{};
  };
  /// With another question. Error(kBadValue) where there would be two objectives, or for another range of free();
  /// kUnknownName for what is no shape.
  Scene asking(const Question& question) const;
  /// Of space: what moves is turned about the scene's "about"; points that leave the grid are put on it once, which
  /// notes() says after those of the file. It ranges over positions then. Error(kUnsupported) in the plane.
  Scene rotated(const Rotation& rotation) const;
  /// Of the plane: the same by an angle, from the x axis to the y axis; on a board counter-clockwise as it is seen. So
  /// all angles of a scene count. Positions on a line stay such. Error(kUnsupported) in space, and where shapes move in
  /// time.
  Scene rotated(const Number& degrees) const;
  /// What asking() and rotated() have changed since it was read, one of the two at a time, in order.
  struct Change {
    /// Of asking().
    std::optional<Question> question{};
    /// Of rotated().
    std::optional<Rotation> rotation{};
    /// The same of the plane.
    std::optional<Number> degrees{};
  };
  /// All of them.
  const std::vector<Change>& changes() const;
  /// Its text with what asking() has changed; all else stays as it was written, comments too. Error(kBadValue) of what
  /// was not read from the text of a scene; kUnsupported where that does not say the changes.
  std::string edited_text() const;
  /// The same scene, which keeps what it makes for one question for the next: its shapes as sets, the region of its
  /// formula and tables to look positions up in; so do the scenes that it becomes by asking() and rotated(). For many
  /// questions, one after another. Takes the memory of it.
  Scene prepared() const;
  /// Whether it does.
  bool is_prepared() const;
  /// With other limits.
  Scene with(const Options& options) const;
  /// The limits of its questions.
  const Options& options() const;
  /// Who hears of a question while it is answered, in the thread that asks.
  struct Listener {
    std::function<void(const std::string&)> note{};   // what Answer::notes() will say
    std::function<void(const std::string&)> stage{};  // what is being done: "building the shapes"
  };
  /// With somebody who hears.
  Scene with(const Listener& listener) const;

  // ---- questions. Error(kBadValue) where nothing moves, or a pose is none of this scene; kUnsupported for what is not
  // computed; Stopped at a limit
  /// Refuses a pose as the questions do: Error(kBadValue), kOutOfRange, kSyntax.
  void require(const Pose& pose) const;
  /// Whether the formula holds at a pose, condition by condition; where it does not, the nearest feasible position too.
  /// The second is of a scene that is not needed any more: it may let go of its shapes.
  Answer check(const Pose& pose = {}, const CheckQuestion& question = {}) const&;
  Answer check(const Pose& pose = {}, const CheckQuestion& question = {}) &&;
  /// The feasible position that is nearest to a pose without degrees, which may be feasible itself.
  Answer nearest(const Pose& pose = {}) const;
  /// Of the plane: the distance between two vertices, edges or arcs of shapes: those nearest to two places, a vertex
  /// where one is about as near. measured() has it, with the features. kBadValue where no shape has a boundary.
  Answer between(const Point& first, const Point& second, const Pose& pose = {}) const;
  /// Distances of what moves to the other shapes. `words`: which (vocabulary.h); none: all. Error(kUnknownName).
  Answer measure(const Pose& pose = {}, const std::vector<std::string>& words = {}) const;
  /// Where the formula holds, or is best where there is an objective, among all that is free(). In space positions,
  /// where they are made of boxes or are a convex polytope, exactly, else on many lines; or those on a line. Of several
  /// orientations each is asked alone (rotated()). The second is of a scene that is not needed any more: it may let go
  /// of its shapes.
  Answer map(const MapQuestion& question = {}) const&;
  Answer map(const MapQuestion& question = {}) &&;
  /// Why the formula holds nowhere, or how far its levels can be tightened (World::explain): at an angle, else over the
  /// angles of free() where there are some; and what stands in the way at a position, where one is given. Where free()
  /// is an angle and none is given: over all angles at the position.
  Answer explain(const Pose& pose = {}) const;
  /// A shape as a point set: in the plane exactly, in space exactly where it is made of boxes or is one convex set,
  /// else on many lines. Error(kUnknownName).
  Answer describe(const std::string& shape, const ShapeQuestion& question = {}) const;
  /// The placement of "place": one shape after another, or all at once. `seconds` of the options end the search with
  /// what was found by then.
  Answer place(const PlaceQuestion& question = {}) const;
  /// Whether it says what to place.
  bool places() const;

  struct Data;
  explicit Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
