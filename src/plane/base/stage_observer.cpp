// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/stage_observer.h"

#include <fmt/format.h>

namespace findspace::plane {
namespace {

constexpr std::size_t kMostDrawn = 20000;  // cells of one search: more make a file that no viewer opens

}  // namespace

void StageDrawing::add_face(const std::vector<Corner>& face) {
  std::vector<int> numbers;
  for (const Corner& corner : face) {
    numbers.push_back(static_cast<int>(corners.size()));
    corners.push_back(corner);
  }
  faces.push_back(std::move(numbers));
}

void StageDrawing::add_box(const Corner& low, const Corner& high) {
  if (planar) {
    add_face({{low[0], low[1], 0}, {high[0], low[1], 0}, {high[0], high[1], 0}, {low[0], high[1], 0}});
    return;
  }
  const int first = static_cast<int>(corners.size());
  for (int k = 0; k < 8; ++k)
    corners.push_back({k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  for (const std::array<int, 4>& face :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    faces.push_back({first + face[0], first + face[1], first + face[2], first + face[3]});
}

bool ObservedCells::full() {
  drawing_.planar = planar_;
  return ++seen_ > kMostDrawn;
}

void ObservedCells::add_box(const StageDrawing::Corner& low, const StageDrawing::Corner& high) {
  if (!full()) drawing_.add_box(low, high);
}

void ObservedCells::add_tetrahedron(const std::array<StageDrawing::Corner, 4>& corners) {
  if (full()) return;
  const int first = static_cast<int>(drawing_.corners.size());
  drawing_.corners.insert(drawing_.corners.end(), corners.begin(), corners.end());
  for (const std::array<int, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    drawing_.faces.push_back({first + face[0], first + face[1], first + face[2]});
}

ObservedCells::~ObservedCells() {
  if (observer_ == nullptr || seen_ == 0) return;
  const std::string shown = seen_ > kMostDrawn ? fmt::format(", the first {}", kMostDrawn) : "";
  observer_->drawing("search", fmt::format("{}: {} cells{}", title_, seen_, shown), drawing_);
}

}  // namespace findspace::plane
