// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/read_height_grid.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <utility>

#include "exact/number/decimal.h"
#include "io/mesh/read_mesh_ply.h"
#include "space/mesh/height_field.h"

namespace findspace::io {
namespace {

using exact::Real;

class HeightGrid {
 public:
  HeightGrid(const std::string& bytes, Real scale, ReadContext& context)
      : lines_(bytes), scale_(std::move(scale)), unit_(context.grid.step() / scale_), context_(context) {
    read_head();
    columns_ = count("ncols");
    rows_ = count("nrows");
    const std::size_t most = bytes.size() / 2 + 1;  // a height and what parts it from the next take two bytes
    if (columns_ > 0 && rows_ > most / columns_)
      throw Error(ErrorCode::kFile,
                  fmt::format("the file is too short for {} columns and {} rows of heights", columns_, rows_));
    context.work.charge(kHeightFieldSquare * columns_ * rows_, "a height field of so many heights");
  }

  space::Solid solid(const Real& floor) {
    space::HeightField field(frame(floor), context_.grid);
    for (std::size_t row = rows_; row-- > 0;)
      for (std::size_t column = 0; column < columns_; ++column) put(field, column, row);
    if (at_ < lines_.words().size() || lines_.next())
      lines_.fail(fmt::format("there are more heights than {} times {}", columns_, rows_));
    return field.solid(context_.rounding, context_.notes);
  }

 private:
  /// Until a line begins with a height, which may be a missing one that is marked by a word.
  void read_head() {
    static constexpr std::array<std::string_view, 10> kKnown{
        "ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "dx", "dy", "nodata_value"};
    mark_missing("-9999");
    while (lines_.next() && std::isalpha(static_cast<unsigned char>(lines_.words()[0][0])) &&
           lines_.words()[0] != none_) {
      const std::vector<std::string_view>& words = lines_.words();
      const std::string key = lower_ending(std::string(words[0]));
      if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end())
        lines_.fail("a word that the head of a grid of heights does not have");
      if (words.size() != 2) lines_.fail(fmt::format("{} is followed by one number", key));
      if (!head_.emplace(key, words[1]).second) lines_.fail(fmt::format("{} stands twice", key));
      if (key == "nodata_value")
        mark_missing(words[1]);
      else
        number(words[1]);
    }
  }

  /// Some files mark missing heights by "nan", others by the least float.
  void mark_missing(std::string_view none) {
    none_ = none;
    none_steps_ = exact::grid_integer(none, unit_);
    none_value_.reset();
    if (none.find_first_of("0123456789") != std::string_view::npos) none_value_ = number(none);
  }

  Real number(std::string_view word) const {
    try {
      return Real::parse_decimal(word);
    } catch (const Error&) {
      lines_.fail(fmt::format("'{}' is not a number", word));
    }
  }

  /// Of two that say the same in different ways.
  bool has_first(const std::string& first, const std::string& second) const {
    if (head_.contains(first) && head_.contains(second))
      throw Error(ErrorCode::kSyntax, fmt::format("the head of the grid of heights has {} and {}", first, second));
    return head_.contains(first);
  }

  Real need(const std::string& key) const {
    const auto found = head_.find(key);
    if (found == head_.end())
      throw Error(ErrorCode::kSyntax, fmt::format("the head of the grid of heights lacks {}", key));
    return number(found->second);
  }

  std::size_t count(const std::string& key) const {
    const auto whole = need(key).integer();
    if (!whole || *whole < 0 || *whole > exact::int128(space::HeightField::kMostHeights))
      throw Error(ErrorCode::kBadValue, fmt::format("{} is a whole number up to {}, not {}", key,
                                                    space::HeightField::kMostHeights, head_.find(key)->second));
    return static_cast<std::size_t>(*whole);
  }

  /// Heights are those of the middles of cells.
  space::FieldFrame frame(const Real& floor) const {
    space::FieldFrame frame{columns_, rows_, {}, {}, floor};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string axis = k == 0 ? "x" : "y", center = axis + "llcenter", corner = axis + "llcorner";
      const Real step = need(has_first("cellsize", "d" + axis) ? "cellsize" : "d" + axis);
      const Real first = has_first(center, corner) ? need(center) : need(corner) + step * Real::ratio(1, 2);
      frame.step[k] = step * scale_;
      frame.at[k] = first * scale_;
    }
    return frame;
  }

  void put(space::HeightField& field, std::size_t column, std::size_t row) {
    if (at_ == lines_.words().size()) {
      if (!lines_.next()) throw Error(ErrorCode::kFile, "the file ends before its last height: it is cut off");
      at_ = 0;
    }
    const std::string_view word = lines_.words()[at_++];
    double moved = 0;
    try {
      if (const auto height = height_of(word, moved)) field.put(column, row, *height, moved);
    } catch (const Error& e) {
      throw e.place().empty() ? e.within(lines_.place()) : e;
    }
  }

  /// In grid steps; nothing where it is missing.
  std::optional<std::int64_t> height_of(std::string_view word, double& moved) const {
    if (word == none_) return std::nullopt;
    if (const auto height = exact::grid_integer(word, unit_)) return height == none_steps_ ? std::nullopt : height;
    const Real value = number(word);
    if (none_value_ && value == *none_value_) return std::nullopt;
    return context_.grid.nearest(value * scale_, moved);
  }

  TextLines lines_;
  Real scale_, unit_;  // of the file in the scene's unit; a grid step in the file's
  ReadContext& context_;
  std::map<std::string, std::string_view> head_;
  std::string_view none_;                        // what stands for a missing height
  std::optional<Real> none_value_;               // of what is a number
  std::optional<std::int64_t> none_steps_;       // likewise, where it is on the grid
  std::size_t columns_ = 0, rows_ = 0, at_ = 0;  // the word of the line that comes next
};

}  // namespace

space::Solid read_height_grid(const std::string& bytes, const Real& scale, const Real& floor, ReadContext& context) {
  return HeightGrid(bytes, scale, context).solid(floor);
}

}  // namespace findspace::io
