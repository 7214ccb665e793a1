// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/in_batches.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/side_by_side.h"
#include "plane/query/boundary_components.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kAtOnce = 4;  // batches, whatever the number of threads

PieceBox reached(const PieceBox& b, const PieceBox& reach) {
  const auto sum = [](double p, double q, int way) {
    return p + q + way * (std::abs(p) + std::abs(q)) * margin::kRoundings8;
  };
  return {sum(b.x0, reach.x0, -1), sum(b.y0, reach.y0, -1), sum(b.x1, reach.x1, 1), sum(b.y1, reach.y1, 1)};
}

/// The components of each batch, ascending; groups stay together.
std::vector<std::vector<Index>> batches(const BoundaryComponents& parts, const PieceBox& reach, std::size_t each) {
  std::vector<PieceBox> boxes;
  boxes.reserve(parts.size());
  for (Index k = 0; k < parts.size(); ++k) boxes.push_back(reached(parts.box(k), reach));
  std::vector<std::vector<Index>> out;
  std::size_t edges = each;
  const IndexGroups groups = groups_apart(boxes);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::span<const Index> group = groups[g];
    if (edges >= each) {
      out.emplace_back();
      edges = 0;
    }
    for (const Index k : group) edges += parts.edge_count(k) + 1;
    out.back().insert(out.back().end(), group.begin(), group.end());
  }
  for (std::vector<Index>& batch : out) std::sort(batch.begin(), batch.end());
  return out;
}

/// Room for `share` times what there is, and a little more: lists that grow are copied, and both are there.
void reserve_times(CellComplex& c, double share) {
  const auto more = [share](auto& list) { list.reserve(std::size_t(double(list.size()) * share * 1.125)); };
  more(c.geometry.supporting_curves);
  more(c.geometry.points);
  more(c.vertices);
  more(c.edges);
  more(c.half_edges);
  more(c.faces);
}

}  // namespace

std::optional<CellComplex> made_in_batches(const CellComplex& set, const PieceBox& reach,
                                           const std::function<CellComplex(const CellComplex&)>& make,
                                           const BatchSizes& sizes) {
  if (!is_worth_batches(set, sizes) || stage_observer() != nullptr) return std::nullopt;
  const BoundaryComponents parts(set);
  const std::vector<std::vector<Index>> all = batches(parts, reach, sizes.each);
  if (all.size() < 2) return std::nullopt;
  std::optional<CellComplex> out;
  for (std::size_t first = 0; first < all.size(); first += kAtOnce) {
    std::vector<CellComplex> made(std::min(kAtOnce, all.size() - first));
    parallel_for(made.size(), [&](std::size_t k) { made[k] = make(parts.of(set, all[first + k])); });
    if (!out) out = CellComplex::uniform(made[0].faces[0].mark);
    for (const CellComplex& m : made) put_beside(*out, m);
    if (first == 0) reserve_times(*out, double(all.size()) / double(made.size()));
  }
  return out;
}

}  // namespace findspace::plane
