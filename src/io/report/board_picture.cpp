// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/report/board_picture.h"

#include <algorithm>

#include "io/board/read_part.h"
#include "plane/base/parallel.h"
#include "plane/build/build.h"

namespace findspace::io {
namespace {

/// The layers of a picture, from below.
enum Layer { kBack, kInner, kFront, kThrough, kHole };

Layer layer_of(const Sides& sides) {
  return sides.front && sides.back ? kThrough : sides.back ? kBack : sides.front ? kFront : kInner;
}

}  // namespace

std::vector<CopperLayer> copper_of(const Board& board, const std::vector<std::string>& moving, double step) {
  std::vector<CopperLayer> out{{"copper-back", "copper: back", {}},
                               {"copper-inner", "inner", {}},
                               {"copper-front", "front", {}},
                               {"copper-through", "through", {}},
                               {"hole", "", {}}};
  std::vector<std::pair<Layer, plane::ShapePtr>> shapes;
  for (const Part& part : board.parts) {
    if (std::find(moving.begin(), moving.end(), part.name) != moving.end()) continue;
    for (const Pad& pad : part.pads) shapes.emplace_back(layer_of(pad.sides), pad.copper);
  }
  for (const Copper& c : board.tracks) shapes.emplace_back(layer_of(sides_of(c.layers)), c.shape);
  for (const Copper& c : board.vias) shapes.emplace_back(kThrough, c.shape);
  for (const Hole& hole : board.holes)
    if (std::find(moving.begin(), moving.end(), hole.part) == moving.end()) shapes.emplace_back(kHole, hole.shape);
  std::vector<plane::Region> built(shapes.size());
  plane::parallel_for(shapes.size(), [&](std::size_t k) { built[k] = plane::build(*shapes[k].second, step).region; });
  for (std::size_t k = 0; k < built.size(); ++k) out[shapes[k].first].regions.push_back(std::move(built[k]));
  std::erase_if(out, [](const CopperLayer& layer) { return layer.regions.empty(); });
  return out;
}

bool is_behind(const Board* board, std::string_view part) {
  const Part* found = board == nullptr ? nullptr : board->find(part);
  return found != nullptr && found->courtyard.back && !found->courtyard.front;
}

}  // namespace findspace::io
