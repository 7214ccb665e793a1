// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the mesh readers share (lines of words, the mesh being built on the grid, numbers out of bytes), and the PLY
// reader.
#pragma once

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/file_kind.h"
#include "io/text/read_context.h"
#include "space/polytope/solid.h"

namespace findspace::io {

/// A text as lines of words; `#` starts a comment. Empty lines and a byte order mark are passed over.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text), at_(text.size() - without_byte_order_mark(text).size()) {}
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  /// Where the next line begins.
  std::size_t offset() const { return at_; }
  /// "line 12"
  std::string place() const;
  [[noreturn]] void fail(const std::string& message) const;
  long integer(std::string_view word) const;

 private:
  std::string_view text_;
  std::size_t at_;
  long line_ = 0;
  std::vector<std::string_view> words_;
};

class MeshBuilder {
 public:
  MeshBuilder(ReadContext& context, const exact::Real& scale);
  void vertex(const TextLines& lines, std::string_view x, std::string_view y, std::string_view z);
  void vertex(double x, double y, double z);
  void vertex(const std::array<exact::Real, 3>& p);
  void vertex(const space::Point& on_grid) { mesh_.vertices.push_back(on_grid); }
  void face(std::vector<int> circuit) { mesh_.faces.push_back(std::move(circuit)); }
  /// So many more vertices come.
  void expect(std::size_t vertices) {
    const std::size_t all = size() + vertices;
    if (all > mesh_.vertices.capacity()) mesh_.vertices.reserve(std::max(all, 2 * mesh_.vertices.capacity()));
  }
  /// The index, if there is such a vertex.
  int index(const TextLines& lines, long index) const;
  /// Counts work beyond that of the file's own bytes. Throws Error(kLimit).
  void charge(std::uint64_t units, std::string_view what) { context_.work.charge(units, what); }
  std::size_t size() const { return mesh_.vertices.size(); }
  /// A grid step in the file's unit; 0 where there is none.
  const exact::Real& step() const { return step_; }
  space::Mesh& mesh() { return mesh_; }

 private:
  std::int64_t on_grid(const TextLines& lines, std::string_view coordinate, double& moved) const;
  std::int64_t on_grid(double coordinate, double& moved) const;
  std::int64_t on_grid(const exact::Real& coordinate, double& moved) const;
  void add(const space::Point& at, const std::array<double, 3>& moved);

  ReadContext& context_;
  exact::Real scale_;
  exact::Real step_;
  double steps_ = 0;  // that one of the file's numbers makes, if a whole number of them
  space::Mesh mesh_;
};

/// A number out of bytes of the given order; throws Error(kFile) past the end.
template <class T>
T number_at(const std::string& bytes, std::size_t at, bool big_endian) {
  if (at > bytes.size() || bytes.size() - at < sizeof(T)) throw Error(ErrorCode::kFile, "the file is truncated");
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + at, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) {
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

template <class T>
T little(const std::string& bytes, std::size_t at) {
  return number_at<T>(bytes, at, false);
}

void read_ply(const std::string& bytes, MeshBuilder& out);

}  // namespace findspace::io
