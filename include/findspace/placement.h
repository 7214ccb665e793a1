// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Several shapes put down, one after another or all at once (docs/scene.md, "Placement"). A body is a shape, or several
// that move together, and may turn about its pole by the angles that are allowed. Conditions hold for each body, for
// each pair, or between named ones; objectives say which of the positions is taken. Guarantee: in the plane, and in
// space with faces along the axes, positions are exact; elsewhere in space they are feasible, and better ones may lie
// between the lines that were looked at. Cost: one overlay a body, and a map for each pair of shapes and angles. A time
// limit ends the search with what was found by then; the other limits end it with Stopped. Source: distances.md 6.
// Keywords: bottom-left placement, nesting, layout, simultaneous placement.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "findspace/formula.h"
#include "findspace/options.h"
#include "findspace/region.h"
#include "findspace/shape.h"
#include "findspace/values.h"
#include "findspace/world.h"

namespace findspace {

/// What has one position.
struct Body {
  std::vector<std::string> shapes;  // names; several move together
  std::vector<Number> angles{0};    // allowed, in degrees about the pole; the first is preferred
  int count = 1;                    // how many of it are placed, one after another

  /// A shape that does not turn.
  Body(std::string shape) : shapes{std::move(shape)} {}  // NOLINT: implicit on purpose
  Body(const char* shape) : shapes{shape} {}             // NOLINT
  /// Several shapes together, at some angles, several times.
  Body(std::vector<std::string> together, std::vector<Number> allowed = {0}, int copies = 1)
      : shapes(std::move(together)), angles(std::move(allowed)), count(copies) {}
};

/// What is asked of a placement.
struct Demands {
  std::vector<Body> bodies;             // in this order
  std::optional<Formula> each{};        // holds for every body, called "self"
  std::optional<Formula> pairs{};       // holds for every body, "self", and each one before it, "other"
  std::vector<Formula> constraints{};   // between bodies by name, or of each, "self"
  std::vector<std::string> minimize{};  // objectives, the first first: "y", "-x", "gap(self, rim)", "x = 5", "grid"
  bool together = false;                // all at once; else one after another
  int lines = 128;                      // each way, where positions of space are taken on lines
};

class Placement {
 public:
  /// One body where it was put.
  struct Placed {
    std::string body;             // its name: that of its shape, or "A1+A2"
    int copy = 0;                 // from 1 where it is placed several times
    double degrees = 0;           // the angle that was taken
    std::optional<Place> at;      // nothing: it has no position, or none that takes the least value
    std::vector<Exact> exact_at;  // the same, exactly
    bool attained = true;         // false: there are positions, but none takes the least value
  };
  /// In the order of the bodies, copies one after another.
  const std::vector<Placed>& placed() const;
  /// Whether every body has a position.
  bool complete() const;
  /// Why there may be more positions, or better ones, than these; empty where the search ended with a proof.
  const std::string& unproven() const;

  /// Of the plane: all positions that a body had when its turn came, or for which all others can be placed.
  struct Positions {
    std::size_t placed = 0;  // in placed()
    double degrees = 0;      // the angle
    Region region;           // the positions
  };
  /// Body by body, angle by angle; none in space.
  const std::vector<Positions>& positions() const;

  /// As `findspace place --json` writes it (docs/results.md).
  std::string json() const;
  /// What stands still and what was placed, as a picture.
  std::string svg() const;

  /// All that it says as one plain value, to be stored or sent, and a placement that says the same again.
  struct Told {
    /// As the functions above.
    std::vector<Placed> placed{};
    std::vector<Positions> positions{};
    bool complete = false;
    std::string unproven{}, json{}, svg{};
  };
  /// With both texts.
  Told told() const;
  /// What was told, for instance by another process.
  explicit Placement(Told told);

  struct Data;
  explicit Placement(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// Shapes by name: those of the bodies are placed, the others stand still. All of the plane, or all of space. Errors:
/// kUnknownName, kSyntax and kBadValue for demands that mean nothing, kUnsupported for what is not computed.
Placement place(const std::map<std::string, Shape>& shapes, const Demands& demands, const WorldOptions& world = {},
                const Options& options = {});

}  // namespace findspace
