// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Joining open chains end to end, as drawings of single lines and arcs need it. Ends join only where they are the same
// grid point: nothing is pulled together.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "findspace/error.h"
#include "io/text/outline_shapes.h"
#include "plane/contour/contour.h"

namespace findspace::io {
namespace {

using plane::Contour;
using plane::GridPoint;

/// An open chain the other way round: its end point comes first.
Contour reversed_chain(const Contour& chain) {
  Contour result = plane::reversed(chain);
  std::rotate(result.begin(), result.begin() + 1, result.end());
  return result;
}

class Joiner {
 public:
  Joiner(std::vector<Chain> chains, double step) : chains_(std::move(chains)), used_(chains_.size(), false) {
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (chains_[i].closed) continue;
      at_[chains_[i].edges.front().start].push_back(i);
      at_[chains_[i].edges.back().start].push_back(i);
    }
    for (const auto& [point, chains] : at_) {
      if (chains.size() <= 2) continue;
      double x = double(point.x) * step, y = double(point.y) * step;
      throw Error(ErrorCode::kGeometry,
                  fmt::format("{} lines end at ({:.10g}, {:.10g}); which belong together is open", chains.size(), x, y))
          .at(x, y);
    }
  }

  std::vector<Chain> join() {
    std::vector<Chain> result;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      Chain chain = std::move(chains_[i]);
      if (!chain.closed && !extend(chain)) {
        chain.edges = reversed_chain(chain.edges);
        extend(chain);
        chain.edges = reversed_chain(chain.edges);
      }
      result.push_back(std::move(chain));
    }
    return result;
  }

 private:
  /// Adds what follows the chain's last point, as far as it goes; true where it comes back to its first.
  bool extend(Chain& chain) {
    while (true) {
      GridPoint end = chain.edges.back().start;
      if (end == chain.edges.front().start) {
        chain.edges.pop_back();
        chain.closed = true;
        return true;
      }
      const std::vector<std::size_t>& here = at_[end];
      auto next = std::find_if(here.begin(), here.end(), [&](std::size_t i) { return !used_[i]; });
      if (next == here.end()) return false;
      used_[*next] = true;
      Contour piece = std::move(chains_[*next].edges);
      if (piece.front().start != end) piece = reversed_chain(piece);
      chain.edges.pop_back();
      chain.edges.insert(chain.edges.end(), piece.begin(), piece.end());
    }
  }

  std::vector<Chain> chains_;
  std::vector<bool> used_;
  std::map<GridPoint, std::vector<std::size_t>> at_;
};

}  // namespace

void join_open_chains(Drawing& drawing, double step) {
  drawing.chains = Joiner(std::move(drawing.chains), step).join();
}

}  // namespace findspace::io
