// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Typed access to the JSON tree of a scene, with errors that say where: the shape, the part of it, the line.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/error.h"
#include "io/text/formula_text.h"
#include "io/text/json_tree.h"
#include "io/text/read_context.h"
#include "plane/contour/shape.h"

namespace findspace::io {

/// Where in the scene a value is, in words; a chain on the stack that becomes text only when something is wrong.
struct Label {
  const Label* outer = nullptr;
  std::string_view what;
  std::string_view name{};
  long index = -1;

  Label part(std::string_view word, std::size_t i) const { return {this, word, {}, static_cast<long>(i)}; }
  Label part(std::string_view word) const { return {this, word}; }
  /// "shape 'board', hole 1, vertex 3"
  std::string text() const;
  /// Appends that, where so many levels follow; gives back how many levels it has.
  std::size_t put(fmt::memory_buffer& all, std::size_t within = 0) const;
};

class SceneReader {
 public:
  SceneReader(std::string file, ReadContext& context) : file_(std::move(file)), context_(context) {}

  const std::string& file() const { return file_; }
  ReadContext& context() const { return context_; }

  /// "shape 'board', vertex 3 (scene.json:12:5)".
  std::string place(const Label& label, const JsonValue& at) const;
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const Label& label, const JsonValue& at) const;
  /// Runs `read`; an error of it gets this place, unless it has one in the same part of the scene.
  template <class Read>
  auto placed(const Label& label, const JsonValue& at, Read read) const {
    try {
      return read();
    } catch (const Error& e) {
      if (is_within(e.place(), label)) throw;
      throw e.within(place(label, at));
    }
  }

  /// The same of a file that `at` names; a scene that was made for this file alone has no place of its own.
  template <class Read>
  auto placed_file(const Label& label, const JsonValue& at, Read read) const {
    return at.text() == file_ ? read() : placed(label, at, read);
  }

  void expect(const JsonValue& value, JsonValue::Kind kind, std::string_view meaning, const Label& label) const;
  /// Every key of the object must be one of `allowed`.
  void check_keys(const JsonValue& object, std::span<const std::string_view> allowed, const Label& label) const;
  const JsonValue& need(const JsonValue& object, std::string_view key, const Label& label) const;

  exact::Real number(const JsonValue& value, const Label& label) const;
  std::string_view text(const JsonValue& value, std::string_view meaning, const Label& label) const;
  std::vector<std::string> texts(const JsonValue& value, std::string_view meaning, const Label& label) const;
  FormulaText formula(const JsonValue& value, const Label& label) const;

  /// A length in grid steps, not rounded.
  exact::Real length(const JsonValue& value, const Label& label) const;
  /// A coordinate, put on the grid; how far it was moved, in grid steps.
  std::int64_t coordinate(const JsonValue& value, double& moved, const Label& label) const;
  /// [x, y], put on the grid.
  plane::GridPoint point(const JsonValue& value, const Label& label) const;
  /// [x, y] or [x, y, z] as `dimension` wants, put on the grid.
  GridPosition position(const JsonValue& value, int dimension, const Label& label) const;

 private:
  /// Whether a place is that of the label, or of a part of it.
  static bool is_within(std::string_view place, const Label& label);
  std::string file_;
  ReadContext& context_;
};

/// ", did you mean 'board'?" where one of the names is near enough, otherwise empty.
std::string suggestion(std::string_view wrong, const std::vector<std::string>& names);

/// The same, and where no name is near "; the shapes are 'a', 'b'" (or whatever `what` calls them).
std::string choice(std::string_view what, std::string_view wrong, const std::vector<std::string>& names);

}  // namespace findspace::io
