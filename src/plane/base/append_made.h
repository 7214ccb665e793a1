// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Appends to a list what a function makes of 0, 1, 2, ...: room is looked for once and each thing is written once,
// where a loop of push_back asks for room each time and resize writes everything twice. Keywords: generate, tabulate.
#pragma once

#include <cstddef>
#include <iterator>

namespace findspace::plane {

/// make(k) for k counting up: as much of an iterator of random access as lists need to learn how many there are.
template <class Thing, class Make>
class Made {
 public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = Thing;
  using difference_type = std::ptrdiff_t;
  using pointer = const Thing*;
  using reference = Thing;

  Made(const Make& make, std::size_t k) : make_(&make), k_(k) {}

  Thing operator*() const { return (*make_)(k_); }
  Made& operator++() {
    ++k_;
    return *this;
  }
  Made& operator--() {
    --k_;
    return *this;
  }
  Made& operator+=(std::ptrdiff_t by) {
    k_ += std::size_t(by);
    return *this;
  }
  bool operator==(const Made& other) const { return k_ == other.k_; }
  bool operator!=(const Made& other) const { return k_ != other.k_; }
  friend std::ptrdiff_t operator-(const Made& a, const Made& b) { return std::ptrdiff_t(a.k_) - std::ptrdiff_t(b.k_); }

 private:
  const Make* make_;
  std::size_t k_;
};

template <class List, class Make>
void append_made(List& list, std::size_t count, const Make& make) {
  using Item = Made<typename List::value_type, Make>;
  list.insert(list.end(), Item(make, 0), Item(make, count));
}

}  // namespace findspace::plane
