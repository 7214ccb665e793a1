// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verdict on the layout that was asked of last: one that is judged, and then written as several files, is verified
// once. Guarantee: the verdict of verify(), and safe to ask from many threads. Cost: a copy of the layout. Keywords:
// memo, cache.
#pragma once

#include <algorithm>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "packing/problem/problem.h"
#include "packing/solid_problem/solid_problem.h"

namespace findspace::io {

inline auto all_of(const packing::LeftOut& out) { return std::tie(out.part, out.copies, out.why); }
inline auto all_of(const packing::Placed& p) {
  return std::tie(p.part, p.copy, p.sheet, p.mirrored, p.angle, p.x, p.y);
}
inline auto all_of(const packing::SolidPlaced& p) { return std::tie(p.part, p.copy, p.form, p.container, p.at); }

template <class Item>
bool are_same(const std::vector<Item>& a, const std::vector<Item>& b) {
  const auto same = [](const Item& one, const Item& other) { return all_of(one) == all_of(other); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

inline bool are_same(const packing::Layout& a, const packing::Layout& b) {
  return std::tie(a.length, a.height, a.sheets) == std::tie(b.length, b.height, b.sheets) &&
         are_same(a.items, b.items) && are_same(a.left_out, b.left_out);
}
inline bool are_same(const packing::SolidLayout& a, const packing::SolidLayout& b) {
  return std::tie(a.height, a.containers) == std::tie(b.height, b.containers) && are_same(a.items, b.items) &&
         are_same(a.left_out, b.left_out);
}

template <class Layout, class Verdict>
class LastVerdict {
 public:
  /// verify() only where another layout was asked of last.
  template <class Verify>
  Verdict of(const Layout& layout, const Verify& verify) const {
    {
      const std::lock_guard held(mutex_);
      if (last_ && are_same(last_->first, layout)) return last_->second;
    }
    Verdict found = verify();
    const std::lock_guard held(mutex_);
    last_.emplace(layout, found);
    return found;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::optional<std::pair<Layout, Verdict>> last_;
};

}  // namespace findspace::io
