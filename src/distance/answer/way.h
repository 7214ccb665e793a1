// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The ways in which questions are answered. An answer says its own; nothing derives it again.
#pragma once

#include <string_view>

namespace findspace::distance {

enum class Way {
  kNone,      // not answered
  kBoxes,     // sets of boxes, all faces parallel to the axes
  kConvex,    // one convex set
  kParts,     // convex parts of the shapes
  kSurfaces,  // the surfaces of meshes, without convex parts
  kFeatures,  // in the plane, the nearest or farthest features of the boundaries
  kContacts,  // in the plane, the boundary of the set of contacts near the position
  kCut,       // containers and obstacles of solids that round ones are cut out of
  kSearch,    // a search that ends within an error
  kMap,       // the sign on the exact map of all positions
  kLines,     // the signs on lines
  kAngles     // the exact angles at which a shape in the plane changes its relation to another
};

/// In plain words.
constexpr std::string_view name(Way way) {
  constexpr std::string_view kNames[] = {"none",     "boxes",    "convex", "parts", "surfaces", "features",
                                         "contacts", "cut-outs", "search", "map",   "lines",    "angles"};
  return kNames[static_cast<int>(way)];
}

}  // namespace findspace::distance
