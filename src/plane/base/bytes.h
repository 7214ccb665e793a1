// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values as bytes, for another process of the same kind of machine. Equal values have equal bytes: only types without
// padding are taken. Guarantee: what is read back is what was written; bytes of anything else end in `failed()`, never
// in memory that is not there. Cost: linear. Keywords: serialisation.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace findspace::plane {

template <class T>
concept PlainBytes = std::is_trivially_copyable_v<T> &&
    (std::is_floating_point_v<T> || std::has_unique_object_representations_v<T>);

class ByteWriter {
 public:
  template <PlainBytes T>
  void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <PlainBytes T>
  void put_all(std::span<const T> values) {
    put(std::uint64_t(values.size()));
    if (!values.empty()) bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  void put_text(std::string_view text) { put_all(std::span<const char>(text.data(), text.size())); }

  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  /// The bytes must live as long.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <PlainBytes T>
  T take() {
    T value{};
    if (!has(sizeof value)) return value;
    std::memcpy(static_cast<void*>(&value), bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  template <PlainBytes T>
  std::vector<T> take_all() {
    const std::uint64_t count = take_count(sizeof(T));
    std::vector<T> values(count);
    if (count == 0) return values;
    std::memcpy(static_cast<void*>(values.data()), bytes_.data(), count * sizeof(T));
    bytes_.remove_prefix(count * sizeof(T));
    return values;
  }
  std::string take_text() {
    const std::uint64_t size = take_count(1);
    std::string text(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return text;
  }
  /// How many items follow, each of at least so many bytes.
  std::uint64_t take_count(std::uint64_t least) {
    const auto count = take<std::uint64_t>();
    if (count <= bytes_.size() / least) return count;
    failed_ = true;
    return 0;
  }

  bool failed() const { return failed_; }
  /// Everything is read, and it was what was expected.
  bool is_whole() const { return !failed_ && bytes_.empty(); }

 private:
  bool has(std::uint64_t size) {
    failed_ = failed_ || bytes_.size() < size;
    return !failed_;
  }

  std::string_view bytes_;
  bool failed_ = false;
};

}  // namespace findspace::plane
