// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A point set that is cheap to copy: all copies are one region, which nobody changes. What holds the shapes of a scene
// holds them in this form, so that a pair of shapes, or a world in which one shape has moved, copies none of the
// others. Threads: safe. Keywords: shared ownership, immutable value.
#pragma once

#include <memory>
#include <utility>

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

class SharedRegion {
 public:
  SharedRegion(Region region) : region_(std::make_shared<const Region>(std::move(region))) {}  // NOLINT: on purpose

  operator const Region&() const { return *region_; }  // NOLINT: on purpose
  const Region& operator*() const { return *region_; }
  const Region* operator->() const { return region_.get(); }

 private:
  std::shared_ptr<const Region> region_;
};

}  // namespace findspace::plane
