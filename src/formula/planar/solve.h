// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over a world of shapes, answered for all positions at once and for single ones. All sign maps of the
// formula are laid over each other once; every vertex, edge and face of the overlay gets the truth of the formula
// (decision 1). Guarantee: the exact set, slots, points, open and closed boundaries included. Lengths are in the
// scene's unit; the region that comes back is in grid steps. Cost: one convolution a pair of shapes, one more for each
// level other than 0, one overlay. Keywords: feasible region, configuration space, formula.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/planar_least/best_position.h"
#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotation_map.h"
#include "distance/rotation/rotation_motion.h"
#include "formula/language/formula.h"
#include "formula/planar/motion.h"
#include "formula/planar/witness.h"
#include "plane/complex/extent.h"
#include "plane/query/boundary_components.h"
#include "plane/query/nearest.h"
#include "plane/query/section.h"

namespace findspace::formula {

struct World {
  std::map<std::string, plane::Region> shapes;  // in grid steps
  std::vector<std::string> moving;
  exact::Real step;                    // one grid step in the scene's unit
  Motion motion;                       // if given, distances are taken over its time
  std::optional<exact::Real> instant;  // of the motion: distances without inf and sup are those of this time
  Parts parts;                         // of the shapes that are collections, for reports
  bool eroded = false;                 // shapes made smaller by the program: nothing may be left of one
};

/// One distance at one position.
struct DistanceAt {
  std::string text;                          // canonical: "gamma1(B, A)"
  std::optional<double> value;               // in the scene's unit, may be -infinity; nothing: undefined, +infinity
  std::optional<exact::RealPoint> nearest;   // in grid steps: the nearest position where it is 0, if that is known
  std::optional<exact::RealPoint> farthest;  // in grid steps: of eta2 and delta2 the position of the farthest touching
  std::vector<FeatureAt> witness;            // two features that attain it, in the order of the arguments; or none
  std::optional<double> bound{};             // not exact: how far the true value may be, of shapes that turn in time
  bool in_degrees = false;                   // of a distance in rotation, not in the scene's unit
};

struct AtomAt {
  Atom atom;
  DistanceAt distance;
  bool holds = false;           // exact, also on a boundary
  std::optional<double> lacks;  // how far the value is from holding, if it does not (of a strict relation the infimum)
};

/// The point of the closure of a region that is nearest to a position.
struct NearestFeasible {
  exact::RealPoint at;    // in grid steps
  exact::Real distance;   // in the scene's unit
  bool attained = false;  // `at` itself is feasible
};

class Solver {
 public:
  explicit Solver(World world);
  ~Solver();

  /// {p : the formula holds at p}. Throws Error(kUnsupported) for distances this version does not compute.
  plane::Region feasible(const Formula& formula) const;

  /// For shapes that turn in time and distances in rotation, over the time of a motion too: positions that certainly
  /// and that possibly belong to feasible(formula).
  struct Bounds {
    plane::Region inner, outer;
  };
  Bounds feasible_bounds(const Formula& formula) const;
  /// Some shape of the formula rotates in time, and no instant is asked for, or some distance is one in rotation with a
  /// level other than 0: feasible() is refused, feasible_bounds() is not.
  bool rotations_in(const Formula& formula) const;

  /// Every atom of the formula at position p (in the scene's unit), and whether the formula holds there.
  struct Check {
    bool holds = false;
    std::vector<AtomAt> atoms;
  };
  Check check(const Formula& formula, const exact::RealPoint& p) const;

  /// One distance at p (in the scene's unit).
  DistanceAt distance_at(const Distance& wanted, const exact::RealPoint& p) const { return value(wanted, steps(p)); }
  /// The nearest position at which the formula holds, or of the closure of those; nothing if it holds nowhere.
  std::optional<NearestFeasible> nearest_feasible(const Formula& formula, const exact::RealPoint& p) const;

  /// All distances of the moving shapes to every other shape at p (in the scene's unit), with a motion their inf and
  /// sup; and those that the formula names besides.
  std::vector<DistanceAt> measure(const exact::RealPoint& p, const Formula& formula = {}) const;

  /// With a motion: the marks that the formula has at p (in the scene's unit) from the start to the end of the motion,
  /// 1 where it holds at the instant. Distances with inf or sup keep to the whole time.
  plane::Section instants(const Formula& formula, const exact::RealPoint& p) const;

  /// The same where the moving shapes stay in place and turn, and nothing else moves; nothing where that is not so.
  std::optional<plane::Section> swing(const Formula& formula, const exact::RealPoint& p) const;

  /// The same where shapes turn in time: instants that certainly and that possibly belong.
  struct InstantBounds {
    plane::Section inner, outer;
  };
  InstantBounds instant_bounds(const Formula& formula, const exact::RealPoint& p) const;

  /// The function that a formula means, in grid steps: along a direction, over time or at the instant too.
  distance::PositionFunctionPointer function(const Distance& wanted) const;
  /// Of a motion of shapes that do not turn, the places of the first of a pair as seen from the second; else the
  /// origin.
  std::vector<exact::RealPoint> way(const Distance& wanted) const;
  /// A distance of a pair as a formula means `wanted`: over the time of a motion.
  distance::PositionFunctionPointer over_its_time(const Distance& wanted, distance::TDistancePointer of_pair) const;
  /// The T-distance that a formula means, whose extrema are computed. Throws Error(kUnsupported) for those that are
  /// none.
  distance::TDistancePointer distance(const Distance& wanted) const;
  /// Its global minimum and the positions that have it: `distance -> min`.
  distance::Extremum least(const Distance& wanted) const;

