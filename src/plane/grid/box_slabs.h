// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes by slabs of y, to find those that reach into a range of y: of the edges of a face, or of faces. Guarantee:
// exact; grid coordinates are exact doubles. Cost: O(n log n) to build, O(n) memory; a question looks at the boxes in
// its slabs. Keywords: bucket grid, interval query.
#pragma once

#include <algorithm>
#include <vector>

#include "plane/grid/grid_faces.h"

namespace findspace::plane {

class BoxSlabs {
 public:
  struct Entry {
    double x0, x1, y0, y1;
    Index item;
    Index slab = 0;  // the lowest one it reaches into
  };

  /// `most`: entries a box, at most, so that tall boxes take no more memory than that.
  BoxSlabs(std::vector<Entry> boxes, std::size_t most);

  /// Calls visit(entry) for every box that reaches into [low, high], once each, while it returns true.
  template <class Visit>
  bool visit(double low, double high, Visit&& visit) const {
    if (start_.empty() || high < bottom_ || low > top_) return true;
    Index first = slab(low), last = slab(high);
    for (Index b = first; b <= last; ++b)
      for (Index k = start_[b]; k < start_[b + 1]; ++k) {
        const Entry& e = boxes_[entries_[k]];
        if (e.y0 <= high && e.y1 >= low && std::max(e.slab, first) == b && !visit(e)) return false;
      }
    return true;
  }

  /// The lowest and the highest place of all.
  double bottom() const { return bottom_; }
  double top() const { return top_; }

  /// How many entries visit() looks at.
  std::size_t count(double low, double high) const {
    if (start_.empty() || high < bottom_ || low > top_) return 0;
    return start_[slab(high) + 1] - start_[slab(low)];
  }

 private:
  Index slab(double y) const {
    double b = (y - bottom_) * per_step_;
    return b <= 0 ? 0 : Index(std::min(b, double(start_.size() - 2)));
  }

  double bottom_ = 0, top_ = 0, per_step_ = 0;
  std::vector<Index> start_;
  std::vector<Entry> boxes_;    // by the lowest slab
  std::vector<Index> entries_;  // of boxes, slab after slab, in the order in which they were given
};

/// Of the edges of a face, by the corners that they leave.
BoxSlabs edge_slabs(const GridFace& face);

}  // namespace findspace::plane
