// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A list that mostly has one item or none, and then asks for no memory; a third smaller than a std::vector. For items
// that are numbers. Keywords: small vector, inline storage.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace findspace::plane {

template <class T>
class ShortList {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= sizeof(T*));

 public:
  using value_type = T;

  ShortList() = default;
  explicit ShortList(std::span<const T> items) {
    if (items.size() > 1) make_room(items.size());
    size_ = std::uint32_t(items.size());
    std::copy(items.begin(), items.end(), begin());
  }
  ShortList(const ShortList& other) : ShortList(std::span<const T>(other)) {}
  ShortList(ShortList&& other) noexcept { swap(other); }
  ShortList& operator=(ShortList other) noexcept {
    swap(other);
    return *this;
  }
  ~ShortList() {
    if (is_long()) delete[] items_.many;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return is_long() ? items_.many : &items_.one; }
  T* end() { return begin() + size_; }
  const T* begin() const { return is_long() ? items_.many : &items_.one; }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t k) { return begin()[k]; }
  const T& operator[](std::size_t k) const { return begin()[k]; }

  void push_back(T item) {
    if (size_ == room_) make_room(2 * std::size_t(room_));
    begin()[size_++] = item;
  }

  friend bool operator==(const ShortList& a, const ShortList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  union Items {
    T one;
    T* many;
  };

  bool is_long() const { return room_ > 1; }
  void swap(ShortList& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(room_, other.room_);
    std::swap(items_, other.items_);
  }
  /// For more than one item, and for all there are.
  void make_room(std::size_t room) {
    T* const many = new T[room];
    std::copy(begin(), end(), many);
    if (is_long()) delete[] items_.many;
    items_.many = many;
    room_ = std::uint32_t(room);
  }

  std::uint32_t size_ = 0, room_ = 1;  // of one item it is in the list itself
  Items items_{};
};

}  // namespace findspace::plane
