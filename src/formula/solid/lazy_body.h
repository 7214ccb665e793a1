// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body of convex parts that is made when it is first asked for: of large meshes that takes seconds, and many
// distances need none. Threads: safe. Keywords: lazy evaluation.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "space/body/body.h"

namespace findspace::formula {

class LazyBody {
 public:
  using Pointer = std::shared_ptr<const space::Body>;

  LazyBody() = default;
  LazyBody(std::nullptr_t) {}
  LazyBody(Pointer made) {
    if (made) {
      state_ = std::make_shared<State>();
      state_->body = std::move(made);
    }
  }
  static LazyBody later(std::function<Pointer()> make) {
    LazyBody out;
    out.state_ = std::make_shared<State>();
    out.state_->make = std::move(make);
    return out;
  }

  /// Whether there is one, as far as is known before it is made.
  explicit operator bool() const { return state_ != nullptr; }
  /// Whether asking for it costs nothing.
  bool made() const {
    if (!state_) return false;
    const std::lock_guard lock(state_->guard);
    return state_->body != nullptr;
  }
  /// Throws what making it throws.
  Pointer pointer() const {
    if (!state_) return nullptr;
    const std::lock_guard lock(state_->guard);
    if (!state_->body) state_->body = state_->make();
    return state_->body;
  }
  const space::Body* get() const { return pointer().get(); }
  const space::Body& operator*() const { return *get(); }
  const space::Body* operator->() const { return get(); }

 private:
  struct State {
    std::mutex guard;
    Pointer body;
    std::function<Pointer()> make;
  };
  std::shared_ptr<State> state_;
};

}  // namespace findspace::formula
