// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_frontier.h"

#include <algorithm>

#include "plane/base/parallel.h"

namespace findspace::space {
namespace {

/// The units of parallel work: fixed, so that the order of pieces does not depend on the number of threads.
constexpr std::size_t kTrianglesAtOnce = 16;

void add_pieces(const TouchSets& sets, const TouchSets::Pair& of, const BoxQuery& wanted, std::vector<FlatPiece>& out) {
  for (const TouchSets::Facet& facet : sets.facets(of)) {
    if (wanted(exact::approx(facet.box.low), exact::approx(facet.box.high))) sets.add_pieces(facet, out);
  }
}

}  // namespace

TouchFrontier touch_frontier(std::shared_ptr<const TouchSets> sets, const BoxQuery& wanted) {
  const std::size_t triangles = sets->sheet().body.faces.size(), parts = sets->parts().size(),
                    blocks = (triangles + kTrianglesAtOnce - 1) / kTrianglesAtOnce;
  std::vector<std::vector<FlatPiece>> found(blocks);
  plane::parallel_for(blocks, [&](std::size_t block) {
    for (std::size_t t = block * kTrianglesAtOnce; t < std::min(triangles, (block + 1) * kTrianglesAtOnce); ++t) {
      for (std::size_t k = 0; k < parts; ++k) add_pieces(*sets, {t, k}, wanted, found[block]);
    }
  });
  TouchFrontier out;
  for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(out.pieces));
  out.sets = std::move(sets);
  return out;
}

}  // namespace findspace::space
