// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that is being asked: its formula and objective as they are read, its shapes as sets, and who hears of it
// meanwhile. Guarantee: mistakes are Errors at their place in the scene, and what is rounded is said once. Cost: shapes
// are built when a world of them is asked for. Keywords: session, question.
#pragma once

#include <findspace/scene.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/language/parse.h"
#include "formula/language/parse_goal.h"
#include "formula/planar/solve.h"
#include "io/question/kept_work.h"
#include "io/scene/scene.h"
#include "plane/build/transform.h"

namespace findspace::io {

class AskedScene {
 public:
  /// How it is asked.
  struct Terms {
    findspace::Scene::Listener listener{};
    std::optional<exact::Real> instant{};    // of its motion; nothing: over all its time
    std::optional<exact::Real> turned{};     // by so many degrees what moves was rotated
    std::shared_ptr<const KeptWork> kept{};  // of a prepared scene
  };
  AskedScene(std::shared_ptr<const Scene> scene, Terms terms) : scene_(std::move(scene)), terms_(std::move(terms)) {}
  AskedScene(Scene scene, findspace::Scene::Listener listener)
      : AskedScene(std::make_shared<const Scene>(std::move(scene)), Terms{std::move(listener), {}, {}, {}}) {}

  const Scene& scene() const { return *scene_; }
  const exact::Real& step() const { return scene_->grid.step(); }
  std::string unit() const;
  bool in_space() const { return scene_->dimension == 3; }
  /// Where it was prepared, what it keeps; else null.
  const std::shared_ptr<const KeptWork>& kept() const { return terms_.kept; }
  /// Who hears of it.
  const findspace::Scene::Listener& listener() const { return terms_.listener; }
  bool at_instant() const { return terms_.instant.has_value(); }
  /// Over all its time.
  AskedScene over_time() const;
  const std::optional<exact::Real>& turned() const { return terms_.turned; }
  /// What the reader of the answer should know.
  void note(const std::string& text) const;
  /// The same of a rotation; `more`: what comes after it.
  void note_rotated(const plane::Rounding& rounding, std::string_view more = "") const;
  /// What is being done now.
  void stage(const std::string& text) const;

  /// The formula of `where`, true without one; a mistake is reported at its place in the scene.
  formula::Formula where() const;
  /// A formula or a goal of a placement in its context; a mistake is reported at its place.
  formula::Formula formula(const FormulaText& text, const formula::Context& context) const;
  formula::Goal goal(const FormulaText& text, const formula::Context& context) const;
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
  /// The same without shapes that the formula does not name and that others are made of; without the parts of
  /// collections, unless a report or a picture needs them.
  formula::World world_of(const formula::Formula& formula, bool parts = true) const;
  /// Of all shapes, or of those that world_of() has; of a prepared scene always that of all.
  std::shared_ptr<const formula::Solver> solver() const;
  std::shared_ptr<const formula::Solver> solver_of(const formula::Formula& formula, bool parts = true) const;
  /// Throws where the scene asks for more than positions in the plane (or on a line of it or instants, if `line`).
  void require_positions(bool line) const;
  /// Throws where a 3D scene asks for more than positions of one moving shape (or those on a line, if `line`; or such
  /// at several orientations, if `poses`).
  void require_positions_in_space(bool line = false, bool poses = false) const;
  /// Throws where the scene does not say what moves.
  void require_moving() const;
  /// Throws where it does not say what must hold, or be best.
  void require_question() const;

  /// Bodies of a placement that come first.
  void want(std::vector<Placement::Near> near);
  /// Lets go of how the shapes are made, where a world has their sets: only their names stay.
  void forget_shapes();

 private:
  formula::World world_with(const std::vector<plane::ShapePtr>& shapes, bool parts) const;
  formula::Formula read_where() const;

  std::shared_ptr<const Scene> scene_;
  Terms terms_;
};

}  // namespace findspace::io
