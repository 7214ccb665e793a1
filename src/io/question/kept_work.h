// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a prepared scene keeps from one question to the next (Scene::prepared): its shapes as sets, ready for questions,
// and what its formula comes to. Each is made when it is first needed. Cost: the memory of it. Threads: safe. Keywords:
// cache, memoization.
#pragma once

#include <findspace/region.h>
#include <findspace/shape.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "formula/planar/solve.h"
#include "formula/solid/solve_region.h"
#include "formula/solid/solve_space.h"

namespace findspace::io {

class AskedScene;

/// A value that is made once; one that threw is tried again.
template <class Value>
class Kept {
 public:
  template <class Make>
  const Value& get(const Make& make) const {
    std::call_once(made_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  mutable std::once_flag made_{};
  mutable std::optional<Value> value_{};
};

/// Of the shapes alone: scenes that differ in their formulas share it.
struct KeptShapes {
  Kept<std::map<std::string, Shape>> shown{};  // as public ones
  Kept<std::shared_ptr<const formula::Solver>> planar{};
  Kept<std::shared_ptr<const formula::SpaceSolver>> solid{};
  /// How that of the plane is made, where another scene has most of it; who asks is told what is rounded.
  std::function<formula::World(const AskedScene&)> world{};
};

/// The region of a formula in the plane.
struct KeptRegion {
  Region region;                // or what is certain of it
  std::optional<Region> outer;  // what is possible
  bool compared = false;        // it is known between bounds as distances are compared
};

struct KeptWork {
  std::shared_ptr<const KeptShapes> shapes = std::make_shared<const KeptShapes>();
  Kept<formula::Formula> where{};
  Kept<KeptRegion> region{};
  Kept<KeptRegion> positions_on_line{};  // of a scene with a line
  Kept<formula::SpaceRegion> space_region{};
};

}  // namespace findspace::io
