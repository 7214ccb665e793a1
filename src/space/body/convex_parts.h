// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body as a finite union of convex polytopes. Convex bodies are one part; a prism stands on the convex parts of its
// polygon (triangulate.h); a non-convex mesh is cut along planes of its own facets (a binary space partition that
// prefers planes with everything on one side), and neighbouring parts whose union is convex are joined again. A mesh
// whose parts do not have exactly the volume that it encloses crosses itself and is refused. Guarantee: exact. The
// union of the parts is the body and their interiors do not meet (given parts of a union may). A cut can meet an edge
// off the grid; then all coordinates are multiplied by the least number that makes them whole, `scale`. Where that
// would leave the range of 2^40 steps, such vertices are rounded once and counted: the only case in which the union
// differs from the body, by at most `moved` steps. Cost: a cut looks at all pieces of facets; about a
// second for a thousand facets. Source: Fuchs, Kedem, Naylor 1980 (partition); phi.md 10 (why seams need no
// rule). Keywords: convex decomposition, convex pieces, BSP.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "space/polytope/solid.h"
#include "space/polytope/surroundings.h"

namespace findspace::space {

struct ConvexParts {
  std::vector<Polytope> parts;
  std::int64_t scale = 1;                                     // coordinates are in steps / scale
  int rounded = 0;                                            // vertices that had to be rounded
  double moved = 0;                                           // the farthest, in grid steps
  std::vector<PlacedSurroundings> around{};                   // of the parts of each mesh that is one of a union
  std::vector<std::shared_ptr<const ConvexParts>> lacking{};  // closed sets that were taken away: it holds none of them
};

/// Of a clean mesh. Throws Error(kUnsupported) for non-convex meshes of more than 100,000 faces.
ConvexParts convex_parts(const Mesh& mesh);
exact::Tried<ConvexParts> try_convex_parts(const Mesh& mesh);

/// Of a 3D shape tree: polytope, box, prism, mesh, and union, intersection, difference, interior, closure, regularize,
/// translate, mirror, hull and minkowski_sum of such: the closure of the set, for interior and difference. Throws
/// Error(kUnsupported) for a node that has no convex polyhedral parts, Error(kGeometry) for flat ones.
ConvexParts convex_parts(const plane::Shape& shape);
exact::Tried<ConvexParts> try_convex_parts(const plane::Shape& shape);

/// The same parts at a scale that is a multiple of theirs.
std::vector<Polytope> at_scale(const ConvexParts& parts, std::int64_t scale);

}  // namespace findspace::space
