// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Memory for the working arrays of one computation: taken from the stack first, given back all at once. Large
// computations use the heap as usual, so that arrays that grow do not leave their old places behind.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace findspace::plane {

using Memory = std::pmr::memory_resource*;

class Arena {
 public:
  /// `items`: about how many cells the computation has.
  explicit Arena(std::size_t items) : pool_(buffer_.data(), buffer_.size()), heap_(items > kFewItems) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  Memory memory() { return heap_ ? std::pmr::new_delete_resource() : &pool_; }

 private:
  static constexpr std::size_t kFewItems = 500, kBytes = 24 * 1024;

  alignas(std::max_align_t) std::array<std::byte, kBytes> buffer_;
  std::pmr::monotonic_buffer_resource pool_;
  bool heap_;
};

}  // namespace findspace::plane
