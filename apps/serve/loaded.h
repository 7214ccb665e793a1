// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A scene that stays loaded between requests, in the plane (loaded_plane.h) or in space (loaded_space.h): what it has,
// its formula, and the answers about it as JSON. It is prepared: what is made for one request serves the next ones.
// Threads: one request at a time. Keywords: session, cache.
#pragma once

#include <findspace/scene.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace findspace::app {

/// Where a request looks: lengths in the scene's unit, angles in degrees, an instant of the motion.
struct Spot {
  std::vector<Number> at;  // as many numbers as the scene has dimensions, or none
  std::optional<Number> angle{}, time{};
};

/// Which region is wanted, and how.
struct RegionQuery {
  bool drawing = false;
  bool brief = false;                // only whether it is empty, a position of it, and how it looks
  std::optional<std::string> where;  // of this formula; the scene keeps its own
  std::string apply;                 // interior closure boundary regularize complement, or nothing
  std::optional<Number> angle;       // of the moving shape rotated so
  int resolution = 0;                // in space: lines each way where the region is not exact; 0: kLines
};

class Loaded {
 public:
  /// In the plane or in space. Throws Error.
  static std::unique_ptr<Loaded> make(const Scene& scene);
  virtual ~Loaded() = default;
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  const Scene& scene() const { return scene_; }
  /// Another formula. Throws Error with the place "LINE:COLUMN" within it and changes nothing then.
  void set_where(const std::string& where);
  /// A scene with another question, whose formula is read. Throws Error as set_where().
  static Scene asking(const Scene& scene, const Scene::Question& question);
  /// The same with another formula; without one always.
  static Scene asking(const Scene& scene, const std::string& where);

  /// What it is: dimension, unit, shapes, what moves, the formula, what is free; with `drawing` how the shapes look.
  std::string summary_json(bool drawing) const;
  /// The region, as `map --json` gives it; with `drawing` how it looks too.
  virtual std::string map_json(const RegionQuery& query) const = 0;
  virtual std::string check_json(const Spot& spot, const CheckQuestion& question) const = 0;
  virtual std::string nearest_json(const Spot& spot) const = 0;
  virtual std::string measure_json(const Spot& spot) const = 0;
  /// `over`: kAngle or kTime, of all angles or instants at the position; nothing: of what is free.
  std::string explain_json(const Spot& spot, const std::optional<Scene::Free::Kind>& over) const;
  /// The angles, or the instants, at which the formula holds at a position.
  virtual std::string angles_json(const Spot& spot) const = 0;
  virtual std::string instants_json(const Spot& spot) const = 0;
  /// The distance between the features of shapes that are nearest to two places.
  virtual std::string between_json(const Spot& spot, const Point& from, const Point& to) const = 0;
  /// The placement that the scene asks for, as `place --json` gives it; no longer than `seconds`, 0: any.
  std::string place_json(double seconds, const PlaceQuestion& question) const;

 protected:
  explicit Loaded(const Scene& scene);
  /// Its formula, or what always holds; over positions, or those on its line.
  const Scene& asked() const { return asked_; }
  bool is_free(Scene::Free::Kind kind) const { return scene_.free().kind == kind; }
  /// Throws Error where nothing moves.
  void require_moving() const;
  [[noreturn]] void refuse(const std::string& what) const;

  /// A shape as it is drawn, as JSON; or nothing.
  virtual std::string drawing_of(const std::string& shape) const = 0;
  /// The formula is another one now.
  virtual void forget_answers() {}

 private:
  static Scene asked_of(const Scene& scene);
  std::string shape_json(const std::string& name, const std::vector<std::string>& used, bool drawing) const;
  std::string free_json() const;
  std::string motion_json() const;

  Scene scene_, asked_;
};

/// The object of JSON with one more member.
std::string with_member(std::string object, std::string_view name, std::string_view value);

}  // namespace findspace::app
