// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a shape tree alone says of the set: never wrong where it says yes. Every set is bounded, or its complement is;
// so the sum of two closed sets is closed, and so is the hull of some. Guarantee: exact in this sense. Cost: the nodes;
// of a hull of sets that are not closed its body.
// Source: distances.md 1.2.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "exact/number/tried.h"
#include "plane/contour/shape.h"

namespace findspace::space {

/// Closed and without sheets, lines and seams of its own: the closure of its interior.
bool is_solid(const plane::Shape& shape);
bool is_closed(const plane::Shape& shape);
bool is_open(const plane::Shape& shape);

/// Whether the closure may fill walls within: two sets of a union that lack boundary have faces that lie on each other.
/// Of shapes that have a body. Cost: such sets as bodies, if there are two.
bool may_lack_walls(const plane::Shape& shape);
exact::Refusal walls_are_lacking();
/// Of a set that is taken away and may lack boundary.
exact::Refusal boundary_stays();

/// A union, intersection or difference that is translated or mirrored, as that of translated or mirrored sets, and a
/// shrunk intersection or difference as one of shrunk and grown sets; else nothing.
plane::ShapePtr moved_inward(const plane::Shape& shape);

/// Takes the step of each set as soon as it is not refused: a thin piece may be gone, or held, after the others.
template <class Step>
std::optional<exact::Refusal> in_any_order(std::vector<plane::ShapePtr> sets, Step&& step) {
  while (!sets.empty()) {
    std::vector<plane::ShapePtr> left;
    std::optional<exact::Refusal> why;
    for (const plane::ShapePtr& set : sets) {
      std::optional<exact::Refusal> no = step(*set);
      if (!no) continue;
      left.push_back(set);
      if (!why || no->fault()) why = std::move(no);
    }
    if (left.size() == sets.size() || (why && why->fault())) return why;
    sets = std::move(left);
  }
  return std::nullopt;
}

}  // namespace findspace::space
