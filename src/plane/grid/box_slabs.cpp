// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/box_slabs.h"

#include <limits>

namespace findspace::plane {

namespace {

constexpr std::size_t kBoxesPerSlab = 4;
constexpr std::size_t kEntriesPerEdge = 8;

}  // namespace

BoxSlabs::BoxSlabs(std::vector<Entry> boxes, std::size_t most) {
  if (boxes.empty()) return;
  bottom_ = std::numeric_limits<double>::infinity();
  top_ = -bottom_;
  for (const Entry& e : boxes) {
    bottom_ = std::min(bottom_, e.y0);
    top_ = std::max(top_, e.y1);
  }
  std::size_t slabs = boxes.size() / kBoxesPerSlab + 1;
  for (std::size_t entries = 0;; slabs = slabs / 2, entries = 0) {
    per_step_ = top_ > bottom_ ? double(slabs) / (top_ - bottom_) : 0;
    start_.assign(slabs + 1, 0);
    for (const Entry& e : boxes) entries += slab(e.y1) - slab(e.y0) + 1;
    if (slabs == 1 || entries <= most * boxes.size()) break;
  }
  std::vector<Index> lowest(slabs + 1, 0);
  for (Entry& e : boxes) {
    e.slab = slab(e.y0);
    ++lowest[e.slab + 1];
    for (Index b = e.slab; b <= slab(e.y1); ++b) ++start_[b + 1];
  }
  for (std::size_t b = 0; b < slabs; ++b) {
    start_[b + 1] += start_[b];
    lowest[b + 1] += lowest[b];
  }
  boxes_.resize(boxes.size());
  entries_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  for (const Entry& e : boxes) {
    const Index place = lowest[e.slab]++;
    boxes_[place] = e;
    for (Index b = e.slab; b <= slab(e.y1); ++b) entries_[at[b]++] = place;
  }
}

BoxSlabs edge_slabs(const GridFace& face) {
  std::vector<BoxSlabs::Entry> edges;
  edges.reserve(face.corners.size());
  for (Index k = 0; k < face.corners.size(); ++k) {
    const GridPoint p = face.corners[k].at, q = face.corners[face.corners[k].next].at;
    edges.push_back({double(std::min(p.x, q.x)), double(std::max(p.x, q.x)), double(std::min(p.y, q.y)),
                     double(std::max(p.y, q.y)), k});
  }
  return {std::move(edges), kEntriesPerEdge};
}

}  // namespace findspace::plane
