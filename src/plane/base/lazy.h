// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A value that is made when it is first asked for. Guarantee: made once, whoever asks; what it is made of is said where
// it is asked for. Threads: safe. Keywords: lazy evaluation, once.
#pragma once

#include <mutex>
#include <optional>

namespace findspace::plane {

template <class T>
class Lazy {
 public:
  template <class Make>
  const T& of(Make make) const {
    std::call_once(made_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  mutable std::once_flag made_;
  mutable std::optional<T> value_;
};

}  // namespace findspace::plane
