// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The movement of shapes in time, and the path of one relative to another: with B(t) = B + b(t) and A(t) = A + a(t)
// every distance depends on w(t) = b(t) - a(t) alone (distances.md 7.3). Positions in grid steps, straight legs at even
// speed; a shape stands still before its first and after its last way point. Guarantee: exact. Keywords: trajectory,
// way point, dynamics.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exact/planar/geometry.h"

namespace findspace::formula {

/// One way point or more; times ascend. Angles in degrees, about the origin of the shape's own coordinates.
struct Trajectory {
  std::vector<exact::Real> times;
  std::vector<exact::RealPoint> path;
  std::vector<exact::Real> angles;

  friend bool operator==(const Trajectory& a, const Trajectory& b);
};

struct Motion {
  exact::Real start, end;
  std::map<std::string, Trajectory> of;  // by shape; the others stand still
  bool given() const { return !of.empty(); }
};

/// Where a shape is along its path at a time.
exact::RealPoint position_at(const Trajectory& trajectory, const exact::Real& time);

/// Its angle then, in degrees; rotating is even between way points.
exact::Real angle_at(const Trajectory& trajectory, const exact::Real& time);
/// Some angle is not 0.
bool rotations(const Trajectory& trajectory);

/// The one movement of all the shapes; throws Error(kUnsupported) where they move differently.
Trajectory common_trajectory(const Motion& motion, const std::vector<std::string>& names);
/// All times where one of the two may change its speed, from the start of the motion to its end.
std::vector<exact::Real> common_times(const Motion& motion, const Trajectory& a, const Trajectory& b);

/// w(t) at all times where its speed may change, from the start of the motion to its end.
Trajectory relative_path(const Motion& motion, const std::vector<std::string>& moving,
                         const std::vector<std::string>& fixed);

}  // namespace findspace::formula
