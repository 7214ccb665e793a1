// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that stays loaded between requests: its shapes as exact sets, and the formula that is asked about. What the
// solver has made for one request (pairs of shapes, least values) serves the next ones. In the plane; other scenes are
// refused when they are loaded. Threads: one request at a time. Keywords: session, cache.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/explain/explain.h"
#include "io/scene/scene.h"
#include "session.h"

namespace findspace::app {

class LoadedScene {
 public:
  /// Throws Error.
  explicit LoadedScene(io::Scene scene);

  /// Another formula or other moving shapes. Throws Error with the place "LINE:COLUMN" within a formula and changes
  /// nothing then.
  void set_where(const std::string& where);
  void set_moving(const std::vector<std::string>& moving);

  /// What it is: unit, shapes, what moves, the formula; with `drawing` the shapes as path data.
  std::string summary_json(bool drawing) const;
  /// The region, as `map --json` gives it; with `drawing` as path data too. `where`: of another formula, which is not
  /// kept.
  std::string map_json(bool drawing, const std::optional<std::string>& where) const;
  /// Where the nearest feasible position is within `snap`, about that one.
  std::string check_json(const exact::RealPoint& at, bool nearest, const exact::Real& snap) const;
  std::string nearest_json(const exact::RealPoint& at) const;
  std::string measure_json(const exact::RealPoint& at) const;
  std::string explain_json(const std::optional<exact::RealPoint>& at) const;

 private:
  /// For the parts of the program that take a session.
  template <class Use>
  auto with_session(const io::Scene& scene, const Use& use) const;
  std::string unit() const;
  formula::Formula parsed(const std::string& where) const;
  /// The region of the formula, made once.
  const plane::Region& region() const;
  std::optional<formula::NearestFeasible> nearest(const exact::RealPoint& at) const;
  std::string drawing_json(const plane::Region& region) const;
  std::string shape_json(const std::string& name, bool drawing) const;

  io::Scene scene_;
  std::shared_ptr<const formula::Solver> solver_;
  formula::Formula formula_;
  mutable std::optional<plane::Region> region_, closure_;
};

}  // namespace findspace::app
