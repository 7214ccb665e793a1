// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/text/json_tree.h"

#include <algorithm>
#include <memory>
#include <type_traits>

namespace findspace::io {

template <class T>
T* JsonTree::copied(std::span<const T> from) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  void* at = free_;
  if (std::align(alignof(T), from.size_bytes(), at, left_) == nullptr) {
    constexpr std::size_t kFirstBlock = 2048, kLargestBlock = std::size_t{1} << 17;
    block_ = std::clamp(2 * block_, kFirstBlock, kLargestBlock);
    left_ = std::max(block_, from.size_bytes());
    at = blocks_.emplace_back(std::make_unique_for_overwrite<std::byte[]>(left_)).get();
  }
  T* const out = static_cast<T*>(at);
  std::uninitialized_copy(from.begin(), from.end(), out);
  free_ = reinterpret_cast<std::byte*>(out + from.size());
  left_ -= from.size_bytes();
  return out;
}

JsonValue JsonTree::text(Kind kind, std::string_view text) {
  JsonValue out(kind);
  const std::string_view own = kept(text);
  out.size_ = static_cast<std::uint32_t>(own.size());
  out.text_ = own.data();
  return out;
}

JsonValue JsonTree::list(std::span<const JsonValue> items) {
  JsonValue out(Kind::kArray);
  out.size_ = static_cast<std::uint32_t>(items.size());
  out.items_ = copied(items);
  return out;
}

JsonValue JsonTree::object(std::span<const std::string_view> keys, std::span<const JsonValue> values) {
  JsonValue out(Kind::kObject);
  out.size_ = static_cast<std::uint32_t>(values.size());
  const JsonValue::Members members{keys.data(), copied(values)};
  out.members_ = copied(std::span<const JsonValue::Members>(&members, 1));
  return out;
}

JsonValue JsonTree::object(std::string_view key, const JsonValue& value) {
  const std::string_view own = kept(key);
  return object(kept(std::span(&own, 1)), std::span(&value, 1));
}

std::string_view JsonTree::kept(std::string_view text) { return {copied(std::span(text)), text.size()}; }

std::span<const std::string_view> JsonTree::kept(std::span<const std::string_view> keys) {
  return {copied(keys), keys.size()};
}

const JsonValue* JsonValue::find(std::string_view key) const {
  const std::span<const std::string_view> all = keys();
  const auto found = std::find(all.begin(), all.end(), key);
  return found == all.end() ? nullptr : &items()[std::size_t(found - all.begin())];
}

const char* JsonValue::kind_name() const {
  switch (kind) {
    case Kind::kNull:
      return "null";
    case Kind::kBoolean:
      return "a truth value";
    case Kind::kNumber:
      return "a number";
    case Kind::kString:
      return "a text";
    case Kind::kArray:
      return "a list";
    case Kind::kObject:
      return "an object";
  }
  return "nothing";
}

}  // namespace findspace::io
