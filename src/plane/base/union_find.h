// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Disjoint sets over 0..n-1; the smaller index leads, so results do not depend on the order of the unions.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "plane/base/arena.h"

namespace findspace::plane {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n, Memory memory = kHeap) : parent_(n, memory) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void unite(std::uint32_t p, std::uint32_t q) {
    p = find(p);
    q = find(q);
    if (p == q) return;
    if (q < p) std::swap(p, q);
    parent_[q] = p;
  }

 private:
  ArenaVector<std::uint32_t> parent_;
};

}  // namespace findspace::plane