  /// Only bounds of its values over positions are known: it is in rotation, or a shape rotates in time.
  bool is_bounded(const Distance& wanted) const;
  /// Its least or greatest value over positions in grid steps (in degrees, of one in rotation), where is_bounded.
  distance::Extremum best_position(const Distance& wanted, const distance::PositionBounds& over,
                                   distance::Sense sense) const;

  const World& world() const { return world_; }
  /// A box around a shape; none for one that is unbounded or empty.
  const plane::PieceBox* box(const std::string& name) const {
    auto found = boxes_.find(name);
    return found == boxes_.end() ? nullptr : &found->second;
  }
  /// A bounded shape's boundary_components; none where it has not several.
  const plane::BoundaryComponents* boundary_components(const std::string& name) const {
    auto found = boundary_components_.find(name);
    return found == boundary_components_.end() ? nullptr : &found->second;
  }
  /// The union of the named shapes, closed.
  plane::Region shape(const std::vector<std::string>& names) const;
  /// Which distance of a pair a formula means, the moving shape being the first of the pair.
  distance::Which which(const Distance& moving_first) const;

 private:
  using Names = std::pair<std::vector<std::string>, std::vector<std::string>>;  // moving, fixed
  struct Cache;

  /// Who moves in a distance, and along which relative path.
  struct Roles {
    Distance wanted;  // with the moving shape first, where the distance allows it
    Names names;
    bool second_moves = false;
    Trajectory path;  // empty without a motion
    bool rotating = false;
  };

  Roles roles(const Distance& wanted) const;
  distance::TDistancePointer plain(const Roles& roles) const;
  /// The same for searches: extrema are found where the numbers are small.
  distance::TDistancePointer searched(const Roles& roles) const;
  distance::PositionFunctionPointer of_instant(const Roles& roles) const;
  std::shared_ptr<const distance::AtPosition> pair(const Names& names) const;
  plane::SignMap sign_map(const SignMap& wanted) const;
  plane::Section instants(const SignMap& wanted, const exact::RealPoint& p) const;
  std::array<plane::Section, 2> rotation_instants(const SignMap& wanted, const Roles& roles,
                                                  const exact::RealPoint& p) const;
  std::optional<Trajectory> swinging(const Formula& formula) const;
  /// Of inf or sup over the time minus the level, where swing() knows the instants.
  std::optional<std::int8_t> swing_sign(const SignMap& wanted, const exact::RealPoint& p) const;
  std::vector<Distance> all_distances() const;
  distance::Extremum least_of_instant(const Roles& r) const;
  distance::Extremum least_directional(const Roles& r) const;
  distance::Extremum least_over_time(const Distance& wanted) const;
  std::vector<plane::SignMap> sign_maps(const Formula& formula) const;
  DistanceAt value(const Distance& distance, const exact::RealPoint& p) const;
  std::int8_t sign(const SignMap& wanted, const exact::RealPoint& p) const;
  std::optional<plane::Nearest> contact(const Atom& atom, const exact::RealPoint& p) const;
  std::optional<NearestFeasible> nearest_by_contact(const Formula& formula, const exact::RealPoint& p) const;
  std::optional<std::int8_t> clear_sign(const SignMap& wanted, const Roles& roles, const exact::RealPoint& p) const;
  /// In rotation, where that is not the plain distance.
  bool in_rotation(const SignMap& wanted) const;
  distance::RotationInTime rotation_in_time(const Roles& roles, const exact::RealPoint& p, bool instant) const;
  std::vector<distance::RotatingPose> rotation_poses(const Roles& roles, bool instant) const;
  distance::BoundedMaps bounded_maps(const SignMap& wanted) const;
  /// In grid steps, of distances in rotation in degrees; nothing where undefined.
  std::optional<distance::ValueRange> rotation_value(const Roles& roles, const exact::RealPoint& p) const;
  double shown(const distance::ValueRange& value, const Roles& roles) const;
  distance::RotatingMotion rotation_motion(const Roles& roles, bool instant) const;
  distance::BoundedMaps bounded_minimisers(const SignMap& wanted) const;
  /// All values of a distance over discs of positions; and where to look for the best.
  distance::DiscRange disc_range(const Roles& roles) const;
  distance::SearchWindow search_window(const Roles& roles, const plane::Region& over) const;
  static distance::Sense sense_over_time(const Distance& wanted);
  void add_witness(DistanceAt& out, const Distance& wanted, const Names& names, const distance::AtPosition& pair,
                   const distance::Measured& measured, const exact::RealPoint& p) const;
  std::vector<FeatureAt> named_features(const Distance& wanted, const Names& names, const distance::AtPosition& pair,
                                        const distance::Measured& measured, const exact::RealPoint& p) const;
  /// Of a distance along a direction, that has a nearest position: the features that touch there.
  void add_contact(DistanceAt& out, const Distance& wanted, const Roles& roles, const exact::RealPoint& p) const;
  exact::RealPoint steps(const exact::RealPoint& p) const { return {p.x / world_.step, p.y / world_.step}; }

  World world_;
  std::map<std::string, plane::PieceBox> boxes_;                          // of the bounded shapes
  std::map<std::string, plane::BoundaryComponents> boundary_components_;  // of those that have several
  std::unique_ptr<Cache> cache_;
};

}  // namespace findspace::formula
