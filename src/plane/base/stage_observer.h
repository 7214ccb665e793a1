// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is given the geometry of each stage of a computation, for debugging: sums, sign maps, overlays, convex parts,
// cells of searches. An observer belongs to the thread that installs it, as the counters of stages.h do. While there is
// one, parallel_for() runs its tasks on that thread and in order, so what it is given does not depend on the number of
// threads. Guarantee: results do not depend on an observer. Cost: nothing is drawn without one; a stage asks once
// whether there is one. Keywords: trace, debug dump, visitor.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "plane/base/of_thread.h"

namespace findspace::plane {

struct CellComplex;

/// Polygons in the steps that the computation uses: grid steps, or steps that divide them.
struct StageDrawing {
  using Corner = std::array<double, 3>;

  bool planar = false;  // all in the plane: the third coordinate is 0
  std::vector<Corner> corners;
  std::vector<std::vector<int>> faces;  // convex, by their corners; two: a segment; one: a point

  void add_face(const std::vector<Corner>& face);
  /// A face between a low and a high corner in the plane, or the six of a box in space.
  void add_box(const Corner& low, const Corner& high);
};

class StageObserver {
 public:
  virtual ~StageObserver() = default;
  /// `stage`: one word. `title`: what is seen.
  virtual void cells(std::string_view stage, const std::string& title, const CellComplex& cells) = 0;
  virtual void drawing(std::string_view stage, const std::string& title, const StageDrawing& drawing) = 0;
};

/// While it lives, the observer is given the stages of this thread; null: none is.
using ObserveStages = OfThread<StageObserver>;
/// The one of this thread, or null.
inline StageObserver* stage_observer() { return ObserveStages::now(); }

/// The cells that one search looks at, given to the observer when the search ends. Without an observer it holds
/// nothing.
class ObservedCells {
 public:
  explicit ObservedCells(const char* title, bool planar = false)
      : observer_(stage_observer()), title_(title), planar_(planar) {}
  ~ObservedCells();
  ObservedCells(const ObservedCells&) = delete;
  ObservedCells& operator=(const ObservedCells&) = delete;

  /// Whether cells are to be added.
  explicit operator bool() const { return observer_ != nullptr; }
  void add_box(const StageDrawing::Corner& low, const StageDrawing::Corner& high);
  void add_tetrahedron(const std::array<StageDrawing::Corner, 4>& corners);

 private:
  bool full();

  StageObserver* observer_;
  const char* title_;
  bool planar_;
  std::size_t seen_ = 0;
  StageDrawing drawing_;
};

}  // namespace findspace::plane
