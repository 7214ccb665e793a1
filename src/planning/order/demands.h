// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is asked of a placement, in names of shapes and texts of formulas, as bodies, conditions and goals (problem.h),
// the same in the plane and in space; and which shapes have to be rotated for it. Guarantee: as the formula language
// says it; mistakes are Errors of the texts' readers. Cost: that of reading a formula once for all bodies. Keywords:
// placement problem, nesting.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "planning/order/problem.h"

namespace findspace::planning {

/// Text that waits for the names that it may use.
template <class Read>
struct Unread {
  std::function<Read(const formula::Context&)> read{};  // none: nothing is asked
  std::string place{};                                  // of the text, for errors; may be empty

  explicit operator bool() const { return static_cast<bool>(read); }
};

struct AskedBody {
  std::string name;                                // "A1", "A1+A2"
  std::vector<std::string> shapes;                 // that move together
  std::vector<Orientation> angles{Orientation{}};  // about the pole; degrees from 0 to 360, each once
  int count = 1;
};

struct Asked {
  std::vector<AskedBody> bodies;
  Unread<formula::Formula> each, pairs;  // of every body, "self"; of every pair, "self" and "other"
  std::vector<Unread<formula::Formula>> constraints;
  std::vector<Unread<formula::Goal>> minimize;
};

struct RotatedShape {
  std::string name, shape;  // a name of its own, and the shape that is rotated
  Orientation turn;
};

/// Where a body is wanted.
struct Wanted {
  std::size_t body = 0;
  std::vector<exact::Real> at;       // in grid steps
  std::optional<std::size_t> angle;  // of Body::angles; nothing: any
};
/// Those bodies come first, in this order, each near its place.
void put_first(Demands& demands, const std::vector<Wanted>& wanted);

struct AskedDemands {
  Demands demands;
  std::vector<RotatedShape> rotated;
};

/// `all`: the context of formulas that may name every shape.
AskedDemands demands_of(const Asked& asked, const formula::Context& all);

}  // namespace findspace::planning
