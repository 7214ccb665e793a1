// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes from drawings and geometry files: .svg, .dxf, .wkt, .geojson (.json). What each reader takes is described in
// docs/scene.md. All of them give trees on the context's grid, in the scene's unit, y upwards.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/read_context.h"
#include "plane/contour/shape.h"

namespace findspace::io {

/// Which part of a file, and what its numbers mean.
struct FileChoice {
  std::optional<std::string> id, layer;
  std::optional<std::size_t> index;    // of the parts left, from 0
  std::optional<Unit> unit;            // one of the file's numbers is this long, whatever the file says
  std::optional<exact::Real> floor{};  // of heights, in the scene's unit
};

/// Throws Error whose place begins with the file's name; kFile where it is missing or of an unknown kind. Which
/// kinds there are it says for that dimension; 0: not known.
plane::ShapePtr read_shape_file(const std::filesystem::path& path, const FileChoice& choice, ReadContext& context,
                                int dimension = 0);

/// The readers, for text in memory; `name` is what messages call it.
plane::ShapePtr read_svg(std::string_view text, const std::string& name, const FileChoice& choice,
                         ReadContext& context);
plane::ShapePtr read_dxf(std::string_view text, const std::string& name, const FileChoice& choice,
                         ReadContext& context);
plane::ShapePtr read_wkt(std::string_view text, const std::string& name, const FileChoice& choice,
                         ReadContext& context);
plane::ShapePtr read_geojson(std::string_view text, const std::string& name, const FileChoice& choice,
                             ReadContext& context);

/// What the readers share.
/// How many of the scene's unit make one of the file's numbers; `millimetres` is what the file states, if it does.
exact::Real file_scale(const std::optional<exact::Real>& millimetres, const std::string& name, const FileChoice& choice,
                       ReadContext& context);
/// The part that `choice.index` wants, or all of them as a collection. Throws where there is none.
plane::ShapePtr chosen(std::vector<plane::ShapePtr> parts, const std::string& name, const FileChoice& choice);
/// Whether the outlines of all elements nest as one part.
bool nests(const FileChoice& choice, const ReadContext& context);
/// Refuses a choice that the format has no meaning for.
void refuse_choice(bool given, const char* key, const char* format, const std::string& name);
/// The places of bytes of a text: "name:line:column". Cost: linear in the text once, then constant.
class TextPlaces {
 public:
  /// The text must outlive it.
  TextPlaces(std::string_view text, std::string name);
  std::string at(std::size_t offset) const;

 private:
  struct Line {
    std::size_t number = 1, start = 0;
  };
  /// To the line at the end of a part that begins in this one.
  void pass(Line& line, std::size_t from, std::size_t to) const;

  static constexpr std::size_t kBlock = 1024;  // bytes

  std::string_view text_;
  std::string name_;
  std::vector<Line> lines_;  // at the beginning of each block
};

}  // namespace findspace::io
