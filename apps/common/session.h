// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the verbs share: the scene, its shapes as regions, its formula.
#pragma once

#include <findspace/world.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/options.h"
#include "common/outputs.h"
#include "common/reporter.h"
#include "formula/language/parse.h"
#include "formula/language/parse_goal.h"
#include "formula/planar/solve_region.h"
#include "io/scene/scene.h"
#include "io/write/write_svg.h"

namespace findspace::app {

class Session {
 public:
  /// Reads the scene; its notes are said. Throws Error.
  Session(const Options& options, Reporter& reporter);
  /// Of a scene that is already read.
  Session(const Options& options, Reporter& reporter, io::Scene scene);

  const Options& options() const { return options_; }
  const io::Scene& scene() const { return scene_; }
  const exact::Real& step() const { return scene_.grid.step(); }
  std::string unit() const;
  Reporter& reporter() const { return reporter_; }

  /// A shape. Error(kUnknownName); what had to be rounded is said where its region is made.
  Shape shape(const std::string& name) const;
  /// The exact set of one of the plane; what had to be rounded is said once.
  Region shape_region(const std::string& name) const;
  /// The formula of `where`, true without one; a mistake is reported at its place in the scene.
  formula::Formula where() const;
  /// A formula or a goal of a placement in its context; a mistake is reported at its place.
  formula::Formula formula(const io::FormulaText& text, const formula::Context& context) const;
  formula::Goal goal(const io::FormulaText& text, const formula::Context& context) const;
  /// What formulas of the scene may speak of.
  formula::Context context() const;
  /// The exact sets of shapes; what had to be rounded is said once.
  std::vector<plane::Region> regions(const std::vector<plane::ShapePtr>& shapes) const;
  /// What `minimize` or `maximize` asks for.
  struct Goal {
    formula::Objective objective;
    distance::Sense sense = distance::Sense::kMinimum;
    std::string text;
  };
  std::optional<Goal> goal() const;
  /// All shapes, and which of them move.
  formula::World world() const;
  /// The same for the public headers, and `where`.
  World public_world() const;
  Formula public_where() const;
  /// The same without shapes that the formula does not name and that others are made of; without the parts of
  /// collections, unless a report or a picture needs them.
  formula::World world_of(const formula::Formula& formula, bool parts = true) const;
  /// Throws where the scene asks for more than positions in the plane (or on a line of it or instants, if `line`).
  void require_positions(bool line) const;
  /// Throws where a 3D scene asks for more than positions of one moving shape (or those on a line, if `line`; or such
  /// at several orientations, if `poses`).
  void require_positions_in_space(bool line = false, bool poses = false) const;
  bool in_space() const { return scene_.dimension == 3; }
  /// Lets go of how the shapes are made, where a world has their sets: only their names stay.
  void forget_shapes();

 private:
  formula::World world_with(const std::vector<plane::ShapePtr>& shapes, bool parts) const;

  const Options& options_;
  Reporter& reporter_;
  io::Scene scene_;
};

/// Whether the file is a circuit board of KiCad.
bool is_board(const std::filesystem::path& path);

}  // namespace findspace::app
