// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// JSON as a tree that forgets nothing: every number keeps its text (a decimal is read exactly, never through a
// double) and every value its line and column, so that a mistake is reported where it stands.
// `//` and `/* */` comments are allowed. Refused: duplicate keys, more than 200 levels, NaN and infinity, text after
// the end. Cost: linear in the text. A value takes 24 bytes beside its text, and objects of one kind that follow each
// other share their keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plane/base/work_budget.h"

namespace findspace::io {

/// What it holds lies in its tree, which must outlive it.
class JsonValue {
 public:
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kString, kArray, kObject };

  JsonValue() = default;
  /// An empty value of that kind.
  explicit JsonValue(Kind k) : kind(k) {}

  Kind kind = Kind::kNull;
  bool boolean = false;
  int line = 0, column = 0;  // from 1, in bytes

  bool is(Kind k) const { return kind == k; }
  /// Of its items.
  std::size_t size() const { return kind == Kind::kArray || kind == Kind::kObject ? size_ : 0; }
  /// kString: the value; kNumber: as written; else empty.
  std::string_view text() const {
    if (kind != Kind::kNumber && kind != Kind::kString) return {};
    return {text_, size_};
  }
  /// kArray: the items; kObject: the values, one for each key; else none.
  std::span<const JsonValue> items() const {
    if (size() == 0) return {};
    return {kind == Kind::kArray ? items_ : members_->values, size_};
  }
  /// kObject: in the order of the file; else none.
  std::span<const std::string_view> keys() const {
    if (kind != Kind::kObject || size_ == 0) return {};
    return {members_->keys, size_};
  }
  /// The value under `key`, or null when there is none.
  const JsonValue* find(std::string_view key) const;
  /// "a list", "a number", ... for messages.
  const char* kind_name() const;

 private:
  friend class JsonTree;
  struct Members {
    const std::string_view* keys;
    const JsonValue* values;
  };

  std::uint32_t size_ = 0;  // of the text, the list or the object
  union {
    const char* text_ = nullptr;
    const JsonValue* items_;
    const Members* members_;
  };
};

/// A value with all that it holds.
class JsonTree {
 public:
  using Kind = JsonValue::Kind;

  const JsonValue& root() const { return root_; }
  void set_root(const JsonValue& root) { root_ = root; }

  /// These make values that lie in the tree, of what lies anywhere.
  JsonValue text(Kind kind, std::string_view text);
  JsonValue list(std::span<const JsonValue> items);
  JsonValue object(std::string_view key, const JsonValue& value);
  /// But these keys are kept already.
  JsonValue object(std::span<const std::string_view> keys, std::span<const JsonValue> values);

  /// A copy that lies in the tree.
  std::string_view kept(std::string_view text);
  std::span<const std::string_view> kept(std::span<const std::string_view> keys);

 private:
  template <class T>
  T* copied(std::span<const T> from);

  JsonValue root_;
  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::byte* free_ = nullptr;         // in the last block
  std::size_t left_ = 0, block_ = 0;  // bytes there, and of the last block
};

/// Throws Error(kSyntax) at "name:line:column", and kLimit where there are too many values: one costs kJsonValue units.
JsonTree parse_json(std::string_view text, const std::string& name, plane::WorkBudget& work);
inline constexpr std::uint64_t kJsonValue = 2;

}  // namespace findspace::io
