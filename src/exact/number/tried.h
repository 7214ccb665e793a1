// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The result of one way to answer a question: a value, or a refusal that says why this way has none. The one place of a
// question tries its ways in order; when all refuse it throws the error of the most telling refusal, which is what a
// user reads. Refusals are values: no exception is caught to try another way. Keywords: expected, result type.
#pragma once

#include <findspace/error.h>

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace findspace::exact {

/// Why a way does not answer, as the error that a user gets where no other way does.
struct Refusal {
  Error error;

  explicit Refusal(Error e) : error(std::move(e)) {}
  explicit Refusal(std::string message, std::string place = {})
      : error(ErrorCode::kUnsupported, std::move(message), std::move(place)) {}
  /// An error of the shape or the request, not the limit of a way.
  bool fault() const { return error.code() != ErrorCode::kUnsupported; }
  /// With `prefix` before its place.
  Refusal within(const std::string& prefix) const { return Refusal(error.within(prefix)); }
  /// At `place`, if it has no place of its own.
  Refusal at(const std::string& place) const { return place.empty() || !error.place().empty() ? *this : within(place); }
};

template <class T>
class [[nodiscard]] Tried {
 public:
  template <class U>
  requires std::convertible_to<U, T> &&(!std::same_as<std::remove_cvref_t<U>, Tried>)Tried(U&& value)
      : state_(std::in_place_index<0>, std::forward<U>(value)) {}
  Tried(Refusal why) : state_(std::in_place_index<1>, std::move(why)) {}

  explicit operator bool() const { return state_.index() == 0; }
  T& operator*() & { return *std::get_if<0>(&state_); }
  const T& operator*() const& { return *std::get_if<0>(&state_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&state_)); }
  T* operator->() { return std::get_if<0>(&state_); }
  const T* operator->() const { return std::get_if<0>(&state_); }
  const Refusal& refusal() const { return *std::get_if<1>(&state_); }

  /// The value; throws the error of a refusal.
  T or_throw() && {
    if (!*this) throw refusal().error;
    return std::move(**this);
  }

 private:
  std::variant<T, Refusal> state_;
};

}  // namespace findspace::exact
