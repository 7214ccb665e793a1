// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Memory for the working arrays of one computation: taken from the stack first, given back all at once. Large
// computations use the heap as usual, so that arrays that grow do not leave their old places behind. Cost: a small sum
// asks some forty times, so what is asked for is cut off where it is asked, which no virtual function does.
// Keywords: arena allocator, bump allocator.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace findspace::plane {

/// Hands out a buffer piece by piece.
class Block {
 public:
  Block(std::byte* first, std::size_t bytes) : next_(first), first_(first), end_(first + bytes) {}

  /// Null if so much is not left.
  void* take(std::size_t bytes, std::size_t alignment) {
    const std::size_t skipped = -reinterpret_cast<std::uintptr_t>(next_) & (alignment - 1);
    if (bytes + skipped > std::size_t(end_ - next_)) return nullptr;
    std::byte* const at = next_ + skipped;
    next_ = at + bytes;
    return at;
  }
  bool holds(const void* at) const {
    const std::less<const void*> lower;  // an order of pointers into different memory
    return !lower(at, first_) && !lower(end_, at);
  }

 private:
  std::byte *next_, *first_, *end_;
};

using Memory = Block*;
inline constexpr Memory kHeap = nullptr;

/// Of a block, and from the heap where that is full. Copies of a container use the heap: they may live longer.
template <class T>
class ArenaAllocator {
 public:
  using value_type = T;

  ArenaAllocator() = default;
  ArenaAllocator(Memory memory) : memory_(memory) {}  // NOLINT: on purpose
  template <class U>
  ArenaAllocator(const ArenaAllocator<U>& other) : memory_(other.memory()) {}  // NOLINT: as allocators are

  T* allocate(std::size_t count) {
    if (memory_ != kHeap)
      if (void* at = memory_->take(count * sizeof(T), alignof(T))) return static_cast<T*>(at);
    return from_heap(count);
  }
  void deallocate(T* at, std::size_t count) {
    if (memory_ == kHeap || !memory_->holds(at)) to_heap(at, count);
  }
  ArenaAllocator select_on_container_copy_construction() const { return {}; }
  Memory memory() const { return memory_; }
  friend bool operator==(const ArenaAllocator& a, const ArenaAllocator& b) { return a.memory_ == b.memory_; }

 private:
  [[gnu::noinline]] static T* from_heap(std::size_t count) { return std::allocator<T>().allocate(count); }
  [[gnu::noinline]] static void to_heap(T* at, std::size_t count) { std::allocator<T>().deallocate(at, count); }

  Memory memory_ = kHeap;
};

template <class T>
using ArenaVector = std::vector<T, ArenaAllocator<T>>;

class Arena {
 public:
  /// `items`: about how many cells the computation has.
  explicit Arena(std::size_t items) : block_(buffer_.data(), buffer_.size()), heap_(items > kFewItems) {}
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  Memory memory() { return heap_ ? kHeap : &block_; }

 private:
  static constexpr std::size_t kFewItems = 500, kBytes = 24 * 1024;

  alignas(std::max_align_t) std::array<std::byte, kBytes> buffer_;
  Block block_;
  bool heap_;
};

}  // namespace findspace::plane
