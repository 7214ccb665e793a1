// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body of the same convex hull as another: known, or made of a surface when it is first asked for. That of a large
// mesh takes a tenth of the time of a question, and many questions need none. Threads: safe. Keywords: convex hull,
// lazy evaluation.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "distance/solid/far_corners.h"
#include "plane/base/lazy.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

class Outline {
 public:
  using Pointer = std::shared_ptr<const space::Body>;

  /// None.
  Outline(std::nullptr_t = nullptr) {}                  // NOLINT: on purpose
  Outline(Pointer known) : known_(std::move(known)) {}  // NOLINT: on purpose
  /// `scale` of the coordinates; none where the surface has balls.
  static Outline of(std::shared_ptr<const space::SurfaceSet> surface, std::int64_t scale) {
    Outline out;
    if (surface->has_hull()) out.later_ = std::make_shared<const Later>(std::move(surface), scale);
    return out;
  }

  /// Whether there is one.
  explicit operator bool() const { return known_ != nullptr || later_ != nullptr; }
  const Pointer& pointer() const { return later_ ? later_->made() : known_; }
  const space::Body& operator*() const { return *pointer(); }
  const space::Body* operator->() const { return pointer().get(); }
  /// Points of the same hull. Those of a surface serve until they are asked for often: then the hull is made.
  std::vector<Corners> corners() const { return later_ ? later_->corners() : corners_of(*known_); }

 private:
  class Later {
   public:
    Later(std::shared_ptr<const space::SurfaceSet> surface, std::int64_t scale)
        : surface_(std::move(surface)), scale_(scale) {}
    const Pointer& made() const {
      return hull_.of([this] { return surface_->hull(scale_); });
    }
    std::vector<Corners> corners() const {
      constexpr int kOften = 100;
      if (asked_ >= kOften) return corners_of(*made());
      ++asked_;
      std::vector<Corners> out;
      for (const auto& sheet : surface_->sheets()) out.push_back({sheet->body.points, exact::Real()});
      return out;
    }

   private:
    std::shared_ptr<const space::SurfaceSet> surface_;
    std::int64_t scale_;
    mutable std::atomic<int> asked_ = 0;
    plane::Lazy<Pointer> hull_;
  };

  Pointer known_;
  std::shared_ptr<const Later> later_;
};

}  // namespace findspace::distance
