// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A body of convex parts that is made when it is first asked for: of large meshes that takes seconds, and many
// distances need none. Threads: safe. Keywords: lazy evaluation.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "exact/number/tried.h"
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
      state_->body.emplace(std::move(made));
    }
  }
  static LazyBody later(std::function<exact::Tried<Pointer>()> make) {
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
    return state_->body && *state_->body;
  }
  /// Null if there is none; a refusal where it cannot be made.
  exact::Tried<Pointer> try_pointer() const {
    if (!state_) return nullptr;
    const std::lock_guard lock(state_->guard);
    if (!state_->body) state_->body.emplace(state_->make());
    return *state_->body;
  }
  Pointer pointer() const { return try_pointer().or_throw(); }
  const space::Body* get() const { return pointer().get(); }
  const space::Body& operator*() const { return *get(); }
  const space::Body* operator->() const { return get(); }

 private:
  struct State {
    std::mutex guard;
    std::optional<exact::Tried<Pointer>> body;
    std::function<exact::Tried<Pointer>()> make;
  };
  std::shared_ptr<State> state_;
};

}  // namespace findspace::formula
