// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that stays loaded between requests, in the plane (loaded_plane.h) or in space (loaded_space.h): what it has,
// its formula, and the answers about it as JSON. What is made for one request serves the next ones. Threads: one
// request at a time. Keywords: session, cache.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/session.h"
#include "formula/language/formula.h"
#include "formula/language/position_answers.h"
#include "io/scene/scene.h"

namespace findspace::app {

/// Where a request looks: lengths in the scene's unit, angles in degrees, an instant of the motion.
struct Spot {
  std::vector<exact::Real> at;  // as many numbers as the scene has dimensions
  std::optional<exact::Real> angle, time;
};

/// Which region is wanted, and how.
struct RegionQuery {
  bool drawing = false;
  bool brief = false;                // only whether it is empty, a position of it, and how it looks
  std::optional<std::string> where;  // of this formula; the scene keeps its own
  std::string apply;                 // interior closure boundary regularize complement, or nothing
  std::optional<exact::Real> angle;  // of the moving shape rotated so
  int resolution = 0;                // in space: lines each way where the region is not exact; 0: kLines
};

struct CheckQuery {
  bool nearest = false;  // the nearest feasible position too
  exact::Real snap;      // go to a corner, an edge or the nearest feasible position within this
};

class Loaded {
 public:
  /// In the plane or in space. Throws Error.
  static std::unique_ptr<Loaded> make(io::Scene scene);
  virtual ~Loaded() = default;
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  const io::Scene& scene() const { return scene_; }
  /// Another formula. Throws Error with the place "LINE:COLUMN" within it and changes nothing then.
  void set_where(const std::string& where);

  /// What it is: dimension, unit, shapes, what moves, the formula, what is free; with `drawing` how the shapes look.
  std::string summary_json(bool drawing) const;
  /// The region, as `map --json` gives it; with `drawing` how it looks too.
  virtual std::string map_json(const RegionQuery& query) const = 0;
  virtual std::string check_json(const Spot& spot, const CheckQuery& query) const = 0;
  std::string nearest_json(const Spot& spot) const;
  virtual std::string measure_json(const Spot& spot) const = 0;
  virtual std::string explain_json(const std::optional<Spot>& spot) const = 0;
  /// The angles, or the instants, at which the formula holds at a position.
  virtual std::string angles_json(const Spot& spot) const = 0;
  virtual std::string instants_json(const Spot& spot) const = 0;
  /// The distance between the features of shapes that are nearest to two places.
  virtual std::string between_json(const Spot& spot, const std::array<exact::RealPoint, 2>& places) const = 0;
  /// The placement that the scene asks for, as `place --json` gives it; no longer than `seconds`, 0: any.
  std::string place_json(double seconds, const PlaceQuestion& question) const;

 protected:
  explicit Loaded(io::Scene scene) : scene_(std::move(scene)) {}
  /// For the parts of the program that take a session.
  template <class Use>
  auto with_session(const Options& options, const Use& use) const {
    Reporter reporter(true);
    return use(Session(options, reporter, scene_));
  }
  template <class Use>
  auto with_session(const Use& use) const {
    return with_session(Options{}, use);
  }
  std::string unit() const;
  double step() const { return scene_.grid.step_size(); }
  const formula::Formula& formula() const { return formula_; }
  void read_formula();
  formula::Formula parsed(const std::string& where) const;
  /// Throws Error where nothing moves.
  void require_moving() const;
  [[noreturn]] void refuse(const std::string& what) const;

  /// Nothing where it is not computed, or no position is feasible.
  virtual formula::TriedNearest nearest(const Spot& spot) const = 0;
  /// A shape as it is drawn, as JSON.
  virtual std::string drawing_of(const std::string& shape) const = 0;
  /// The formula is another one now.
  virtual void forget_answers() = 0;

 private:
  std::string shape_json(const std::string& name, bool drawing) const;
  std::string free_json() const;
  std::string motion_json() const;

  io::Scene scene_;
  formula::Formula formula_;
};

/// The object of JSON with one more member.
std::string with_member(std::string object, std::string_view name, std::string_view value);

/// "in the scene's grid's reach": throws Error(kOutOfRange) otherwise.
void check_reach(const io::Scene& scene, const Spot& spot);

}  // namespace findspace::app
